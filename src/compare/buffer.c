/* Streaming comparison of one buffer. */
#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include "compare/compare.h"
#include "compare/decided.h"
#include "compare/order.h"
#include "kernels/base/num.h"
#include "kernels/raster/eye_sample.h"
#include "trace/item.h"
#include "trace/reader.h"

enum { RUN = 256, MAX_ELEMENT = 128, MAX_FLOATS = 32 };

typedef struct {
	ts_verdict *verdict;
	ts_buffer_id id;
	const ts_trace *reference;
	size_t bytes; /* of an element */
	ts_fields fields;
	bool ignored[TS_MAX_FIELDS];
	u32 float_at[MAX_FLOATS], n_floats; /* offsets of the floats that are judged */
	const ts_order *order;
	ts_dim points; /* the elements with that order */
	const ts_relaxations *relaxations;
	const ts_tie_rule *tie;
	void *ties; /* NULL: no ties */
	ts_decided decided;
	ts_reader *ref, *cand;
	ts_gather *gather;     /* for a set in order of arrival; NULL: elements are in place */
	u32 mask_every;        /* elements per pixel of the mask; 0: no mask applies */
	bool sums;             /* judged by their counts */
	i64 ref_sum, cand_sum; /* the last ones read */
} judge;

/* True for a field of points' indices, where the order of points differs. */
static bool is_mapped(const judge *j, const ts_field *field)
{
	return j->order->given && ts_field_names(field, j->points);
}

/* Up to RUN elements of the candidate, mapped; they may be copied to `scratch`. */
static const u8 *mapped(const judge *j, const u8 *cand, u64 n, u8 *scratch)
{
	const u8 *from = cand;
	for (u32 f = 0; f < j->fields.n; f++) {
		if (!is_mapped(j, &j->fields.field[f])) continue;
		if (from == cand) memcpy(scratch, cand, n * j->bytes);
		from = scratch;
		ts_order_map_field(j->order, &j->fields.field[f], scratch, n, j->bytes);
	}
	return from;
}

/* Whether one of n floats, `apart` bytes apart, is a NaN. */
static bool has_nan(const u8 *at, u64 n, size_t apart)
{
	u32 found = 0;
	for (u64 i = 0; i < n; i++) {
		u32 word;
		memcpy(&word, at + i * apart, sizeof word);
		found |= 0x7f800000u - (word & 0x7fffffffu); /* negative only for a NaN */
	}
	return found >> 31 != 0;
}

/* Equal bytes without a NaN. */
static bool is_clean(const judge *j, const u8 *ref, const u8 *cand, u64 n)
{
	if (memcmp(ref, cand, n * j->bytes) != 0) return false;
	if (j->bytes == sizeof(f32) && j->n_floats == 1) return !has_nan(ref, n, sizeof(f32));
	for (u32 f = 0; f < j->n_floats; f++) {
		if (has_nan(ref + j->float_at[f], n, j->bytes)) return false;
	}
	return true;
}

