/* Which row answers a question, and the message if none does. */
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include "probe/parts.h"

static const ts_probe_part *const none[] = {NULL};
static const ts_probe_part *const *used = none;

static const struct {
	const char *noun, *option;
} subjects[] = {
	[TS_PROBE_PIXEL] = {"the eye's pixels", "--pixel X,Y"},
	[TS_PROBE_TEXEL] = {"texels", "--pixel X,Y --view VIEW"},
	[TS_PROBE_TRIANGLE] = {"triangles", "--triangle T"},
	[TS_PROBE_POINT] = {"points", "--point P"},
};

const char *ts_probe_option(ts_probe_subject subject) { return subjects[subject].option; }

void ts_probe_use(const ts_probe_part *const *families) { used = families; }

const ts_probe_part *ts_probe_part_at(u32 i)
{
	for (const ts_probe_part *const *family = used; *family != NULL; family++) {
		for (const ts_probe_part *part = *family; part->answer != NULL; part++) {
			if (i-- == 0) return part;
		}
	}
	return NULL;
}

static bool is_for(const ts_probe_part *part, const ts_pipeline *pipeline)
{
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL; step++) {
		if (strcmp(step->stage, part->stage) == 0) return true;
	}
	return false;
}

/* Whether the row answers for the method; NULL: any. */
static bool answers_for(const ts_probe_part *part, const ts_pipeline *pipeline)
{
	const ts_probe_part *row;
	if (part != NULL) return is_for(part, pipeline);
	for (u32 i = 0; (row = ts_probe_part_at(i)) != NULL; i++) {
		if (is_for(row, pipeline)) return true;
	}
	return false;
}

__attribute__((format(printf, 2, 3))) static void append(char text[TS_PROBE_TEXT], const char *format, ...)
{
	size_t n = strlen(text);
	va_list values;
	va_start(values, format);
	vsnprintf(text + n, TS_PROBE_TEXT - n, format, values);
	va_end(values);
}

/* Appends the methods that the row answers for; NULL: any row; only of `effect`, unless that is NULL. */
static void append_methods(char text[TS_PROBE_TEXT], const ts_probe_part *part, const ts_effect *effect)
{
	const ts_effect *last = NULL;
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		const ts_pipeline *p = *at;
		if ((effect != NULL && p->effect != effect) || !answers_for(part, p)) continue;
		if (p->effect == last) append(text, ", %s", p->name);
		if (p->effect != last) append(text, "%s%s by %s", last != NULL ? "; " : "", p->effect->name, p->name);
		last = p->effect;
	}
}

void ts_probe_methods(char text[TS_PROBE_TEXT], const ts_probe_part *part)
{
	text[0] = 0;
	append_methods(text, part, NULL);
}

ts_status ts_probe_explains(const ts_trace *trace)
{
	char methods[TS_PROBE_TEXT] = "";
	if (answers_for(NULL, trace->pipeline)) return TS_OK;
	append_methods(methods, NULL, trace->pipeline->effect);
	return ts_fail("%s: probe explains %s; this is %s by %s, which compare and replay judge", trace->dir,
	               methods[0] != 0 ? methods : "other effects", trace->pipeline->effect->name, trace->pipeline->name);
}

/* Reads a view such as "node12.back" into index and side; false if the row's views have other names. */
static bool is_view(const ts_probe_view *view, ts_probe_question *q)
{
	size_t n = strlen(view->prefix);
	char *end;
	if (strncmp(q->view, view->prefix, n) != 0 || q->view[n] < '0' || q->view[n] > '9') return false;
	errno = 0;
	q->index = strtoull(q->view + n, &end, 10);
	if (errno != 0 || *end != '.') return false;
	for (q->side = 0; q->side < view->n_sides; q->side++) {
		if (strcmp(end + 1, view->side(q->side)) == 0 || (end[1] == (char)('0' + q->side) && end[2] == 0)) return true;
	}
	return false;
}

/* The first row that answers the question about the trace, whose view is read; NULL: none. */
static const ts_probe_part *part_for(const ts_probe *p, ts_probe_question *q)
{
	const ts_probe_part *part;
	for (u32 i = 0; (part = ts_probe_part_at(i)) != NULL; i++) {
		if (part->subject != q->subject || !is_for(part, p->trace->pipeline)) continue;
		if (part->view == NULL || is_view(part->view, q)) return part;
	}
	return NULL;
}

/* Names the questions that the trace can answer. */
static ts_status refuse(const ts_probe *p, const ts_probe_question *q)
{
	char can[TS_PROBE_TEXT] = "";
	const ts_probe_part *part;
	const ts_pipeline *pipeline = p->trace->pipeline;
	for (u32 i = 0; (part = ts_probe_part_at(i)) != NULL; i++) {
		if (!is_for(part, pipeline)) continue;
		append(can, "%s%s", can[0] != 0 ? ", " : "", subjects[part->subject].noun);
		if (part->view != NULL) append(can, " (view %s)", part->view->form);
	}
	return ts_fail("%s: probe explains no %s%s of %s by %s, only %s", p->trace->dir, q->view != NULL ? "view " : "",
	               q->view != NULL ? q->view : subjects[q->subject].noun, pipeline->effect->name, pipeline->name, can);
}

ts_status ts_probe_ask(ts_probe *p, const ts_probe_question *question, json_t **answer)
{
	ts_probe_question q = *question;
	const ts_probe_part *part = part_for(p, &q);
	*answer = NULL;
	if (part == NULL) return refuse(p, question);
	json_t *o = json_object();
	ts_status status = part->answer(p, &q, o);
	if (status == TS_OK && (p->failed || o == NULL)) status = ts_fail_as(TS_KIND_MEMORY, "out of memory");
	if (status != TS_OK) json_decref(o);
	if (status == TS_OK) *answer = o;
	return status;
}
