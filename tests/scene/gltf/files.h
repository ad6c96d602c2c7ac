/* Small glTF files that tests write and load. */
#ifndef TS_TESTS_SCENE_GLTF_FILES_H
#define TS_TESTS_SCENE_GLTF_FILES_H
#include <unistd.h>
#include "model/core.h"
#include "scene/sources.h"
#include "tests/status.h"

/* n is a multiple of 3. */
static inline void base64(char *to, const unsigned char *from, size_t n)
{
	static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	for (size_t i = 0; i < n; i += 3) {
		u32 word = 0;
		for (size_t k = 0; k < 3; k++) word = word << 8 | (i + k < n ? from[i + k] : 0);
		for (size_t k = 0; k < 4; k++) *to++ = i + k <= n ? digits[word >> (18 - 6 * k) & 63] : '=';
	}
	*to = '\0';
}

/* A build of a file with that text, failed or not. */
static inline ts_build *load_text(const char *text, const char *reflector, u32 neighbours)
{
	char path[] = "/tmp/touchstone-gltf-XXXXXX";
	int file = mkstemp(path);
	assert_true(file >= 0);
	assert_int_equal(write(file, text, strlen(text)), strlen(text));
	close(file);
	ts_build *build = ts_build_new("test");
	ts_gltf_load(build, &(ts_scene_file){.name = path}, reflector, NULL, neighbours);
	unlink(path);
	return build;
}

/* Requires that the build failed with one line that has `words` in it, and releases it. */
static inline void assert_refused(ts_build *build, const char *words)
{
	if (!ts_build_failed(build)) fail_msg("loaded; \"%s\" is expected", words);
	says(words);
	ts_build_free(build);
}

static inline bool has_note(ts_build *build, const char *words)
{
	const ts_scene *scene = ts_build_peek(build);
	for (u32 i = 0; i < scene->n_notes; i++)
		if (strstr(scene->notes[i], words)) return true;
	return false;
}

static inline void assert_note(ts_build *build, const char *words)
{
	if (!has_note(build, words)) fail_msg("no note says \"%s\"", words);
}

#endif
