/* Fast counts and points equal the plain kernels' bit for bit: of wide pieces and narrow ones, slivers, pieces with a
 * mask and pieces without points. */
#include "backends/c/points/made_points.h"
#include "backends/fast.h"
#include "backends/kernels.h"
#include "tests/kernels/points/mesh.h"

enum { N = 600, TRIANGLES = 12 };

/* Everything about one run, printed when it fails. */
typedef struct {
	u32 start, snap, paper_splat, threads;
	i32 half_size;
} setting;

/* Of every size and shape: up to 300 samples wide. */
static void random_mesh(mesh *m)
{
	mesh_begin(m);
	for (u32 t = 0; t < TRIANGLES; t++) {
		ts_v3 corner[3];
		random_corners(corner, 6, 0.002f, 64);
		if (is_degenerate(corner)) corner[1] = ts_add(corner[0], ts_v3_make(1, 0, 0));
		if (is_degenerate(corner)) corner[2] = ts_add(corner[0], ts_v3_make(0, 1, 0));
		mesh_triangle(m, corner[0], corner[1], corner[2], random_bits() % 2 == 0 ? 0 : t % 5, 0);
	}
	mesh_whole(m, 1);
	for (u32 t = 0; t < TRIANGLES; t++) {
		f32 length;
		const ts_piece *p = &m->pieces[t];
		ts_k_longest_edge(ts_load3(p->a), ts_load3(p->b), ts_load3(p->c), &length);
		m->scale[t] = random_bits() % 8 == 0 ? 0 : uniform_power(0, 8) / length;
	}
	mesh_align(m);
}

static ts_points_args points_of(const mesh *m, const setting *s, u32 *offset)
{
	return (ts_points_args){.scene = mesh_arrays(m),
	                        .pieces = m->pieces,
	                        .frames = m->frames,
	                        .offset = offset,
	                        .half_size = s->half_size,
	                        .paper_splat = s->paper_splat,
	                        .snap = s->snap};
}

/* Returns how many points there are. */
static u32 assert_equal(const mesh *m, const setting *s)
{
	u32 plain[TRIANGLES + 1] = {0}, fast[TRIANGLES + 1] = {0};
	ts_points_args of[2] = {points_of(m, s, plain), points_of(m, s, fast)};
	ts_c_launch(TS_KERNEL_points_count, &of[0], TRIANGLES, 1);
	assert_true(ts_c_fast_points_count(&of[1], TRIANGLES, s->threads));
	bool same = memcmp(plain, fast, sizeof plain) == 0;
	u32 n = mesh_scan(plain, TRIANGLES);
	mesh_scan(fast, TRIANGLES);
	for (u32 way = 0; way < 2; way++) {
		of[way].points = mesh_alloc(n, sizeof *of[way].points);
		of[way].keys = mesh_alloc(n, sizeof *of[way].keys);
		of[way].room = n;
	}
	memset(of[1].points, 0xff, n * sizeof *of[1].points);
	ts_c_launch(TS_KERNEL_points, &of[0], TRIANGLES, 1);
	assert_true(!same || ts_c_fast_points(&of[1], TRIANGLES, s->threads));
	same = same && memcmp(of[0].points, of[1].points, n * sizeof *of[0].points) == 0;
	same = same && memcmp(of[0].keys, of[1].keys, n * sizeof *of[0].keys) == 0;
	for (u32 way = 0; way < 2; way++) {
		free(of[way].points);
		free(of[way].keys);
	}
	if (!same) {
		fail_msg("random %u: snap %u paper %u threads %u half size %d", s->start, s->snap, s->paper_splat, s->threads,
		         s->half_size);
	}
	return n;
}

static void fast_points_equal_the_kernel(void **state)
{
	static const i32 half_sizes[] = {129, 128, 0};
	(void)state;
	n_random = 0;
	u64 n_points = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		setting s = {.start = n_random,
		             .snap = random_bits() % 2,
		             .paper_splat = random_bits() % 4 == 0,
		             .threads = 1 + random_bits() % 7,
		             .half_size = half_sizes[random_bits() % 3]};
		random_mesh(&m);
		n_points += assert_equal(&m, &s);
		mesh_clear(&m);
	}
	assert_true(n_points > 1000 * N);
}

static bool is_within(const ts_bounds *of, const f32 *const at[3], u32 i)
{
	for (u32 c = 0; c < 3; c++) {
		if (fabs((double)at[c][i] - (double)of->middle[c]) > (double)of->half[c]) return false;
	}
	return true;
}

/* The bounds of a piece hold all of its points, rounded as these are. */
static void bounds_of_a_piece_hold_its_points(void **state)
{
	(void)state;
	static f32 place[3][1024];
	f32 *const at[3] = {place[0], place[1], place[2]};
	const f32 *const from[3] = {place[0], place[1], place[2]};
	u64 n_points = 0;
	n_random = 77;
	for (u32 i = 0; i < 100; i++) {
		mesh m;
		u32 offset[TRIANGLES + 1];
		random_mesh(&m);
		ts_points_args args = points_of(&m, &(setting){.half_size = 129, .snap = i % 2}, offset);
		for (u32 t = 0; t < TRIANGLES; t++) {
			if (!(m.frames[t].s > 0)) continue;
			ts_made_piece piece = ts_made_piece_begin(&args, t);
			ts_bounds bounds = ts_made_piece_bounds(&piece);
			for (i32 y = piece.cover.touched.y0; y <= piece.cover.touched.y1; y++) {
				u32 n = ts_made_row(&piece, y, at);
				for (u32 k = 0; k < n; k++) assert_true(is_within(&bounds, from, k));
				n_points += n;
			}
		}
		mesh_clear(&m);
	}
	assert_true(n_points > 100000);
}

/* Room that was not counted: the plain kernel counts what finds none. */
static void without_room_the_kernel_counts(void **state)
{
	(void)state;
	mesh m;
	n_random = 0;
	random_mesh(&m);
	u32 offset[TRIANGLES + 1] = {0};
	ts_points_args args = points_of(&m, &(setting){.half_size = 129}, offset);
	assert_true(ts_c_fast_points_count(&args, TRIANGLES, 1));
	args.room = mesh_scan(offset, TRIANGLES) - 1;
	assert_false(ts_c_fast_points(&args, TRIANGLES, 1));
	mesh_clear(&m);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_points_equal_the_kernel),
	                                   cmocka_unit_test(bounds_of_a_piece_hold_its_points),
	                                   cmocka_unit_test(without_room_the_kernel_counts)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
