/* Streaming comparison of two traces. */
#include "compare.h"
#include <inttypes.h>
#include <stdio.h>
#include "../kernels/num.h"
#include "decided.h"
#include "emit.h"
#include "reader.h"
#include "tie.h"

typedef struct {
	ts_verdict *verdict;
	ts_buffer_id id;
	ts_fields fields;
	bool ignored[TS_MAX_FIELDS];
	const ts_order *order;
	const ts_relaxations *relaxations;
	ts_ties *ties;         /* NULL: the candidate has no freedom here */
	ts_decided decided;
	ts_reader *ref, *cand;
	u32 mask_every;        /* elements a pixel that the mask speaks of; 0: it does not */
} judge;

static bool is_close(const ts_relaxations *r, u64 a, u64 b)
{
	i64 ulps = ts_field_ulps(a, b);
	if (ulps == INT64_MAX) return false;
	double x = (double)ts_u2f((u32)a), y = (double)ts_u2f((u32)b), apart = x > y ? x - y : y - x;
	double size = x < 0 ? -x : x;
	return (u64)(ulps < 0 ? -ulps : ulps) <= r->ulp || (r->abs > 0 && apart <= r->abs) ||
	       (r->rel > 0 && apart <= r->rel * size);
}

/* The candidate's bits, with an index into the points as the reference counts them. */
static u64 mapped(const judge *j, const ts_field *field, u64 bits)
{
	if (!j->order->given || field->of == NULL || strcmp(field->of, "N") != 0) return bits;
	u32 index = (u32)bits;
	if (field->bytes == 8) return bits == TS_EMPTY ? bits : (bits & ~(u64)0xffffffffu) | ts_order_map(j->order, index);
	return index == TS_NONE ? bits : ts_order_map(j->order, index);
}

/* The floats of two values: their own, or the depths of keys that name the same thing. False: there are none. */
static bool floats_of(const ts_field *field, const ts_difference *d, u64 *ref, u64 *cand)
{
	bool key = field->bytes == 8 && field->of != NULL && d->ref != TS_EMPTY && d->cand != TS_EMPTY;
	*ref = key ? d->ref >> 32 : d->ref;
	*cand = key ? d->cand >> 32 : d->cand;
	return field->kind == 'f' || (key && (u32)d->ref == (u32)d->cand);
}

static void note_worst(judge *j, const ts_difference *d, u64 ref, u64 cand)
{
	i64 ulps = ts_field_ulps(ref, cand);
	i64 worst = j->verdict->worst_ulps;
	if ((ulps < 0 ? -ulps : ulps) <= (worst < 0 ? -worst : worst)) return;
	j->verdict->worst_ulps = ulps;
	j->verdict->worst = *d;
}

typedef enum { EQUAL, RELAXED, DIFFERENT } outcome;

/* One component; the first that differs is noted. TS_ERROR only if a file could not be read. */
static ts_status judge_value(judge *j, const ts_difference *d, outcome *result)
{
	const ts_field *field = &j->fields.field[d->field];
	bool tied = false;
	*result = EQUAL;
	if (d->ref == d->cand && !(field->kind == 'f' && ts_field_is_nan(d->cand))) return TS_OK;
	if (j->ties != NULL && ts_tie_allows(j->ties, d->element, d->ref, d->cand, &tied) != TS_OK) return TS_ERROR;
	j->verdict->n_tied += tied;
	if (tied) return TS_OK;
	u64 ref, cand;
	*result = DIFFERENT;
	if (!floats_of(field, d, &ref, &cand)) return TS_OK;
	note_worst(j, d, ref, cand);
	if (is_close(j->relaxations, ref, cand)) *result = RELAXED;
	return TS_OK;
}

static ts_status judge_element(judge *j, u64 element, const void *ref, const void *cand)
{
	outcome worst = EQUAL, result;
	ts_difference first = {.element = element};
	for (u32 f = 0; f < j->fields.n; f++) {
		const ts_field *field = &j->fields.field[f];
		for (u32 c = 0; c < field->count && !j->ignored[f]; c++) {
			ts_difference d = {element, f, c, ts_field_bits(field, ref, c), mapped(j, field, ts_field_bits(field, cand, c))};
			if (judge_value(j, &d, &result) != TS_OK) return TS_ERROR;
			if (result == DIFFERENT && worst != DIFFERENT) first = d;
			worst = result > worst ? result : worst;
		}
	}
	bool decided = true;
	if (worst == DIFFERENT && ts_decided_is(&j->decided, element, &decided) != TS_OK) return TS_ERROR;
	j->verdict->n_relaxed += worst == RELAXED;
	j->verdict->n_undecided += !decided;
	if (worst != DIFFERENT || !decided) return TS_OK;
	if (!j->verdict->has_first) j->verdict->first = first;
	j->verdict->has_first = true;
	j->verdict->n_different++;
	if (j->verdict->marks != NULL) j->verdict->marks[element] = 1;
	return TS_OK;
}

