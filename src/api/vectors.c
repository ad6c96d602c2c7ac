/* Arithmetic vectors in memory. */
#include <assert.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include "api/api.h"

typedef struct {
	ts_vector_info info;
	char in[TS_VECTOR_DESCR], out[TS_VECTOR_DESCR];
	ts_vector_column_info inputs[TS_VECTOR_COLUMNS], outputs[TS_VECTOR_COLUMNS];
} row;

enum { MOST_ROWS = 256 };
static row rows[MOST_ROWS];
static u32 n_rows;

static u32 describe_columns(ts_vector_column_info *info, const ts_vector_column *columns)
{
	u32 n = 0, word = 0;
	for (const ts_vector_column *c = columns; c->name != NULL; c++) {
		info[n++] = (ts_vector_column_info){c->name, c->type, c->count, word};
		word += c->count * ts_vector_type_words(c->type);
	}
	return n;
}

static void describe(row *r, const ts_vector *v, bool composed)
{
	u64 shape[TS_MAX_DIMS];
	ts_vector_in_descr(r->in, v);
	ts_vector_out_descr(r->out, v);
	r->info = (ts_vector_info){.name = v->name,
	                           .rule = v->rule,
	                           .doc = v->doc,
	                           .items = TS_VECTOR_ITEMS,
	                           .in_words = ts_vector_in_words(v),
	                           .out_words = ts_vector_out_words(v),
	                           .in_dtype = r->in,
	                           .out_dtype = r->out,
	                           .composed = composed,
	                           .record = ts_vector_gives_record(v),
	                           .n_inputs = describe_columns(r->inputs, v->in),
	                           .n_outputs = describe_columns(r->outputs, v->out),
	                           .inputs = r->inputs,
	                           .outputs = r->outputs,
	                           .n_dims = ts_vector_out_shape(shape, v)};
	memcpy(r->info.shape, shape, r->info.n_dims * sizeof *shape);
}

static void make(void)
{
	ts_api_ready();
	n_rows = ts_vectors_count();
	assert(n_rows <= MOST_ROWS);
	for (u32 i = 0; i < n_rows; i++) describe(&rows[i], ts_vectors_at(i), ts_vectors_place(i).composed);
}

const ts_vector_info *ts_vector_at(size_t i)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, make);
	return i < n_rows ? &rows[i].info : NULL;
}

static ts_status make_words(ts_api_words *words, const ts_vector *v)
{
	if (words->vector == v) return TS_OK;
	const size_t most = TS_VECTOR_ITEMS * TS_VECTOR_WORDS;
	if (words->in == NULL) words->in = ts_alloc(2 * most, sizeof *words->in, "arithmetic vectors");
	if (words->in == NULL) return TS_ERROR;
	words->out = words->in + most;
	words->vector = v;
	ts_vector_make(v, words->in, words->out);
	return TS_OK;
}

/* Makes the context, which is entered, hold the words of a primitive. */
static ts_status find(ts_context *context, const char *name)
{
	const ts_vector *v = ts_vectors_find(name);
	if (v == NULL) return ts_fail("there is no primitive \"%.60s\"; ts_vector_at names all", name);
	return make_words(&context->words, v);
}

ts_status ts_vector_words(ts_context *context, uint32_t *in, uint32_t *out, const char *primitive)
{
	if (TS_LACKS(context) || TS_LACKS(primitive) || ts_api_enter_alone(context) != TS_OK) return TS_ERROR;
	ts_status status = find(context, primitive);
	ts_api_leave();
	if (status != TS_OK) return status;
	const ts_api_words *w = &context->words;
	if (in != NULL) memcpy(in, w->in, TS_VECTOR_ITEMS * ts_vector_in_words(w->vector) * sizeof *in);
	if (out != NULL) memcpy(out, w->out, TS_VECTOR_ITEMS * ts_vector_out_words(w->vector) * sizeof *out);
	return TS_OK;
}

static void name_fault(const char **name, const char **remedy, ts_vector_fault fault)
{
	*name = fault != TS_N_FAULTS ? ts_vector_fault_table[fault].name : NULL;
	*remedy = fault != TS_N_FAULTS ? ts_vector_fault_table[fault].remedy : NULL;
}

/* Some items are wrong. */
static void report_wrong(ts_vector_judged *judged, const ts_vector *vector, const ts_vector_verdict *v)
{
	const ts_vector_spot spot = ts_vector_out_spot(vector, v->first_element);
	judged->n_wrong = v->n_wrong;
	judged->first = v->first;
	judged->first_word = spot.word;
	name_fault(&judged->fault, &judged->remedy, v->fault);
	judged->n_explained = v->fault != TS_N_FAULTS ? v->n_explained[v->fault] : 0;
	judged->first_column = (u32)(spot.column - vector->out);
	judged->first_element = spot.element;
	judged->first_nan = v->first_nan;
	judged->first_apart = v->first_apart;
	name_fault(&judged->first_fault, &judged->first_remedy, v->first_fault);
}

/* The struct's first version ended here. */
enum { LEAST_BYTES = offsetof(ts_vector_judged, n_explained) };

ts_status ts_vector_check(ts_context *context, ts_vector_judged *judged, const char *primitive, const uint32_t *found)
{
	ts_vector_verdict verdict = {.n_wrong = 0};
	if (TS_LACKS(context) || TS_LACKS(judged) || TS_LACKS(primitive) || TS_LACKS(found)) return TS_ERROR;
	ts_vector_judged result = {.bytes = judged->bytes};
	if (ts_api_room(result.bytes, LEAST_BYTES, sizeof result, "ts_vector_judged") != TS_OK) return TS_ERROR;
	if (ts_api_enter_alone(context) != TS_OK) return TS_ERROR;
	const ts_api_words *w = &context->words;
	ts_status status = find(context, primitive);
	if (status == TS_OK) verdict = ts_vector_judge(w->vector, w->in, w->out, found);
	ts_api_leave();
	if (status != TS_OK) return status;
	if (verdict.n_wrong > 0) report_wrong(&result, w->vector, &verdict);
	memcpy(judged, &result, result.bytes < sizeof result ? result.bytes : sizeof result);
	return verdict.n_wrong > 0 ? TS_DIFFERENT : TS_OK;
}
