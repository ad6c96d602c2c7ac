/* Points: which samples become points, in what order, where, and with what weights. */
#include "tests/kernels/points/mesh.h"
#include "tests/whole.h"

static u32 n_cases(void) { return whole_or(4000, 1500); }

static bool random_points(mesh *m, ts_v3 corner[3], i32 half_size, f32 least, f32 most)
{
	mesh_begin(m);
	random_corners(corner, 4, 0.01f, 4);
	f32 choice = uniform(0, 1);
	if (is_degenerate(corner)) return false;
	f32 length;
	ts_k_longest_edge(corner[0], corner[1], corner[2], &length);
	mesh_triangle(m, corner[0], corner[1], corner[2], 0, 0);
	mesh_whole(m, least * (f32)pow(most / least, choice) / length);
	mesh_points(m, half_size, 0);
	return true;
}

static i32 key_x(u64 key) { return (i32)(key & 0xffff) - 32768; }
static i32 key_y(u64 key) { return (i32)(key >> 16 & 0xffff) - 32768; }

/* The triangle in its lattice, unsnapped, in double precision from the frame's axes. */
typedef struct {
	double x[3], y[3];
} flat;

static flat flatten(const ts_align *f, const ts_v3 corner[3])
{
	flat r;
	for (u32 k = 0; k < 3; k++) {
		d3 d = d3_sub(d3_of(corner[k]), d3_load(f->c));
		r.x[k] = d3_dot(d, d3_load(f->u)) * f->s + 0.5;
		r.y[k] = d3_dot(d, d3_load(f->v)) * f->s + 0.5;
	}
	return r;
}

/* The square of half size h about the middle of sample (x, y) meets the triangle: no axis of either separates them. */
static bool square_meets(const flat *t, i32 x, i32 y, double h)
{
	double cx = x + 0.5, cy = y + 0.5;
	double area = (t->x[1] - t->x[0]) * (t->y[2] - t->y[0]) - (t->y[1] - t->y[0]) * (t->x[2] - t->x[0]);
	if (fmin(t->x[0], fmin(t->x[1], t->x[2])) > cx + h || fmax(t->x[0], fmax(t->x[1], t->x[2])) < cx - h) return false;
	if (fmin(t->y[0], fmin(t->y[1], t->y[2])) > cy + h || fmax(t->y[0], fmax(t->y[1], t->y[2])) < cy - h) return false;
	for (u32 k = 0; k < 3; k++) {
		u32 next = (k + 1) % 3;
		double dx = t->x[next] - t->x[k], dy = t->y[next] - t->y[k];
		double e = dx * (cy - t->y[k]) - dy * (cx - t->x[k]);
		if ((area < 0 ? -e : e) + h * (fabs(dx) + fabs(dy)) < 0) return false;
	}
	return true;
}

/* Keys ascend, so each is unique; offsets count them; records say which piece. */
static void keys_ascend_and_offsets_count_them(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < 200; i++) {
		mesh m;
		mesh_begin(&m);
		for (u32 k = 0; k < MESH_TRIANGLES; k++) {
			ts_v3 corner[3];
			random_corners(corner, 4, 0.01f, 4);
			mesh_triangle(&m, corner[0], corner[1], corner[2], k % 5, 0);
		}
		mesh_whole(&m, uniform_power(-3, 3));
		m.scale[7] = 0;
		mesh_points(&m, 129, 0);
		assert_int_equal(m.count[m.n_pieces], m.n_points);
		assert_int_equal(m.count[7], m.count[8]);
		for (u32 p = 0; p < m.n_points; p++) {
			u32 piece = m.points[p].piece;
			assert_true(p == 0 || m.keys[p] > m.keys[p - 1]);
			assert_true(m.keys[p] >> 32 == piece && m.count[piece] <= p && p < m.count[piece + 1]);
			assert_int_equal(m.points[p].pad[0] | m.points[p].pad[1], 0);
		}
		mesh_clear(&m);
	}
}

/* Every sample whose square the unsnapped triangle meets is a point, and none whose square it misses by 1/64. With the
 * exact half size a miss of the snapping is allowed. */
