/* params.txt of a golden: the rendered scene and parameters. */
#include "golden/params.h"
#include <stdio.h>
#include <stdlib.h>
#include "golden/beside.h"

enum { MOST_BYTES = 16 << 10 };

static ts_status read_line(ts_golden_settings *s, char *line)
{
	char *equals = strchr(line, '=');
	if (equals == NULL) return ts_fail("\"%.60s\" is not NAME=VALUE", line);
	*equals = 0;
	const struct {
		const char *name;
		char *to;
		size_t bytes;
	} words[] = {
		{"effect", s->effect, sizeof s->effect},
		{"method", s->method, sizeof s->method},
		{"scene", s->scene, sizeof s->scene},
	};
	for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
		if (strcmp(line, words[i].name) != 0) continue;
		snprintf(words[i].to, words[i].bytes, "%s", equals + 1);
		return TS_OK;
	}
	if (ts_place_is(line)) return ts_golden_place(s, line, equals + 1);
	return ts_params_set(&s->params, line, equals + 1);
}

ts_status ts_golden_read_params(ts_golden_settings *s, const ts_golden_dir *dir)
{
	char *text, *end;
	size_t bytes;
	memset(s, 0, sizeof *s);
	ts_params_default(&s->params);
	ts_status status = ts_golden_read_file(&text, &bytes, dir, TS_GOLDEN_PARAMS, MOST_BYTES);
	if (status != TS_OK) return status;
	if (strlen(text) != bytes) status = ts_fail("a byte that is no text");
	for (char *line = text; status == TS_OK && *line != 0; line = end) {
		end = line + strcspn(line, "\n");
		if (*end != 0) *end++ = 0;
		status = read_line(s, line);
	}
	if (status != TS_OK) ts_fail("%s/%s: %s", dir->path, TS_GOLDEN_PARAMS, ts_error_message());
	free(text);
	return status;
}

ts_status ts_golden_place(ts_golden_settings *s, const char *name, const char *text)
{
	size_t used = strlen(s->places), n = strlen(name) + strlen(text) + 2;
	if (n >= sizeof s->places - used) return ts_fail("%s: the options of the scene are too long", name);
	snprintf(s->places + used, sizeof s->places - used, "%s=%s\n", name, text);
	return TS_OK;
}

static bool is_file(const char *spec)
{
	static const char *const kinds[] = {".gltf", ".glb", ".ply"};
	const char *kind = strrchr(spec, '.');
	for (size_t i = 0; i < 3 && kind != NULL; i++) {
		if (strcmp(kind, kinds[i]) == 0) return spec[0] != '/';
	}
	return false;
}

ts_status ts_golden_bound(const ts_golden_settings *s)
{
	const ts_params *p = &s->params;
	if (!ts_builtin_is(s->scene) && !is_file(s->scene)) {
		return ts_fail("\"%.60s\" is neither a built-in scene nor the path of a .gltf, .glb or .ply file from here",
		               s->scene);
	}
	if ((u64)TS_PARAM(p, width) * TS_PARAM(p, height) <= TS_GOLDEN_PIXELS && TS_PARAM(p, frame) <= TS_GOLDEN_FRAME) {
		return TS_OK;
	}
	return ts_fail("%u x %u pixels, frame %u: a golden has at most %d pixels and frame %d", TS_PARAM(p, width),
	               TS_PARAM(p, height), TS_PARAM(p, frame), TS_GOLDEN_PIXELS, TS_GOLDEN_FRAME);
}

/* The texts point into `lines`, which this splits. */
static ts_status set_places(ts_places *places, char *lines)
{
	*places = (ts_places){.options.bytes = sizeof places->options};
	for (char *state, *line = strtok_r(lines, "\n", &state); line != NULL; line = strtok_r(NULL, "\n", &state)) {
		char *text = strchr(line, '=');
		*text = 0;
		if (ts_place_set(places, line, text + 1) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static ts_status open_scene(ts_scene **scene, const ts_golden_settings *s, const char *folder, ts_golden_opener *open)
{
	char path[TS_GOLDEN_PATH + TS_GOLDEN_SCENE], lines[TS_GOLDEN_PLACES];
	ts_places places;
	bool builtin = ts_builtin_is(s->scene);
	snprintf(path, sizeof path, "%s%s%s", builtin ? "" : folder, builtin ? "" : "/", s->scene);
	memcpy(lines, s->places, sizeof lines);
	if (set_places(&places, lines) != TS_OK) return TS_ERROR;
	return open(scene, path, &s->params, &places.options);
}

ts_status ts_golden_make(ts_golden *golden, const char *name, const ts_pipeline *pipeline,
                         const ts_golden_settings *settings, const char *folder, ts_golden_opener *open,
                         const ts_how *how)
{
	ts_scene *scene;
	memset(golden, 0, sizeof *golden);
	if (open_scene(&scene, settings, folder, open) != TS_OK) return TS_ERROR;
	u64 need = ts_pipeline_estimate(pipeline, scene, &settings->params, true), limit = ts_memory_limit();
	ts_golden_job job = {pipeline, scene, &settings->params, *how};
	ts_status status = need <= limit ? ts_golden_compute(golden, &job)
	                                 : ts_fail_as(TS_KIND_MEMORY, "%s: needs about %llu MiB; %llu are there", name,
	                                              (unsigned long long)(need >> 20), (unsigned long long)(limit >> 20));
	ts_scene_free(scene);
	return status;
}
