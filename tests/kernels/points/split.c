/* Splitting for the rates of iVIR: pieces that are even enough, that cover their triangle without moving a corner, and
 * that meet their neighbours' in the same bits (METHODS 2 and 9). Limits and paths: tests/kernels/points/density.c. */
#include "tests/kernels/points/views.h"

enum { N = 300, N_VIEWS = 5 };

static ts_offscreen views[N_VIEWS];

static void random_views(void)
{
	for (u32 v = 0; v < N_VIEWS; v++) {
		views[v] = view_from(uniform3(-1, 1), unit3(), uniform(0.5f, 1.5f), 64 + random_bits() % 448, 0.0625f, v == 3);
	}
}

/* Two triangles on the two sides of an edge, which are seen by all views. */
static void random_pair(mesh *m)
{
	mesh_begin(m);
	random_views();
	ts_v3 v[4];
	f32 size = uniform_power(-3, 4);
	for (u32 k = 0; k < 4; k++) v[k] = uniform3(-size, size);
	mesh_triangle(m, v[0], v[1], v[2], 1, 0);
	mesh_triangle(m, v[1], v[0], v[3], 1, 0);
	for (u32 t = 0; t < 2; t++) m->bits[t * 2] = (1u << N_VIEWS) - 1;
}

static ts_need need_of(const mesh *m, const ts_density_args *args, u32 piece)
{
	const ts_piece *p = &m->pieces[piece];
	return ts_k_view_density(args, m->bits, ts_load3(p->a), ts_load3(p->b), ts_load3(p->c));
}

/* Each piece has the density that it needs itself, or less if it is capped; watertight ones of more than 64 samples
 * need nowhere 1.5 times what they need elsewhere, or were bisected twelve times. Other rates are not split for
 * that. */
static void watertight_pieces_are_even_enough(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_split[5] = {0}, n_last = 0; /* the last ones: watertight */
	for (u32 i = 0; i < N; i++) {
		u32 rate = TS_RATE_WATERTIGHT + i % 4;
		mesh m;
		i64 n_capped = 0, n_lower = 0;
		random_pair(&m);
		ts_density_args args = views_density(&m, views, N_VIEWS, rate, &n_capped);
		mesh_split(&m, args);
		for (u32 p = 0; p < m.n_pieces; p++) {
			ts_need need = need_of(&m, &args, p);
			const ts_piece *piece = &m.pieces[p];
			double s = need.s, area = d3_area(d3_load(piece->a), d3_load(piece->b), d3_load(piece->c));
			bool last = piece->path >= 1u << TS_MAX_SPLITS;
			assert_true(m.scale[p] <= need.s);
			n_lower += m.scale[p] < need.s;
			n_last += last && rate == TS_RATE_WATERTIGHT;
			if (!last) assert_true(m.scale[p] == need.s && area * s * s <= 65536.1);
			if (rate == TS_RATE_WATERTIGHT && !last) assert_true(need.uneven <= 1.5f || area * s * s <= 64.1);
			if (rate != TS_RATE_WATERTIGHT) assert_true(need.uneven == 1);
			if (rate == TS_RATE_WATERTIGHT) assert_true(need.uneven >= 0.9999f);
			n_split[rate] += piece->path != 1;
		}
		assert_true(n_lower == n_capped);
		mesh_clear(&m);
	}
	assert_true(n_split[TS_RATE_WATERTIGHT] > 2 * n_split[RATE_IS_EXACT] && n_split[RATE_IS_EXACT] > 100);
	assert_true(n_split[TS_RATE_WATERTIGHT] > n_last + 1000);
}

