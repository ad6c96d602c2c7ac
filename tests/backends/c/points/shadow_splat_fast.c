/* The fast path of EPR's shadow splats gives the kernel's bits and tallies: random pieces of any density in random
 * views, some along the world's axes and some that a piece reaches behind, in batches, by several threads. */
#include "backends/fast.h"
#include "backends/kernels.h"
#include "kernels/points/shadow_splat.h"
#include "tests/kernels/points/views.h"

enum { N = 12, N_VIEWS = 40, SIDE = 64, N_TEXELS = SIDE * SIDE };

static u32 texels[2][N_VIEWS * N_TEXELS];

static void random_views(ts_offscreen *views, u32 n)
{
	u64 offset = 0;
	for (u32 v = 0; v < n; v++) {
		bool straight = random_bits() % 3 == 0;
		ts_v3 back = straight ? ts_v3_make(0, 0, 1) : unit3(), eye = ts_mad(uniform3(-2, 2), back, uniform(0, 8));
		views[v] = view_from(eye, back, uniform(0.3f, 1.5f), 1 + random_bits() % SIDE, uniform_power(-7, 0), 0);
		if (straight) {
			ts_store3(views[v].right, ts_v3_make(1, 0, 0));
			ts_store3(views[v].up, ts_v3_make(0, 1, 0));
		}
		views[v].offset = offset;
		offset += (u64)views[v].width * views[v].height;
	}
}

static void random_mesh(mesh *m)
{
	mesh_begin(m);
	for (u32 k = 0; k < MESH_TRIANGLES; k++) {
		ts_v3 corner[3];
		random_corners(corner, 4, 0.01f, 1);
		u32 t = mesh_triangle(m, corner[0], corner[1], corner[2], k % 5, 0);
		m->bits[t * 2] = ((u64)random_bits() << 32 | random_bits()) & ((1UL << N_VIEWS) - 1);
	}
	mesh_whole(m, 8);
	for (u32 i = 0; i < m->n_pieces; i++) m->scale[i] = uniform_power(-2, 5);
}

static void splat(u32 *to, i64 tally[5], const ts_shadow_splat_args *like, u32 n, u32 threads)
{
	ts_shadow_splat_args args = *like;
	memset(to, 0xff, sizeof texels[0]);
	memset(tally, 0, 5 * sizeof *tally);
	args.of.depths = to;
	args.of.n_points = &tally[0];
	args.of.n_scatters = &tally[1];
	args.of.n_writes = &tally[2];
	args.n_splats = &tally[3];
	args.n_texels = &tally[4];
	if (threads != 0) {
		assert_true(ts_c_fast_shadow_splat_pieces(&args, n, threads));
	} else {
		for (u32 i = 0; i < n; i++) ts_k_shadow_splat_pieces_item(&args, i);
	}
}

static void fast_shadow_splats_equal_the_kernel(void **state)
{
	(void)state;
	i64 n_writes = 0, n_splats = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		ts_offscreen views[N_VIEWS];
		i64 tally[2][5] = {{0}};
		ts_points_args how = {.half_size = i % 2 == 0 ? 128 : 129, .snap = i & 1, .paper_splat = i / 2 & 1};
		n_random = i << 16;
		random_views(views, N_VIEWS);
		random_mesh(&m);
		mesh_make_points(&m, how);
		ts_shadow_splat_args args = {.of = views_scatter(&m, views, N_VIEWS, how, tally[0]),
		                             .clip = i % 3 != 0,
		                             .plane_depth = i % 4 != 0,
		                             .inset = i % 5 == 0 ? 0 : TS_SPLAT_INSET};
		args.of.from.points = NULL;
		for (u32 first = 0; first < N_VIEWS; first += i % 5 == 0 ? N_VIEWS : 17) {
			args.of.first_view = first;
			args.of.n_views = i % 5 == 0 || first + 17 > N_VIEWS ? N_VIEWS - first : 17;
			splat(texels[0], tally[0], &args, m.n_pieces, 0);
			splat(texels[1], tally[1], &args, m.n_pieces, 1 + random_bits() % 4);
			assert_memory_equal(texels[0], texels[1], sizeof texels[0]);
			assert_memory_equal(tally[0], tally[1], sizeof tally[0]);
			assert_int_equal(tally[0][0], first == 0 ? m.n_points : 0);
			n_writes += tally[0][2];
			n_splats += tally[0][3];
		}
		mesh_clear(&m);
	}
	assert_true(n_writes > 100 * N && n_splats > 100 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_shadow_splats_equal_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
