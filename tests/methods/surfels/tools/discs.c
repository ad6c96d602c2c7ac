/* Rays into surfels: all of them tried by Cramer's rule in double; and their truths against closed forms: what a surfel
 * covers, what two blend to, where one throws its shadow, and what a mesh and the checkerboard look like. */
#include "methods/surfels/tools/discs.h"
#include "methods/surfels/tools/tools.h"
#include "tests/methods/surfels/surfels.h"

enum { WIDTH = 64, HEIGHT = 48, N_RANDOM = 300, N_RAYS = 4000 };
#define NEAR_ENOUGH 1e-5

static const double nothing[3] = {0.2, 0.3, 0.5}; /* the sky */

static double random_in(double low, double high) { return low + (high - low) * (double)surfels_uniform(); }

static ts_v3 random_v3(double size)
{
	f32 x = (f32)random_in(-size, size), y = (f32)random_in(-size, size);
	return ts_v3_make(x, y, (f32)random_in(-size, size));
}

static double det(const double a[3], const double b[3], const double c[3])
{
	return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* o + t d = c + a u + b v, solved for a, b and t. */
static bool cramer(const ts_surfel *s, const ts_disc_ray *ray, double *t, double *r2)
{
	double u[3], v[3], to[3], d[3];
	for (u32 k = 0; k < 3; k++) {
		u[k] = (double)s->u[k];
		v[k] = (double)s->v[k];
		to[k] = ray->origin[k] - (double)s->centre[k];
		d[k] = -ray->direction[k];
	}
	double all = det(u, v, d), a = det(to, v, d) / all, b = det(u, to, d) / all;
	*t = det(u, v, to) / all;
	*r2 = a * a + b * b;
	return all > 0; /* the front: -d . (u x v) > 0 */
}

typedef struct {
	u32 n;
	double sum;
} taken;

static void take(void *user, const ts_disc_met *met)
{
	taken *all = user;
	all->n++;
	all->sum += met->t + met->r2 + met->surfel;
}

static void rays_meet_what_trying_all_finds(void **state)
{
	(void)state;
	ts_surfel surfels[N_RANDOM];
	ts_discs *discs;
	u32 n_hits = 0;
	surfels_random = 0;
	for (u32 i = 0; i < N_RANDOM; i++) {
		ts_v3 n = ts_normalize(random_v3(1)), u = ts_normalize(ts_cross(n, random_v3(1)));
		surfels[i] = (ts_surfel){.colour = {1, 1, 1}};
		ts_store3(surfels[i].centre, random_v3(4));
		ts_store3(surfels[i].u, ts_scale(u, (f32)random_in(0.01, 2)));
		ts_store3(surfels[i].v, ts_scale(ts_cross(n, u), (f32)random_in(0.01, 2)));
	}
	assert_int_equal(ts_discs_new(&discs, surfels, N_RANDOM, 2), TS_OK);
	for (u32 i = 0; i < N_RAYS; i++) {
		ts_v3 o = random_v3(6), d = ts_normalize(random_v3(1));
		double length = sqrt((double)d.x * (double)d.x + (double)d.y * (double)d.y + (double)d.z * (double)d.z);
		ts_disc_ray ray = {.origin = {(double)o.x, (double)o.y, (double)o.z},
		                   .near = i % 3,
		                   .direction = {(double)d.x / length, (double)d.y / length, (double)d.z / length}};
		double nearest = INFINITY, t, r2;
		u32 first = TS_NONE;
		taken all = {0, 0}, expected = {0, 0};
		for (u32 k = 0; k < N_RANDOM; k++) {
			bool front = cramer(&surfels[k], &ray, &t, &r2);
			if (!front || r2 > 1 || t < ray.near) continue;
			first = t < nearest ? k : first;
			nearest = t < nearest ? t : nearest;
		}
		ts_disc_met met = ts_discs_nearest(discs, &ray);
		assert_int_equal(met.surfel, first);
		n_hits += first != TS_NONE;
		if (first == TS_NONE) continue;
		assert_true(fabs(met.t - nearest) < 1e-9 * (1 + nearest));
		for (u32 k = 0; k < N_RANDOM; k++) {
			if (!cramer(&surfels[k], &ray, &t, &r2) || r2 > 1 || t < ray.near || t > nearest + 1.5) continue;
			expected.n++;
			expected.sum += t + r2 + k;
		}
		ts_discs_each(discs, &ray, nearest + 1.5, take, &all);
		assert_int_equal(all.n, expected.n);
		assert_true(fabs(all.sum - expected.sum) < 1e-7 * (1 + expected.sum));
	}
	assert_in_range(n_hits, N_RAYS / 4, N_RAYS / 2);
	ts_discs_free(discs);
}

static ts_params params_of(u32 rays)
{
	ts_params params = small_params(WIDTH, HEIGHT);
	params.reflectors_count = 0;
	params.truth_grid_rays = rays;
	params.surfel_depth_epsilon = 0.125f;
	return params;
}

/* A light along `direction`. */
static ts_build *begin(ts_v3 direction)
{
	ts_build *build = ts_build_new("discs");
	ts_light sun = {.intensity = {3, 3, 3}};
	ts_store3(sun.direction, direction);
	ts_build_light(build, &sun);
	return build;
}

static ts_scene *finish(ts_build *build, const ts_params *params)
{
	return surfels_finish(build, params, ts_v3_make(0, 0, 0), 0.125f); /* 45 degrees */
}

static f32 *truth_of(const ts_scene *scene, const ts_params *params)
{
	f32 *radiance;
	if (ts_truth_discs(&radiance, scene, params, 2, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	return radiance;
}

/* Pixels a unit, a unit deep. */
static double focal(void) { return HEIGHT / 2.0 / tan(acos(-1) / 8); }

/* The ray of a pixel's cell, to the right and up by a unit of depth. */
static void ray_at(double way[2], u32 p, u32 cell, u32 side)
{
	double place[2];
	ts_truth_place(place, p, cell, side, 0);
	way[0] = (p % WIDTH + place[0] - WIDTH / 2.0) / focal();
	way[1] = (HEIGHT / 2.0 - p / WIDTH - place[1]) / focal();
}

static void assert_pixel(const f32 *radiance, u32 p, const double expected[3])
{
	for (u32 k = 0; k < 3; k++) {
		double found = (double)radiance[3 * p + k];
		if (fabs(found - expected[k]) < NEAR_ENOUGH) continue;
		fail_msg("pixel %u channel %u: %g instead of %g", p, k, found, expected[k]);
	}
}

/* A ray a cell, anywhere in it, and in no pixel, cell or seed as in another: means and spreads as those of a uniform
 * distribution, and no correlation. */
static void rays_of_cells_are_uniform_and_independent(void **state)
{
	(void)state;
	enum { SIDE = 3, CELLS = SIDE * SIDE, PIXELS = 20000, N = CELLS * PIXELS };
	const u32 steps[4][3] = {{1, 0, 0}, {WIDTH, 0, 0}, {0, 1, 0}, {0, 0, 1}}; /* pixel, cell, seed */
	double mean[2] = {0, 0}, spread[2] = {0, 0}, across = 0, along[4] = {0, 0, 0, 0};
	for (u32 i = 0; i < N; i++) {
		u32 p = i / CELLS, cell = i % CELLS;
		double place[2], in[2], other[2];
		ts_truth_place(place, p, cell, SIDE, 5);
		for (u32 k = 0; k < 2; k++) {
			in[k] = place[k] * SIDE - (k == 0 ? cell % SIDE : cell / SIDE) - 0.5;
			assert_true(in[k] >= -0.5 - 1e-12 && in[k] < 0.5);
			mean[k] += in[k] / N;
			spread[k] += 12 * in[k] * in[k] / N;
		}
		across += 12 * in[0] * in[1] / N;
		for (u32 k = 0; k < 4; k++) {
			u32 next = (cell + steps[k][1]) % CELLS;
			ts_truth_place(other, p + steps[k][0], next, SIDE, 5 + steps[k][2]);
			along[k] += 12 * in[0] * (other[0] * SIDE - next % SIDE - 0.5) / N;
		}
	}
	const double sd = 1 / sqrt(N); /* of a correlation */
	for (u32 k = 0; k < 2; k++) assert_true(fabs(mean[k]) < 4 * sd / sqrt(12) && fabs(spread[k] - 1) < 4 * sd);
	assert_true(fabs(across) < 4 * sd);
	for (u32 k = 0; k < 4; k++) assert_true(fabs(along[k]) < 4 * sd);
}

/* An ellipse that faces the eye, in ambient light: a pixel shows it by as many of its rays as stand in the ellipse. */
static void an_ellipse_covers_its_area(void **state)
{
	(void)state;
	const u32 side = 5;
	const double depth = 4, half[2] = {1, 0.6}, at[2] = {0.3, -0.2};
	double way[2];
	ts_params params = params_of(side);
	ts_build *build = begin(ts_v3_make(0, 0, 1));
	const f32 colour[3] = {0.5f, 1, 0.25f};
	ts_surfel s = {
		.centre = {(f32)at[0], (f32)at[1], (f32)-depth}, .u = {(f32)half[0], 0, 0}, .v = {0, (f32)half[1], 0}};
	memcpy(s.colour, colour, sizeof colour);
	ts_build_surfel(build, &s);
	ts_scene *scene = finish(build, &params);
	f32 *radiance = truth_of(scene, &params);
	double f = focal(), covered = 0, area = acos(-1) * half[0] * half[1] * f * f / (depth * depth);
	for (u32 p = 0; p < WIDTH * HEIGHT; p++) {
		u32 n = 0;
		double expected[3];
		for (u32 k = 0; k < side * side; k++) {
			ray_at(way, p, k, side);
			double x = way[0] * depth - at[0], y = way[1] * depth - at[1];
			n += x * x / (half[0] * half[0]) + y * y / (half[1] * half[1]) <= 1;
		}
		double share = (double)n / (side * side), ambient = (double)scene->info.ambient;
		for (u32 k = 0; k < 3; k++) expected[k] = share * ambient * (double)colour[k] + (1 - share) * nothing[k];
		assert_pixel(radiance, p, expected);
		covered += share;
	}
	assert_true(fabs(covered / area - 1) < 0.003);
	free(radiance);
	ts_scene_free(scene);
}

static void add_facing(ts_build *build, double depth, double radius, const f32 colour[3])
{
	ts_surfel s = {.centre = {0, 0, (f32)-depth}, .u = {(f32)radius, 0, 0}, .v = {0, (f32)radius, 0}};
	memcpy(s.colour, colour, sizeof s.colour);
	ts_build_surfel(build, &s);
}

/* Discs behind each other: the second is near enough behind the first to be blended with it, the third is not. */
static void discs_near_enough_are_blended(void **state)
{
	(void)state;
	const double depth[2] = {4, 4.125 - 0.01}, radius = 5;
	const f32 colour[3][3] = {{1, 0, 0.5f}, {0, 1, 0.5f}, {0, 0, 1}};
	ts_params params = params_of(1);
	ts_build *build = begin(ts_v3_make(0, 0, 1));
	for (u32 i = 0; i < 2; i++) add_facing(build, depth[i], radius, colour[i]);
	add_facing(build, 5, radius, colour[2]);
	ts_scene *scene = finish(build, &params);
	f32 *radiance = truth_of(scene, &params);
	u32 n_both = 0;
	for (u32 p = 0; p < WIDTH * HEIGHT; p++) {
		double way[2], weight[2], expected[3];
		ray_at(way, p, 0, 1);
		double across = hypot(way[0], way[1]);
		bool both = (depth[1] - depth[0]) * hypot(1, across) <= (double)params.surfel_depth_epsilon;
		for (u32 i = 0; i < 2; i++) {
			double r = depth[i] * across / radius / (double)params.ewa_sigma_k;
			weight[i] = i == 0 || both ? exp(-0.5 * r * r) : 0;
		}
		for (u32 k = 0; k < 3; k++) {
			double sum = weight[0] * (double)colour[0][k] + weight[1] * (double)colour[1][k];
			expected[k] = (double)scene->info.ambient * sum / (weight[0] + weight[1]);
		}
		assert_pixel(radiance, p, expected);
		n_both += both;
	}
	assert_in_range(n_both, WIDTH * HEIGHT / 4, WIDTH * HEIGHT - 100);
	free(radiance);
	ts_scene_free(scene);
}

/* A small disc before a large one: the sun throws it as a circle of the same size, away from where the eye sees it. */
static void a_disc_casts_a_shadow_its_size(void **state)
{
	(void)state;
	const f32 grey[3] = {0.5f, 0.5f, 0.5f};
	ts_params params = params_of(1);
	params.deferred_shader = TS_SHADER_PHONG_SHADOW;
	ts_build *build = begin(ts_v3_make(0.6f, 0, -0.8f));
	add_facing(build, 5, 6, grey);
	ts_surfel s = {.centre = {-1.5f, 0, -3}, .u = {0.5f, 0, 0}, .v = {0, 0.5f, 0}, .colour = {1, 1, 1}};
	ts_build_surfel(build, &s);
	ts_scene *scene = finish(build, &params);
	f32 *radiance = truth_of(scene, &params);
	u32 n_dark = 0;
	for (u32 p = 0; p < WIDTH * HEIGHT; p++) {
		double way[2];
		ray_at(way, p, 0, 1);
		if (hypot(3 * way[0] + 1.5, 3 * way[1]) <= 0.51) continue; /* the small one itself */
		bool dark = hypot(5 * way[0], 5 * way[1]) <= 0.5;
		double ambient = (double)(scene->info.ambient * grey[0]), lit = (double)radiance[3 * p];
		assert_true(dark ? fabs(lit - ambient) < NEAR_ENOUGH : lit > ambient + 0.8 * 0.5 * 3 / acos(-1) - NEAR_ENOUGH);
		n_dark += dark;
	}
	assert_in_range(n_dark, 90, 120);
	free(radiance);
	ts_scene_free(scene);
}

static f32 *surface_of(const char *spec, const ts_params *params, ts_scene **scene)
{
	f32 *radiance;
	if (ts_scene_load(scene, spec, params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	assert_true(ts_truth_has_surface(*scene, params));
	if (ts_truth_surface(&radiance, *scene, params, 2, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	return radiance;
}

/* Every channel is between those of the raster's pixel and its eight neighbours. */
static bool is_among(const f32 *radiance, const f32 *raster, u32 p)
{
	for (u32 k = 0; k < 3; k++) {
		f32 least = INFINITY, most = -INFINITY;
		for (u32 n = 0; n < 9; n++) {
			i32 x = (i32)(p % WIDTH + n % 3) - 1, y = (i32)(p / WIDTH + n / 3) - 1;
			if (x < 0 || y < 0 || x >= WIDTH || y >= HEIGHT) continue;
			f32 value = raster[3 * (y * WIDTH + x) + (i32)k];
			least = fminf(least, value);
			most = fmaxf(most, value);
		}
		if (!(radiance[3 * p + k] > least - 0.02f && radiance[3 * p + k] < most + 0.02f)) return false;
	}
	return true;
}

/* One ray a pixel into the mesh sees the same as the raster about there, but for the levels of textures and details
 * smaller than a pixel. */
static void a_mesh_looks_as_rasterized(void **state)
{
	(void)state;
	static const char *const stages[] = {"pose", "eye", "gbuffer", "deferred", NULL};
	ts_run run;
	ts_scene *scene;
	ts_params params = params_of(1);
	params.surfels_from_mesh = 2000;
	f32 *radiance = surface_of("dining:triangles=10000:texels=16", &params, &scene);
	surfels_run(&run, scene, &params, "deferred", 2);
	for (u32 k = 0; stages[k] != NULL; k++) assert_int_equal(ts_run_stage(&run, ts_stage_find(stages[k])), TS_OK);
	const f32 *raster = ts_frame_data(&run.frame, TS_B_image_radiance);
	u32 n_same = 0;
	for (u32 p = 0; p < WIDTH * HEIGHT; p++) n_same += is_among(radiance, raster, p);
	print_message("# %u of %u pixels as the raster has them\n", n_same, WIDTH * HEIGHT);
	assert_true(n_same > WIDTH * HEIGHT * 9 / 10);
	params.surfels_from_mesh = 0;
	assert_false(ts_truth_has_surface(scene, &params));
	free(radiance);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* The built-in board by its plane: light and dark in the middle of near squares, the sky above. */
static void the_board_follows_its_plane(void **state)
{
	(void)state;
	ts_scene *scene;
	ts_params params = params_of(1);
	f32 *radiance = surface_of("checkerboard:surfels=10000", &params, &scene);
	const ts_camera *camera = &scene->cameras[scene->camera];
	u32 n_squares[2] = {0, 0}, n_sky = 0;
	for (u32 p = 0; p < WIDTH * HEIGHT; p++) {
		double way[2], d[3];
		ray_at(way, p, 0, 1);
		for (u32 k = 0; k < 3; k++)
			d[k] = way[0] * (double)camera->right[k] + way[1] * (double)camera->up[k] - (double)camera->back[k];
		double t = -(double)camera->eye[1] / d[1];
		double x = (double)camera->eye[0] + t * d[0], z = (double)camera->eye[2] + t * d[2];
		if (d[1] >= 0 || z < -256 || fabs(x) > 32) {
			assert_pixel(radiance, p, nothing);
			n_sky++;
			continue;
		}
		bool middle = fabs(x - floor(x) - 0.5) < 0.49 && fabs(z - floor(z) - 0.5) < 0.49;
		bool light = ((i64)floor(x) + (i64)floor(z)) % 2 == 0, shines = radiance[3 * p] > 0.4f;
		if (!middle) continue;
		assert_int_equal(light, shines);
		n_squares[light]++;
	}
	assert_true(n_sky > 300 && n_squares[0] > 300 && n_squares[1] > 300);
	free(radiance);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(rays_meet_what_trying_all_finds), cmocka_unit_test(rays_of_cells_are_uniform_and_independent),
		cmocka_unit_test(an_ellipse_covers_its_area),      cmocka_unit_test(discs_near_enough_are_blended),
		cmocka_unit_test(a_disc_casts_a_shadow_its_size),  cmocka_unit_test(a_mesh_looks_as_rasterized),
		cmocka_unit_test(the_board_follows_its_plane),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
