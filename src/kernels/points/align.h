/* Alignment: the lattice of each piece that culling keeps (EPR section 3.2; METHODS 2). */
#ifndef TS_KERNELS_POINTS_ALIGN_H
#define TS_KERNELS_POINTS_ALIGN_H
#include "kernels/base/args.h"
#include "kernels/raster/lattice.h"

#define TS_ROWS_ts_align_args(ARG) \
	ARG(IN, ts_piece, pieces, split_piece) \
	ARG(IN, f32, scale, split_density) \
	ARG(IN, u32, keep, cull_keep) \
	ARG(OUT, ts_align, frames, align_frame)
TS_ARGS(ts_align_args);

/* map over pieces */
TS_FN void ts_k_align_item(const ts_align_args *args, u64 i)
{
	f32 s = args->keep[i] != 0u ? args->scale[i] : 0.0f;
	ts_k_lattice_align(&args->pieces[i], s, &args->frames[i]);
}

#endif