/* The floats of two values: their own, or the depths of maps and of keys with equal names. False: there are none. */
static bool floats_of(const judge *j, const ts_difference *d, u64 *ref, u64 *cand)
{
	const ts_field *field = &j->fields.field[d->field];
	bool depth = j->id == TS_B_depth_map_depth && d->ref != TS_NONE && d->cand != TS_NONE;
	bool key = field->distance && d->ref != TS_EMPTY && d->cand != TS_EMPTY;
	*ref = key ? d->ref >> 32 : d->ref;
	*cand = key ? d->cand >> 32 : d->cand;
	return field->kind == 'f' || depth || (key && (u32)d->ref == (u32)d->cand);
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

/* Judges one component. TS_ERROR only if a file could not be read. */
static ts_status judge_value(judge *j, const ts_difference *d, outcome *result)
{
	const ts_field *field = &j->fields.field[d->field];
	bool tied = false;
	u64 ref, cand;
	*result = EQUAL;
	if (d->ref == d->cand && !(field->kind == 'f' && ts_field_is_nan(d->cand))) return TS_OK;
	if (j->ties != NULL && j->tie->allows(j->ties, d->element, d->ref, d->cand, &tied) != TS_OK) return TS_ERROR;
	j->verdict->n_tied += tied;
	if (tied) return TS_OK;
	*result = DIFFERENT;
	if (!floats_of(j, d, &ref, &cand)) return TS_OK;
	note_worst(j, d, ref, cand);
	if (ts_relax_close(j->relaxations, ref, cand)) *result = RELAXED;
	return TS_OK;
}

/* Counts an element by its worst outcome. first: its first difference; unlike: one bit per different field. */
static ts_status count_element(judge *j, outcome worst, const ts_difference *first, u32 unlike)
{
	bool decided = true;
	ts_verdict *v = j->verdict;
	if (worst == DIFFERENT && ts_decided_is(&j->decided, first->element, &decided) != TS_OK) return TS_ERROR;
	v->n_relaxed += worst == RELAXED;
	v->n_undecided += !decided;
	if (worst != DIFFERENT || !decided) return TS_OK;
	if (!v->has_first) v->first = *first;
	v->has_first = true;
	v->n_different++;
	for (u32 f = 0; f < j->fields.n; f++) v->n_field[f] += unlike >> f & 1;
	if (v->marks != NULL) v->marks[first->element] = 1;
	return ts_differences_add(&v->list, j->reference, j->id, first);
}

static ts_status judge_element(judge *j, u64 element, const void *ref, const void *cand)
{
	outcome worst = EQUAL, result;
	u32 unlike = 0;
	ts_difference first = {.element = element};
	for (u32 f = 0; f < j->fields.n; f++) {
		const ts_field *field = &j->fields.field[f];
		for (u32 c = 0; c < field->count && !j->ignored[f]; c++) {
			ts_difference d = {TS_UNEQUAL, element, f, c, ts_field_bits(field, ref, c), ts_field_bits(field, cand, c)};
			if (judge_value(j, &d, &result) != TS_OK) return TS_ERROR;
			if (result == DIFFERENT && worst != DIFFERENT) first = d;
			worst = result > worst ? result : worst;
			if (result == DIFFERENT) unlike |= 1u << f;
		}
	}
	return count_element(j, worst, &first, unlike);
}

/* Judges up to RUN sums of both, by the difference of each from the sum before it. */
static ts_status judge_sums(judge *j, u64 first, u64 n, const u8 *ref, const u8 *cand)
{
	const ts_field *field = &j->fields.field[0];
	for (u64 k = 0; k < n; k++) {
		i64 ours = (i64)ts_field_bits(field, ref + k * j->bytes, 0);
		i64 theirs = (i64)ts_field_bits(field, cand + k * j->bytes, 0);
		const ts_difference d = {
			.element = first + k, .ref = (u64)(ours - j->ref_sum), .cand = (u64)(theirs - j->cand_sum)};
		j->ref_sum = ours;
		j->cand_sum = theirs;
		if (d.ref != d.cand && count_element(j, DIFFERENT, &d, 1) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static bool is_masked(const judge *j, u64 element)
{
	const ts_relaxations *r = j->relaxations;
	return j->mask_every != 0 && r->mask[element / j->mask_every % ((u64)r->mask_width * r->mask_height)] == 0;
}

/* Judges up to RUN elements of both; equal ones are skipped together. */
static ts_status judge_run(judge *j, u64 first, u64 n, const u8 *ref, const u8 *cand)
{
	u8 scratch[RUN * MAX_ELEMENT];
	if (j->sums) return judge_sums(j, first, n, ref, cand);
	cand = mapped(j, cand, n, scratch);
	if (j->mask_every == 0 && is_clean(j, ref, cand, n)) return TS_OK;
	for (u64 k = 0; k < n; k++) {
		const u8 *a = ref + k * j->bytes, *b = cand + k * j->bytes;
		bool lacks = j->gather != NULL && j->order->cand_of_ref[first + k] == TS_NONE;
		if (is_masked(j, first + k)) {
			j->verdict->n_masked++;
		} else if (!lacks && !is_clean(j, a, b, 1) && judge_element(j, first + k, a, b) != TS_OK) {
			return TS_ERROR;
		}
	}
	return TS_OK;
}

static ts_status judge_elements(judge *j, u64 n)
{
	u64 held_ref, held_cand, held;
	for (u64 i = 0; i < n; i += held) {
		const u8 *ref = ts_reader_at(j->ref, i, &held_ref), *cand = NULL;
		if (ref == NULL) return TS_ERROR;
		cand = j->gather != NULL ? ts_gather_at(j->gather, i, &held_cand) : ts_reader_at(j->cand, i, &held_cand);
		if (cand == NULL) return TS_ERROR;
		held = held_ref < held_cand ? held_ref : held_cand;
		held = held < n - i ? held : n - i;
		held = held < RUN ? held : RUN;
		if (judge_run(j, i, held, ref, cand) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Judges records that are matched by their keys, which are therefore equal. */
static ts_status judge_set(judge *j, const ts_trace *candidate)
{
	const ts_order *order = j->order;
	const ts_trace_item *cand = &candidate->item[j->id];
	ts_verdict *v = j->verdict;
	v->n_missing = order->n_missing;
	v->n_extra = order->n_extra;
	v->n_different = order->n_missing + order->n_extra;
	if (v->n_ref != order->n_ref || v->n_cand != order->n_cand) {
		return ts_fail("%s: as many records as keys would be right, in both", cand->path);
	}
	if (ts_order_unmet(&v->list, order, j->id, j->reference, candidate) != TS_OK) return TS_ERROR;
	if (j->id == order->key) return TS_OK;
	j->gather = ts_gather_open(cand, j->id, order);
	ts_status status = j->gather != NULL ? judge_elements(j, order->n_ref) : TS_ERROR;
	ts_gather_close(j->gather);
	return status;
}

static void find_fields(judge *j)
{
	char name[128];
	for (u32 f = 0; f < j->fields.n; f++) {
		const ts_field *field = &j->fields.field[f];
		snprintf(name, sizeof name, "%s.%s", ts_buffer_table[j->id].name, field->name);
		j->ignored[f] = field->name[0] != 0 && ts_relax_ignores(j->relaxations, name);
		if (j->ignored[f] || field->kind != 'f') continue;
		assert(j->n_floats + field->count <= MAX_FLOATS);
		for (u32 c = 0; c < field->count; c++) j->float_at[j->n_floats++] = field->offset + 4 * c;
	}
}

/* Elements per pixel, or per sample of one; 0: no mask applies to the buffer. */
static u32 elements_a_pixel(ts_buffer_id id, const ts_trace_item *item, const ts_relaxations *r)
{
	if (r->mask == NULL || !ts_shape_is_image(ts_buffer_shape(id))) return 0;
	u64 elements = 1;
	for (u32 i = 2; i < item->npy.n_dims; i++) elements *= item->npy.shape[i];
	return (u32)elements;
}

static ts_status check_mask(ts_buffer_id id, const ts_trace_item *item, const ts_relaxations *r)
{
	const u64 *shape = item->npy.shape;
	if (elements_a_pixel(id, item, r) == 0) return TS_OK;
	bool samples = ts_buffer_counts(id) != TS_DIM_height && shape[0] == (u64)TS_N_EYE_SAMPLES * r->mask_height;
	if ((samples || shape[0] == r->mask_height) && shape[1] == r->mask_width) return TS_OK;
	return ts_fail("mask: %u x %u pixels; %s has %" PRIu64 " x %" PRIu64, (unsigned)r->mask_width,
	               (unsigned)r->mask_height, ts_buffer_table[id].name, shape[1], shape[0]);
}

static ts_status open_readers(judge *j, const ts_trace_item *ref, const ts_trace_item *cand)
{
	j->ref = ts_trace_read(ref, j->id);
	j->cand = j->ref != NULL ? ts_trace_read(cand, j->id) : NULL;
	return j->cand != NULL ? TS_OK : TS_ERROR;
}

ts_status ts_compare_buffer(ts_verdict *verdict, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                            const ts_order *order, const ts_relaxations *relaxations)
{
	const ts_trace_item *ref = &reference->item[id], *cand = &candidate->item[id];
	bool set = order->given && ts_order_key_of(id) == order->key;
	*verdict = (ts_verdict){.n_ref = ref->npy.n,
	                        .n_cand = cand->npy.n,
	                        .marks = verdict->marks,
	                        .list = {.items = verdict->list.items, .most = verdict->list.most}};
	if (ts_item_match(id, ref, cand) != TS_OK || check_mask(id, ref, relaxations) != TS_OK) return TS_ERROR;
	judge j = {.verdict = verdict,
	           .id = id,
	           .reference = reference,
	           .bytes = ts_buffer_table[id].element_bytes,
	           .fields = ts_fields_of(id),
	           .order = order,
	           .points = ts_order_of(),
	           .relaxations = relaxations,
	           .mask_every = elements_a_pixel(id, ref, relaxations),
	           .sums = ts_sum_of(id) != NULL,
	           .tie = ts_tie_find(id)};
	assert(j.bytes <= MAX_ELEMENT);
	find_fields(&j);
	ts_status status = open_readers(&j, ref, cand);
	if (status == TS_OK && order->given && j.tie != NULL) status = j.tie->open(&j.ties, reference);
	if (status == TS_OK && relaxations->decided) status = ts_decided_open(&j.decided, reference, id);
	u64 n = ref->npy.n < cand->npy.n ? ref->npy.n : cand->npy.n;
	if (status == TS_OK) status = set ? judge_set(&j, candidate) : judge_elements(&j, n);
	if (!set) verdict->n_different += ref->npy.n + cand->npy.n - 2 * n;
	verdict->judgement = verdict->n_different > relaxations->allow ? TS_UNLIKE : TS_SAME;
	if (j.ties != NULL) j.tie->close(j.ties);
	ts_decided_close(&j.decided);
	ts_reader_close(j.ref);
	ts_reader_close(j.cand);
	return status;
}
