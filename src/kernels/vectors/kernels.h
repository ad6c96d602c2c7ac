/* The kernel of the arithmetic vectors: for backends. */
#ifndef TS_KERNELS_VECTORS_KERNELS_H
#define TS_KERNELS_VECTORS_KERNELS_H
#include "vectors.h"

#endif
