/* The G-buffer against rays in double precision: position, depth, normal and albedo of a soup of triangles, the sky,
 * the screen's depth by its formula, and the footprint by which textures are read. */
#include "kernels/raster/eye.h"
#include "kernels/raster/gbuffer.h"
#include "tests/kernels/raster/sight.h"

enum { SIZE = 48, N_PIXELS = SIZE * SIZE * 3 / 4, N_SOUPS = 24, N_TRIANGLES = 24 };

static small_scene scene;
static ts_view eye;
static u64 keys[N_PIXELS];
static ts_gpixel pixels[N_PIXELS];

/* The eye from an off-screen view, whose first fields are an eye's. */
static void look(const ts_offscreen *from) { memcpy(&eye, from, sizeof eye); }

static void draw(void)
{
	ts_eye_args drawn = {.scene = small_arrays(&scene), .view = &eye, .texels = keys};
	ts_gbuffer_args args = {.scene = small_arrays(&scene), .view = &eye, .depth_triangle = keys, .pixels = pixels};
	memset(keys, 0xff, sizeof keys);
	memset(pixels, 0xff, sizeof pixels);
	for (u32 t = 0; t < scene.n_triangles; t++) ts_k_eye_item(&drawn, t);
	for (u32 i = 0; i < N_PIXELS; i++) ts_k_gbuffer_item(&args, i);
}

/* Shading normals on the side of the front, at every other triangle. */
static void add_normals(void)
{
	for (u32 t = 0; t < scene.n_triangles; t += 2) {
		for (u32 k = 0; k < 3; k++) {
			ts_v3 n = direction();
			bool behind = d3_dot(d3_of(n), normal_of(&scene, t)) < 0;
			ts_store3(scene.vertices[3 * t + k].normal, behind ? ts_neg(n) : n);
		}
	}
}

/* The normal that a viewer sees: the shading normal of the front, the opposite of the back. */
static double3 normal_at(const hit *h)
{
	const ts_vertex *v = &scene.vertices[3 * h->triangle];
	double3 face = normal_of(&scene, h->triangle), n = {0, 0, 0}, way = d3_sub(d3_of(ts_load3(eye.eye)), h->p);
	for (u32 k = 0; k < 3; k++) n = d3_mad(n, d3_of(ts_load3(v[k].normal)), (&h->w.x)[k]);
	if (d3_length(n) == 0) n = face;
	return d3_scale(d3_unit(n), d3_dot(face, way) < 0 ? -1 : 1);
}

static void check_pixel(const ts_gpixel *pixel, const sight *s)
{
	double depth[4], p[3][4], n[3][4], albedo[3][4];
	for (u32 k = 0; k < 4; k++) {
		const hit *h = &s->around[k];
		double3 normal = normal_at(h);
		depth[k] = 1 - (double)eye.near / h->z;
		for (u32 i = 0; i < 3; i++) {
			p[i][k] = (&h->p.x)[i];
			n[i][k] = (&normal.x)[i];
			albedo[i][k] = albedo_at(&scene, h, i);
		}
	}
	assert_among((double)pixel->depth, depth, 1e-6);
	for (u32 i = 0; i < 3; i++) {
		assert_among((double)pixel->position[i], p[i], 1e-5);
		assert_among((double)pixel->normal[i], n[i], 1e-3);
		assert_among((double)pixel->albedo[i], albedo[i], 1e-5);
	}
}

