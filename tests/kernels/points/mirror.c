/* MVR's look-ups: constant cubes, seams between faces, the level of detail, and which pixels a batch answers. */
#include "kernels/points/mirror.h"
#include "tests/kernels/points/mesh.h"

/* A chain of levels, all filled by `fill` from face, s and t of the texel's middle. */
typedef ts_v3 filling(u32 face, f32 s, f32 t);

static f32 *chain(u32 n, filling *fill)
{
	f32 *texels = mesh_alloc(ts_k_mip_texels(n, TS_NONE) * 4, sizeof *texels), *out = texels;
	for (u32 level = 0; level < ts_k_mip_levels(n); level++) {
		u32 size = ts_k_mip_size(n, level);
		for (u32 i = 0; i < 6 * size * size; i++, out += 4) {
			f32 s = (f32)(2 * (i % size) + 1) / (f32)size - 1, t = (f32)(2 * (i / size % size) + 1) / (f32)size - 1;
			ts_store3(out, fill(i / (size * size), s, t));
			out[3] = 1;
		}
	}
	return texels;
}

static ts_v3 constant(u32 face, f32 s, f32 t)
{
	(void)face;
	(void)s;
	(void)t;
	return ts_v3_make(0.75f, 0.1f, 2);
}

static ts_v3 noise(u32 face, f32 s, f32 t)
{
	(void)face;
	(void)s;
	(void)t;
	return uniform3(0, 1);
}

static ts_v3 direction_of(u32 face, f32 s, f32 t) { return ts_normalize(ts_k_cube_direction(face, s, t)); }

static double apart(ts_v3 a, ts_v3 b) { return d3_length(d3_sub(d3_of(a), d3_of(b))); }

/* A pixel whose mirror sends the eye's ray along d: the eye at 0, the mirror half way between its ray and d. */
static ts_pixel pixel_towards(ts_v3 d, u32 reflector)
{
	ts_v3 in = ts_normalize(ts_add(ts_neg(d), ts_v3_make(0.3f, 0.2f, 0.1f)));
	ts_pixel p = {.reflector = reflector, .tint_r = 1, .tint_g = 1, .tint_b = 1};
	ts_store3(p.position, ts_scale(in, 2));
	ts_store3(p.normal, ts_normalize(ts_sub(d, in)));
	return p;
}

static ts_pixel random_pixel(ts_v3 *d, f32 change)
{
	*d = ts_normalize(uniform3(-1, 1));
	ts_pixel p = pixel_towards(*d, 0);
	ts_store3(p.normal_dx, uniform3(-change, change));
	ts_store3(p.normal_dy, uniform3(-change, change));
	ts_store3(p.position_dx, uniform3(-change, change));
	ts_store3(p.position_dy, uniform3(-change, change));
	return p;
}

/* A cube of one colour shows that colour in every direction, at every level, with every filter. */
static void constant_cubes_show_their_colour(void **state)
{
	(void)state;
	n_random = 0;
	ts_v3 colour = constant(0, 0, 0), eye = ts_v3_make(0, 0, 0), d;
	for (u32 n = 1; n <= 40; n++) {
		f32 *texels = chain(n, constant);
		ts_mip_cube cube = {texels, n};
		for (u32 i = 0; i < 500; i++) {
			ts_pixel p = random_pixel(&d, uniform_power(-10, 1));
			assert_true(apart(ts_k_mirror_trilinear(&cube, &p, eye), colour) <= 1e-6);
			assert_true(apart(ts_k_mirror_supersample(&cube, &p, eye), colour) <= 2e-6);
		}
		free(texels);
	}
}

/* Never darker or brighter than the texels. */
static void no_look_up_is_beyond_the_texels(void **state)
{
	(void)state;
	n_random = 0;
	ts_v3 eye = ts_v3_make(0, 0, 0), d;
	for (u32 n = 1; n <= 40; n++) {
		f32 *texels = chain(n, noise);
		ts_mip_cube cube = {texels, n};
		for (u32 i = 0; i < 500; i++) {
			ts_pixel p = random_pixel(&d, uniform_power(-10, 1));
			ts_v3 c = ts_k_mirror_trilinear(&cube, &p, eye);
			assert_true(c.x > -1e-6f && c.x < 1.000001f && c.y > -1e-6f && c.y < 1.000001f);
		}
		free(texels);
	}
}

static void the_middle_of_a_texel_shows_it(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 n = 1; n <= 16; n *= 2) {
		f32 *texels = chain(n, noise);
		ts_mip_cube cube = {texels, n};
		for (u32 i = 0; i < 6 * n * n; i++) {
			f32 s = (f32)(2 * (i % n) + 1) / (f32)n - 1, t = (f32)(2 * (i / n % n) + 1) / (f32)n - 1;
			ts_cube_place place = {i / (n * n), s, t};
			ts_v3 c = ts_k_mip_bilinear(&cube, 0, place);
			assert_true(apart(c, ts_load3(texels + i * 4)) <= 1e-6);
		}
		free(texels);
	}
}

/* The face that meets `face` where s or t is +-1, and the same point there. */
static ts_cube_place across(u32 face, f32 s, f32 t)
{
	ts_v3 d = ts_k_cube_direction(face, s, t);
	f32 axis[3] = {d.x, d.y, d.z};
	ts_cube_place r = {TS_NONE, 0, 0};
	for (u32 other = 0; other < 6; other++) {
		if (other / 2 == face / 2 || axis[other / 2] != (other % 2 == 0 ? 1 : -1)) continue;
		r.face = other;
		r.s = ts_dot(ts_k_cube_row(other, 0), d);
		r.t = -ts_dot(ts_k_cube_row(other, 1), d);
	}
	return r;
}

