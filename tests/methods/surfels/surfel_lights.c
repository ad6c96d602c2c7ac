/* Shadows of surfels by a point light, whose maps are the faces of a cube: rays from the light in double precision,
 * found by Embree, on every wall of a room with blockers all around the light, on edges and corners of the cube too;
 * without blockers no line where the faces meet; and each of several lights has its own views. */
#include "kernels/base/shade.h"
#include "kernels/raster/cube.h"
#include "kernels/raster/gbuffer.h"
#include "methods/surfels/tools/discs.h"
#include "tests/methods/surfels/surfels.h"

enum { WIDTH = 96, HEIGHT = 72, N_PIXELS = WIDTH * HEIGHT, TEXELS = 96 };
static const ts_v3 light_at = {0.1f, -0.05f, 0.07f};

static ts_params room_params(void)
{
	ts_params params = small_params(WIDTH, HEIGHT);
	params.reflectors_count = 0;
	params.depth_map_px = TEXELS;
	params.surfel_depth_epsilon = 0.02f;
	params.deferred_shader = TS_SHADER_PHONG_SHADOW;
	return params;
}

/* Surfels of a rectangle about c, that n points away from. */
static void add_sheet(ts_build *build, ts_v3 c, ts_v3 n, ts_v3 u, ts_v3 v, f32 spacing)
{
	i32 columns = (i32)ceilf(ts_length(u) / spacing), rows = (i32)ceilf(ts_length(v) / spacing);
	for (i32 k = 0; k < 4 * columns * rows; k++) {
		f32 a = ((f32)(k % (2 * columns)) + 0.5f) / (f32)columns - 1,
			b = ((f32)(k / (2 * columns)) + 0.5f) / (f32)rows - 1;
		ts_v3 p = ts_mad(ts_mad(c, u, a), v, b);
		surfels_add(build, p, n, 1.2f * spacing, 1, ts_v3_make(0.8f, 0.8f, 0.8f));
	}
}

static const f32 half_room[3] = {2, 1.2f, 1.6f};
static const ts_v3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/* Three pairs of walls, so apart that faces of the cube meet within them. */
static void add_room(ts_build *build)
{
	for (u32 k = 0; k < 6; k++) {
		u32 x = k / 2, y = (x + 1) % 3, z = (x + 2) % 3;
		ts_v3 n = ts_scale(axis[x], k % 2 != 0 ? 1 : -1);
		add_sheet(build, ts_scale(n, -half_room[x]), n, ts_scale(axis[y], half_room[y]),
		          ts_scale(axis[z], half_room[z]), 0.1f);
	}
}

/* In the 26 directions of a cube's faces, edges and corners. */
static void add_blockers(ts_build *build)
{
	for (i32 k = 0; k < 27; k++) {
		ts_v3 d = ts_v3_make((f32)(k % 3 - 1), (f32)(k / 3 % 3 - 1), (f32)(k / 9 - 1));
		if (k == 13) continue;
		d = ts_normalize(d);
		ts_v3 u = ts_normalize(ts_cross(d, fabsf(d.y) < 0.9f ? axis[1] : axis[0])), v = ts_cross(d, u);
		add_sheet(build, ts_mad(light_at, d, 0.5f), ts_neg(d), ts_scale(u, 0.08f), ts_scale(v, 0.08f), 0.04f);
	}
}

/* From the wall behind, along the axis of a face. */
static void look_along(ts_build *build, u32 face)
{
	char name[] = "eye";
	ts_camera camera = {.name = name, .yfov = 110.0f / 360};
	ts_v3 back = ts_k_cube_row(face, 2);
	ts_store3(camera.right, ts_neg(ts_k_cube_row(face, 0)));
	ts_store3(camera.up, ts_k_cube_row(face, 1));
	ts_store3(camera.back, back);
	ts_store3(camera.eye, ts_scale(back, 0.9f * half_room[face / 2]));
	ts_build_camera(build, &camera);
}

static ts_scene *room(u32 face, bool blockers, const ts_light *lights, u32 n_lights, const ts_params *params)
{
	ts_build *build = ts_build_new("room");
	for (u32 k = 0; k < n_lights; k++) ts_build_light(build, &lights[k]);
	add_room(build);
	if (blockers) add_blockers(build);
	look_along(build, face);
	ts_scene *scene;
	if (ts_build_finish(build, params, "eye", &scene) != TS_OK) fail_msg("%s", ts_error_message());
	return scene;
}

static ts_light bulb(void)
{
	ts_light light = {.kind = TS_LIGHT_KIND_POINT, .intensity = {3, 3, 3}};
	ts_store3(light.position, light_at);
	return light;
}

/* Something stands in the first three quarters of the way from the light, beside the point by so much of its
 * distance. */
static bool is_blocked(const ts_discs *discs, ts_v3 p, f32 right, f32 up)
{
	ts_v3 way = ts_sub(p, light_at), d = ts_normalize(way);
	ts_v3 u = ts_normalize(ts_cross(d, fabsf(d.y) < 0.9f ? axis[1] : axis[0])), v = ts_cross(d, u);
	ts_v3 aside = ts_mad(ts_mad(d, u, right), v, up);
	double length = sqrt((double)aside.x * aside.x + (double)aside.y * aside.y + (double)aside.z * aside.z);
	ts_disc_ray ray = {.origin = {light_at.x, light_at.y, light_at.z},
	                   .direction = {aside.x / length, aside.y / length, aside.z / length}};
	return ts_discs_nearest(discs, &ray).t < 0.75 * (double)ts_length(way);
}

