/* Composites of hulls: the light that corners gather (corner.h), its lobes (corner_lobes.h), lobes between corners and
 * their irradiance (hull.h), lamps as triangles (polygon.h). */
#ifndef TS_KERNELS_HULLS_COMPOSITES_H
#define TS_KERNELS_HULLS_COMPOSITES_H
#include "kernels/hulls/corner.h"
#include "kernels/hulls/corner_lobes.h"
#include "kernels/hulls/hull.h"
#include "kernels/hulls/polygon.h"
#include "kernels/hulls/vectors.h"
#include "kernels/vectors/composites_row.h"

TS_ROW_AT(ts_patch)
TS_ROW_AT(ts_lobes)
TS_FN TS_GLOBAL ts_patch *ts_row_at_patch(TS_GLOBAL u32 *row) { return (TS_GLOBAL ts_patch *)row; }

TS_VECTOR(gather)
{
	ts_gathered sum;
	sum.w = ts_v3_make(0.0f, 0.0f, 0.0f);
	sum.red = sum.w;
	sum.green = sum.w;
	sum.blue = sum.w;
	ts_k_gather(&sum, ts_row_at_ts_patch(in, 0u), ts_row_v3(in, 16u), in[19] != 0u);
	ts_put_v3(out, sum.w);
	ts_put_v3(out + 3, sum.red);
	ts_put_v3(out + 6, sum.green);
	ts_put_v3(out + 9, sum.blue);
}

TS_FN void ts_put_sg(TS_GLOBAL u32 *row, const ts_sg *g)
{
	ts_put_f32(row, 0u, g->mu);
	ts_put_f32(row, 1u, g->lambda);
	ts_put_v3(row + 2, g->phi);
}

TS_VECTOR(lobe_fit)
{
	ts_sg g = ts_k_fit(TS_A, ts_row_v3(in, 1u), in[4]);
	ts_put_sg(out, &g);
}

TS_VECTOR(hull_lobe)
{
	ts_shares shares;
	for (u32 k = 0u; k < 4u; k++) shares.of[k] = ts_row_f32(in, 64u + k);
	ts_sg g = ts_k_lobe_of_lobes(ts_row_at_ts_lobes(in, 0u), &shares, in[68]);
	ts_put_sg(out, &g);
}

TS_VECTOR(lobe_irradiance)
{
	ts_hull_args args;
	args.cosine = in[8];
	args.printed = in[9];
	ts_sg g = ts_row_sg(in, 0u);
	ts_put_f32(out, 0u, ts_k_lobe_irradiance(&args, &g, ts_row_v3(in, 5u)));
}

/* A triangle of a ball or of a disc; its exitance is not set. */
TS_VECTOR(lamp_triangle)
{
	TS_GLOBAL ts_patch *patch = ts_row_at_patch(out);
	ts_k_patch_clear(patch);
	if (in[8] != 0u) {
		ts_k_polygon_ball(patch, ts_row_v3(in, 0u), ts_row_f32(in, 6u), in[7]);
	} else {
		ts_k_polygon_disc(patch, ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_f32(in, 6u), in[7]);
	}
}

#define TS_LIST_hulls_composites(VECTOR) \
	VECTOR(gather) \
	VECTOR(lobe_fit) \
	VECTOR(hull_lobe) \
	VECTOR(lobe_irradiance) \
	VECTOR(lamp_triangle)
/* map over rows */
TS_VECTORS(hulls_composites)

#endif
