/* Attributes of surfels (NV40: 3-Pass Deferred Shading; METHODS 16): every fragment that is no deeper than the
 * visibility pass allows adds its colour, its normal and 1, each times its weight.
 *
 * Sums are integers in units of 2^-30 (CONTRACT rule 30), so that the order of the surfels does not matter. A surfel
 * has at most one fragment at a pixel, and there are at most 2^32 - 1 surfels. Weights are at most 1, colours are
 * clamped to [0,1], a component of a normal is at most 1 + 2^-22; so no term passes 2^31 - 1 and no sum 2^63. A term
 * has an error of at most 2^-31, the mean of n fragments one of at most n 2^-30 over the sum of weights, which at a
 * covered pixel is at least e^(-1/2 ewa.sigma_k^-2). */
#ifndef TS_KERNELS_SURFELS_SURFEL_BLEND_H
#define TS_KERNELS_SURFELS_SURFEL_BLEND_H
#include "kernels/base/args.h"
#include "kernels/surfels/fragment.h"

#define TS_BLEND_BITS 30
#define TS_BLEND_WEIGHT 6u /* places in a pixel's sums */
#define TS_BLEND_FRAGMENTS 7u
#define TS_BLEND_SUMS 8u

#define TS_ROWS_ts_surfel_blend_args(ARG) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_surfel, surfels, scene_surfel) \
	ARG(IN, ts_disc, discs, surfel_setup_disc) \
	ARG(IN, u64, keys, surfel_depth_surfel) \
	ARG(SUM, i64, sums, surfel_blend_sum) \
	ARG(MIN, u64, heaviest, surfel_blend_heaviest) \
	ARG(TALLY, i64, tally, 0) /* [0] fragments, [1] pixels of the boxes */ \
	ARG(VALUE, ts_filter, filter, none)
TS_ARGS(ts_surfel_blend_args);

/* The attributes that a surfel adds for a weight of 1. */
typedef struct {
	f32 value[6];
} ts_attributes;

TS_FN ts_attributes ts_k_attributes(TS_GLOBAL const ts_surfel *surfel, const ts_disc *disc)
{
	ts_attributes r;
	for (u32 k = 0u; k < 3u; k++) {
		r.value[k] = ts_clamp(surfel->colour[k], 0.0f, 1.0f);
		r.value[k + 3u] = disc->normal[k];
	}
	return r;
}

/* Whether a fragment is no deeper than the visibility pass allows. Where that pass found no surfel there is none; with
 * ewa.outline=filter every depth is allowed there, so that the screen filter makes all outlines wider. */
TS_FN bool ts_k_is_visible(const ts_filter *filter, u64 key, f32 z)
{
	return key == TS_EMPTY ? filter->opens != 0u : z <= ts_u2f((u32)(key >> 32));
}

/* The key of a fragment's weight; the least key is that of the heaviest fragment. */
TS_FN u64 ts_k_heavy(f32 weight, u32 surfel) { return ((u64)~ts_f2u(ts_put(weight)) << 32) | surfel; }

TS_FN void ts_k_blend_add(const ts_surfel_blend_args *args, u64 pixel, u32 surfel, const ts_attributes *attributes,
                          f32 weight)
{
	TS_GLOBAL i64 *sums = args->sums + pixel * TS_BLEND_SUMS;
	for (u32 k = 0u; k < TS_BLEND_WEIGHT; k++) {
		f32 term = weight * attributes->value[k];
		ts_add_i64(&sums[k], (i64)ts_fix(term, TS_BLEND_BITS, 31));
	}
	ts_add_i64(&sums[TS_BLEND_WEIGHT], (i64)ts_fix(weight, TS_BLEND_BITS, 31));
	ts_add_i64(&sums[TS_BLEND_FRAGMENTS], 1);
	u64 heavy = ts_k_heavy(weight, surfel);
	ts_min_u64(&args->heaviest[pixel], heavy);
}

/* scatter over surfels */
TS_FN void ts_k_surfel_blend_item(const ts_surfel_blend_args *args, u64 i)
{
	/* Load the surfel in the view, and the attributes that it adds. */
	ts_camera_k view = ts_k_view(args->view);
	ts_disc disc = args->discs[i];
	ts_attributes attributes = ts_k_attributes(&args->surfels[i], &disc);
	i64 n = 0;
	for (i32 y = disc.low[1]; y <= disc.high[1]; y++) {
		for (i32 x = disc.low[0]; x <= disc.high[0]; x++) {
			/* Blend each fragment that the visibility pass allows (NV40: 3-Pass Deferred Shading). */
			u64 pixel = (u64)y * (u64)view.width + (u64)x;
			ts_surfel_fragment f = ts_k_surfel_fragment(&disc, &args->filter, view.near, x, y);
			if (!f.covers || !ts_k_is_visible(&args->filter, args->keys[pixel], f.z)) continue;
			ts_k_blend_add(args, pixel, (u32)i, &attributes, ts_k_fragment_weight(&f));
			n++;
		}
	}
	/* Count the fragments, and the pixels of the box; surfels that are not drawn have none. */
	if (disc.high[0] < disc.low[0]) return;
	ts_add_i64(&args->tally[0], n);
	ts_add_i64(&args->tally[1], (i64)(disc.high[0] - disc.low[0] + 1) * (i64)(disc.high[1] - disc.low[1] + 1));
}

#endif
