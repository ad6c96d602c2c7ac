/* All kernels that belong to no family: for backends. */
#ifndef TS_KERNELS_BASE_KERNELS_H
#define TS_KERNELS_BASE_KERNELS_H
#include "kernels/base/bench.h"
#include "kernels/base/pose.h"
#include "kernels/base/scan.h"
#include "kernels/base/sort.h"

#endif
