/* Sizes and shapes of buffers, as records.def names and writes them: dimensions apart by blanks, each a product of
 * numbers and sizes with at most one "+1" behind it: "height width 3", "mirror_pixels*lookup_samples+1". */
#ifndef TS_MODEL_SHAPE_H
#define TS_MODEL_SHAPE_H
#include "kernels/base/compat.h"
#include "model/core.h"

#define DIM(id, noun, how, bits, doc) TS_DIM_##id,
typedef enum {
#include <touchstone/records.def>
	TS_N_DIMS,
	TS_DIM_none = TS_N_DIMS,
} ts_dim;

enum { TS_MAX_DIMS = 4, TS_MAX_FACTORS = 2 };

/* How the value of a size becomes known; see records.def. */
typedef enum { TS_IS_fixed, TS_IS_counted, TS_IS_given, TS_IS_found, TS_IS_batched } ts_how_known;

/* One DIM row of records.def. */
typedef struct {
	const char *name, *noun;
	ts_how_known how;
	u32 bits;
	const char *doc;
} ts_dim_info;
extern const ts_dim_info ts_dim_table[TS_N_DIMS];

#define TS_UNKNOWN UINT64_MAX

typedef struct {
	u64 n[TS_N_DIMS];
} ts_sizes;
/* Sets all sizes to TS_UNKNOWN. */
void ts_sizes_clear(ts_sizes *sizes);

/* A dimension: number * (product of n_factors sizes) + more. */
typedef struct {
	u64 number;
	u32 n_factors;
	ts_dim factor[TS_MAX_FACTORS];
	u32 more;
} ts_axis;

typedef struct {
	u32 n;
	ts_axis axis[TS_MAX_DIMS];
} ts_shape;

/* Reads a shape. False if the text is no shape or names an unknown size. */
bool ts_shape_parse(ts_shape *shape, const char *text);
/* The value of a dimension; TS_UNKNOWN if the value of a size in it is unknown, or if the result is 2^64 or more. */
u64 ts_axis_size(const ts_axis *axis, const ts_sizes *sizes);
/* Writes the values of the dimensions of a shape. False if one is unknown. */
bool ts_shape_dims(const ts_shape *shape, const ts_sizes *sizes, u64 dims[TS_MAX_DIMS]);
/* The size that a dimension is, or is one more than (prefix sums); TS_DIM_none if the dimension has another form. */
ts_dim ts_axis_counts(const ts_axis *axis);
/* Whether the first dimensions are those of the eye's image, or of one image for each sample of a pixel, one below the
 * other. */
bool ts_shape_is_image(const ts_shape *shape);
/* Writes the product of the dimensions; false if the product is 2^64 or more. */
bool ts_shape_count(u64 *n, u32 n_dims, const u64 *dims);

#endif
