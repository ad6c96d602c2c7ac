/* Composites of the lattice of samples (lattice.h). */
#ifndef TS_KERNELS_VECTORS_COMPOSITES_LATTICE_H
#define TS_KERNELS_VECTORS_COMPOSITES_LATTICE_H
#include "kernels/raster/lattice.h"
#include "kernels/vectors/composites_row.h"

TS_VECTOR(align) { ts_k_lattice_align(ts_row_at_ts_piece(in, 0u), ts_row_f32(in, 12u), ts_row_at_result(out)); }

TS_VECTOR(lattice_weights)
{
	ts_put_v3(out, ts_k_weights_around(ts_row_v2(in, 0u), ts_row_v2(in, 2u), ts_row_v2(in, 4u), ts_row_i32(in, 6u),
	                                   ts_row_i32(in, 7u)));
}

TS_VECTOR(sample_centre)
{
	ts_put_v3(out, ts_k_sample_centre(ts_row_at_ts_piece(in, 0u), ts_row_at_ts_align(in, 12u), in[32] != 0u,
	                                  ts_row_i32(in, 33u), ts_row_i32(in, 34u)));
}

#endif
