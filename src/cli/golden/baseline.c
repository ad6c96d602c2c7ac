/* Known differences, and what is skipped. */
#include "cli/golden/baseline.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "model/core.h"
#include "model/input.h"
#include "study/asked/words.h"
#include "trace/emitted/emit.h"

enum { MOST_BYTES = 1 << 24 };

const ts_entry *ts_baseline_find(const ts_baseline *b, const char *name, const char *buffer)
{
	for (size_t i = 0; i < b->n; i++) {
		const ts_entry *e = &b->entry[i];
		if (strcmp(e->name, name) == 0 && (buffer == NULL || strcmp(e->buffer, buffer) == 0)) return e;
	}
	return NULL;
}

/* The next word of *rest, ended by a 0; "" if there is none. */
static char *word(char **rest)
{
	char *at = *rest + strspn(*rest, " \t"), *end = at + strcspn(at, " \t");
	*rest = end + (*end != 0);
	*end = 0;
	return at;
}

static ts_status find_buffer(ts_buffer_id *buffer, const char *name)
{
	u32 id = 0;
	ts_nearest nearest = ts_nearest_begin(name);
	for (; id < TS_N_BUFFERS && strcmp(ts_buffer_table[id].name, name) != 0; id++) {
		ts_nearest_offer(&nearest, ts_buffer_table[id].name);
	}
	*buffer = (ts_buffer_id)id;
	return id < TS_N_BUFFERS ? TS_OK : ts_fail("no buffer \"%.60s\"%s", name, ts_nearest_hint(&nearest, NULL));
}

static ts_status check_stage(const ts_entry *e, ts_buffer_id buffer, const ts_pipeline *pipeline)
{
	const char *maker = ts_emit_maker(pipeline, buffer);
	ts_nearest nearest = ts_nearest_begin(e->stage);
	ts_nearest_offer(&nearest, "scene");
	for (const ts_step *s = ts_pipeline_steps(pipeline); s->stage != NULL; s++) ts_nearest_offer(&nearest, s->stage);
	if (nearest.distance != 0) {
		return ts_fail("no stage \"%.60s\" of %s%s", e->stage, pipeline->name, ts_nearest_hint(&nearest, NULL));
	}
	if (strcmp(maker, e->stage) == 0) return TS_OK;
	return ts_fail("%s is made by the stage %s, not by %s", e->buffer, maker, e->stage);
}

/* How a list is read: of differences, or of names. */
typedef struct {
	ts_baseline_case *find; /* NULL: of names, */
	ts_baseline_named *check;
	const void *user;
} reading;

static ts_status read_difference(ts_entry *e, const reading *r, char **rest)
{
	const char *effect, *method;
	ts_buffer_id buffer;
	e->stage = word(rest);
	e->buffer = word(rest);
	if (r->find(r->user, e->name, &effect, &method) != TS_OK || find_buffer(&buffer, e->buffer) != TS_OK) {
		return TS_ERROR;
	}
	return check_stage(e, buffer, ts_pipeline_find(effect, method));
}

static ts_status read_entry(ts_baseline *b, const reading *r, u32 line, char *text)
{
	void *entries = b->entry;
	ts_entry e = {.line = line};
	char *rest = text;
	e.name = word(&rest);
	ts_status status = r->find != NULL ? read_difference(&e, r, &rest) : r->check(r->user, e.name);
	e.reason = rest + strspn(rest, " \t");
	if (status != TS_OK) return status;
	if (e.reason[0] == 0) {
		return ts_fail("no reason; write %s REASON", r->find != NULL ? "CASE STAGE BUFFER" : "NAME");
	}
	const ts_entry *other = ts_baseline_find(b, e.name, e.buffer);
	if (other != NULL) return ts_fail("%s again; line %u has it", e.name, (unsigned)other->line);
	status = ts_grow(&entries, &b->capacity, b->n + 1, sizeof *b->entry, "a list of what is known");
	b->entry = entries;
	if (status == TS_OK) b->entry[b->n++] = e;
	return status;
}

static ts_status read_list(ts_baseline *b, const char *path, const reading *r)
{
	size_t bytes;
	u32 number = 1;
	*b = (ts_baseline){.path = path};
	b->text = ts_text_read(&bytes, path, MOST_BYTES);
	if (b->text == NULL) return TS_ERROR;
	if (strlen(b->text) != bytes) return ts_fail("%s: a byte that is no text", path);
	for (char *line = b->text, *end; *line != 0; line = end, number++) {
		end = line + strcspn(line, "\n");
		if (*end != 0) *end++ = 0;
		line[strcspn(line, "\r")] = 0;
		for (char *tab = line; (tab = strchr(tab, '\t')) != NULL;) *tab = ' ';
		ts_line_clean(line);
		if (line[0] == '#' || line[strspn(line, " ")] == 0) continue;
		if (read_entry(b, r, number, line) != TS_OK)
			return ts_fail("%s:%u: %s", path, (unsigned)number, ts_error_message());
	}
	return TS_OK;
}

ts_status ts_baseline_read(ts_baseline *b, const char *path, ts_baseline_case *find, const void *user)
{
	return read_list(b, path, &(reading){find, NULL, user});
}

ts_status ts_baseline_skips(ts_baseline *b, const char *path, ts_baseline_named *check, const void *user)
{
	return read_list(b, path, &(reading){NULL, check, user});
}

void ts_baseline_free(ts_baseline *b)
{
	free(b->text);
	free(b->entry);
	*b = (ts_baseline){.n = 0};
}
