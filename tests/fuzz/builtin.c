/* libFuzzer on the names of built-in scenes, "atrium:triangles=1.05M:texels=64": `make fuzz`. An accepted name
 * gives a scene as large as such names can say. */
#include "scene/scene.h"
#include "scene/sources.h"
#include "tests/fuzz/folder.h"

enum { LEAST = 10000, MOST = 16000000, MOST_SIDE = 512 };

static void check(const ts_scene *scene)
{
	u32 n = scene->n_triangles + scene->n_surfels;
	assert(n >= LEAST && n <= MOST && (scene->n_triangles == 0 || scene->n_surfels == 0));
	for (u32 i = 0; i < scene->n_images; i++) {
		u32 side = scene->images[i].width;
		assert(side <= MOST_SIDE && (side & (side - 1)) == 0);
	}
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	ts_params params;
	ts_scene *scene;
	char *spec = strndup((const char *)data, n);
	if (spec == NULL) abort();
	ts_params_default(&params);
	params.reflectors_count = 0;
	if (ts_builtin_open(&scene, spec, &params, NULL) == TS_OK) {
		check(scene);
		ts_scene_free(scene);
	} else {
		assert(scene == NULL);
		fuzz_refused();
	}
	free(spec);
	return 0;
}
