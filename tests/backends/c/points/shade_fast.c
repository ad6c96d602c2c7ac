/* Fast shading equals the plain kernel bit for bit: of pixels and of entries of later bounces, whose samples see the
 * same points again and again, from many cubes, or nothing, or a mirror; of stored points, points that are made again,
 * and colours; with a texture and without. */
#include "backends/fast.h"
#include "backends/kernels.h"
#include "kernels/points/lookup.h"
#include "tests/kernels/points/mesh.h"

enum { N = 120, ENTRIES = 1500, SAMPLES = ENTRIES * TS_N_SAMPLES };

typedef struct {
	mesh m;
	ts_light light;
	ts_lookup_args args;
	ts_pixel pixels[ENTRIES];
	ts_bounce queue[ENTRIES];
	u32 found[SAMPLES], offset[SAMPLES + 1], used[ENTRIES];
	f32 next[SAMPLES * 3], radiance[ENTRIES * 3];
	u32 n, start, threads;
} scene;

static void random_mesh(mesh *m)
{
	mesh_begin(m);
	for (u32 i = 0; i < 5; i++) m->materials[i].roughness = 0.5f;
	m->materials[1].slot[0] = 0;
	m->texels[0] = (u64)random_bits() << 16;
	u32 n_cubes = 1 + random_bits() % MESH_CUBES;
	for (u32 r = 0; r < n_cubes; r++) mesh_cube(m, uniform3(-4, 4), 1, 8);
	for (u32 t = 0; t < 20; t++) {
		ts_v3 a = uniform3(-8, 8), b = ts_add(a, uniform3(-1, 1)), c = ts_add(a, uniform3(-1, 1));
		u32 at = mesh_triangle(m, a, b, c, t % 2, random_bits() % 3);
		for (u32 k = 0; k < 3; k++) {
			ts_vertex *v = &m->vertices[at * 3 + k];
			ts_store3(v->normal, uniform3(-1, 1));
			for (u32 channel = 0; channel < 3; channel++) v->colour[channel] = uniform(0, 1);
		}
	}
	mesh_whole(m, 1);
	for (u32 t = 0; t < m->n_pieces; t++) m->scale[t] = uniform_power(0, 6);
	mesh_points(m, 129, 0);
}

/* Points near the one before, or anywhere. */
static void random_samples(scene *s)
{
	u32 at = 0, n_points = s->m.n_points;
	for (u32 i = 0; i < s->n * s->args.n_samples; i++) {
		u32 sort = random_bits() % 64;
		at = sort == 0 ? random_bits() % n_points : (at + random_bits() % 3) % n_points;
		s->found[i] = sort == 1 ? TS_NONE : at;
		s->offset[i] = s->args.follow != 0 && s->found[i] != TS_NONE && sort < 8 ? 1 : 0;
		for (u32 k = 0; k < 3; k++) s->next[i * 3 + k] = uniform(0, 1);
	}
	mesh_scan(s->offset, s->n * s->args.n_samples);
}

static void random_entries(scene *s)
{
	u32 cube = 0;
	for (u32 i = 0; i < s->n; i++) {
		cube = random_bits() % 8 == 0 ? random_bits() % s->m.n_cubes : cube;
		s->pixels[i] = (ts_pixel){.reflector = cube, .tint_r = uniform(0, 1), .tint_g = uniform(0, 1), .tint_b = 1};
		s->queue[i] = (ts_bounce){.point = random_bits() % s->m.n_points, .reflector = cube};
	}
}

static void random_scene(scene *s)
{
	u32 way = random_bits() % 4;
	s->start = n_random;
	s->threads = 1 + random_bits() % 7;
	s->n = 1 + random_bits() % ENTRIES;
	random_mesh(&s->m);
	s->light = (ts_light){.kind = TS_LIGHT_KIND_POINT, .intensity = {9, 8, 7}};
	s->args = (ts_lookup_args){.from = {.scene = mesh_arrays(&s->m),
	                                    .pieces = s->m.pieces,
	                                    .frames = s->m.frames,
	                                    .points = s->m.points,
	                                    .keys = s->m.keys,
	                                    .offset = s->m.count,
	                                    .half_size = 129},
	                           .cubes = s->m.cubes,
	                           .pixels = s->pixels,
	                           .queue = s->queue,
	                           .found = s->found,
	                           .offset = s->offset,
	                           .next_radiance = s->next,
	                           .radiance = s->radiance,
	                           .used = s->used,
	                           .n_pieces = way == 1 ? s->m.n_pieces : 0,
	                           .coloured = way == 2,
	                           .first = random_bits() % 2,
	                           .follow = random_bits() % 2};
	s->args.from.scene.lights = &s->light;
	s->args.from.scene.n_lights = 1;
	s->args.n_samples = s->args.first != 0 ? TS_N_SAMPLES : TS_N_BOUNCE_SAMPLES;
	random_samples(s);
	random_entries(s);
}

static void fast_shading_equals_the_kernel(void **state)
{
	(void)state;
	static scene s;
	static f32 plain[ENTRIES * 3];
	n_random = 0;
	u64 n_points = 0;
	for (u32 i = 0; i < N; i++) {
		random_scene(&s);
		n_points += s.m.n_points;
		memset(s.radiance, 0, sizeof s.radiance);
		memset(s.used, 0, sizeof s.used);
		ts_c_launch(TS_KERNEL_shade, &s.args, s.n, 1);
		memcpy(plain, s.radiance, sizeof plain);
		for (u32 k = 0; k < s.n; k++) assert_int_equal(s.used[k], s.args.first != 0 ? TS_N_SAMPLES : 0);
		memset(s.radiance, 0, sizeof s.radiance);
		memset(s.used, 0, sizeof s.used);
		assert_true(ts_c_fast_shade(&s.args, s.n, s.threads));
		for (u32 k = 0; k < s.n; k++) assert_int_equal(s.used[k], s.args.first != 0 ? TS_N_SAMPLES : 0);
		for (u32 k = 0; k < ENTRIES * 3; k++) {
			if (memcmp(&plain[k], &s.radiance[k], sizeof *plain) == 0) continue;
			fail_msg("random %u: %u entries, %u threads, first %u follow %u pieces %u coloured %u: entry %u: %a %a",
			         s.start, s.n, s.threads, s.args.first, s.args.follow, s.args.n_pieces, s.args.coloured, k / 3,
			         (double)plain[k], (double)s.radiance[k]);
		}
		mesh_clear(&s.m);
	}
	assert_true(n_points > 4000 * N);
}

/* Where samples end a pixel early, the plain kernel counts. */
static void the_kernel_shades_adaptively(void **state)
{
	(void)state;
	ts_lookup_args args = {.adaptive = 1};
	assert_false(ts_c_fast_shade(&args, 1, 1));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_shading_equals_the_kernel),
	                                   cmocka_unit_test(the_kernel_shades_adaptively)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
