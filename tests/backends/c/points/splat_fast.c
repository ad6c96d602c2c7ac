/* The fast splats equal the plain kernel bit for bit: texels, counters and marks of ties, on random meshes biased to
 * the extremes; and the texels that pixels ask for, where those are told. */
#include "backends/c/points/asked_texels.h"
#include "backends/fast.h"
#include "backends/kernels.h"
#include "tests/kernels/points/pixels.h"
#include "tests/whole.h"

enum { PIXELS = 400 };

/* Everything about one run, printed when it fails. */
typedef struct {
	u32 start, clip, plane_depth, paper_splat, threads, n_cubes;
	i32 half_size;
	f32 samples, inset;
} setting;

/* Slivers, needles through the near plane, triangles through the eye, along an axis, at the ends of the range. */
static void extreme_corners(ts_v3 corner[3], ts_v3 centre)
{
	u32 sort = random_bits() % 8;
	random_corners(corner, 6, 0.002f, 64);
	if (sort == 0)
		for (u32 k = 0; k < 3; k++) corner[k].x = centre.x;
	if (sort == 1) corner[random_bits() % 3] = centre;
	if (sort == 2)
		for (u32 k = 0; k < 3; k++) corner[k] = ts_mad(centre, uniform3(-1, 1), 0.004f);
	if (sort == 3) corner[random_bits() % 3] = ts_scale(uniform3(-1, 1), 16777216);
	if (sort == 4)
		for (u32 k = 0; k < 3; k++) corner[k] = ts_add(centre, uniform3(-9, 9));
	if (sort == 5) {
		for (u32 k = 0; k < 3; k++) {
			corner[k] = ts_v3_make(ts_floor(corner[k].x), ts_floor(corner[k].y), ts_floor(corner[k].z));
		}
	}
}

/* As visibility leaves them: no bit of a cube that is out of sight, some bits of the others. */
static void random_visibility(mesh *m, u32 triangle)
{
	u64 *words = m->bits + triangle * 2;
	bool all = random_bits() % 3 != 0;
	for (u32 bit = 0; bit < m->n_cubes * 6; bit++) {
		bool seen = m->cubes[bit / 6].n != 0 && (all || random_bits() % 2 == 0);
		if (!seen) words[bit / 64] &= ~(1UL << bit % 64);
	}
}

static void random_mesh(mesh *m, setting *s)
{
	static const u32 sizes[] = {0, 1, 2, 7, 16, 33, 64};
	mesh_begin(m);
	s->n_cubes = 1 + random_bits() % (random_bits() % 8 == 0 ? MESH_CUBES : 3);
	for (u32 r = 0; r < s->n_cubes; r++) mesh_cube(m, uniform3(-4, 4), uniform_power(-6, 6), sizes[random_bits() % 7]);
	for (u32 t = 0; t < 6; t++) {
		ts_v3 corner[3];
		do extreme_corners(corner, ts_load3(m->cubes->centre));
		while (is_degenerate(corner));
		mesh_triangle(m, corner[0], corner[1], corner[2], t % 5, 0);
		random_visibility(m, t);
	}
	mesh_whole(m, 1);
	for (u32 t = 0; t < 6; t++) {
		f32 length;
		const ts_piece *p = &m->pieces[t];
		ts_k_longest_edge(ts_load3(p->a), ts_load3(p->b), ts_load3(p->c), &length);
		m->scale[t] = random_bits() % 8 == 0 ? 0 : s->samples / length;
	}
	mesh_points(m, s->half_size, s->paper_splat);
}

static ts_splat_args splat_of(const mesh *m, const setting *s, u64 *texels, i64 tallies[2])
{
	ts_splat_args args = mesh_splat(m, texels, &tallies[0], &tallies[1]);
	args.from.scene = mesh_arrays(m);
	args.from.half_size = s->half_size;
	args.from.paper_splat = s->paper_splat;
	args.clip = s->clip;
	args.inset = s->inset;
	args.plane_depth = s->plane_depth;
	args.n_pieces = m->n_pieces;
	return args;
}

