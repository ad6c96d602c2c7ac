/* All kernels. Only backends, which run kernels, include this. */
#ifndef TS_BACKENDS_KERNELS_H
#define TS_BACKENDS_KERNELS_H
#include "kernels/base/kernels.h"
#include "kernels/vectors/kernels.h"

#define FAMILY(name) FAMILY_FILE(kernels, name, kernels.h)
#include "families.def"

#endif