static bool is_masked(const judge *j, u64 element)
{
	return j->mask_every != 0 && j->relaxations->mask[element / j->mask_every] == 0;
}

/* Elements of both, in the same order; equal bytes are passed over at once. */
static ts_status judge_sequence(judge *j, u64 n)
{
	size_t bytes = ts_buffer_table[j->id].element_bytes;
	u64 held_ref, held_cand, held;
	bool plain = !j->order->given && j->mask_every == 0;
	for (u64 i = 0; i < n; i += held) {
		const u8 *ref = ts_reader_at(j->ref, i, &held_ref);
		const u8 *cand = ref != NULL ? ts_reader_at(j->cand, i, &held_cand) : NULL;
		if (cand == NULL) return TS_ERROR;
		held = held_ref < held_cand ? held_ref : held_cand;
		held = held < n - i ? held : n - i;
		if (plain && memcmp(ref, cand, held * bytes) == 0) continue;
		for (u64 k = 0; k < held; k++) {
			if (is_masked(j, i + k)) {
				j->verdict->n_masked++;
			} else if (judge_element(j, i + k, ref + k * bytes, cand + k * bytes) != TS_OK) {
				return TS_ERROR;
			}
		}
	}
	return TS_OK;
}

/* Records that find each other by their keys. */
static ts_status judge_set(judge *j)
{
	const ts_order *order = j->order;
	u64 held;
	ts_verdict *v = j->verdict;
	v->n_missing = order->n_missing;
	v->n_extra = order->n_extra;
	v->missing_key = order->missing;
	v->extra_key = order->extra;
	v->n_different = order->n_missing + order->n_extra;
	for (u64 i = 0; i < order->n_ref; i++) {
		if (order->cand_of_ref[i] == TS_NONE) continue;
		const void *ref = ts_reader_at(j->ref, i, &held);
		const void *cand = ref != NULL ? ts_reader_at(j->cand, order->cand_of_ref[i], &held) : NULL;
		if (cand == NULL || judge_element(j, i, ref, cand) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Sizes that follow from what was computed, not from the scene and the parameters. */
static bool is_counted(ts_buffer_id id) { return strchr("QNPC", ts_buffer_table[id].shape[0]) != NULL; }

static ts_status check_shapes(ts_buffer_id id, const ts_trace_item *ref, const ts_trace_item *cand)
{
	bool same = memcmp(ref->crop, cand->crop, sizeof ref->crop) == 0;
	for (u32 i = is_counted(id) ? 1 : 0; i < ref->npy.n_dims; i++) same &= ref->npy.shape[i] == cand->npy.shape[i];
	if (same) return TS_OK;
	char text[2][128];
	for (u32 t = 0; t < 2; t++) {
		const ts_npy *npy = t == 0 ? &ref->npy : &cand->npy;
		size_t used = 0;
		for (u32 i = 0; i < npy->n_dims; i++) {
			used += (size_t)snprintf(text[t] + used, sizeof text[t] - used, "%s%" PRIu64, i ? " x " : "", npy->shape[i]);
		}
	}
	return ts_fail("%s: shape %s; the reference's is %s", cand->path, text[1], text[0]);
}

static bool is_listed(const char *list, const char *name)
{
	size_t n = strlen(name);
	for (const char *at = list; at != NULL; at = strchr(at, ',') != NULL ? strchr(at, ',') + 1 : NULL) {
		if (strncmp(at, name, n) == 0 && (at[n] == ',' || at[n] == 0)) return true;
	}
	return false;
}

static void find_ignored(judge *j)
{
	char name[128];
	for (u32 f = 0; f < j->fields.n; f++) {
		snprintf(name, sizeof name, "%s.%s", ts_buffer_table[j->id].name, j->fields.field[f].name);
		j->ignored[f] = is_listed(j->relaxations->ignore, name);
	}
}

/* Elements a pixel, where rows and columns are the mask's. */
static u32 elements_a_pixel(ts_buffer_id id, const ts_trace_item *item, const ts_relaxations *r)
{
	const u64 *shape = item->npy.shape;
	if (r->mask == NULL || strncmp(ts_buffer_table[id].shape, "H W", 3) != 0) return 0;
	if (shape[0] != r->mask_height || shape[1] != r->mask_width) return 0;
	return item->npy.n_dims > 2 ? (u32)shape[2] : 1;
}

static ts_status open_readers(judge *j, const ts_trace_item *ref, const ts_trace_item *cand)
{
	size_t bytes = ts_buffer_table[j->id].element_bytes;
	j->ref = ts_reader_open(ref->path, ref->npy.data_at, ref->npy.n, bytes);
	j->cand = j->ref != NULL ? ts_reader_open(cand->path, cand->npy.data_at, cand->npy.n, bytes) : NULL;
	return j->cand != NULL ? TS_OK : TS_ERROR;
}

ts_status ts_compare_buffer(ts_verdict *verdict, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                            const ts_order *order, const ts_relaxations *relaxations)
{
	const ts_trace_item *ref = &reference->item[id], *cand = &candidate->item[id];
	bool set = order->given && strcmp(ts_buffer_table[id].order, "set") == 0;
	ts_ties ties = {.reference = NULL};
	*verdict = (ts_verdict){.n_ref = ref->npy.n, .n_cand = cand->npy.n, .marks = verdict->marks};
	if (check_shapes(id, ref, cand) != TS_OK) return TS_ERROR;
	judge j = {.verdict = verdict, .id = id, .fields = ts_fields_of(id), .order = order, .relaxations = relaxations,
	           .mask_every = elements_a_pixel(id, ref, relaxations), .decided = {.margin = TS_N_BUFFERS}};
	find_ignored(&j);
	ts_status status = open_readers(&j, ref, cand);
	if (status == TS_OK && order->given && id == TS_B_splat_depth_index) {
		status = ts_ties_open(&ties, reference);
		j.ties = &ties;
	}
	if (status == TS_OK && relaxations->decided) status = ts_decided_open(&j.decided, reference, id);
	u64 n = ref->npy.n < cand->npy.n ? ref->npy.n : cand->npy.n;
	if (status == TS_OK) status = set ? judge_set(&j) : judge_sequence(&j, n);
	if (!set) verdict->n_different += ref->npy.n + cand->npy.n - 2 * n;
	verdict->judgement = verdict->n_different > relaxations->allow ? TS_UNLIKE : TS_SAME;
	ts_ties_close(&ties);
	ts_decided_close(&j.decided);
	ts_reader_close(j.ref);
	ts_reader_close(j.cand);
	return status;
}

static void count(ts_comparison *c, ts_buffer_id id)
{
	ts_judgement judgement = c->verdict[id].judgement;
	c->n_judged += judgement == TS_SAME || judgement == TS_UNLIKE;
	c->n_unlike += judgement == TS_UNLIKE;
	c->n_missing += judgement == TS_MISSING;
	if (judgement == TS_UNLIKE && c->first == TS_N_BUFFERS) c->first = id;
}

static ts_status judge_one(ts_comparison *c, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                           const ts_order *order, const ts_relaxations *relaxations)
{
	ts_verdict *v = &c->verdict[id];
	ts_status status = TS_OK;
	if (reference->item[id].path == NULL) return TS_OK;
	if (is_listed(relaxations->ignore, ts_buffer_table[id].name)) {
		v->judgement = TS_IGNORED;
	} else if (candidate->item[id].path == NULL) {
		v->judgement = TS_MISSING;
	} else {
		status = ts_compare_buffer(v, id, reference, candidate, order, relaxations);
	}
	count(c, id);
	return status;
}

static ts_status judge_all(ts_comparison *c, const ts_trace *reference, const ts_trace *candidate, const ts_order *order,
                           const ts_relaxations *relaxations)
{
	for (u32 number = 0; number <= TS_N_BUFFERS; number++) {
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			if (ts_emit_number(reference->pipeline, (ts_buffer_id)id) != number) continue;
			ts_status status = judge_one(c, (ts_buffer_id)id, reference, candidate, order, relaxations);
			if (status != TS_OK) return status;
		}
	}
	return TS_OK;
}

ts_status ts_compare(ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate,
                     const ts_relaxations *relaxations)
{
	ts_order order;
	*comparison = (ts_comparison){.first = TS_N_BUFFERS};
	if (reference->pipeline != candidate->pipeline) {
		return ts_fail("%s: a trace of %s; the reference's is of %s", candidate->dir, candidate->pipeline->name,
		               reference->pipeline->name);
	}
	if (reference->arrival) return ts_fail("%s: in order of arrival, so it is no reference", reference->dir);
	ts_status status = ts_order_make(&order, reference, candidate);
	if (status == TS_OK) status = judge_all(comparison, reference, candidate, &order, relaxations);
	ts_order_free(&order);
	if (status != TS_OK) return status;
	if (comparison->n_judged == 0) {
		return ts_fail("%s: no buffer that the reference has too: nothing to judge", candidate->dir);
	}
	return comparison->n_unlike > 0 ? TS_DIFFERENT : TS_OK;
}