/* What all rays within the texels about a point say; -1 where they do not agree. */
static int truth_of(const ts_discs *discs, ts_v3 p)
{
	enum { SIDE = 5, ALL = SIDE * SIDE };
	int n = 0;
	const f32 texel = 2.0f / TEXELS; /* at a distance of 1 */
	for (i32 k = 0; k < ALL; k++) n += is_blocked(discs, p, texel * (f32)(k % SIDE - 2), texel * (f32)(k / SIDE - 2));
	return n == 0 ? 1 : n == ALL ? 0 : -1;
}

/* Within two texels of where two faces of the cube meet. */
static bool is_at_seam(ts_v3 way)
{
	ts_cube_place place = ts_k_cube_place(way);
	return fmaxf(fabsf(place.s), fabsf(place.t)) > 1 - 4.0f / TEXELS;
}

typedef struct {
	u32 lit, dark, seam_lit, seam_dark, faces;
} seen;

static void look(seen *s, u32 face, const ts_params *params)
{
	ts_run run;
	ts_discs *discs;
	ts_light light = bulb();
	ts_scene *scene = room(face, true, &light, 1, params);
	surfels_run(&run, scene, params, "deferred", 2);
	assert_int_equal(ts_discs_new(&discs, scene->surfels, scene->n_surfels, 2), TS_OK);
	const ts_gpixel *pixels = ts_frame_data(&run.frame, TS_B_gbuffer_pixel);
	const u32 *lit = ts_frame_data(&run.frame, TS_B_shadow_test_lit);
	for (u32 i = 0; i < N_PIXELS; i++) {
		ts_v3 p = ts_load3(pixels[i].position), way = ts_sub(p, light_at);
		int truth = pixels[i].depth == TS_SKY ? -1 : truth_of(discs, p);
		if (truth < 0 || ts_dot(way, ts_load3(pixels[i].normal)) > -0.1f * ts_length(way)) continue;
		if ((int)lit[i] != truth) fail_msg("face %u, pixel %u, %u: %u", face, i % WIDTH, i / WIDTH, lit[i]);
		*(truth != 0 ? &s->lit : &s->dark) += 1;
		*(truth != 0 ? &s->seam_lit : &s->seam_dark) += is_at_seam(way);
		s->faces |= 1u << ts_k_cube_place(way).face;
	}
	ts_discs_free(discs);
	ts_run_end(&run);
	ts_scene_free(scene);
}

static void shadows_of_a_point_light_match_rays(void **state)
{
	(void)state;
	seen s = {.lit = 0};
	ts_params params = room_params();
	for (u32 face = 0; face < 6; face++) look(&s, face, &params);
	print_message("# %u lit and %u dark, of which %u and %u where faces meet\n", s.lit, s.dark, s.seam_lit,
	              s.seam_dark);
	assert_true(s.lit > 2 * N_PIXELS && s.dark > N_PIXELS / 8 && s.seam_lit > 200 && s.seam_dark > 200);
	assert_int_equal(s.faces, 63);
}

/* All walls are lit, to where they meet. */
static void without_blockers_seams_are_lit(void **state)
{
	(void)state;
	ts_params params = room_params();
	for (u32 face = 0; face < 6; face++) {
		ts_run run;
		ts_light light = bulb();
		ts_scene *scene = room(face, false, &light, 1, &params);
		surfels_run(&run, scene, &params, "deferred", 2);
		const ts_gpixel *pixels = ts_frame_data(&run.frame, TS_B_gbuffer_pixel);
		const u32 *lit = ts_frame_data(&run.frame, TS_B_shadow_test_lit);
		for (u32 i = 0; i < N_PIXELS; i++) assert_int_equal(lit[i], pixels[i].depth != TS_SKY);
		ts_run_end(&run);
		ts_scene_free(scene);
	}
}

static void several_lights_shine_as_each_alone(void **state)
{
	(void)state;
	ts_run run, alone;
	ts_params params = room_params();
	const ts_light sun = {.direction = {0.6f, -0.48f, -0.64f}, .intensity = {1, 1, 1}};
	ts_light lights[4] = {sun, bulb(), bulb(), bulb()};
	lights[2].position[0] += 0.8f;
	lights[3].kind = TS_LIGHT_KIND_SPOT;
	ts_store3(lights[3].direction, ts_v3_make(0, 0, -1));
	lights[3].spot_scale = 4;
	lights[3].spot_offset = -3;
	ts_scene *scene = room(5, true, lights, 4, &params);
	surfels_run(&run, scene, &params, "deferred", 2);
	const u32 *lit = ts_frame_data(&run.frame, TS_B_shadow_test_lit);
	assert_int_equal(ts_frame_n(&run.frame, TS_B_offscreen_view), 1 + 6 + 6 + 1);
	assert_int_equal(ts_frame_n(&run.frame, TS_B_depth_map_depth), 14 * TEXELS * TEXELS);
	for (u32 k = 0; k < 4; k++) {
		ts_scene *own = room(5, true, &lights[k], 1, &params);
		surfels_run(&alone, own, &params, "deferred", 2);
		const u32 *one = ts_frame_data(&alone.frame, TS_B_shadow_test_lit);
		u32 n_lit = 0;
		for (u32 i = 0; i < N_PIXELS; i++) {
			assert_int_equal(lit[4 * i + k], one[i]);
			n_lit += one[i];
		}
		assert_true(n_lit > 0 && n_lit < N_PIXELS);
		ts_run_end(&alone);
		ts_scene_free(own);
	}
	ts_run_end(&run);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(shadows_of_a_point_light_match_rays),
		cmocka_unit_test(without_blockers_seams_are_lit),
		cmocka_unit_test(several_lights_shine_as_each_alone),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
