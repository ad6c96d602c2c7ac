/* All kernels that belong to no family: for backends. */
#ifndef TS_KERNELS_BASE_KERNELS_H
#define TS_KERNELS_BASE_KERNELS_H
#include "bench.h"
#include "pose.h"
#include "scan.h"
#include "sort.h"

#endif
