/* The kernels of the arithmetic vectors that all methods share: for backends. */
#ifndef TS_KERNELS_VECTORS_KERNELS_H
#define TS_KERNELS_VECTORS_KERNELS_H
#include "kernels/vectors/composites.h"
#include "kernels/vectors/vectors.h"

#endif
