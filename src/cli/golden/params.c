/* params.txt of a case: the parameters of its method and its scene. */
#include <stdio.h>
#include <string.h>
#include "cli/golden/golden.h"
#include "output/file.h"
#include "output/folder.h"
#include "study/asked/reads.h"

enum { MOST_BYTES = 16 << 10 };

static bool is_read(const ts_case *c, const char *param)
{
	const char *kind = ts_builtin_is(c->settings.scene) ? "built-in" : "file";
	return ts_reads("scene", kind, param) || ts_reads_method(c->pipeline, &c->settings.params, param);
}

ts_status ts_case_write_params(const ts_case *c)
{
	char text[MOST_BYTES], value[TS_GOLDEN_VALUE];
	size_t n_params, used;
	const ts_param_info *params = ts_param_table(&n_params);
	used = (size_t)snprintf(text, sizeof text, "effect=%s\nmethod=%s\nscene=%s\n%s", c->settings.effect,
	                        c->settings.method, c->settings.scene, c->settings.places);
	for (size_t i = 0; i < n_params && used < sizeof text; i++) {
		if (!is_read(c, params[i].name)) continue;
		ts_params_format(&c->settings.params, i, value, sizeof value);
		used += (size_t)snprintf(text + used, sizeof text - used, "%s=%s\n", params[i].name, value);
	}
	if (used >= sizeof text) return ts_fail("%s: its parameters are too long", c->name);
	const char *path = ts_folder_file(TS_GOLDEN_PARAMS);
	return path != NULL ? ts_file_write(path, text, used) : TS_ERROR;
}

static bool differs(char *text, size_t text_bytes, const char *name, const char *stored, const char *now)
{
	if (strcmp(stored, now) == 0) return false;
	snprintf(text, text_bytes, "params.txt: %s=%s, but cases.txt makes it %s", name, stored, now);
	ts_line_clean(text);
	return true;
}

/* The first line of one list that the other does not have at this place. */
static bool places_differ(char *text, size_t text_bytes, const char *stored, const char *now)
{
	while (*stored != 0 && strncmp(stored, now, strcspn(stored, "\n") + 1) == 0) {
		now += strcspn(stored, "\n") + 1;
		stored += strcspn(stored, "\n") + 1;
	}
	if (*stored == 0 && *now == 0) return false;
	snprintf(text, text_bytes, "params.txt: of the scene's options \"%.*s\", but cases.txt makes it \"%.*s\"",
	         (int)strcspn(stored, "\n"), stored, (int)strcspn(now, "\n"), now);
	ts_line_clean(text);
	return true;
}

ts_status ts_case_check_params(char *text, size_t text_bytes, const ts_case *c, const ts_golden_dir *dir)
{
	ts_golden_settings s;
	if (ts_golden_read_params(&s, dir) != TS_OK) return TS_ERROR;
	if (differs(text, text_bytes, "effect", s.effect, c->settings.effect)) return TS_DIFFERENT;
	if (differs(text, text_bytes, "method", s.method, c->settings.method)) return TS_DIFFERENT;
	if (differs(text, text_bytes, "scene", s.scene, c->settings.scene)) return TS_DIFFERENT;
	if (places_differ(text, text_bytes, s.places, c->settings.places)) return TS_DIFFERENT;
	size_t n;
	const ts_param_info *params = ts_param_table(&n);
	for (size_t i = 0; i < n; i++) {
		char stored[TS_GOLDEN_VALUE], now[TS_GOLDEN_VALUE];
		ts_params_format(&s.params, i, stored, sizeof stored);
		ts_params_format(&c->settings.params, i, now, sizeof now);
		if (differs(text, text_bytes, params[i].name, stored, now)) return TS_DIFFERENT;
	}
	return TS_OK;
}
