/* Compares a port's outputs with ours, bit by bit, and finds which well-known fault would explain them. */
#include "vectors/row.h"

static i64 ordinal(u32 u)
{
	i64 m = u & 0x7fffffffu;
	return u >> 31 != 0 ? -1 - m : m;
}

i64 ts_vector_ulps(u32 from, u32 to) { return ordinal(to) - ordinal(from); }

/* The faults that reproduce an item, as bits. */
static u32 explain(const ts_vector *v, const u32 *in, const u32 *found)
{
	u32 faults = 0, out[TS_VECTOR_WORDS];
	for (const ts_vector_variant *variant = v->variants; variant->item != NULL; variant++) {
		variant->item(out, in);
		if (memcmp(out, found, ts_vector_out_words(v) * sizeof *out) == 0) faults |= 1u << variant->fault;
	}
	return faults;
}

static u32 elements(const ts_vector *v)
{
	u32 n = 0;
	for (const ts_vector_column *c = v->out; c->name != NULL; c++) n += c->count;
	return n;
}

static u32 first_difference(const ts_vector *v, const u32 *out, const u32 *found)
{
	u32 word = 0, k = 0;
	while (out[word] == found[word]) word++;
	while (k + 1 < elements(v) && ts_vector_out_spot(v, k + 1).word <= word) k++;
	return k;
}

static bool is_nan(u32 u) { return (u & 0x7fffffffu) > 0x7f800000u; }

static u64 wide(const u32 *words) { return (u64)words[1] << 32 | words[0]; }

static i64 distance(ts_vector_type type, const u32 *out, const u32 *found)
{
	switch (type) {
	case TS_VECTOR_F32: return ts_vector_ulps(out[0], found[0]);
	case TS_VECTOR_I32: return (i64)(i32)found[0] - (i32)out[0];
	case TS_VECTOR_U32: return (i64)found[0] - out[0];
	default: return (i64)(wide(found) - wide(out));
	}
}

/* Where the first wrong item is wrong, and how far. */
static void locate(ts_vector_verdict *r, const ts_vector *v, const u32 *out, const u32 *found)
{
	r->first_element = first_difference(v, out, found);
	ts_vector_spot spot = ts_vector_out_spot(v, r->first_element);
	r->first_nan = spot.column->type == TS_VECTOR_F32 && is_nan(found[spot.word]);
	if (!r->first_nan) r->first_apart = distance(spot.column->type, out + spot.word, found + spot.word);
}

/* The fault that reproduces most items, and the fault to name for the first item, one of these. */
static void choose(ts_vector_verdict *r, u32 first_faults)
{
	u32 most = 0;
	r->fault = r->first_fault = TS_N_FAULTS;
	for (u32 f = 0; f < TS_N_FAULTS; f++) {
		if (r->n_explained[f] > most) r->fault = (ts_vector_fault)f;
		most = r->n_explained[f] > most ? r->n_explained[f] : most;
		if ((first_faults >> f & 1) != 0) r->first_fault = (ts_vector_fault)f;
	}
	if (most > 0 && (first_faults >> r->fault & 1) != 0) r->first_fault = r->fault;
}

ts_vector_verdict ts_vector_judge(const ts_vector *vector, const u32 *in, const u32 *out, const u32 *found)
{
	ts_vector_verdict r;
	memset(&r, 0, sizeof r);
	u32 first_faults = 0;
	u32 in_words = ts_vector_in_words(vector), out_words = ts_vector_out_words(vector);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++, in += in_words, out += out_words, found += out_words) {
		if (memcmp(out, found, out_words * sizeof *out) == 0) continue;
		u32 faults = explain(vector, in, found);
		if (r.n_wrong++ == 0) {
			r.first = i;
			first_faults = faults;
			locate(&r, vector, out, found);
		}
		for (u32 f = 0; f < TS_N_FAULTS; f++) r.n_explained[f] += faults >> f & 1;
	}
	choose(&r, first_faults);
	return r;
}
