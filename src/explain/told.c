/* Records lines. */
#include "explain/told.h"
#include <string.h>
#include "model/core.h"

static ts_telling *telling;

void ts_told_to(ts_telling *to) { telling = to; }

/* Functions of no single kernel: ts_dot, not ts_k_splat. */
static bool is_primitive(const ts_told_site *call) { return strncmp(call->text, "ts_k_", 5) != 0; }

static bool is_heard(ts_told_how how)
{
	return telling->listens && !telling->failed && (telling->hidden == 0 || how == TS_TOLD_STORE);
}

/* A line, whose other members the caller sets; NULL: it is not kept. */
static ts_told_line *add(const ts_told_site *site)
{
	ts_telling *t = telling;
	if (t->n_lines >= t->most) {
		t->n_more++;
		return NULL;
	}
	if (ts_grow((void **)&t->lines, &t->line_capacity, t->n_lines + 1, sizeof *t->lines, "an explanation") != TS_OK) {
		t->failed = true;
		return NULL;
	}
	t->lines[t->n_lines] = (ts_told_line){.site = site, .depth = t->depth};
	return &t->lines[t->n_lines++];
}

void ts_told_call(const ts_told_site *site)
{
	if (!telling->listens) return;
	if (telling->hidden > 0 || (is_primitive(site) && !telling->primitives)) {
		telling->hidden++;
		return;
	}
	if (is_heard(TS_TOLD_CALL)) add(site);
	telling->depth++;
}

void ts_told_end(void)
{
	if (!telling->listens) return;
	if (telling->hidden > 0) {
		telling->hidden--;
	} else {
		telling->depth--;
	}
}

static void note_store(const u8 *at, size_t bytes)
{
	if (at >= telling->to || at + bytes <= telling->from) return;
	telling->stored = true;
	telling->stores = telling->n_lines;
}

void ts_told(const ts_told_site *site, const void *value)
{
	ts_telling *t = telling;
	if (site->how == TS_TOLD_STORE) note_store(value, site->type->bytes);
	if (!is_heard(site->how)) return;
	ts_told_line *line = add(site);
	if (line == NULL) return;
	size_t need = t->n_bytes + site->type->bytes;
	if (ts_grow((void **)&t->bytes, &t->byte_capacity, need, 1, "an explanation") != TS_OK) {
		t->failed = true;
		t->n_lines--;
		return;
	}
	line->at = value;
	line->value = t->n_bytes;
	memcpy(t->bytes + t->n_bytes, value, site->type->bytes);
	t->n_bytes = need;
}

bool ts_told_test(const ts_told_site *site, bool yes)
{
	ts_told_line *line = is_heard(TS_TOLD_TEST) ? add(site) : NULL;
	if (line != NULL) line->yes = yes;
	return yes;
}

void ts_told_title(const ts_told_site *site)
{
	if (is_heard(TS_TOLD_TITLE)) add(site);
}