/* Stored points by the plain kernel and by pieces; the same points made on the spot by the plain kernel and its fast
 * path: texels and counts are one. */
static void assert_equal(const mesh *m, const setting *s)
{
	static const char *const names[] = {"stored", "stored, fast", "made", "made, fast"};
	u64 n = mesh_texels(m), *texels[4];
	for (u32 way = 0; way < 4; way++) {
		i64 tallies[2] = {0, 0};
		static i64 first[2];
		texels[way] = mesh_alloc(n, sizeof **texels);
		memset(texels[way], 0xff, n * sizeof **texels);
		ts_splat_args args = splat_of(m, s, texels[way], tallies);
		if (way > 0) args.from.offset = m->count;
		if (way >= 2) args.from.points = NULL;
		if (way == 0) ts_c_launch(TS_KERNEL_splat, &args, m->n_points, 1);
		if (way == 1) assert_true(ts_c_fast_splat(&args, m->n_pieces, s->threads));
		if (way == 2) ts_c_launch(TS_KERNEL_splat_fragments, &args, m->n_pieces, 1);
		if (way == 3) assert_true(ts_c_fast_splat_fragments(&args, m->n_pieces, s->threads));
		if (way == 0) memcpy(first, tallies, sizeof first);
		bool same = memcmp(texels[0], texels[way], n * sizeof **texels) == 0;
		if (same && memcmp(first, tallies, sizeof first) == 0) continue;
		fail_msg("%s: random %u: clip %u inset %g splat.plane_depth %u paper %u threads %u cubes %u half size %d "
		         "samples %a: scatters %lld %lld writes %lld %lld",
		         names[way], s->start, s->clip, (double)s->inset, s->plane_depth, s->paper_splat, s->threads,
		         s->n_cubes, s->half_size, (double)s->samples, (long long)first[0], (long long)tallies[0],
		         (long long)first[1], (long long)tallies[1]);
	}
	for (u32 way = 0; way < 4; way++) free(texels[way]);
}

/* Texels that a sample reads are those of the plain kernel, and the others are empty. Returns how many are read. */
static u64 assert_asked(const mesh *m, const setting *s, u32 n_pixels)
{
	ts_pixel pixels[PIXELS];
	ts_asked asked = {.n = 0};
	i64 tallies[2] = {0, 0};
	u64 n = mesh_texels(m), n_read = 0, *plain = mesh_alloc(n, sizeof *plain), *fast = mesh_alloc(n, sizeof *fast);
	memset(plain, 0xff, n * sizeof *plain);
	memset(fast, 0xff, n * sizeof *fast);
	random_pixels(pixels, n_pixels, m->n_cubes);
	ts_splat_args args = splat_of(m, s, plain, tallies);
	args.from.offset = m->count;
	ts_c_launch(TS_KERNEL_splat, &args, m->n_points, 1);
	args.texels = fast;
	args.pixels = pixels;
	args.view = &m->view;
	args.n_pixels = n_pixels;
	assert_true(ts_c_fast_splat(&args, m->n_pieces, s->threads));
	assert_true(ts_asked_make(&asked, &args, 1));
	for (u64 t = 0; t < n; t++) {
		n_read += asked.texel[t] != 0 && plain[t] != TS_EMPTY;
		if (fast[t] == (asked.texel[t] != 0 ? plain[t] : TS_EMPTY)) continue;
		fail_msg("random %u: clip %u splat.plane_depth %u paper %u threads %u cubes %u: texel %u", s->start, s->clip,
		         s->plane_depth, s->paper_splat, s->threads, s->n_cubes, (u32)t);
	}
	ts_asked_clear(&asked);
	free(plain);
	free(fast);
	return n_read;
}