/* The children keep two corners each and share the middle of the longest edge: together they are the parent. */
static void two_children_make_up_the_parent(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < 20000; i++) {
		ts_part part = {.path = 1 + random_bits() % 4095};
		random_corners(part.v, 100, 0.01f, 64);
		f32 length;
		u32 edge = ts_k_longest_edge(part.v[0], part.v[1], part.v[2], &length), next = (edge + 1) % 3,
			apex = (edge + 2) % 3;
		ts_part first = ts_k_child(&part, edge, 0), second = ts_k_child(&part, edge, 1);
		assert_true(first.path == 2 * part.path && second.path == 2 * part.path + 1);
		assert_memory_equal(&first.v[edge], &part.v[edge], sizeof(ts_v3));
		assert_memory_equal(&first.v[apex], &part.v[apex], sizeof(ts_v3));
		assert_memory_equal(&second.v[next], &part.v[next], sizeof(ts_v3));
		assert_memory_equal(&second.v[apex], &part.v[apex], sizeof(ts_v3));
		assert_memory_equal(&first.v[next], &second.v[edge], sizeof(ts_v3));
		d3 middle = d3_scale(d3_add(d3_of(part.v[edge]), d3_of(part.v[next])), 0.5);
		assert_true(d3_length(d3_sub(d3_of(first.v[next]), middle)) <= 1e-7 * (d3_length(middle) + length));
	}
}

/* True if p is an end of the edge, or a middle of middles of it. */
static bool is_dyadic(ts_v3 p, ts_v3 from, ts_v3 to, u32 depth)
{
	if (memcmp(&p, &from, sizeof p) == 0 || memcmp(&p, &to, sizeof p) == 0) return true;
	if (depth == 0) return false;
	ts_v3 middle = ts_scale(ts_add(from, to), 0.5f);
	bool first = d3_length(d3_sub(d3_of(p), d3_of(from))) <= d3_length(d3_sub(d3_of(p), d3_of(to)));
	return first ? is_dyadic(p, from, middle, depth - 1) : is_dyadic(p, middle, to, depth - 1);
}

/* Whatever the two sides of an edge need, their corners on it are middles of the same bits: where one side is split
 * further the other's piece ends at ends of its pieces. */
static void shared_edges_split_at_the_same_bits(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_on_edge = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		i64 n_capped = 0;
		random_pair(&m);
		mesh_split(&m, views_density(&m, views, N_VIEWS, TS_RATE_WATERTIGHT, &n_capped));
		ts_v3 from = ts_load3(m.vertices[0].position), to = ts_load3(m.vertices[1].position);
		double length = d3_length(d3_sub(d3_of(to), d3_of(from)));
		for (u32 k = 0; k < 3 * m.n_pieces; k++) {
			const ts_piece *piece = &m.pieces[k / 3];
			ts_v3 p = ts_load3(k % 3 == 0 ? piece->a : k % 3 == 1 ? piece->b : piece->c);
			d3 on = d3_on_segment(d3_of(p), d3_of(from), d3_of(to));
			if (d3_length(d3_sub(d3_of(p), on)) > 1e-6 * length) continue;
			n_on_edge++;
			assert_true(is_dyadic(p, from, to, TS_MAX_SPLITS));
		}
		mesh_clear(&m);
	}
	assert_true(n_on_edge > 20 * N);
}

/* The pieces hold every point of their triangle, and none outside: random points lie in just one of them, or on
 * borders. */
static void pieces_hold_every_point_of_their_triangle(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < N / 4; i++) {
		mesh m;
		i64 n_capped = 0;
		random_pair(&m);
		mesh_split(&m, views_density(&m, views, N_VIEWS, TS_RATE_WATERTIGHT, &n_capped));
		d3 a = d3_load(m.vertices[0].position), b = d3_load(m.vertices[1].position),
		   c = d3_load(m.vertices[2].position);
		double size = d3_length(d3_sub(b, a)) + d3_length(d3_sub(c, a));
		for (u32 k = 0; k < 40; k++) {
			f32 x = uniform(0, 1), y = uniform(0, 1 - x);
			d3 p = d3_mad(d3_mad(a, d3_sub(b, a), x), d3_sub(c, a), y);
			u32 n_holding = 0;
			for (u32 q = 0; q < m.n_pieces && m.pieces[q].triangle == 0; q++) {
				const ts_piece *piece = &m.pieces[q];
				d3 on = d3_on_triangle(p, d3_load(piece->a), d3_load(piece->b), d3_load(piece->c));
				n_holding += d3_length(d3_sub(p, on)) <= 1e-6 * size;
			}
			assert_true(n_holding >= 1 && n_holding <= 8);
		}
		mesh_clear(&m);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(watertight_pieces_are_even_enough),
		cmocka_unit_test(two_children_make_up_the_parent),
		cmocka_unit_test(shared_edges_split_at_the_same_bits),
		cmocka_unit_test(pieces_hold_every_point_of_their_triangle),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
