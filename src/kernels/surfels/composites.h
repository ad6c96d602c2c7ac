/* Composites of surfels: a surfel in a view (surfel_setup.h), its fragments (fragment.h), their light (deferred.h). */
#ifndef TS_KERNELS_SURFELS_COMPOSITES_H
#define TS_KERNELS_SURFELS_COMPOSITES_H
#include "kernels/surfels/deferred.h"
#include "kernels/surfels/fragment.h"
#include "kernels/vectors/composites_row.h"

TS_ROW_AT(ts_surfel)
TS_ROW_AT(ts_disc)
TS_FN TS_GLOBAL ts_disc *ts_row_at_disc(TS_GLOBAL u32 *row) { return (TS_GLOBAL ts_disc *)row; }

TS_FN ts_filter ts_row_filter(TS_GLOBAL const u32 *row)
{
	ts_filter r;
	r.filter = row[0];
	r.botsch = row[1];
	r.opens = 0u;
	r.per_sigma2 = ts_row_f32(row, 2u);
	r.reach = ts_row_f32(row, 3u);
	r.fall = ts_row_f32(row, 4u);
	r.object2 = ts_row_f32(row, 5u);
	r.screen2 = ts_row_f32(row, 6u);
	return r;
}

TS_VECTOR(disc)
{
	ts_disc disc;
	ts_camera_k view = ts_k_view(ts_row_at_ts_view(in, 0u));
	view.orthographic = in[16];
	ts_filter filter = ts_row_filter(in + 17);
	out[24] = ts_k_disc(&disc, &view, &filter, ts_row_at_ts_surfel(in, 24u));
	*ts_row_at_disc(out) = disc;
}

TS_VECTOR(surfel_fragment)
{
	ts_disc disc = *ts_row_at_ts_disc(in, 0u);
	ts_filter filter = ts_row_filter(in + 24);
	ts_surfel_fragment f =
		ts_k_surfel_fragment(&disc, &filter, ts_row_f32(in, 31u), ts_row_i32(in, 32u), ts_row_i32(in, 33u));
	out[0] = f.covers ? 1u : 0u;
	out[1] = f.inside ? 1u : 0u;
	ts_put_f32(out, 2u, f.z);
	ts_put_f32(out, 3u, ts_k_fragment_weight(&f));
}

TS_VECTOR(surfel_light)
{
	ts_put_v3(out, ts_k_shade_by(ts_row_at_ts_light(in, 0u), ts_row_f32(in, 16u), in[17], ts_row_v3(in, 18u),
	                             ts_row_v3(in, 21u), ts_row_v3(in, 24u), ts_row_v3(in, 27u)));
}

#define TS_LIST_surfels_composites(VECTOR) \
	VECTOR(disc) \
	VECTOR(surfel_fragment) \
	VECTOR(surfel_light)
/* map over rows */
TS_VECTORS(surfels_composites)

#endif
