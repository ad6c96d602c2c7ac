/* The fast densities equal the plain kernel bit for bit: of triangles in all places about many views, biased to the
 * extremes. */
#include "../../../kernels/points/views.h"
#include "../../../../src/backends/fast.h"
#include "../../../../src/backends/kernels.h"

enum { N = 1500, VIEWS = 128 };

/* Points of a lattice lie in borders of regions, where two corners can also be one. */
static ts_v3 extreme_corner(const ts_offscreen *view)
{
	u32 sort = random_bits() % 8;
	ts_v3 p = uniform3(-3, 3);
	if (sort == 0) return ts_load3(view->eye);
	if (sort == 1) return ts_scale(p, 1048576);
	if (sort == 2) return ts_mad(ts_load3(view->eye), p, 0.000030517578125f);
	return sort < 6 ? ts_v3_make(ts_floor(p.x), ts_floor(p.y), ts_floor(p.z)) : p;
}

static void random_scene(mesh *m, ts_offscreen *views, u32 n_views)
{
	mesh_begin(m);
	for (u32 v = 0; v < n_views; v++) {
		ts_v3 eye = uniform3(-2, 2);
		if (v % 2 == 0) eye = ts_v3_make(ts_floor(eye.x), ts_floor(eye.y), ts_floor(eye.z));
		views[v] = view_from(eye, unit3(), uniform(0.1f, 1), 1 + random_bits() % 1024, uniform_power(-10, 0), 0);
	}
	for (u32 t = 0; t < MESH_TRIANGLES; t++) {
		ts_v3 corner[3];
		for (u32 k = 0; k < 3; k++) corner[k] = extreme_corner(&views[random_bits() % n_views]);
		mesh_triangle(m, corner[0], corner[1], corner[2], 1, 0);
		for (u32 w = 0; w < 2; w++) {
			u64 word = (u64)random_bits() << 32;
			m->bits[t * 2 + w] = random_bits() % 4 == 0 ? 0 : word | random_bits();
		}
		u64 beyond = n_views < 64 ? ~0UL << n_views : 0;
		m->bits[t * 2] &= ~beyond;
		if (n_views < 128) m->bits[t * 2 + 1] &= n_views <= 64 ? 0 : ~(~0UL << (n_views - 64));
	}
}

static void test_equal(void **state)
{
	(void)state;
	n_random = 0;
	u64 n_seen = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		ts_offscreen views[VIEWS];
		f32 plain[MESH_TRIANGLES], fast[MESH_TRIANGLES];
		u32 pieces[2][MESH_TRIANGLES];
		i64 none = 0;
		u32 start = n_random, n_views = 1 + random_bits() % VIEWS, threads = 1 + random_bits() % 3;
		random_scene(&m, views, n_views);
		u32 rate = random_bits() % 2 == 0 ? TS_RATE_IS_PAPER : TS_RATE_IS_VIR;
		ts_density_args args = views_density(&m, views, n_views, rate, &none);
		args.split = 0;
		args.whole = plain;
		args.offset = pieces[0];
		ts_c_launch(TS_KERNEL_split_count, &args, m.n_triangles, 1);
		args.whole = fast;
		args.offset = pieces[1];
		assert_true(ts_c_fast_split_count(&args, m.n_triangles, threads));
		if (memcmp(plain, fast, sizeof plain) != 0 || memcmp(pieces[0], pieces[1], sizeof *pieces) != 0) {
			u32 t = 0;
			while (ts_f2u(plain[t]) == ts_f2u(fast[t]) && pieces[0][t] == pieces[1][t]) t++;
			fail_msg("random %u: %u views, rate %u, %u threads: triangle %u: %a, %a", start, n_views, rate, threads, t,
			         (double)plain[t], (double)fast[t]);
		}
		for (u32 t = 0; t < MESH_TRIANGLES; t++) n_seen += plain[t] > 0;
		mesh_clear(&m);
	}
	assert_true(n_seen > 40 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_equal)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
