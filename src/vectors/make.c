/* Inputs that are biased to the extremes, from a hash of the primitive's name and a counter. */
#include <assert.h>
#include "vectors/row.h"

/* From each of these on, items are drawn in another style. */
enum { MIXED_FROM = 1024, MODERATE_FROM = 2048, BITS_FROM = 2560, FAULTS_FROM = 3072 };
enum { STREAM_TESTS = 6, MAX_TRIES = 256, NEIGHBOURS = 5 };

typedef enum { SPECIAL, EDGE, MODERATE, BITS, NEAR, N_STYLES } style;

typedef struct {
	u32 n, seed;
} source;

static u32 next(source *s) { return ts_random(s->n++, STREAM_TESTS, s->seed); }
static u32 below(source *s, u32 n) { return (u32)((u64)next(s) * n >> 32); }

/* clang-format off */
/* Zeros, denormals, the contract's thresholds, 1 and its neighbours, ties, powers of two, the largest, NaN. */
static const u32 special[] = {
	0x00000000, 0x80000000, 0x00000001, 0x80000001, 0x00400000, 0x007fffff, 0x807fffff, 0x00800000, 0x80800000,
	0x00800001, 0x00ffffff, 0x01000000, 0x0d7fffff, 0x0d800000, 0x0d800001, 0x8d7fffff, 0x8d800000, 0x2bffffff,
	0x2c000000, 0x2c000001, 0xabffffff, 0xac000000, 0x33000000, 0x33800000, 0x33800001, 0x34000000, 0x3b000000,
	0x3b800000, 0x3bc00000, 0x3e800000, 0x3eaaaaab, 0x3effffff, 0x3f000000, 0x3f000001, 0xbf000000, 0x3f2aaaab,
	0x3f7fffff, 0x3f800000, 0x3f800001, 0x3f800800, 0xbf7fffff, 0xbf800000, 0xbf800001, 0xbf801000, 0x3fb504f3,
	0x3fc00000, 0xbfc00000, 0x40000000, 0x3fffffff, 0x40200000, 0xc0200000, 0x40400000, 0x40490fdb, 0x40e00000,
	0x41200000, 0x437f8000, 0x46fffe00, 0x46ffff80, 0x47000000, 0xc7000000, 0x4a7fffff, 0x4a800000, 0x4affffff,
	0x4b000000, 0x4b000001, 0x4b400000, 0x4b7fffff, 0x4b800000, 0xcb800000, 0x4effffff, 0x4f000000, 0xcf000000,
	0xcf000001, 0x4f7fffff, 0x4f800000, 0x5e7fffff, 0x5e800000, 0x5e800001, 0xde800000, 0xde800001, 0x5f000000,
	0x7e800000, 0x7effffff, 0x7f000000, 0x7f7fffff, 0xff7fffff, 0x7f800000, 0xff800000, 0x7fc00000, 0xffc00000,
	0x7f800001, 0xff800001, 0x7fffffff, 0xffffffff,
};
/* clang-format on */
enum { N_SPECIAL = sizeof special / sizeof special[0] };

/* Maps bits to a value of the column's range. */
static u32 fold_f32(u32 u, const ts_vector_column *c)
{
	u32 low = (u32)c->low, high = (u32)c->high, sign = c->is_signed ? u & 0x80000000u : 0;
	u32 m = u & 0x7fffffffu, exponent = m >> 23;
	if (m == 0) return low == 0 ? sign : 0;
	if (exponent < low || exponent > high) exponent = low + exponent % (high - low + 1);
	m = exponent << 23 | (m & 0x7fffffu);
	return m == 0 && low != 0 ? 0 : sign | m;
}

static i64 fold_integer(u64 x, const ts_vector_column *c)
{
	u64 span = (u64)c->high - (u64)c->low + 1;
	bool in_range = c->type == TS_VECTOR_U64 || ((i64)x >= c->low && (i64)x <= c->high);
	return (i64)(in_range || span == 0 ? x : (u64)c->low + (x - (u64)c->low) % span);
}

static u32 near_edge(const ts_vector *v, u32 k)
{
	if (v->n_edges == 0) return special[k % N_SPECIAL];
	u32 u = ts_f2u(v->edges[k / NEIGHBOURS % v->n_edges]);
	return u + k % NEIGHBOURS - NEIGHBOURS / 2;
}

/* Few exponents around 1 and often few bits, so that sums are exact or ties. */
static u32 moderate_f32(source *s)
{
	u32 u = next(s), few = below(s, 24);
	u32 mantissa = (u & 0x7fffffu) >> few << few;
	return (u & 0x80000000u) | (115 + below(s, 24)) << 23 | mantissa;
}

static u32 draw_f32(source *s, const ts_vector *v, style how, u32 before)
{
	switch (how) {
	case SPECIAL: return special[below(s, N_SPECIAL)];
	case EDGE: return near_edge(v, next(s));
	case MODERATE: return moderate_f32(s);
	case NEAR: return (before ^ (next(s) & 0x80000000u)) + below(s, 5) - 2;
	default: return next(s);
	}
}

static u64 draw_special_integer(source *s, const ts_vector_column *c)
{
	u64 power = 1ull << below(s, 64), step = (u64)below(s, 3) - 1;
	switch (below(s, 6)) {
	case 0: return (u64)c->low + below(s, 2);
	case 1: return (u64)c->high - below(s, 2);
	case 2: return step;
	case 3: return 0 - power + step;
	default: return power + step;
	}
}

