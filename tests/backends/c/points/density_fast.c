/* The fast densities equal the plain kernel bit for bit: of triangles in all places about many views, biased to the
 * extremes. */
#include "backends/fast.h"
#include "backends/kernels.h"
#include "tests/kernels/points/views.h"
#include "tests/whole.h"

enum { VIEWS = 128 };

static u32 n_meshes(void) { return whole_or(1500, 500); }

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

static void fast_densities_equal_the_kernel(void **state)
{
	(void)state;
	n_random = 0;
	u64 n_seen = 0;
	for (u32 i = 0; i < n_meshes(); i++) {
		mesh m;
		ts_offscreen views[VIEWS];
		f32 plain[MESH_TRIANGLES], fast[MESH_TRIANGLES];
		u32 pieces[2][MESH_TRIANGLES];
		i64 none = 0;
		u32 start = n_random, n_views = 1 + random_bits() % VIEWS, threads = 1 + random_bits() % 7;
		random_scene(&m, views, n_views);
		u32 rate = random_bits() % 2 == 0 ? TS_RATE_PAPER : TS_RATE_VIR;
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
	assert_true(n_seen > 40 * n_meshes());
}

/* Mirrors of all sizes about an eye; some of them are none, or all but touch a triangle. */
static void random_mirrors(mesh *m)
{
	static const u32 sizes[] = {0, 1, 16, 64, 512};
	u32 n_cubes = 1 + random_bits() % MESH_CUBES;
	mesh_begin(m);
	ts_store3(m->view.eye, uniform3(-4, 4));
	for (u32 r = 0; r < n_cubes; r++) {
		ts_v3 centre = uniform3(-3, 3);
		if (random_bits() % 3 == 0) centre = ts_v3_make(ts_floor(centre.x), ts_floor(centre.y), ts_floor(centre.z));
		mesh_cube(m, centre, random_bits() % 8 == 0 ? 0 : uniform_power(-8, 1), sizes[random_bits() % 5]);
	}
	for (u32 t = 0; t < MESH_TRIANGLES; t++) {
		ts_v3 corner[3], at = ts_load3(m->cubes[random_bits() % n_cubes].centre);
		ts_offscreen near_by = view_from(at, unit3(), 1, 1, 1, 0);
		for (u32 k = 0; k < 3; k++) corner[k] = extreme_corner(&near_by);
		mesh_triangle(m, corner[0], corner[1], corner[2], 1, 0);
		for (u32 w = 0; w < 2; w++) m->bits[t * 2 + w] &= (u64)random_bits() << 32 | random_bits();
	}
}

static bool eye_is_in_a_ball(const mesh *m)
{
	bool is = false;
	for (u32 r = 0; r < m->n_cubes; r++) {
		is = is || ts_length(ts_sub(ts_load3(m->view.eye), ts_load3(m->cubes[r].centre))) <= m->cubes[r].radius;
	}
	return is;
}

static void fast_eye_densities_equal_the_kernel(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_seen = 0, n_within = 0, n_limited = 0;
	for (u32 i = 0; i < n_meshes(); i++) {
		mesh m;
		f32 plain[MESH_TRIANGLES], fast[MESH_TRIANGLES];
		u32 pieces[2][MESH_TRIANGLES], start = n_random, threads = 1 + random_bits() % 7;
		i64 n_capped = 0, limited[2] = {0, 0};
		random_mirrors(&m);
		ts_density_args args = mesh_density(&m, &n_capped, uniform_power(-4, 4));
		args.cap = random_bits() % 4 != 0;
		args.greatest = random_bits() % 2 == 0 ? 0 : 1 + random_bits() % 1024;
		args.split = random_bits() % 2;
		for (u32 way = 0; way < 2; way++) {
			args.whole = way == 0 ? plain : fast;
			args.offset = pieces[way];
			args.n_limited = &limited[way];
			if (way == 0) ts_c_launch(TS_KERNEL_split_count, &args, m.n_triangles, 1);
			if (way == 1 && ts_c_fast_split_count(&args, m.n_triangles, threads) == eye_is_in_a_ball(&m)) {
				fail_msg("random %u: the eye in a ball is the kernel's", start);
			}
		}
		n_within += eye_is_in_a_ball(&m);
		if (eye_is_in_a_ball(&m)) continue;
		u32 t = 0;
		while (t < MESH_TRIANGLES && ts_f2u(plain[t]) == ts_f2u(fast[t]) && pieces[0][t] == pieces[1][t]) t++;
		if (t < MESH_TRIANGLES || limited[0] != limited[1]) {
			fail_msg("random %u: %u mirrors, cap %u, greatest %u, %u threads: triangle %u: %a, %a; limited %lld, %lld",
			         start, m.n_cubes, args.cap, args.greatest, threads, t, (double)plain[t % MESH_TRIANGLES],
			         (double)fast[t % MESH_TRIANGLES], (long long)limited[0], (long long)limited[1]);
		}
		for (t = 0; t < MESH_TRIANGLES; t++) n_seen += plain[t] > 0;
		n_limited += (u32)limited[0];
	}
	assert_true(n_seen > 20 * n_meshes() && n_limited > n_meshes() && n_within > n_meshes() / 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_densities_equal_the_kernel),
	                                   cmocka_unit_test(fast_eye_densities_equal_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
