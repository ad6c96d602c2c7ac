/* libFuzzer on glTF files: `make fuzz`. By hand, for longer, or with a file to try again instead of the folders:
 *   make config=fuzz build/fuzz/tests/fuzz/gltf
 *   build/fuzz/tests/fuzz/gltf -max_total_time=3600 build/fuzz/corpus/gltf build/fuzz/seeds/gltf
 * Each input becomes a file, .glb or .gltf by its first byte, which is opened with two mirrors and described. */
#include "scene/scene.h"
#include "tests/fuzz/folder.h"

static const char *text, *binary;
static FILE *nowhere;

static void begin(void)
{
	nowhere = fopen("/dev/null", "w");
	if (nowhere == NULL) abort();
	fuzz_begin();
	text = fuzz_name("scene.gltf");
	binary = fuzz_name("scene.glb");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	ts_params params;
	ts_scene *scene;
	if (nowhere == NULL) begin();
	const char *path = n > 0 && data[0] == 'g' ? binary : text;
	fuzz_write(path, data, n);
	ts_params_default(&params);
	params.reflectors_count = 2;
	if (ts_scene_load(&scene, path, &params, NULL) == TS_OK) {
		assert(ts_scene_print(scene, nowhere, 0) == TS_OK && ts_scene_print(scene, nowhere, 1) == TS_OK);
		ts_scene_free(scene);
	} else {
		assert(scene == NULL);
		fuzz_refused();
	}
	return 0;
}