static u64 draw_integer(source *s, const ts_vector_column *c, style how, u64 before)
{
	u64 high = next(s), wide = high << 32 | next(s);
	switch (how) {
	case SPECIAL:
	case EDGE: return draw_special_integer(s, c);
	case MODERATE: return (u64)below(s, 2048) - 1024;
	case NEAR: return before + below(s, 3) - 1;
	default: return c->is_signed ? (u64)((i64)wide >> below(s, 64)) : wide >> below(s, 2) * below(s, 64);
	}
}

static void draw_column(source *s, const ts_vector *v, const ts_vector_column *c, style how, const u32 *first, u32 *at)
{
	u32 words = ts_vector_type_words(c->type);
	for (u32 e = 0; e < c->count; e++, at += words) {
		style own = how == N_STYLES ? (style)below(s, N_STYLES) : how;
		u32 back = at > first ? below(s, (u32)(at - first)) + 1 : 0;
		if (c->type == TS_VECTOR_F32) {
			*at = fold_f32(draw_f32(s, v, own, back != 0 ? at[-(ptrdiff_t)back] : next(s)), c);
		} else {
			bool wide = words == 2 && back > 1;
			u64 before = wide ? ts_row_u64(at - back, 0) : back != 0 ? (u64)(i32)at[-(ptrdiff_t)back] : next(s);
			i64 x = fold_integer(draw_integer(s, c, own, before), c);
			at[0] = (u32)x;
			if (words == 2) at[1] = (u32)((u64)x >> 32);
		}
	}
}

/* Single floats first run through all special values, then through all edges. */
static bool enumerate(const ts_vector *v, u32 i, u32 *row)
{
	const ts_vector_column *c = v->in;
	if (c[0].type != TS_VECTOR_F32 || c[0].count != 1 || c[1].name != NULL) return false;
	if (i >= N_SPECIAL + v->n_edges * NEIGHBOURS) return false;
	row[0] = fold_f32(i < N_SPECIAL ? special[i] : near_edge(v, i - N_SPECIAL), c);
	return true;
}

/* The value, or the nearest in the column's range. */
static u32 limit_f32(u32 u, const ts_vector_column *c)
{
	u32 exponent = u >> 23 & 255, sign = c->is_signed ? u & 0x80000000u : 0;
	if (exponent < (u32)c->low || (u & 0x7fffffffu) == 0) return c->low == 0 ? u : 0;
	return exponent > (u32)c->high ? sign | (u32)c->high << 23 | 0x7fffffu : u;
}

static void limit_row(const ts_vector *v, u32 *row)
{
	for (const ts_vector_column *c = v->in; c->name != NULL; c++) {
		for (u32 k = 0; k < c->count && c->type == TS_VECTOR_F32; k++) row[k] = limit_f32(row[k], c);
		row += c->count * ts_vector_type_words(c->type);
	}
}

static void draw_row(source *s, const ts_vector *v, u32 i, u32 *row)
{
	style how = i < MIXED_FROM ? SPECIAL : i < MODERATE_FROM ? N_STYLES : i < BITS_FROM ? MODERATE : BITS;
	u32 *at = row;
	if (i >= FAULTS_FROM) how = below(s, 2) == 0 ? N_STYLES : MODERATE;
	for (const ts_vector_column *c = v->in; c->name != NULL; c++) {
		draw_column(s, v, c, how, row, at);
		at += c->count * ts_vector_type_words(c->type);
	}
	if (v->relate != NULL) v->relate(row, next(s));
	limit_row(v, row);
}

static bool is_finite(const ts_vector *v, const u32 *out)
{
	for (const ts_vector_column *c = v->out; c->name != NULL; c++) {
		for (u32 k = 0; k < c->count && c->type == TS_VECTOR_F32; k++) {
			if ((out[k] & 0x7fffffffu) >= 0x7f800000u) return false;
		}
		out += c->count * ts_vector_type_words(c->type);
	}
	return true;
}

/* From FAULTS_FROM on each fault in turn must show; but libm, which differs between systems, chooses no input. */
static bool shows_fault(const ts_vector *v, u32 i, const u32 *row, const u32 *out)
{
	u32 n = 0, faulty[TS_VECTOR_WORDS];
	while (v->variants[n].item != NULL) n++;
	if (i < FAULTS_FROM || n == 0 || v->variants[i % n].fault == TS_FAULT_BUILTIN) return true;
	v->variants[i % n].item(faulty, row);
	return memcmp(faulty, out, ts_vector_out_words(v) * sizeof *out) != 0;
}

static u32 seed_of(const char *name)
{
	u32 h = 0;
	for (; *name != 0; name++) h = ts_pcg(h ^ (u8)*name);
	return h;
}

void ts_vector_make(const ts_vector *vector, u32 *in, u32 *out)
{
	source s = {0, seed_of(vector->name)};
	u32 in_words = ts_vector_in_words(vector), out_words = ts_vector_out_words(vector);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
		u32 *row = in + (size_t)i * in_words, *result = out + (size_t)i * out_words;
		bool good = enumerate(vector, i, row);
		if (good) vector->item(result, row);
		good = good && is_finite(vector, result);
		for (u32 n = 0; !good; n++) {
			draw_row(&s, vector, n < MAX_TRIES ? i : BITS_FROM, row);
			vector->item(result, row);
			good = is_finite(vector, result) && (n >= MAX_TRIES || shows_fault(vector, i, row, result));
		}
	}
}