static void pixels_hold_what_rays_meet(void **state)
{
	(void)state;
	const ts_gpixel sky = {.depth = 1};
	u32 n_decided = 0, n_of[4][2] = {{0}}, n_sky = 0;
	for (u32 n = 0; n < N_SOUPS; n++) {
		ts_offscreen from = random_view(SIZE, 0);
		small_soup(&scene, N_TRIANGLES);
		add_normals();
		look(&from);
		draw();
		ts_camera_k camera = ts_k_view(&eye);
		for (u32 i = 0; i < N_PIXELS; i++) {
			sight s;
			if (!is_decided(&scene, &camera, TS_NONE, i, &s)) continue;
			n_decided++;
			n_sky += s.at.triangle == TS_NONE;
			if (s.at.triangle == TS_NONE) assert_memory_equal(&pixels[i], &sky, sizeof sky);
			if (s.at.triangle == TS_NONE) continue;
			assert_true(pixels[i].depth < 1 && pixels[i].pad0 == 0 && pixels[i].pad1 == 0);
			check_pixel(&pixels[i], &s);
			n_of[scene.triangles[s.at.triangle].material][scene.vertices[3 * s.at.triangle].object]++;
		}
	}
	assert_true(n_decided > N_SOUPS * N_PIXELS * 8 / 10 && n_sky > N_PIXELS);
	for (u32 m = 0; m < 4; m++) assert_true(n_of[m][0] > N_PIXELS / 4 && n_of[m][1] > N_PIXELS / 4);
}

/* 1 - near / z: within rounding, growing, 0 at the near plane, below 1 however far. */
static void screen_depth_grows_from_the_near_plane(void **state)
{
	(void)state;
	for (u32 n = 0; n < 1000; n++) {
		f32 near = (f32)exp2((double)uniform(-10, 4)), before = 0;
		assert_true(ts_k_screen_depth(near, near) == 0 && ts_k_screen_depth(near, near * 0.99f) == 0);
		for (f32 z = near; z < 1e30f; z *= uniform(1, 8)) {
			f32 depth = ts_k_screen_depth(near, z);
			assert_near(depth, 1 - (double)near / (double)z, 0x1p-23);
			assert_true(depth >= before && depth < TS_SKY);
			before = depth;
		}
	}
}

enum { SIDE = 16, N_LEVELS = 5, BRIGHT = 8192, REPEATS = 128, ACROSS = 64 };

/* A slanted wall about the origin. Level l of its image is l times as bright. */
static void make_wall(ts_v3 back)
{
	ts_v3 front = ts_normalize(ts_mad(back, direction(), 0.8f));
	ts_v3 u = ts_normalize(ts_cross(front, direction())), v = ts_cross(front, u);
	ts_v3 a = ts_scale(ts_add(u, v), -0.3f * ACROSS);
	small_clear(&scene);
	small_add(&scene, a, ts_mad(a, u, ACROSS), ts_mad(a, v, ACROSS), 0, 0);
	small_colour(&scene, 0, SIDE, 0);
	scene.slots[0].transform[0] = scene.slots[0].transform[4] = REPEATS;
	scene.materials[0].slot[0] = 0;
	for (u32 l = 0, at = 0; l < N_LEVELS; l++) {
		u32 side = SIDE >> l;
		for (u32 k = 0; k < side * side; k++) scene.texels[at++] = texel(l * BRIGHT, 0, 0, 65535);
	}
}

/* Textures are read at the level of a pixel: at axial depth z it is z / (focal sqrt cos) wide. */
static void textures_are_read_at_pixel_level(void **state)
{
	(void)state;
	u32 n_seen = 0;
	for (u32 n = 0; n < N_SOUPS; n++) {
		ts_offscreen from = random_view(SIZE, 0);
		make_wall(ts_load3(from.back));
		look(&from);
		draw();
		ts_camera_k camera = ts_k_view(&eye);
		for (u32 i = 0; i < N_PIXELS; i++) {
			sight s;
			if (!is_decided(&scene, &camera, TS_NONE, i, &s) || s.at.triangle == TS_NONE) continue;
			double3 way = d3_unit(d3_sub(d3_of(ts_load3(eye.eye)), s.at.p));
			double cosine = d3_dot(way, d3_unit(normal_of(&scene, 0)));
			double level = log2(s.at.z / (double)eye.focal / sqrt(cosine) * SIDE * REPEATS / ACROSS);
			if (cosine < 0.1 || level < 0.1 || level > N_LEVELS - 1.1) continue;
			n_seen++;
			assert_near((double)pixels[i].albedo[0] * 65535 / BRIGHT, level, 0.02);
		}
	}
	assert_true(n_seen > 4 * N_PIXELS);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(pixels_hold_what_rays_meet),
		seeded_test(screen_depth_grows_from_the_near_plane),
		seeded_test(textures_are_read_at_pixel_level),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
