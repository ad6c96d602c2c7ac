/* libFuzzer on the keyframes of an eye: `make fuzz`. An accepted file gives the eye of each frame as
 * <touchstone/records.def> promises it; the parameter eye.fov changes nothing but the field of view. */
#include <math.h>
#include "scene/build.h"
#include "scene/sources.h"
#include "tests/fuzz/folder.h"

static const double nearly = 1e-5;
static const char *path;

static double dot(const f32 a[3], const f32 b[3])
{
	return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static void check_axes(const ts_path_eye *at)
{
	const f32 *axis[] = {at->right, at->up, at->back};
	for (u32 i = 0; i < 3; i++) {
		assert(fabs(dot(axis[i], axis[i]) - 1) < nearly);
		assert(fabs(dot(axis[i], axis[(i + 1) % 3])) < nearly);
	}
}

static void check(const ts_scene *scene)
{
	const ts_camera *camera = &scene->cameras[0];
	const ts_path_eye *first = scene->path;
	assert(scene->n_path >= 1 && scene->n_path <= TS_PATH_MAX_FRAMES && scene->n_cameras == 1);
	assert(memcmp(camera->eye, first->eye, sizeof camera->eye) == 0);
	assert(memcmp(camera->back, first->back, sizeof camera->back) == 0 && camera->yfov == first->yfov);
	for (u32 frame = 0; frame < scene->n_path; frame++) {
		const ts_path_eye *at = &first[frame];
		double degrees = (double)at->yfov * 360;
		for (u32 i = 0; i < 3; i++) assert(fabsf(at->eye[i]) <= 0x1p24f);
		assert((degrees > 1 - nearly && degrees < 150 + nearly) || at->yfov == 0);
		assert((at->yfov == 0) == (first->yfov == 0));
		assert(at->pad0 == 0 && at->pad1 == 0 && at->pad2 == 0);
		check_axes(at);
	}
}

static void check_own_fov(const ts_scene *scene, const ts_scene *file)
{
	assert(scene->n_path == file->n_path);
	for (u32 frame = 0; frame < scene->n_path; frame++) {
		ts_path_eye at = file->path[frame];
		at.yfov = 0;
		assert(memcmp(&scene->path[frame], &at, sizeof at) == 0);
	}
}

static ts_scene *open_path(bool own_fov)
{
	ts_params params;
	ts_scene *scene;
	ts_build *build = ts_build_new("path");
	if (build == NULL) abort();
	ts_params_default(&params);
	const char *camera = ts_path_add(build, path, own_fov);
	assert((camera == NULL) == ts_build_failed(build));
	bool opened = ts_build_finish(build, &params, camera, &scene) == TS_OK;
	assert(opened == (camera != NULL));
	if (!opened) fuzz_refused();
	return scene;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	if (path == NULL) {
		fuzz_begin();
		path = fuzz_name("eye.txt");
	}
	fuzz_write(path, data, n);
	ts_scene *file = open_path(false), *own = open_path(true);
	assert((file == NULL) == (own == NULL));
	if (file != NULL && own != NULL) {
		check(file);
		check_own_fov(own, file);
	}
	ts_scene_free(file);
	ts_scene_free(own);
	return 0;
}
