/* libFuzzer on scene files: `make fuzz`. By hand, for longer, or with a file to try again instead of the folders:
 *   make config=fuzz build/fuzz/tests/fuzz/gltf
 *   build/fuzz/tests/fuzz/gltf -max_total_time=3600 build/fuzz/corpus/gltf scenes
 * Each input becomes a file, .glb, .ply or .gltf by its first byte, which is opened with two mirrors and described. */
#include <assert.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <touchstone/scene.h>

static char folder[] = "/tmp/touchstone-fuzz-XXXXXX";
static char path[3][64];
static FILE *nowhere;

static void clear(void)
{
	unlink(path[0]);
	unlink(path[1]);
	unlink(path[2]);
	rmdir(folder);
}

static void begin(void)
{
	nowhere = fopen("/dev/null", "w");
	if (!nowhere || !mkdtemp(folder)) abort();
	snprintf(path[0], sizeof path[0], "%s/scene.gltf", folder);
	snprintf(path[1], sizeof path[1], "%s/scene.glb", folder);
	snprintf(path[2], sizeof path[2], "%s/scene.ply", folder);
	atexit(clear);
}

static const char *keep(const uint8_t *data, size_t n)
{
	const char *to = path[n == 0 ? 0 : data[0] == 'g' ? 1 : data[0] == 'p' ? 2 : 0];
	FILE *file = fopen(to, "wb");
	if (!file || fwrite(data, 1, n, file) != n || fclose(file) != 0) abort();
	return to;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	ts_params params;
	ts_scene *scene;
	if (!nowhere) begin();
	ts_params_default(&params);
	params.reflectors_count = 2;
	if (ts_scene_open(&scene, keep(data, n), &params, NULL) == TS_OK) {
		assert(ts_scene_print(scene, nowhere, 0) == TS_OK && ts_scene_print(scene, nowhere, 1) == TS_OK);
		ts_scene_free(scene);
	} else {
		const char *message = ts_error_message();
		assert(scene == NULL && message[0] != '\0' && strchr(message, '\n') == NULL);
	}
	return 0;
}