/* Both faces of an edge agree along it, up to the texel before the corner, whatever the texels are. */
static void both_faces_of_an_edge_agree(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_edges = 0;
	for (u32 n = 4; n <= 32; n++) {
		f32 *texels = chain(n, noise);
		ts_mip_cube cube = {texels, n};
		for (u32 i = 0; i < 24 * 50; i++) {
			f32 along = uniform(-1, 1) * (1 - 1.01f / (f32)n), end = i / 6 % 2 == 0 ? 1 : -1;
			bool on_s = i / 12 % 2 == 0;
			ts_cube_place here = {i % 6, on_s ? end : along, on_s ? along : end};
			ts_cube_place there = across(here.face, here.s, here.t);
			assert_true(there.face < 6);
			n_edges++;
			assert_true(apart(ts_k_mip_bilinear(&cube, 0, here), ts_k_mip_bilinear(&cube, 0, there)) <= 1e-4);
		}
		free(texels);
	}
	assert_true(n_edges > 30000);
}

/* The level is log2 of the change of direction in texels, from 0 to the last. */
static void levels_follow_the_change_of_direction(void **state)
{
	(void)state;
	n_random = 0;
	ts_v3 eye = ts_v3_make(0, 0, 0), d;
	u32 n_between = 0;
	for (u32 i = 0; i < 20000; i++) {
		u32 n = 1 + random_bits() % 512;
		ts_pixel p = random_pixel(&d, uniform_power(-12, 0));
		double change = 0;
		for (u32 axis = 0; axis < 2; axis++) {
			d3 r[2];
			for (u32 side = 0; side < 2; side++) {
				double step = side == 0 ? -0.5 : 0.5;
				d3 at = d3_mad(d3_load(p.position), d3_load(axis == 0 ? p.position_dx : p.position_dy), step);
				d3 nn = d3_unit(d3_mad(d3_load(p.normal), d3_load(axis == 0 ? p.normal_dx : p.normal_dy), step));
				d3 in = d3_unit(at);
				r[side] = d3_mad(in, nn, -2 * d3_dot(in, nn));
			}
			change = fmax(change, d3_length(d3_sub(r[1], r[0])));
		}
		double level = fmin(fmax(log2(fmax(n / 2.0 * change, 1)), 0), ts_k_mip_levels(n) - 1);
		n_between += level > 0 && level < ts_k_mip_levels(n) - 1;
		assert_true(fabs(ts_k_mirror_level(&p, eye, n) - level) <= 2e-3);
	}
	assert_true(n_between > 5000);
	ts_pixel flat = pixel_towards(ts_v3_make(0, 0, 1), 0);
	assert_true(ts_k_mirror_level(&flat, eye, 512) == 0);
}

/* A flat, still mirror shows the texel it sees: with 25 samples, and unfiltered at the texel's middle. */
static void flat_mirrors_show_the_texel_they_see(void **state)
{
	(void)state;
	n_random = 0;
	u32 n = 8;
	f32 *texels = chain(n, noise);
	ts_mip_cube cube = {texels, n};
	for (u32 i = 0; i < 6 * n * n; i++) {
		ts_v3 d =
			direction_of(i / (n * n), (f32)(2 * (i % n) + 1) / (f32)n - 1, (f32)(2 * (i / n % n) + 1) / (f32)n - 1);
		ts_pixel p = pixel_towards(d, 0);
		ts_v3 eye = ts_v3_make(0, 0, 0), expected = ts_load3(texels + i * 4);
		assert_true(apart(ts_k_mirror_supersample(&cube, &p, eye), expected) <= 1e-5);
		assert_true(apart(ts_k_mirror_trilinear(&cube, &p, eye), expected) <= 1e-4);
	}
	free(texels);
}

/* A batch answers the pixels of its cubes and leaves the others; a cube out of sight shows the background; all
 * tinted. */
static void a_batch_answers_its_cubes_pixels(void **state)
{
	(void)state;
	enum { N = 40 };
	f32 *texels = chain(4, constant), radiance[N * 3];
	ts_face cubes[4] = {{.n = 4}, {.n = 4}, {.n = 0}, {.n = 4}};
	ts_view view = {.focal = 1};
	ts_pixel pixels[N];
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		pixels[i] = pixel_towards(ts_normalize(uniform3(-1, 1)), i % 4);
		pixels[i].tint_g = 0.5f;
		radiance[i * 3] = radiance[i * 3 + 1] = -1;
	}
	for (u32 supersample = 0; supersample < 2; supersample++) {
		ts_mirror_args args = {.view = &view,
		                       .cubes = cubes,
		                       .pixels = pixels,
		                       .mip = texels,
		                       .radiance = radiance,
		                       .first_cube = 1,
		                       .n_cubes = 2,
		                       .supersample = supersample};
		for (u32 i = 0; i < N; i++) ts_k_mirror_item(&args, i);
		for (u32 i = 0; i < N; i++) {
			f32 red = i % 4 == 1 ? 0.75f : i % 4 == 2 ? 0.2f : -1, green = i % 4 == 1 ? 0.05f : i % 4 == 2 ? 0.15f : -1;
			assert_true(ts_abs(radiance[i * 3] - red) <= 1e-6f && ts_abs(radiance[i * 3 + 1] - green) <= 1e-6f);
		}
	}
	free(texels);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(constant_cubes_show_their_colour),      cmocka_unit_test(no_look_up_is_beyond_the_texels),
		cmocka_unit_test(the_middle_of_a_texel_shows_it),        cmocka_unit_test(both_faces_of_an_edge_agree),
		cmocka_unit_test(levels_follow_the_change_of_direction), cmocka_unit_test(flat_mirrors_show_the_texel_they_see),
		cmocka_unit_test(a_batch_answers_its_cubes_pixels),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
