/* libFuzzer on files of keyframes: `make fuzz`. An accepted file gives an eye as <touchstone/scene.h> promises it. */
#include "folder.h"
#include <math.h>
#include "../../src/scene/path.h"
#include "../../src/scene/scene.h"

static const char *path;

static double dot(const f32 a[3], const f32 b[3])
{
	return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static void check(const ts_path_eye *eye)
{
	const f32 *axis[3] = {eye->right, eye->up, eye->back};
	for (u32 i = 0; i < 3; i++) {
		assert(fabsf(eye->eye[i]) <= 16777216.0f);
		for (u32 k = 0; k <= i; k++) assert(fabs(dot(axis[i], axis[k]) - (i == k)) < 1e-5);
	}
	assert(eye->yfov == 0 || (eye->yfov >= 0.99f / 360 && eye->yfov <= 150.01f / 360));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	if (path == NULL) {
		fuzz_begin();
		path = fuzz_name("path.txt");
	}
	fuzz_write(path, data, n);
	ts_params params;
	ts_scene *scene;
	const ts_vertex corner = {.position = {0, 0, 0}};
	ts_build *build = ts_build_new("path");
	ts_params_default(&params);
	params.reflectors_count = 0;
	for (u32 i = 0; i < 3; i++) ts_build_vertex(build, &corner);
	ts_build_triangle(build, 0, 1, 2, TS_NONE);
	const char *camera = ts_path_add(build, path, n % 2 != 0);
	if (ts_build_finish(build, &params, camera, &scene) == TS_OK) {
		assert(scene->n_path > 0 && scene->n_path <= TS_PATH_MAX_FRAMES);
		for (u32 i = 0; i < scene->n_path; i++) check(&scene->path[i]);
		ts_scene_free(scene);
	} else {
		assert(scene == NULL);
		fuzz_refused();
	}
	return 0;
}
