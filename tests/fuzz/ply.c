/* libFuzzer on PLY files: `make fuzz`. An accepted file gives surfels as <touchstone/scene.h> promises them. */
#include <math.h>
#include "scene/scene.h"
#include "scene/surfel.h"
#include "tests/fuzz/folder.h"

static const char *path;

static double dot(const f32 a[3], const f32 b[3])
{
	return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static void check(const ts_surfel *s)
{
	double u = dot(s->u, s->u), v = dot(s->v, s->v);
	for (u32 k = 0; k < 3; k++) {
		assert(fabsf(s->centre[k]) <= TS_SURFEL_LIMIT && isfinite(s->colour[k]) && s->colour[k] >= 0);
	}
	assert(u > 0 && v > 0 && u <= 0x1p48 && v <= 0x1p48);
	assert(fabs(dot(s->u, s->v)) <= sqrt(u) * sqrt(v) / 255);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	ts_params params;
	ts_scene *scene;
	if (path == NULL) {
		fuzz_begin();
		path = fuzz_name("scene.ply");
	}
	fuzz_write(path, data, n);
	ts_params_default(&params);
	if (ts_scene_load(&scene, path, &params, NULL) == TS_OK) {
		for (u32 i = 0; i < scene->n_surfels; i++) check(&scene->surfels[i]);
		ts_scene_free(scene);
	} else {
		assert(scene == NULL);
		fuzz_refused();
	}
	return 0;
}
