/* A C backend for explanations: the items of each launch in order, on one thread. */
#include "explain/explain.h"
#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "model/core.h"

enum { MOST_BYTES = 256 };

/* A run either finds the item that gives an element its value, or records what items compute. */
typedef struct {
	ts_explanation *explanation;
	const ts_question *question;
	bool seeks;
	bool there;                  /* the buffer exists while items run */
	size_t launch, found_launch; /* found_launch: SIZE_MAX: none yet */
	u64 found_item;
} explainer;

static explainer *explaining;

static ts_explained_launch *add(ts_explanation *e, ts_kernel kernel, u64 n)
{
	void **launches = (void **)&e->launch;
	if (ts_grow(launches, &e->capacity, e->n_launches + 1, sizeof *e->launch, "launches") != TS_OK) return NULL;
	e->launch[e->n_launches] = (ts_explained_launch){.kernel = kernel, .n = n, .item = n};
	return &e->launch[e->n_launches++];
}

/* The item of this launch to record; n: none. */
static u64 asked(const explainer *x, ts_kernel kernel, u64 n)
{
	const ts_question *q = x->question;
	bool any = q->kernel == TS_N_KERNELS || q->kernel == kernel;
	if (q->subject == TS_EXPLAIN_ITEM && any && q->item < n) return q->item;
	return q->subject == TS_EXPLAIN_ELEMENT && x->launch == x->found_launch ? x->found_item : n;
}

/* Watches for stores to the element in question, if there is one. */
static void watch(explainer *x, const ts_frame *frame)
{
	const ts_question *q = x->question;
	ts_telling *t = &x->explanation->telling;
	const ts_buffer *buffer = q->subject == TS_EXPLAIN_ELEMENT ? &frame->buffer[q->buffer] : NULL;
	bool can = buffer != NULL && buffer->made && q->element < buffer->n;
	size_t bytes = can ? ts_buffer_table[q->buffer].element_bytes : 0;
	t->from = can ? (const u8 *)buffer->data + q->element * bytes : NULL;
	t->to = can ? t->from + bytes : NULL;
	x->there |= buffer != NULL && buffer->made;
}

/* The item that changes the element last gave it its value; if none changes it, the one that wrote it first. */
static void seek(explainer *x, ts_kernel kernel, const void *args, u64 n)
{
	ts_telling *t = &x->explanation->telling;
	u8 before[MOST_BYTES];
	if (t->from == NULL) {
		ts_c_items(kernel, args, 0, n);
		return;
	}
	size_t bytes = (size_t)(t->to - t->from);
	assert(bytes <= sizeof before);
	for (u64 item = 0; item < n; item++) {
		memcpy(before, t->from, bytes);
		t->stored = false;
		ts_told_item(kernel, args, item);
		bool counts = x->found_launch == SIZE_MAX || memcmp(before, t->from, bytes) != 0;
		if (!t->stored || !counts) continue;
		x->found_launch = x->launch;
		x->found_item = item;
	}
}

static ts_status record_item(explainer *x, ts_kernel kernel, const void *args, u64 n)
{
	ts_telling *t = &x->explanation->telling;
	ts_explained_launch *launch = add(x->explanation, kernel, n);
	if (launch == NULL) return TS_ERROR;
	launch->item = asked(x, kernel, n);
	launch->first_line = t->n_lines;
	ts_c_items(kernel, args, 0, launch->item);
	if (launch->item < n) {
		t->listens = true;
		ts_told_item(kernel, args, launch->item);
		t->listens = false;
		ts_c_items(kernel, args, launch->item + 1, n);
	}
	launch->n_lines = t->n_lines - launch->first_line;
	return t->failed ? TS_ERROR : TS_OK;
}

static ts_status launch(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	(void)backend;
	explainer *x = explaining;
	ts_status status = TS_OK;
	watch(x, frame);
	if (x->seeks) {
		seek(x, launch->kernel, args, n);
	} else {
		status = record_item(x, launch->kernel, args, n);
	}
	x->launch++;
	return status;
}

static ts_status run(explainer *x, const ts_stage *stage, bool seeks)
{
	ts_run *run = &x->explanation->load->run;
	x->seeks = seeks;
	x->launch = 0;
	run->c.no_fast_paths = true;
	run->c.backend.launch = launch;
	explaining = x;
	ts_told_to(&x->explanation->telling);
	return ts_replay_stage(run, stage);
}

/* Refuses an item, and names what the stage launches. */
static ts_status refuse_item(const ts_explanation *e, const ts_stage *stage, const ts_question *q)
{
	char text[512] = "";
	for (size_t i = 0; i < e->n_launches && strlen(text) < sizeof text - 80; i++) {
		size_t used = strlen(text);
		snprintf(text + used, sizeof text - used, "%s%s %" PRIu64, i > 0 ? ", " : "",
		         ts_kernel_name(e->launch[i].kernel), e->launch[i].n);
	}
	return ts_fail("stage %s: no launch has item %" PRIu64 "; items of its launches: %s", stage->name, q->item, text);
}

static ts_status answer(explainer *x, const ts_stage *stage)
{
	const ts_question *q = x->question;
	const ts_explanation *e = x->explanation;
	if (q->subject == TS_EXPLAIN_ELEMENT && run(x, stage, true) != TS_OK) return TS_ERROR;
	if (q->subject == TS_EXPLAIN_ELEMENT && x->launch > 0 && x->found_launch == SIZE_MAX) {
		return ts_fail("stage %s: no item writes element %" PRIu64 " of %s%s", stage->name, q->element,
		               ts_buffer_table[q->buffer].name,
		               x->there ? "" : "; it is made of what items leave: ask for one by its number and kernel");
	}
	if (run(x, stage, false) != TS_OK) return TS_ERROR;
	if (e->n_launches == 0) return ts_fail("stage %s: the host computes it, without a kernel", stage->name);
	for (size_t i = 0; i < e->n_launches; i++) {
		if (e->launch[i].item < e->launch[i].n) return TS_OK;
	}
	return q->subject == TS_EXPLAIN_LAUNCHES ? TS_OK : refuse_item(e, stage, q);
}

ts_status ts_explain(ts_explanation *explanation, const ts_stage *stage, const ts_question *question,
                     const ts_trace *reference, const ts_trace *candidate)
{
	*explanation = (ts_explanation){.telling = {.primitives = question->primitives, .most = question->most}};
	explainer x = {.explanation = explanation, .question = question, .found_launch = SIZE_MAX};
	if (!ts_told_here) return ts_fail("explain: built without its kernels; `make` without DEVICES= adds them");
	if (ts_replay_load(&explanation->load, stage, reference, candidate, 1) != TS_OK) return TS_ERROR;
	return answer(&x, stage);
}

void ts_explain_end(ts_explanation *explanation)
{
	ts_load_end(explanation->load);
	free(explanation->telling.lines);
	free(explanation->telling.bytes);
	free(explanation->launch);
	*explanation = (ts_explanation){.load = NULL};
}
