/* The texels that samples read are marked, no other; and boxes of texels without a marked one are told, of faces of any
 * size. */
#include "backends/c/points/asked_texels.h"
#include "kernels/points/lookup.h"
#include "tests/kernels/points/pixels.h"

enum { N = 300, PIXELS = 7, BOXES = 400 };

static const u32 sizes[] = {0, 1, 2, 3, 7, 16, 33, 64};

typedef struct {
	mesh m;
	ts_pixel pixels[PIXELS];
	ts_splat_args args;
	ts_asked asked;
	u32 start;
} scene;

static void random_scene(scene *s)
{
	s->start = n_random;
	u32 n_cubes = 1 + random_bits() % MESH_CUBES;
	mesh_begin(&s->m);
	for (u32 r = 0; r < n_cubes; r++) mesh_cube(&s->m, uniform3(-1, 1), 1, sizes[random_bits() % 8]);
	ts_store3(s->m.view.eye, uniform3(-4, 4));
	random_pixels(s->pixels, PIXELS, n_cubes);
	s->args = (ts_splat_args){.pixels = s->pixels,
	                          .view = &s->m.view,
	                          .cubes = s->m.cubes,
	                          .n_cubes = n_cubes,
	                          .n_pixels = random_bits() % (PIXELS + 1)};
	s->asked = (ts_asked){.n = 0};
	assert_true(ts_asked_make(&s->asked, &s->args, 1 + random_bits() % 3));
}

/* 1 for each texel that a look-up of the kernel reads: texels hold their own numbers. */
static u8 *read_by_kernel(const scene *s)
{
	u64 n = mesh_texels(&s->m), *texels = mesh_alloc(n, sizeof *texels);
	u8 *reads = mesh_alloc(n, 1);
	u32 found[PIXELS * TS_N_SAMPLES];
	for (u64 t = 0; t < n; t++) texels[t] = t;
	ts_lookup_args args = {.view = &s->m.view,
	                       .cubes = s->m.cubes,
	                       .texels = texels,
	                       .pixels = s->pixels,
	                       .found = found,
	                       .n_samples = TS_N_SAMPLES,
	                       .first = 1};
	memset(reads, 0, n);
	for (u32 i = 0; i < s->args.n_pixels; i++) {
		ts_k_lookup_item(&args, i);
		for (u32 k = 0; k < TS_N_SAMPLES; k++) {
			if (found[i * TS_N_SAMPLES + k] != TS_NONE) reads[found[i * TS_N_SAMPLES + k]] = 1;
		}
	}
	free(texels);
	return reads;
}

static void just_the_texels_read_are_marked(void **state)
{
	(void)state;
	n_random = 0;
	u64 n_read = 0;
	for (u32 i = 0; i < N; i++) {
		scene s;
		random_scene(&s);
		u8 *reads = read_by_kernel(&s);
		assert_int_equal(s.asked.n, mesh_texels(&s.m));
		for (u64 t = 0; t < s.asked.n; t++) {
			if (s.asked.texel[t] != reads[t]) fail_msg("random %u: texel %u: %u", s.start, (u32)t, reads[t]);
			n_read += reads[t];
		}
		free(reads);
		ts_asked_clear(&s.asked);
	}
	assert_true(n_read > 10 * N);
}

static bool is_marked(const u8 *texel, u32 n, ts_box box)
{
	for (i32 y = ts_max_i32(box.y0, 0); y <= ts_min_i32(box.y1, (i32)n - 1); y++) {
		for (i32 x = ts_max_i32(box.x0, 0); x <= ts_min_i32(box.x1, (i32)n - 1); x++) {
			if (texel[(u32)y * n + (u32)x] != 0) return true;
		}
	}
	return false;
}

/* What is said to have a mark has one not farther away than four times its size. */
static void check_box(const scene *s, u32 cube, u32 side, ts_box box)
{
	const ts_face *of = &s->m.cubes[cube];
	const u8 *texel = s->asked.texel + of->offset + (u64)side * of->n * of->n;
	ts_asked_face face = ts_asked_face_of(&s->asked, s->m.cubes, cube, side);
	i32 far = 4 * (1 + ts_max_i32(box.x1 - box.x0, box.y1 - box.y0));
	ts_box near = {box.x0 - far, box.y0 - far, box.x1 + far, box.y1 + far};
	bool any = ts_asked_any(&face, box);
	if (any ? is_marked(texel, of->n, near) : !is_marked(texel, of->n, box)) return;
	fail_msg("random %u: cube %u of %u, face %u: box %d %d %d %d: %d", s->start, cube, of->n, side, box.x0, box.y0,
	         box.x1, box.y1, any);
}

static ts_box random_box(u32 n)
{
	i32 a = (i32)(random_bits() % n), b = (i32)(random_bits() % n), c = (i32)(random_bits() % n);
	i32 d = (i32)(random_bits() % n), small = (i32)(random_bits() % 4);
	bool far = random_bits() % 3 == 0;
	i32 x1 = far ? ts_max_i32(a, b) : ts_min_i32(a + small, (i32)n - 1);
	i32 y1 = far ? ts_max_i32(c, d) : ts_min_i32(c + small, (i32)n - 1);
	return (ts_box){far ? ts_min_i32(a, b) : a, far ? ts_min_i32(c, d) : c, x1, y1};
}

static void boxes_without_a_mark_are_told(void **state)
{
	(void)state;
	n_random = 0;
	u64 n_empty = 0;
	for (u32 i = 0; i < N; i++) {
		scene s;
		random_scene(&s);
		for (u32 k = 0; k < BOXES; k++) {
			u32 cube = random_bits() % s.args.n_cubes, side = random_bits() % 6, n = s.m.cubes[cube].n;
			ts_box box = random_box(n > 0 ? n : 1);
			ts_asked_face face = ts_asked_face_of(&s.asked, s.m.cubes, cube, side);
			if (n > 0) check_box(&s, cube, side, box);
			n_empty += n > 0 && !ts_asked_any(&face, box);
		}
		ts_asked_clear(&s.asked);
	}
	ts_asked nobody = {.n = 0};
	ts_face cube = {.n = 4};
	ts_asked_face face = ts_asked_face_of(&nobody, &cube, 0, 0);
	assert_true(ts_asked_any(&face, (ts_box){0, 0, 3, 3}));
	assert_true(n_empty > 50 * N);
}

/* Closed texels keep a key that nothing beats, and are empty after it; the others never change. */
static void closed_texels_keep_a_key_nothing_beats(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		scene s;
		random_scene(&s);
		u64 *texels = mesh_alloc(s.asked.n, sizeof *texels);
		for (u64 t = 0; t < s.asked.n; t++) texels[t] = TS_EMPTY - t;
		ts_asked_close(&s.asked, texels, 2);
		for (u64 t = 0; t < s.asked.n; t++) assert_true(texels[t] == (s.asked.texel[t] != 0 ? TS_EMPTY - t : 0));
		ts_asked_open(&s.asked, texels, 2);
		for (u64 t = 0; t < s.asked.n; t++) assert_true(texels[t] == (s.asked.texel[t] != 0 ? TS_EMPTY - t : TS_EMPTY));
		free(texels);
		ts_asked_clear(&s.asked);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(just_the_texels_read_are_marked),
	                                   cmocka_unit_test(boxes_without_a_mark_are_told),
	                                   cmocka_unit_test(closed_texels_keep_a_key_nothing_beats)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
