/* params.txt of a case: what its method and a built-in scene read. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../output/file.h"
#include "../output/folder.h"
#include "../study/reads.h"
#include "golden.h"

enum { MOST_BYTES = 16 << 10, VALUE_BYTES = 64 };

static bool is_read(const ts_case *c, const char *param)
{
	return ts_reads("scene", "built-in", param) || ts_reads_method(c->pipeline, &c->params, param);
}

ts_status ts_case_write_params(const ts_case *c)
{
	char text[MOST_BYTES], value[VALUE_BYTES];
	size_t n_params, used;
	const ts_param_info *params = ts_param_table(&n_params);
	used = (size_t)snprintf(text, sizeof text, "effect=%s\nmethod=%s\nscene=%s\n", c->pipeline->effect->name,
	                        c->pipeline->name, c->scene);
	for (size_t i = 0; i < n_params && used < sizeof text; i++) {
		if (!is_read(c, params[i].name)) continue;
		ts_params_format(&c->params, i, value, sizeof value);
		used += (size_t)snprintf(text + used, sizeof text - used, "%s=%s\n", params[i].name, value);
	}
	if (used >= sizeof text) return ts_fail("%s: its parameters are too long", c->name);
	const char *path = ts_folder_file(TS_GOLDEN_PARAMS);
	return path != NULL ? ts_file_write(path, text, used) : TS_ERROR;
}

/* What a params.txt says. */
typedef struct {
	char effect[VALUE_BYTES], method[VALUE_BYTES], scene[VALUE_BYTES];
	ts_params params;
} said;

static ts_status read_line(said *s, char *line)
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
		snprintf(words[i].to, VALUE_BYTES, "%s", equals + 1);
		return TS_OK;
	}
	return ts_params_set(&s->params, line, equals + 1);
}

static ts_status read_params(said *s, const ts_golden_dir *dir)
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

static bool differs(char *text, size_t text_bytes, const char *name, const char *stored, const char *now)
{
	if (strcmp(stored, now) == 0) return false;
	snprintf(text, text_bytes, "params.txt: %s=%s, but cases.txt makes it %s", name, stored, now);
	ts_line_clean(text);
	return true;
}

ts_status ts_case_check_params(char *text, size_t text_bytes, const ts_case *c, const ts_golden_dir *dir)
{
	said s;
	if (read_params(&s, dir) != TS_OK) return TS_ERROR;
	if (differs(text, text_bytes, "effect", s.effect, c->pipeline->effect->name)) return TS_DIFFERENT;
	if (differs(text, text_bytes, "method", s.method, c->pipeline->name)) return TS_DIFFERENT;
	if (differs(text, text_bytes, "scene", s.scene, c->scene)) return TS_DIFFERENT;
	size_t n;
	const ts_param_info *params = ts_param_table(&n);
	for (size_t i = 0; i < n; i++) {
		char stored[VALUE_BYTES], now[VALUE_BYTES];
		ts_params_format(&s.params, i, stored, sizeof stored);
		ts_params_format(&c->params, i, now, sizeof now);
		if (differs(text, text_bytes, params[i].name, stored, now)) return TS_DIFFERENT;
	}
	return TS_OK;
}
