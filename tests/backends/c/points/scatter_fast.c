/* The fast path of the scatter kernels gives the kernels' bits and tallies: random pieces into random views,
 * perspective and orthographic, of stored points and of points made on the spot, at coordinates where views begin
 * and end. */
#include "backends/fast.h"
#include "backends/kernels.h"
#include "tests/kernels/points/mesh.h"

enum { N = 24, MOST_VIEWS = 80 };

static ts_offscreen views[MOST_VIEWS];

static void random_axes(ts_offscreen *view)
{
	d3 back = d3_unit(d3_of(uniform3(-1, 1))), right = d3_unit(d3_cross(d3_of(uniform3(-1, 1)), back));
	d3 up = d3_cross(back, right);
	ts_store3(view->back, ts_v3_make((f32)back.x, (f32)back.y, (f32)back.z));
	ts_store3(view->right, ts_v3_make((f32)right.x, (f32)right.y, (f32)right.z));
	ts_store3(view->up, ts_v3_make((f32)up.x, (f32)up.y, (f32)up.z));
}

/* Views of different sizes; some see along the world's axes, where points lie on borders of texels. Returns the
 * texels. */
static u64 random_views(u32 n)
{
	u64 offset = 0;
	for (u32 v = 0; v < n; v++) {
		ts_offscreen *view = &views[v];
		*view = (ts_offscreen){.width = 1 + random_bits() % 70,
		                       .height = 1 + random_bits() % 70,
		                       .object = TS_NONE,
		                       .orthographic = random_bits() % 4 == 0,
		                       .near = uniform_power(-10, 0),
		                       .offset = offset};
		ts_store3(view->eye, uniform3(-3, 3));
		if (random_bits() % 3 == 0) {
			ts_store3(view->right, ts_v3_make(1, 0, 0));
			ts_store3(view->up, ts_v3_make(0, 1, 0));
			ts_store3(view->back, ts_v3_make(0, 0, 1));
			ts_store3(view->eye, ts_v3_make(0, 0, 2));
		} else {
			random_axes(view);
		}
		view->focal = (f32)view->width * (view->orthographic != 0 ? 0.25f : uniform_power(-2, 2));
		offset += (u64)view->width * view->height;
	}
	return offset;
}

typedef struct {
	u32 *depths;
	i64 tally[3];
} result;

static void scatter(result *r, ts_scatter_args args, u64 n_texels, u64 n, bool stored, u32 threads)
{
	r->depths = mesh_alloc(n_texels, sizeof *r->depths);
	memset(r->depths, 0xff, n_texels * sizeof *r->depths);
	memset(r->tally, 0, sizeof r->tally);
	args.depths = r->depths;
	args.n_points = &r->tally[0];
	args.n_scatters = &r->tally[1];
	args.n_writes = &r->tally[2];
	if (threads != 0) {
		assert_true((stored ? ts_c_fast_scatter : ts_c_fast_scatter_pieces)(&args, n, threads));
	} else {
		ts_c_launch(stored ? TS_KERNEL_scatter : TS_KERNEL_scatter_pieces, &args, n, 1);
	}
}

static void check_equal(const result *a, const result *b, u64 n_texels)
{
	assert_memory_equal(a->tally, b->tally, sizeof a->tally);
	assert_memory_equal(a->depths, b->depths, n_texels * sizeof *a->depths);
}

static void random_pieces(mesh *m, f32 samples)
{
	mesh_begin(m);
	u32 n = 1 + random_bits() % 12;
	for (u32 t = 0; t < n; t++) {
		ts_v3 a = uniform3(-2, 2);
		f32 size = uniform_power(-6, 2);
		mesh_triangle(m, a, ts_mad(a, uniform3(-1, 1), size), ts_mad(a, uniform3(-1, 1), size), random_bits() % 5, 0);
	}
	mesh_whole(m, samples);
	mesh_points(m, 129, 0);
}

/* A coordinate that overflows on the way to points, as a port's may. */
static void spoil(mesh *m)
{
	ts_piece *piece = &m->pieces[random_bits() % m->n_pieces];
	f32 *corner = (f32 *[]){piece->a, piece->b, piece->c}[random_bits() % 3];
	corner[random_bits() % 3] = uniform(-1, 1) * uniform_power(0, 127);
}

/* The same of a frame; corners that leave the lattice are refused before (check_points.c). */
static void spoil_frame(mesh *m)
{
	ts_align *frame = &m->frames[random_bits() % m->n_pieces];
	f32 *member = (f32 *[]){frame->c, frame->u, frame->v}[random_bits() % 3];
	member[random_bits() % 3] = uniform(-1, 1) * uniform_power(0, 127);
}

