/* Computed sizes of rasterization. */
#include "kernels/raster/mip.h"
#include "methods/raster/raster.h"
#include "methods/registry.h"
#include "methods/stages.h"

u64 ts_size_eye_rows(const ts_size_question *q)
{
	return (u64)ts_eye_samples(&q->run->params) * TS_PARAM(&q->run->params, height);
}

u64 ts_size_sample_rows(const ts_size_question *q)
{
	return ts_eye_samples(&q->run->params) > 1 ? ts_size_eye_rows(q) : 0;
}

u64 ts_size_view_words(const ts_size_question *q)
{
	u64 views = q->known->n[TS_DIM_views];
	return views != TS_UNKNOWN ? views / 64 + (views % 64 != 0) : TS_UNKNOWN;
}

/* The units in question: cubes or views. */
static u32 units(const ts_size_question *q, u32 *first)
{
	ts_buffer_id id = ts_run_has_cubes(q->run) ? TS_B_cube_size_face : TS_B_offscreen_view;
	*first = q->whole ? 0 : q->run->first_unit;
	return !q->whole ? q->run->n_units : ts_is_made(q, id) ? (u32)ts_frame_n(&q->run->frame, id) : 0;
}

u64 ts_size_texels(const ts_size_question *q)
{
	u32 first, n = units(q, &first);
	bool any = ts_is_made(q, TS_B_cube_size_face) || ts_is_made(q, TS_B_offscreen_view);
	return any ? ts_run_n_texels(q->run, first, n) : TS_UNKNOWN;
}

u64 ts_size_mip_texels(const ts_size_question *q)
{
	u32 first, n = units(q, &first);
	if (!ts_is_made(q, TS_B_cube_size_face)) return TS_UNKNOWN;
	if (!ts_run_has_cubes(q->run)) return 0;
	const ts_face *cubes = ts_frame_data(&q->run->frame, TS_B_cube_size_face);
	return ts_k_mip_first(cubes, first, first + n);
}