/* Texels of a run; some then hold another point at the same distance, a nearer one, or none. */
static u64 *finished_texels(const mesh *m, const setting *s)
{
	i64 tallies[2] = {0, 0};
	u64 n = mesh_texels(m), *texels = mesh_alloc(n, sizeof *texels);
	memset(texels, 0xff, n * sizeof *texels);
	ts_splat_args args = splat_of(m, s, texels, tallies);
	ts_c_launch(TS_KERNEL_splat, &args, m->n_points, 1);
	for (u64 t = 0; t < n; t++) {
		u32 change = random_bits() % 16;
		if (texels[t] == TS_EMPTY) continue;
		if (change < 4) texels[t] ^= 1;
		if (change == 4) texels[t] -= 1ul << 32;
		if (change == 5) texels[t] = TS_EMPTY;
	}
	return texels;
}

/* Marks of stored points, and of points made on the spot. Returns how many texels are marked. */
static u64 assert_marks(const mesh *m, const setting *s)
{
	u64 n = mesh_texels(m), n_marked = 0, *texels = finished_texels(m, s);
	u8 *tie[3];
	for (u32 way = 0; way < 3; way++) {
		i64 tallies[2] = {0, 0};
		ts_splat_args args = splat_of(m, s, texels, tallies);
		args.mark = 1;
		args.tie = tie[way] = mesh_alloc(n, 1);
		memset(tie[way], 0, n);
		if (way > 0) args.from.offset = m->count;
		if (way == 2) args.from.points = NULL;
		if (way == 0) ts_c_launch(TS_KERNEL_splat, &args, m->n_points, 1);
		if (way == 1) assert_true(ts_c_fast_splat(&args, m->n_pieces, s->threads));
		if (way == 2) assert_true(ts_c_fast_splat_fragments(&args, m->n_pieces, s->threads));
		for (u64 t = 0; t < n; t++) {
			n_marked += way == 0 && tie[0][t] != 0;
			if (tie[way][t] == tie[0][t]) continue;
			fail_msg("random %u: clip %u splat.plane_depth %u paper %u threads %u cubes %u: tie of texel %u, way %u",
			         s->start, s->clip, s->plane_depth, s->paper_splat, s->threads, s->n_cubes, (u32)t, way);
		}
	}
	for (u32 way = 0; way < 3; way++) free(tie[way]);
	free(texels);
	return n_marked;
}

static void fast_splats_equal_the_kernel(void **state)
{
	(void)state;
	n_random = 0;
	u32 n = whole_or(1500, 400);
	u64 n_points = 0, n_asked = 0, n_marked = 0;
	for (u32 i = 0; i < n; i++) {
		mesh m;
		setting s = {.start = n_random,
		             .clip = random_bits() % 2,
		             .plane_depth = random_bits() % 4 == 0,
		             .paper_splat = random_bits() % 4 == 0,
		             .threads = 1 + random_bits() % 7,
		             .half_size = random_bits() % 2 == 0 ? 129 : 128,
		             .inset = random_bits() % 3 == 0 ? 0 : TS_SPLAT_INSET,
		             .samples = uniform_power(-6, 6)};
		random_mesh(&m, &s);
		n_points += m.n_points;
		assert_equal(&m, &s);
		n_asked += assert_asked(&m, &s, 3);
		n_marked += assert_marks(&m, &s);
		mesh_clear(&m);
	}
	assert_true(n_points > 50 * n && n_asked > 2 * n && n_marked > 20 * n);
}

