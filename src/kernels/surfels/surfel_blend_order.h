/* Attributes of surfels as frame buffers blend them (NV40: Floating Point Precision; METHODS 16): pixel
 * by pixel in the order of the surfels, every partial sum in the format of the target.
 *
 *     float32  every sum is rounded to binary32
 *     half     every term and every sum is rounded to binary16; none passes 2048, where a term of 1 changes nothing
 *     8bit     terms are rounded to 255ths and sums end at 1; normals are stored as n / 2 + 1 / 2
 *
 * Results are written in units of 2^-30, like integer sums: sums of at least 2^-6 exactly, smaller sums rounded to the
 * nearest. */
#ifndef TS_KERNELS_SURFELS_SURFEL_BLEND_ORDER_H
#define TS_KERNELS_SURFELS_SURFEL_BLEND_ORDER_H
#include "kernels/base/args.h"
#include "kernels/base/half.h"
#include "kernels/surfels/surfel_blend.h"

#define TS_ACCUMULATION_FIXED 0u
#define TS_ACCUMULATION_FLOAT32 1u
#define TS_ACCUMULATION_HALF 2u
#define TS_ACCUMULATION_8BIT 3u

#define TS_BLEND_NORMAL 3u /* index of the normal in a pixel's sums */

#define TS_ROWS_ts_surfel_blend_order_args(ARG) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_surfel, surfels, scene_surfel) \
	ARG(IN, ts_disc, discs, surfel_setup_disc) \
	ARG(IN, u32, offset, fragment_list_offset) \
	ARG(IN, u32, list, fragment_list_surfel) \
	ARG(SUM, i64, sums, surfel_blend_sum) \
	ARG(MIN, u64, heaviest, surfel_blend_heaviest) \
	ARG(VALUE, ts_filter, filter, none) \
	ARG(VALUE, u32, accumulation, none) /* TS_ACCUMULATION_* */
TS_ARGS(ts_surfel_blend_order_args);

/* A partial sum plus one term, in the format. */
TS_FN f32 ts_k_blended(u32 accumulation, f32 sum, f32 term)
{
	bool short_float = accumulation == TS_ACCUMULATION_HALF;
	if (accumulation == TS_ACCUMULATION_8BIT) {
		f32 level = 255.0f * ts_clamp(term, 0.0f, 1.0f);
		return ts_min(sum + ts_rint(level), 255.0f);
	}
	f32 more = sum + (short_float ? ts_half(term) : term);
	return short_float ? ts_half(more) : more;
}

/* x in units of 2^-30. */
TS_FN i64 ts_k_blend_units(f32 x)
{
	f32 size = ts_abs(x);
	f32 whole = ts_floor(size);
	f32 part = size - whole;
	i64 units = (i64)ts_f2i(whole) * 1073741824 + (i64)ts_fix(part, TS_BLEND_BITS, 31);
	return x < 0.0f ? -units : units;
}

/* Sum k of the target as a number; for 8bit a normal n is recovered from n / 2 + 1 / 2. */
TS_FN f32 ts_k_blend_number(u32 accumulation, u32 k, f32 sum, f32 weight)
{
	bool normal = k >= TS_BLEND_NORMAL && k < TS_BLEND_WEIGHT;
	if (accumulation != TS_ACCUMULATION_8BIT) return sum;
	f32 level = normal ? 2.0f * sum - weight : sum;
	return level / 255.0f;
}

/* One pixel of the target into which fragments are blended. */
typedef struct {
	f32 sum[TS_BLEND_WEIGHT + 1u];
} ts_blend_target;

TS_FN ts_blend_target ts_k_blend_none(void)
{
	ts_blend_target r;
	for (u32 k = 0u; k <= TS_BLEND_WEIGHT; k++) r.sum[k] = 0.0f;
	return r;
}

/* Blends one more fragment into the target. */
TS_FN void ts_k_blend_next(u32 accumulation, ts_blend_target *target, const ts_attributes *attributes, f32 weight)
{
	bool moved = accumulation == TS_ACCUMULATION_8BIT;
	for (u32 k = 0u; k < TS_BLEND_WEIGHT; k++) {
		f32 value = attributes->value[k];
		f32 stored = moved && k >= TS_BLEND_NORMAL ? 0.5f * value + 0.5f : value;
		target->sum[k] = ts_k_blended(accumulation, target->sum[k], weight * stored);
	}
	target->sum[TS_BLEND_WEIGHT] = ts_k_blended(accumulation, target->sum[TS_BLEND_WEIGHT], weight);
}

/* Stores the sums after n fragments. */
TS_FN void ts_k_blend_end(u32 accumulation, const ts_blend_target *target, u32 n, TS_GLOBAL i64 *sums)
{
	f32 weight = target->sum[TS_BLEND_WEIGHT];
	for (u32 k = 0u; k <= TS_BLEND_WEIGHT; k++) {
		sums[k] = ts_k_blend_units(ts_k_blend_number(accumulation, k, target->sum[k], weight));
	}
	sums[TS_BLEND_FRAGMENTS] = (i64)n;
}

/* map over pixels */
TS_FN void ts_k_surfel_blend_order_item(const ts_surfel_blend_order_args *args, u64 i)
{
	/* Start with an empty target. */
	ts_camera_k view = ts_k_view(args->view);
	i32 x = (i32)(i % (u64)view.width);
	i32 y = (i32)(i / (u64)view.width);
	ts_blend_target target = ts_k_blend_none();
	u64 heaviest = TS_EMPTY;
	for (u32 at = args->offset[i]; at < args->offset[i + 1u]; at++) {
		/* Find the fragment of the next surfel. */
		u32 surfel = args->list[at];
		ts_disc disc = args->discs[surfel];
		ts_attributes attributes = ts_k_attributes(&args->surfels[surfel], &disc);
		ts_surfel_fragment f = ts_k_surfel_fragment(&disc, &args->filter, view.near, x, y);
		f32 weight = ts_k_fragment_weight(&f);
		/* Blend it in the format of the target (NV40: Floating Point Precision), and keep the heaviest; of equal
		 * weights the lower surfel. */
		ts_k_blend_next(args->accumulation, &target, &attributes, weight);
		u64 heavy = ts_k_heavy(weight, surfel);
		heaviest = heavy < heaviest ? heavy : heaviest;
	}
	/* Store the sums as if they were integer sums. */
	ts_k_blend_end(args->accumulation, &target, args->offset[i + 1u] - args->offset[i], args->sums + i * TS_BLEND_SUMS);
	args->heaviest[i] = heaviest;
}

#endif
