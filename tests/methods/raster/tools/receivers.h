/* A square, and receivers above it whose light truths gather. */
#ifndef TS_TESTS_METHODS_RASTER_TOOLS_RECEIVERS_H
#define TS_TESTS_METHODS_RASTER_TOOLS_RECEIVERS_H
#include <math.h>
#include "tests/model/test.h"
#include "tests/truth/world.h"
#include "truth/sampling.h"

enum { N_RECEIVERS = 64, N_RAYS = 4096 };

/* A square of side 2 at y = 0, its front up. */
static const ts_v3 square[4] = {{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}};

static inline world *square_new(void)
{
	world *w = malloc(sizeof *w);
	assert_non_null(w);
	world_begin(w);
	w->scene.info.box_max[1] = 8;
	world_quad(w, square[0], square[1], square[2], square[3], ONE_SIDED, 0);
	return w;
}

/* A square of side 18 at that height. */
static inline void cover_with(world *w, f32 y)
{
	world_quad(w, ts_v3_make(-9, y, -9), ts_v3_make(-9, y, 9), ts_v3_make(9, y, 9), ts_v3_make(9, y, -9), TWO_SIDED, 0);
}

/* In a row, above the square, at random places; their normals look down, and aside. */
static inline ts_gpixel *make_receivers(world *w)
{
	w->run.params.width = N_RECEIVERS;
	w->run.params.height = 1;
	ts_gpixel *pixels = ts_frame_make2(&w->run.frame, TS_B_gbuffer_pixel, 1, N_RECEIVERS);
	assert_non_null(pixels);
	for (u32 i = 0; i < N_RECEIVERS; i++) {
		f32 x = ts_uniform(ts_random(i, 1, 0)) * 4 - 2, z = ts_uniform(ts_random(i, 2, 0)) * 4 - 2;
		f32 y = 0.5f + ts_uniform(ts_random(i, 3, 0)), tilt = ts_uniform(ts_random(i, 4, 0)) * 2 - 1;
		ts_store3(pixels[i].position, ts_v3_make(x, y, z));
		ts_store3(pixels[i].normal, ts_normalize(ts_v3_make(tilt, -1, 0)));
		pixels[i].depth = 0.5f;
	}
	return pixels;
}

typedef ts_status truth_of(ts_truth *truth, ts_run *run, ts_sampling *sampling);

static inline const f32 *traced(world *w, truth_of *trace)
{
	ts_truth *truth;
	w->run.params.truth_bounce_rays = N_RAYS;
	assert_int_equal(ts_truth_new(&truth, &w->run), TS_OK);
	assert_int_equal(trace(truth, &w->run, NULL), TS_OK);
	ts_truth_free(truth);
	return ts_frame_data(&w->run.frame, TS_B_indirect_irradiance);
}

static inline void world_done(world *w)
{
	ts_run_end(&w->run);
	free(w);
}

#endif
