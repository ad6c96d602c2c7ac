/* The fast split writes the pieces of the plain kernel: whole triangles, split ones, those that splitting leaves too
 * large, and those that nobody sees; by the eye and by views. */
#include "backends/fast.h"
#include "backends/kernels.h"
#include "tests/kernels/points/views.h"

enum { N = 400, VIEWS = 4 };

/* Of every size, seen by some cubes or views, or by none. */
static void random_mesh(mesh *m, ts_offscreen *views)
{
	mesh_begin(m);
	ts_store3(m->view.eye, uniform3(-4, 4));
	for (u32 r = 0; r < VIEWS; r++) {
		mesh_cube(m, uniform3(-3, 3), uniform_power(-8, 1), 64);
		views[r] = view_from(uniform3(-3, 3), unit3(), uniform(0.1f, 1), 256, 0.01f, 0);
	}
	for (u32 t = 0; t < MESH_TRIANGLES; t++) {
		ts_v3 corner[3];
		random_corners(corner, 6, 0.002f, 64);
		mesh_triangle(m, corner[0], corner[1], corner[2], 0, 0);
		m->bits[t * 2] &= random_bits() % 4 == 0 ? 0 : (u64)random_bits();
	}
}

/* How pieces are made: by the eye, or by views. */
static ts_density_args random_args(mesh *m, const ts_offscreen *views, i64 *n_capped)
{
	static const u32 rates[] = {TS_RATE_PAPER, TS_RATE_VIR, TS_RATE_WATERTIGHT};
	ts_density_args args = mesh_density(m, n_capped, uniform_power(-2, 4));
	if (random_bits() % 2 == 0) args = views_density(m, views, VIEWS, rates[random_bits() % 3], n_capped);
	args.split = random_bits() % 4 != 0;
	return args;
}

/* Returns how many pieces there are. */
static u32 assert_equal(const mesh *m, ts_density_args args, u32 threads, u32 start)
{
	f32 whole[MESH_TRIANGLES];
	u32 offset[MESH_TRIANGLES + 1], n;
	i64 capped[2] = {0, 0};
	ts_piece *pieces[2];
	f32 *scale[2];
	args.whole = whole;
	args.offset = offset;
	ts_c_launch(TS_KERNEL_split_count, &args, m->n_triangles, 1);
	n = mesh_scan(offset, m->n_triangles);
	for (u32 way = 0; way < 2; way++) {
		args.pieces = pieces[way] = mesh_alloc(n, sizeof **pieces);
		args.scale = scale[way] = mesh_alloc(n, sizeof **scale);
		args.n_capped = &capped[way];
		if (way == 0) ts_c_launch(TS_KERNEL_split, &args, m->n_triangles, 1);
		if (way == 1) assert_true(ts_c_fast_split(&args, m->n_triangles, threads));
	}
	bool same = memcmp(pieces[0], pieces[1], n * sizeof **pieces) == 0 && capped[0] == capped[1];
	same = same && memcmp(scale[0], scale[1], n * sizeof **scale) == 0;
	for (u32 way = 0; way < 2; way++) {
		free(pieces[way]);
		free(scale[way]);
	}
	if (!same) {
		fail_msg("random %u: views %u, rate %u, split %u, %u threads: %u pieces, capped %lld, %lld", start,
		         args.n_views, args.rate, args.split, threads, n, (long long)capped[0], (long long)capped[1]);
	}
	return n;
}

static void fast_split_equals_the_kernel(void **state)
{
	(void)state;
	n_random = 0;
	u64 n_pieces = 0;
	i64 n_capped = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		ts_offscreen views[VIEWS];
		u32 start = n_random, threads = 1 + random_bits() % 7;
		random_mesh(&m, views);
		ts_density_args args = random_args(&m, views, &n_capped);
		n_pieces += assert_equal(&m, args, threads, start);
		mesh_clear(&m);
	}
	assert_true(n_pieces > 60 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_split_equals_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