static void fast_scattering_equals_the_kernel(void **state)
{
	(void)state;
	i64 n_writes = 0, n_missed = 0;
	for (u32 i = 0; i < N; i++) {
		n_random = i << 16;
		mesh m;
		random_pieces(&m, uniform_power(-4, 5));
		if (i % 4 == 3) spoil(&m);
		if (i % 4 == 2) spoil_frame(&m);
		u32 n_views = 1 + random_bits() % MOST_VIEWS, first = random_bits() % n_views;
		u64 n_texels = random_views(n_views), bits[MESH_TRIANGLES * 2];
		for (u32 k = 0; k < MESH_TRIANGLES * 2; k++) bits[k] = (u64)random_bits() << 32 | random_bits();
		ts_scatter_args args = {
			.from = {.scene = mesh_arrays(&m),
		             .pieces = m.pieces,
		             .frames = m.frames,
		             .keys = m.keys,
		             .points = m.points,
		             .half_size = 129,
		             .snap = random_bits() % 2},
			.views = views,
			.bits = bits,
			.first_view = first,
			.n_views = n_views - first,
			.n_words = 2,
			.centre = random_bits() % 2,
			.culled = random_bits() % 2,
		};
		for (u32 stored = 0; stored < 2; stored++) {
			u64 n = stored != 0 ? m.n_points : m.n_pieces;
			result plain, fast;
			scatter(&plain, args, n_texels, n, stored != 0, 0);
			scatter(&fast, args, n_texels, n, stored != 0, 1 + random_bits() % 4);
			check_equal(&plain, &fast, n_texels);
			n_writes += plain.tally[2];
			n_missed += plain.tally[1] - plain.tally[2];
			free(plain.depths);
			free(fast.depths);
		}
		mesh_clear(&m);
	}
	assert_true(n_writes > 100 * N && n_missed > 100 * N);
}

/* More points than a pool holds, in rows as long as the lattice allows; and what of a pool is left for the next piece
 * may be less than a row. */
static void several_pools_equal_the_kernel(void **state)
{
	(void)state;
	n_random = 1;
	mesh m;
	mesh_begin(&m);
	for (u32 t = 0; t < 3; t++) {
		f32 y = (f32)t * 0.125f;
		mesh_triangle(&m, ts_v3_make(-1, y, 0), ts_v3_make(1, y, 0), ts_v3_make(0, y + 0.015625f, 0.03125f), 1, 0);
	}
	mesh_whole(&m, 8000);
	mesh_points(&m, 129, 0);
	assert_true(m.n_points > 600000);
	u64 n_texels = random_views(5), bits[6];
	memset(bits, 0xff, sizeof bits);
	ts_scatter_args args = {
		.from = {.scene = mesh_arrays(&m),
	             .pieces = m.pieces,
	             .frames = m.frames,
	             .keys = m.keys,
	             .points = m.points,
	             .half_size = 129},
		.views = views,
		.bits = bits,
		.n_views = 5,
		.n_words = 2,
	};
	result stored, made, plain;
	scatter(&plain, args, n_texels, m.n_pieces, false, 0);
	scatter(&stored, args, n_texels, m.n_points, true, 2);
	scatter(&made, args, n_texels, m.n_pieces, false, 3);
	check_equal(&plain, &made, n_texels);
	check_equal(&plain, &stored, n_texels);
	assert_int_equal(plain.tally[0], m.n_points);
	free(plain.depths);
	free(stored.depths);
	free(made.depths);
	mesh_clear(&m);
}

/* More views than it takes, and nothing to write to, it leaves to the kernel. */
static void the_kernel_takes_too_many_views(void **state)
{
	(void)state;
	u32 depth;
	ts_scatter_args args = {.depths = &depth, .first_view = 31, .n_views = 2048 - 31 + 1, .views = views};
	assert_false(ts_c_fast_scatter(&args, 0, 1));
	assert_false(ts_c_fast_scatter_pieces(&args, 0, 1));
	args = (ts_scatter_args){.n_views = 1, .views = views};
	assert_false(ts_c_fast_scatter(&args, 0, 1));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_scattering_equals_the_kernel),
	                                   cmocka_unit_test(several_pools_equal_the_kernel),
	                                   cmocka_unit_test(the_kernel_takes_too_many_views)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
