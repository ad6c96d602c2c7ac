/* Arithmetic vectors in memory. */
#include "api.h"
#include <touchstone/vectors.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include "../vectors/vectors.h"

typedef struct {
	ts_vector_info info;
	char in[TS_VECTOR_DESCR], out[TS_VECTOR_DESCR];
} row;

static row *rows;
static u32 n_rows;

static void make(void)
{
	ts_api_ready();
	rows = ts_alloc(ts_vectors_count(), sizeof *rows, "the table of primitives");
	if (rows == NULL) return;
	n_rows = ts_vectors_count();
	for (u32 i = 0; i < n_rows; i++) {
		const ts_vector *v = ts_vectors_at(i);
		row *r = &rows[i];
		ts_vector_in_descr(r->in, v);
		ts_vector_out_descr(r->out, v);
		r->info = (ts_vector_info){v->name,
		                           v->rule,
		                           v->doc,
		                           TS_VECTOR_ITEMS,
		                           ts_vector_in_words(v),
		                           ts_vector_out_words(v),
		                           r->in,
		                           r->out,
		                           ts_vectors_place(i).composed};
	}
}

const ts_vector_info *ts_vector_at(size_t i)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, make);
	return i < n_rows ? &rows[i].info : NULL;
}

/* The words of a primitive, by free(). */
typedef struct {
	const ts_vector *vector;
	u32 *in, *out;
} words;

static ts_status find(words *w, const ts_context *context, const char *name)
{
	*w = (words){.vector = ts_vectors_find(name)};
	if (w->vector == NULL) return ts_fail("there is no primitive \"%.60s\"; ts_vector_at names all", name);
	if (ts_api_enter(context) != TS_OK) return TS_ERROR;
	w->in = ts_alloc(TS_VECTOR_ITEMS, ts_vector_in_words(w->vector) * sizeof *w->in, "inputs");
	w->out = ts_alloc(TS_VECTOR_ITEMS, ts_vector_out_words(w->vector) * sizeof *w->out, "outputs");
	if (w->in != NULL && w->out != NULL) ts_vector_make(w->vector, w->in, w->out);
	ts_api_leave();
	return w->in != NULL && w->out != NULL ? TS_OK : TS_ERROR;
}

static void drop(words *w)
{
	free(w->in);
	free(w->out);
}

ts_status ts_vector_words(ts_context *context, uint32_t *in, uint32_t *out, const char *primitive)
{
	words w;
	if (TS_LACKS(context) || TS_LACKS(primitive)) return TS_ERROR;
	ts_status status = find(&w, context, primitive);
	if (status == TS_OK && in != NULL) memcpy(in, w.in, TS_VECTOR_ITEMS * ts_vector_in_words(w.vector) * sizeof *in);
	if (status == TS_OK && out != NULL)
		memcpy(out, w.out, TS_VECTOR_ITEMS * ts_vector_out_words(w.vector) * sizeof *out);
	drop(&w);
	return status;
}

static void tell(ts_vector_judged *judged, const ts_vector *vector, const ts_vector_verdict *v)
{
	const ts_vector_fault_info *fault = v->fault != TS_N_FAULTS ? &ts_vector_fault_table[v->fault] : NULL;
	judged->n_wrong = v->n_wrong;
	judged->first = v->first;
	judged->first_word = v->n_wrong > 0 ? ts_vector_out_spot(vector, v->first_element).word : 0;
	judged->fault = fault != NULL ? fault->name : NULL;
	judged->remedy = fault != NULL ? fault->remedy : NULL;
}

ts_status ts_vector_check(ts_context *context, ts_vector_judged *judged, const char *primitive, const uint32_t *found)
{
	words w;
	if (TS_LACKS(context) || TS_LACKS(judged) || TS_LACKS(primitive) || TS_LACKS(found)) return TS_ERROR;
	ts_vector_judged told = {.bytes = judged->bytes};
	if (ts_api_options(&told, sizeof told, judged, "ts_vector_judged") != TS_OK) return TS_ERROR;
	ts_status status = find(&w, context, primitive);
	ts_vector_verdict verdict = {.n_wrong = 0};
	if (status == TS_OK) {
		verdict = ts_vector_judge(w.vector, w.in, w.out, found);
		tell(&told, w.vector, &verdict);
		memcpy(judged, &told, told.bytes < sizeof told ? told.bytes : sizeof told);
	}
	drop(&w);
	return status == TS_OK && verdict.n_wrong > 0 ? TS_DIFFERENT : status;
}
