/* The fast G-buffer equals the plain kernel bit for bit: of pixels that name triangles in front of the eye, across
 * the near plane, behind it, degenerate, or beside the pixel, in runs of any length; of the sky; and of samples of
 * pixels. */
#include <stdlib.h>
#include <string.h>
#include "../../../../src/backends/fast.h"
#include "../../../../src/backends/kernels.h"
#include "../../../../src/methods/stages.h"
#include "../../../../src/scene/scene.h"
#include "../../../kernels/seeded.h"

enum { N = 60, WIDTH = 61, HEIGHT = 37, SAMPLES = 4, PIXELS = SAMPLES * WIDTH * HEIGHT };

/* Keys of an image of the scene, with runs of triangles drawn at random over it. */
static void scribble(u64 *keys, u32 n_triangles)
{
	for (u32 k = below(12); k > 0; k--) {
		u64 key = below(8) == 0 ? TS_EMPTY : ((u64)ts_f2u(uniform(0.01f, 40)) << 32) | below(n_triangles);
		u32 first = below(PIXELS), n = 1 + below(200);
		for (u32 i = first; i < first + n && i < PIXELS; i++) keys[i] = key;
	}
}

static void check(const ts_run *run, u32 n_triangles)
{
	static ts_gpixel plain[PIXELS], fast[PIXELS];
	static u64 keys[PIXELS];
	memcpy(keys, ts_frame_data(&run->frame, TS_B_eye_depth_triangle), sizeof keys);
	scribble(keys, n_triangles);
	ts_view view = *(const ts_view *)ts_frame_data(&run->frame, TS_B_eye_view);
	if (below(4) == 0) view.near = uniform(0.5f, 8);
	ts_gbuffer_args args = {.view = &view, .depth_triangle = keys, .pixels = plain, .samples = SAMPLES};
	args.scene = ts_run_arrays(run);
	memset(plain, 0x55, sizeof plain);
	memset(fast, 0x55, sizeof fast);
	u32 n = 1 + below(PIXELS), threads = 1 + below(4);
	ts_c_launch(TS_KERNEL_gbuffer, &args, n, 1);
	args.pixels = fast;
	assert_true(ts_c_fast_gbuffer(&args, n, threads));
	assert_memory_equal(plain, fast, sizeof plain);
}

static void test_equal(void **state)
{
	(void)state;
	ts_params params;
	ts_scene *scene;
	ts_run run;
	ts_params_default(&params);
	params.width = WIDTH;
	params.height = HEIGHT;
	params.eye_samples = TS_EYE_SAMPLES_4;
	assert_int_equal(ts_scene_open(&scene, "dining:triangles=10000:texels=32", &params, NULL), TS_OK);
	ts_run_begin(&run, scene, &params, 1);
	static const char *const stages[] = {"eye.view", "pose", "eye"};
	for (u32 i = 0; i < 3; i++) assert_int_equal(ts_run_stage(&run, ts_stage_find(stages[i])), TS_OK);
	for (u32 i = 0; i < N; i++) check(&run, scene->n_triangles);
	ts_run_end(&run);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(test_equal)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
