/* Shapes of buffers, as records.def writes them: dimensions apart by blanks, each a product with at most one "+1" behind
 * it, of numbers and of the sizes that the head of that file names: "H W 3", "P*K+1". */
#ifndef TS_CORE_SHAPE_H
#define TS_CORE_SHAPE_H
#include "../kernels/compat.h"
#include "core.h"

enum { TS_MAX_SIZES = 48, TS_MAX_DIMS = 4 };

typedef struct { const char *name; u64 n; } ts_size;
typedef struct { ts_size size[TS_MAX_SIZES]; u32 n; } ts_sizes;

/* Gives the size `name`, a text that stays, its number; a second time replaces it. */
void ts_sizes_set(ts_sizes *sizes, const char *name, u64 n);
/* The dimensions of a shape. False if it names a size that was not given or a product passes 2^64. */
bool ts_shape_dims(const char *shape, const ts_sizes *sizes, u32 *n_dims, u64 dims[TS_MAX_DIMS]);
/* Product of the dimensions; false if it passes 2^64. */
bool ts_shape_count(u64 *n, u32 n_dims, const u64 *dims);

#endif
