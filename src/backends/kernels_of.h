/* KERNELS_H and KERNELS_DEF: the kernels of the folder OF of src/kernels, or all without OF, for a file of a backend's
 * folder to include. scripts/ptx compiles such a file once for each folder. */
#ifndef TS_BACKENDS_KERNELS_OF_H
#define TS_BACKENDS_KERNELS_OF_H
#ifdef OF
/* clang-format off */
#define TEXT(path) QUOTED(path)
#define QUOTED(path) #path
#define KERNELS_H TEXT(kernels/OF/kernels.h)
#define KERNELS_DEF TEXT(kernels/OF/kernels.def)
#define BANDS(kernel, arguments, others)
#define PIECES(kernel, by, arguments, from, unless, n)
/* clang-format on */
#else
#define KERNELS_H "backends/kernels.h"
#define KERNELS_DEF "backends/kernels.def"
#endif
#endif