static void every_touched_sample_is_a_point(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < n_cases(); i++) {
		mesh m;
		ts_v3 corner[3];
		i32 half_size = i % 2 == 0 ? 129 : 128;
		if (!random_points(&m, corner, half_size, 0.01f, 40)) continue;
		flat t = flatten(m.frames, corner);
		double must = half_size == 129 ? 0.5 - 1e-4 : 0.5 - 1.0 / 256, may = half_size / 256.0 + 1.0 / 128;
		for (i32 y = -64; y <= 64; y++) {
			for (i32 x = -64; x <= 64; x++) {
				u64 key = (u64)(u32)(y + 32768) << 16 | (u64)(u32)(x + 32768);
				u32 low = 0, high = m.n_points;
				while (low < high) {
					u32 middle = (low + high) / 2;
					if (m.keys[middle] < key)
						low = middle + 1;
					else
						high = middle;
				}
				bool is = low < m.n_points && m.keys[low] == key;
				if (is)
					assert_true(square_meets(&t, x, y, may));
				else
					assert_false(square_meets(&t, x, y, must));
			}
		}
		mesh_clear(&m);
	}
}

/* A point lies at integer steps of l = 1/s from the centroid along u and v. */
static void points_lie_at_steps_from_the_centroid(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < n_cases(); i++) {
		mesh m;
		ts_v3 corner[3];
		if (!random_points(&m, corner, 129, 0.01f, 200)) continue;
		const ts_align *f = m.frames;
		double area = d3_area(d3_of(corner[0]), d3_of(corner[1]), d3_of(corner[2])) * f->s * f->s;
		for (u32 p = 0; p < m.n_points; p++) {
			d3 at = d3_mad(d3_mad(d3_load(f->c), d3_load(f->u), key_x(m.keys[p]) / (double)f->s), d3_load(f->v),
			               key_y(m.keys[p]) / (double)f->s);
			assert_true(d3_length(d3_sub(at, d3_load(m.points[p].centre))) <= 4e-6);
			assert_true(m.points[p].length == 1 / f->s);
			if (fabs(area - 1) > 1e-3) assert_int_equal(m.points[p].flags, area < 1 ? TS_POINT_TINY : 0);
		}
		mesh_clear(&m);
	}
}

/* The paper gives a sub-pixel triangle a square of its own area; others keep l = 1/s. */
static void the_papers_tiny_squares_keep_their_area(void **state)
{
	(void)state;
	for (f32 side = 0.125f; side <= 64; side *= 2) {
		mesh m;
		mesh_begin(&m);
		mesh_triangle(&m, ts_v3_make(0, 0, 0), ts_v3_make(side, 0, 0), ts_v3_make(0, side, 0), 0, 0);
		mesh_whole(&m, 0.5f);
		mesh_points(&m, 129, 1);
		double area = side * side / 2;
		double expected = area * 0.25 < 1 ? sqrt(area) : 2;
		for (u32 p = 0; p < m.n_points; p++) {
			assert_true(fabs(m.points[p].length - expected) <= 1e-6 * expected);
			assert_int_equal(m.points[p].flags, 0);
		}
		mesh_clear(&m);
	}
}

/* Not negative, of sum 1; inside the triangle they give the sample's own place. */
static void weights_give_the_place_of_the_sample(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_inside = 0;
	for (u32 i = 0; i < n_cases(); i++) {
		mesh m;
		ts_v3 corner[3];
		if (!random_points(&m, corner, 129, 0.01f, 100)) continue;
		ts_arrays arrays = mesh_arrays(&m);
		flat t = flatten(m.frames, corner);
		for (u32 p = 0; p < m.n_points; p++) {
			i32 x = key_x(m.keys[p]), y = key_y(m.keys[p]);
			ts_v3 w = ts_k_lattice_weights(&arrays, m.frames, 0, x, y);
			assert_true(w.x >= 0 && w.y >= 0 && w.z >= 0 && fabs((double)w.x + w.y + w.z - 1) <= 1e-6);
			if (!square_meets(&t, x, y, -1e-3)) continue;
			n_inside++;
			double px = w.x * t.x[0] + w.y * t.x[1] + w.z * t.x[2], py = w.x * t.y[0] + w.y * t.y[1] + w.z * t.y[2];
			assert_true(fabs(px - x - 0.5) <= 5e-3 && fabs(py - y - 0.5) <= 5e-3);
		}
		mesh_clear(&m);
	}
	assert_true(n_inside > n_cases());
}

