/* Lists of the surfels of every pixel's fragments (METHODS 16), for sums that depend on an order. */
#ifndef TS_KERNELS_SURFELS_FRAGMENT_LIST_H
#define TS_KERNELS_SURFELS_FRAGMENT_LIST_H
#include "kernels/base/args.h"
#include "kernels/surfels/surfel_blend.h"

#define TS_ROWS_ts_fragment_list_args(ARG) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_disc, discs, surfel_setup_disc) \
	ARG(IN, u64, keys, surfel_depth_surfel) \
	ARG(SUM, u32, offset, fragment_list_offset)      /* [k + 1]: count, start, then end of list k */ \
	ARG(OUT_OPT, u32, surfels, fragment_list_surfel) /* NULL: they are counted */ \
	ARG(VALUE, ts_filter, filter, none)
TS_ARGS(ts_fragment_list_args);

/* scatter over surfels: into the counts of the pixels, or into their lists, in the order of arrival, until leaf_sort
 * sorts them */
TS_FN void ts_k_fragment_list_item(const ts_fragment_list_args *args, u64 i)
{
	ts_camera_k view = ts_k_view(args->view);
	ts_disc disc = args->discs[i];
	for (i32 y = disc.low[1]; y <= disc.high[1]; y++) {
		for (i32 x = disc.low[0]; x <= disc.high[0]; x++) {
			u64 pixel = (u64)y * (u64)view.width + (u64)x;
			ts_surfel_fragment f = ts_k_surfel_fragment(&disc, &args->filter, view.near, x, y);
			if (!f.covers || !ts_k_is_visible(&args->filter, args->keys[pixel], f.z)) continue;
			u32 place = ts_next_u32(&args->offset[pixel + 1u]);
			if (args->surfels != NULL) args->surfels[place] = (u32)i;
		}
	}
}

#endif
