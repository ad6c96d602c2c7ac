/* Surfels in a view: bounds of kernels' loops and indices. */
#include <inttypes.h>
#include "kernels/surfels/surfel_blend_order.h"
#include "methods/surfels/tools/tools.h"

/* Boxes are in the image, or empty. */
static ts_status check_discs(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n;
	const ts_disc *discs = ts_check_elements(load, id, &n);
	const i32 size[2] = {(i32)TS_PARAM(&load->run.params, width), (i32)TS_PARAM(&load->run.params, height)};
	for (u64 i = 0; i < n; i++) {
		for (u32 k = 0; k < 2; k++) {
			if (discs[i].low[k] < 0) return ts_check_refuse(load, id, i, "low", k, "0 or more");
			if (discs[i].high[k] >= size[k] || discs[i].high[k] < -1) {
				return ts_check_refuse(load, id, i, "high", k, "from -1 to %" PRId32, size[k] - 1);
			}
			bool near = discs[i].pixel[k] > -(1 << 21) && discs[i].pixel[k] < 1 << 21;
			if (!near) return ts_check_refuse(load, id, i, "pixel", k, "within 2^21");
		}
	}
	return TS_OK;
}

/* Where there is a fragment the heaviest is a surfel. */
static ts_status check_sums(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n, n_pixels;
	const i64 *sums = ts_check_elements(load, id, &n);
	const u64 *heaviest = ts_check_elements(load, TS_B_surfel_blend_heaviest, &n_pixels);
	for (u64 i = 0; heaviest != NULL && i < n / TS_BLEND_SUMS; i++) {
		bool named = heaviest[i] != TS_EMPTY, summed = sums[TS_BLEND_SUMS * i + TS_BLEND_FRAGMENTS] != 0;
		if (named == summed) continue;
		return ts_check_refuse(load, id, TS_BLEND_SUMS * i + TS_BLEND_FRAGMENTS, "", 0,
		                       "%s, as surfel_blend.heaviest says,", named ? "at least 1 fragment" : "no fragment");
	}
	return TS_OK;
}

const ts_check_rule ts_surfels_checks[] = {
	{TS_B_surfel_setup_disc, TS_CHECK_VALUES, check_discs},
	{TS_B_surfel_blend_sum, TS_CHECK_VALUES, check_sums},
	{.check = NULL},
};
