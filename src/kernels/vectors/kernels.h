/* The kernels of the arithmetic vectors that all methods share: for backends. */
#ifndef TS_KERNELS_VECTORS_KERNELS_H
#define TS_KERNELS_VECTORS_KERNELS_H
#include "composites.h"
#include "vectors.h"

#endif
