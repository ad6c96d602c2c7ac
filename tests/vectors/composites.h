/* What the tests of composites share: each function against an independent truth in double precision, item by item, and
 * a point's closest one of a triangle. */
#ifndef TS_TESTS_VECTORS_COMPOSITES_H
#define TS_TESTS_VECTORS_COMPOSITES_H
#include "tests/kernels/seeded.h"
#include "tests/model/test.h"
#include "vectors/relate.h"

/* Items whose answer hangs on rounding are not judged; of a composite an eighth must be. */
typedef enum { NOT_JUDGED, RIGHT, WRONG } judgement;

typedef struct {
	const char *name;
	judgement (*judge)(const u32 *in, const u32 *out);
} composite;
#define COMPOSITE(name) {#name, name},

static inline judgement right_if(bool right) { return right ? RIGHT : WRONG; }
static inline bool is_near(double a, double b, double tolerance) { return fabs(a - b) <= tolerance; }
static inline double3 d3_row(const u32 *row, u32 k) { return d3_of(ts_row_v3(row, k)); }

static inline void judge_all(const composite *composites, u32 n)
{
	static _Alignas(8) u32 in[TS_VECTOR_ITEMS * TS_VECTOR_WORDS], out[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];
	u32 n_wrong = 0, n_idle = 0;
	for (u32 c = 0; c < n; c++) {
		const ts_vector *v = ts_vectors_find(composites[c].name);
		u32 made[3] = {0}, in_words = ts_vector_in_words(v), out_words = ts_vector_out_words(v);
		ts_vector_make(v, in, out);
		for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
			judgement j = composites[c].judge(in + (size_t)i * in_words, out + (size_t)i * out_words);
			made[j]++;
			if (j == WRONG && made[WRONG] == 1) print_error("%s: item %u is wrong\n", v->name, i);
		}
		if (made[WRONG] != 0 || made[RIGHT] < TS_VECTOR_ITEMS / 8)
			print_error("%s: %u right, %u wrong, %u not judged\n", v->name, made[RIGHT], made[WRONG], made[NOT_JUDGED]);
		n_wrong += made[WRONG];
		n_idle += made[RIGHT] < TS_VECTOR_ITEMS / 8;
	}
	assert_int_equal(n_wrong, 0);
	assert_int_equal(n_idle, 0);
}

static inline double3 on_segment(double3 p, double3 a, double3 b)
{
	double3 u = d3_sub(b, a);
	double uu = d3_dot(u, u), k = uu > 0 ? d3_dot(d3_sub(p, a), u) / uu : 0;
	return d3_mad(a, u, fmin(fmax(k, 0), 1));
}

static inline double3 nearer(double3 p, double3 a, double3 b) { return d3_distance(p, b) < d3_distance(p, a) ? b : a; }

static inline double3 on_border(double3 p, double3 a, double3 b, double3 c)
{
	return nearer(p, nearer(p, on_segment(p, a, b), on_segment(p, b, c)), on_segment(p, c, a));
}

/* The foot of the perpendicular if the triangle holds it, else the nearest point of the border. */
static inline double3 on_triangle(double3 p, double3 a, double3 b, double3 c)
{
	double3 n = d3_cross(d3_sub(b, a), d3_sub(c, a)), border = on_border(p, a, b, c);
	double nn = d3_dot(n, n);
	if (!(nn > 0)) return border;
	double3 foot = d3_mad(p, n, d3_dot(d3_sub(a, p), n) / nn);
	bool ab = d3_dot(d3_cross(d3_sub(b, a), d3_sub(foot, a)), n) >= 0;
	bool bc = d3_dot(d3_cross(d3_sub(c, b), d3_sub(foot, b)), n) >= 0;
	bool ca = d3_dot(d3_cross(d3_sub(a, c), d3_sub(foot, c)), n) >= 0;
	return ab && bc && ca ? foot : border;
}

/* Height over the longest edge, as a share of that edge: how far a triangle is from a needle. */
static inline double fatness(double3 a, double3 b, double3 c)
{
	double l = fmax(fmax(d3_distance(a, b), d3_distance(b, c)), d3_distance(c, a));
	return l > 0 ? d3_length(d3_cross(d3_sub(b, a), d3_sub(c, a))) / (l * l) : 0;
}

/* Rounding moves places that are at most 32 from the middle, and 64 from each other, by so much. */
#define PLACE_ERROR 4e-4

#endif
