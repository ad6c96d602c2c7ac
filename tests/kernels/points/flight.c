/* Points made again from their index are those that are stored; rows of samples are those that touch. */
#include "kernels/points/flight.h"
#include "tests/kernels/points/mesh.h"

enum { N = 600 };

/* What touches of a row, one sample after the other. */
static void assert_rows(const ts_cover *cover)
{
	ts_lines lines;
	ts_k_lines(&lines, cover);
	for (i32 y = cover->touched.y0 - 2; y <= cover->touched.y1 + 2; y++) {
		ts_span row = ts_k_touched_row(&lines, cover->touched, y);
		for (i32 x = cover->touched.x0; x <= cover->touched.x1; x++) {
			if (ts_k_touches(cover, x, y) != (x >= row.first && x <= row.last)) {
				fail_msg("random %u: sample %d of row %d, which is from %d to %d", n_random, x, y, row.first, row.last);
			}
		}
		assert_true(row.last >= row.first - 1 && row.first >= cover->touched.x0 && row.last <= cover->touched.x1);
	}
}

static void rows_hold_the_samples_that_touch(void **state)
{
	(void)state;
	static const i32 half_sizes[] = {129, 128, 0};
	n_random = 0;
	for (u32 i = 0; i < 4000; i++) {
		ts_cover cover = {.n = 3};
		i32 reach = 1 << (1 + random_bits() % 14);
		for (u32 k = 0; k < 3; k++) {
			cover.v[k].x = (i32)(random_bits() % (2 * (u32)reach)) - reach;
			cover.v[k].y = (i32)(random_bits() % (2 * (u32)reach)) - reach;
			if (random_bits() % 8 == 0 && k > 0) cover.v[k].x = cover.v[0].x;
			if (random_bits() % 8 == 0 && k > 0) cover.v[k].y = cover.v[0].y;
		}
		ts_k_cover_finish(&cover, half_sizes[random_bits() % 3]);
		assert_rows(&cover);
	}
}

/* A row whose lines cross far beyond all numbers of 32 bits. */
static void rows_of_far_crossings_are_right(void **state)
{
	(void)state;
	const ts_box box = {.x0 = -5, .y0 = 0, .x1 = 5, .y1 = 0};
	ts_lines away = {.n = 1, .edge = {{256, 0, -((i64)1 << 60)}}}, all = {.n = 1, .edge = {{-256, 0, (i64)1 << 60}}};
	ts_span none = ts_k_touched_row(&away, box, 0), row = ts_k_touched_row(&all, box, 0);
	assert_true(none.first == 6 && none.last == 5 && row.first == -5 && row.last == 5);
}

static ts_points_args counted(const mesh *m, i32 half_size, u32 paper_splat, u32 snap)
{
	return (ts_points_args){.scene = mesh_arrays(m),
	                        .pieces = m->pieces,
	                        .frames = m->frames,
	                        .offset = m->count,
	                        .half_size = half_size,
	                        .paper_splat = paper_splat,
	                        .snap = snap};
}

static void assert_point(const mesh *m, const ts_points_args *from, u32 index)
{
	ts_points_args stored = *from;
	stored.keys = m->keys;
	stored.points = m->points;
	ts_flight a = ts_k_flight_at(&stored, 0, index), b = ts_k_flight_at(from, m->n_pieces, index);
	bool same = a.piece == b.piece && a.x == b.x && a.y == b.y && a.flags == b.flags;
	same = same && memcmp(&a.centre, &b.centre, sizeof a.centre) == 0 && ts_f2u(a.length) == ts_f2u(b.length);
	if (!same) {
		fail_msg("random %u: point %u is %d %d of piece %u, made again %d %d of %u", n_random, index, a.x, a.y,
		         (unsigned)a.piece, b.x, b.y, (unsigned)b.piece);
	}
}

/* Triangles of all materials, masked ones among them, some without points. */
static void points_made_again_are_those_stored(void **state)
{
	(void)state;
	static const i32 half_sizes[] = {129, 128, 0};
	n_random = 0;
	u64 n_points = 0, n_masked = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		mesh_begin(&m);
		f32 samples = uniform_power(-4, 6);
		for (u32 t = 0; t < 7; t++) {
			ts_v3 corner[3];
			do random_corners(corner, 4, 0.01f, 8);
			while (is_degenerate(corner));
			mesh_triangle(&m, corner[0], corner[1], corner[2], t % 5, 0);
		}
		mesh_whole(&m, samples);
		for (u32 t = 0; t < 7; t++) {
			const ts_piece *p = &m.pieces[t];
			f32 length;
			ts_k_longest_edge(ts_load3(p->a), ts_load3(p->b), ts_load3(p->c), &length);
			m.scale[t] = random_bits() % 6 == 0 ? 0 : samples / length;
		}
		ts_points_args args = {.half_size = half_sizes[i % 3], .paper_splat = i % 4 == 0, .snap = i % 5 == 0};
		mesh_make_points(&m, args);
		ts_points_args from = counted(&m, args.half_size, args.paper_splat, args.snap);
		for (u32 k = 0; k < m.n_points; k++) assert_point(&m, &from, k);
		n_points += m.n_points;
		n_masked += m.count[5] - m.count[4];
		mesh_clear(&m);
	}
	assert_true(n_points > 100 * N && n_masked > N);
}

int main(void)
{
	const struct CMUnitTest flight[] = {
		cmocka_unit_test(rows_hold_the_samples_that_touch),
		cmocka_unit_test(rows_of_far_crossings_are_right),
		cmocka_unit_test(points_made_again_are_those_stored),
	};
	return cmocka_run_group_tests(flight, NULL, NULL);
}