/* Pieces of split triangles, in their order. */
static void fast_splats_of_pieces_equal_the_kernel(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_pieces = 0;
	for (u32 i = 0; i < 6; i++) {
		mesh m;
		mesh_begin(&m);
		mesh_cube(&m, uniform3(-1, 1), uniform_power(-2, 1), 48);
		mesh_cube(&m, uniform3(-1, 1), uniform_power(-2, 1), 16);
		for (u32 t = 0; t < 2; t++) mesh_triangle(&m, uniform3(-24, 24), uniform3(-24, 24), uniform3(-24, 24), 0, 0);
		ts_store3(m.view.eye, uniform3(-2, 2));
		i64 n_capped = 0;
		ts_density_args args = mesh_density(&m, &n_capped, 0.25f);
		args.cap = 0;
		mesh_split(&m, args);
		n_pieces += m.n_pieces;
		mesh_points(&m, 129, 0);
		setting s = {.start = i, .clip = i % 2, .threads = 2, .half_size = 129, .n_cubes = 2};
		s.inset = i % 3 == 0 ? 0 : TS_SPLAT_INSET;
		if (m.n_points < 400000) assert_equal(&m, &s);
		if (m.n_points < 400000) assert_asked(&m, &s, 3);
		if (m.n_points < 400000) assert_marks(&m, &s);
		mesh_clear(&m);
	}
	assert_true(n_pieces > 12);
}

/* A piece of several clusters, of which the last may be the nearest, and then pieces of a few points. */
static void asked_texels_of_clusters_equal_the_kernel(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < 40; i++) {
		mesh m;
		setting s = {.start = n_random, .clip = i % 2, .threads = 1, .half_size = 129, .n_cubes = 1, .samples = 150};
		s.inset = i % 3 == 0 ? 0 : TS_SPLAT_INSET;
		mesh_begin(&m);
		mesh_cube(&m, uniform3(-1, 1), uniform_power(-2, 1), 64);
		ts_v3 a = ts_add(uniform3(-8, 8), ts_v3_make(0, 0, 9)), b = ts_add(a, uniform3(-6, 6));
		mesh_triangle(&m, a, b, ts_add(b, uniform3(-6, 6)), 0, 0);
		for (u32 t = 0; t < 8; t++) {
			ts_v3 p = uniform3(-8, 8);
			mesh_triangle(&m, p, ts_add(p, uniform3(-1, 1)), ts_add(p, uniform3(-1, 1)), 0, 0);
		}
		mesh_whole(&m, 20);
		mesh_points(&m, 129, 0);
		assert_asked(&m, &s, PIXELS);
		mesh_clear(&m);
	}
}

/* Many points a row, in planes just ahead of the eye or through it; half of the scenes are far from the origin, where
 * squares have slack. */
static void splats_beside_the_eye_equal_the_kernel(void **state)
{
	(void)state;
	n_random = 0;
	u64 n_marked = 0;
	for (u32 i = 0; i < 150; i++) {
		mesh m;
		setting s = {.start = n_random, .clip = i % 4 / 2, .threads = 1, .half_size = 129, .n_cubes = 1};
		s.inset = TS_SPLAT_INSET;
		s.samples = uniform_power(2, 5);
		ts_v3 eye = ts_add(uniform3(-1, 1), ts_v3_make(i % 2 * 4000.0f, 0, 0));
		mesh_begin(&m);
		const f32 near = mesh_cube(&m, eye, uniform_power(0, 8), 64)->near;
		for (u32 t = 0; t < 6; t++) {
			ts_v3 corner[3];
			f32 ahead = uniform(-4, 4) * near;
			for (u32 k = 0; k < 3; k++) {
				corner[k] = ts_add(eye, uniform3(-4, 4));
				corner[k].z = eye.z + ahead + uniform(0, 0.25f) * near;
				if (t % 2 == 0)
					corner[k] = ts_v3_make(corner[k].x, eye.y + corner[k].z - eye.z, eye.z + corner[k].y - eye.y);
			}
			mesh_triangle(&m, corner[0], corner[1], corner[2], 0, 0);
		}
		mesh_whole(&m, s.samples);
		mesh_points(&m, 129, 0);
		n_marked += assert_marks(&m, &s);
		assert_asked(&m, &s, PIXELS);
		mesh_clear(&m);
	}
	assert_true(n_marked > 1000);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_splats_equal_the_kernel),
	                                   cmocka_unit_test(fast_splats_of_pieces_equal_the_kernel),
	                                   cmocka_unit_test(asked_texels_of_clusters_equal_the_kernel),
	                                   cmocka_unit_test(splats_beside_the_eye_equal_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
