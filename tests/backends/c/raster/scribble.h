/* A small scene with textures that a run has posed and drawn, and keys of an image of it scribbled over. */
#ifndef TS_TESTS_BACKENDS_C_RASTER_SCRIBBLE_H
#define TS_TESTS_BACKENDS_C_RASTER_SCRIBBLE_H
#include <string.h>
#include "backends/fast.h"
#include "backends/kernels.h"
#include "methods/stages.h"
#include "scene/scene.h"
#include "tests/kernels/seeded.h"

enum { WIDTH = 61, HEIGHT = 37, EYE_SAMPLES = 4, PIXELS = EYE_SAMPLES * WIDTH * HEIGHT };

/* Runs of triangles drawn at random, or of the sky, over keys. */
static inline void scribble(u64 *keys, u32 n_keys, u32 n_triangles)
{
	for (u32 k = below(12); k > 0; k--) {
		u64 key = below(8) == 0 ? TS_EMPTY : ((u64)ts_f2u(uniform(0.01f, 40)) << 32) | below(n_triangles);
		u32 first = below(n_keys), n = 1 + below(200);
		for (u32 i = first; i < first + n && i < n_keys; i++) keys[i] = key;
	}
}

/* Runs the kernel by some arguments, and its fast path by others that differ in where the output goes. */
static inline void launch_both(ts_kernel kernel, ts_fast_path *path, const void *plain, const void *fast, u32 n)
{
	ts_c_launch(kernel, plain, n, 1);
	assert_true(path(fast, n, 1 + below(4)));
}

/* Calls `check` with a run that has drawn what the eye sees, so many times. */
static inline void with_run(void (*check)(const ts_run *, u32 n_triangles), u32 times)
{
	ts_params params;
	ts_scene *scene;
	ts_run run;
	ts_params_default(&params);
	params.width = WIDTH;
	params.height = HEIGHT;
	params.eye_samples = TS_EYE_SAMPLES_4;
	assert_int_equal(ts_scene_load(&scene, "dining:triangles=10000:texels=32", &params, NULL), TS_OK);
	ts_run_begin(&run, scene, &params, 1);
	static const char *const stages[] = {"eye.view", "pose", "eye"};
	for (u32 i = 0; i < 3; i++) assert_int_equal(ts_run_stage(&run, ts_stage_find(stages[i])), TS_OK);
	for (u32 i = 0; i < times; i++) check(&run, scene->n_triangles);
	ts_run_end(&run);
	ts_scene_free(scene);
}

#endif
