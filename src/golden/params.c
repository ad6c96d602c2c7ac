/* params.txt of a golden: what was rendered. */
#include "params.h"
#include <stdio.h>
#include <stdlib.h>
#include "../scene/sources.h"
#include "beside.h"

enum { MOST_BYTES = 16 << 10 };

static ts_status read_line(ts_golden_said *s, char *line)
{
	char *equals = strchr(line, '=');
	if (equals == NULL) return ts_fail("\"%.60s\" is not NAME=VALUE", line);
	*equals = 0;
	const struct {
		const char *name;
		char *to;
	} words[] = {
		{"effect", s->effect},
		{"method", s->method},
		{"scene", s->scene},
	};
	for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
		if (strcmp(line, words[i].name) != 0) continue;
		snprintf(words[i].to, TS_GOLDEN_VALUE, "%s", equals + 1);
		return TS_OK;
	}
	return ts_params_set(&s->params, line, equals + 1);
}

ts_status ts_golden_read_params(ts_golden_said *s, const ts_golden_dir *dir)
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

ts_status ts_golden_bound(const ts_params *p)
{
	if ((u64)TS_PARAM(p, width) * TS_PARAM(p, height) <= TS_GOLDEN_PIXELS && TS_PARAM(p, frame) <= TS_GOLDEN_FRAME) {
		return TS_OK;
	}
	return ts_fail("%u x %u pixels, frame %u: a golden has at most %d pixels and frame %d", TS_PARAM(p, width),
	               TS_PARAM(p, height), TS_PARAM(p, frame), TS_GOLDEN_PIXELS, TS_GOLDEN_FRAME);
}

ts_status ts_golden_make(ts_golden *golden, const char *name, const ts_pipeline *pipeline, const char *builtin,
                         const ts_params *params, const ts_how *how)
{
	ts_scene *scene;
	memset(golden, 0, sizeof *golden);
	if (ts_builtin_open(&scene, builtin, params, NULL) != TS_OK) return TS_ERROR;
	u64 need = ts_pipeline_estimate(pipeline, scene, params, true), limit = ts_memory_limit();
	ts_golden_job job = {pipeline, scene, params, *how};
	ts_status status = need <= limit ? ts_golden_compute(golden, &job)
	                                 : ts_fail("%s: needs about %llu MiB; %llu are there", name,
	                                           (unsigned long long)(need >> 20), (unsigned long long)(limit >> 20));
	ts_scene_free(scene);
	return status;
}