/* Mean points of a random triangle of A samples: the figures of FIGURES 1, which 800 triangles gave, within four
 * standard errors of both samples; and exactly as many as the definition counts, but for squares that just touch. */
static void mean_counts_are_those_of_the_figures(void **state)
{
	(void)state;
	static const double table[][2] = {{0.001, 1.000}, {0.01, 1.016}, {0.1, 1.781}, {0.3, 2.898},
	                                  {1, 4.805},     {3, 10.081},   {10, 23.767}, {100, 140.848}};
	n_random = 0;
	for (u32 row = 0; row < 8; row++) {
		double sum = 0, squares = 0, defined = 0;
		u32 n = 0;
		while (n < n_cases()) {
			mesh m;
			ts_v3 corner[3];
			for (u32 k = 0; k < 3; k++) {
				double r = sqrt(-2 * log(1 - (double)ts_uniform(random_bits()))),
					   turn = 6.283185307179586 * uniform(0, 1);
				corner[k] = ts_v3_make((f32)(r * cos(turn)), (f32)(r * sin(turn)), 0);
			}
			double area = d3_area(d3_of(corner[0]), d3_of(corner[1]), d3_of(corner[2])), s = sqrt(table[row][0] / area);
			f32 length;
			ts_k_longest_edge(corner[0], corner[1], corner[2], &length);
			if (area < 0.05 || length * s > 120) continue;
			mesh_begin(&m);
			mesh_triangle(&m, corner[0], corner[1], corner[2], 0, 0);
			mesh_whole(&m, (f32)s);
			mesh_points(&m, 128, 0);
			flat t = flatten(m.frames, corner);
			i32 reach = (i32)(length * s) + 2;
			for (i32 y = -reach; y <= reach; y++)
				for (i32 x = -reach; x <= reach; x++) defined += square_meets(&t, x, y, 0.5);
			sum += m.n_points;
			squares += (double)m.n_points * m.n_points;
			n++;
			mesh_clear(&m);
		}
		double mean = sum / n, deviation = sqrt(squares / n - mean * mean);
		assert_true(fabs(mean - table[row][1]) <= 0.0011 + 4 * deviation * sqrt(1.0 / n + 1.0 / 800));
		assert_true(fabs(sum - defined) <= 0.01 * sum);
	}
}

static u32 n_points_of(u32 material, f32 s)
{
	mesh m;
	mesh_begin(&m);
	mesh_triangle(&m, ts_v3_make(0, 0, 0), ts_v3_make(16, 0, 0), ts_v3_make(16, 16, 0), material, 0);
	mesh_whole(&m, s);
	mesh_points(&m, 129, 0);
	u32 n = m.n_points;
	if (material == 4) {
		for (u32 p = 0; p < n; p++) assert_true(m.points[p].centre[0] > 8 - 1.5 / s);
	}
	mesh_clear(&m);
	return n;
}

/* Masked away: none. Masked but opaque: all. Half of the texture clear: those of the other half. */
static void masked_samples_are_no_points(void **state)
{
	(void)state;
	for (f32 s = 0.25f; s <= 8; s *= 2) {
		u32 all = n_points_of(0, s), half = n_points_of(4, s);
		assert_int_equal(n_points_of(2, s), 0);
		assert_int_equal(n_points_of(3, s), all);
		assert_true(all >= 128 * s * s);
		if (s >= 2) assert_true(fabs(half - 0.75 * all) <= 0.06 * all);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(keys_ascend_and_offsets_count_them),
		cmocka_unit_test(every_touched_sample_is_a_point),
		cmocka_unit_test(points_lie_at_steps_from_the_centroid),
		cmocka_unit_test(the_papers_tiny_squares_keep_their_area),
		cmocka_unit_test(weights_give_the_place_of_the_sample),
		cmocka_unit_test(mean_counts_are_those_of_the_figures),
		cmocka_unit_test(masked_samples_are_no_points),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
