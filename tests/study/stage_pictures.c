/* Pictures of stages: as many as there is room for, found by name; what a mask leaves out is the image in grey; and
 * each picture of a family, pixel by pixel, is what its caption says of the buffers. */
#include <math.h>
#include "image/falsecolour.h"
#include "kernels/base/srgb.h"
#include "kernels/points/forward.h"
#include "kernels/raster/gpixel.h"
#include "kernels/views/paraboloid.h"
#include "study/stage_pictures.h"
#include "tests/methods/small.h"

static void pictures_are_found_by_their_names(void **state)
{
	(void)state;
	ts_stage_pictures pictures = {.n = 0};
	for (u32 i = 0; i < TS_MAX_STAGE_PICTURES; i++) {
		char name[8];
		snprintf(name, sizeof name, "p%u", (unsigned)i);
		ts_stage_picture *p = ts_stage_pictures_add(&pictures, name, 2 + i, 3, i % 2 == 1);
		assert_non_null(p);
		assert_true(p->width == 2 + i && p->height == 3 && p->zoom == 1 && (p->mask != NULL) == (i % 2 == 1));
		for (u32 k = 0; k < (2 + i) * 3 * 3; k++) assert_int_equal(p->rgb[k], 0);
		for (u32 k = 0; p->mask != NULL && k < (2 + i) * 3; k++) assert_int_equal(p->mask[k], 0);
		assert_ptr_equal(ts_stage_pictures_find(&pictures, name), p);
	}
	assert_null(ts_stage_pictures_find(&pictures, "p"));
	assert_null(ts_stage_pictures_add(&pictures, "more", 1, 1, false));
	assert_non_null(strstr(ts_error_message(), "picture more: one more than 8"));
	assert_int_equal(pictures.n, TS_MAX_STAGE_PICTURES);
	ts_stage_pictures_free(&pictures);
	assert_int_equal(pictures.n, 0);
}

/* Of a picture three times as large as the image, and of one without a mask. */
static void what_a_mask_leaves_out_is_grey(void **state)
{
	(void)state;
	enum { W = 4, H = 3, ZOOM = 3 };
	u8 image[W * H * 3];
	ts_stage_pictures pictures = {.n = 0};
	for (u32 i = 0; i < sizeof image; i++) image[i] = (u8)(i * 53 + 7);
	ts_stage_picture *large = ts_stage_pictures_add(&pictures, "large", W * ZOOM, H * ZOOM, true);
	ts_stage_picture *whole = ts_stage_pictures_add(&pictures, "whole", W, H, false);
	large->zoom = ZOOM;
	memset(large->rgb, 9, W * ZOOM * H * ZOOM * 3);
	memset(whole->rgb, 9, W * H * 3);
	for (u32 i = 0; i < W * ZOOM * H * ZOOM; i++) large->mask[i] = i % 5 == 0;
	ts_stage_pictures_finish(&pictures, image);
	for (u32 y = 0; y < H * ZOOM; y++) {
		for (u32 x = 0; x < W * ZOOM; x++) {
			const u8 *pixel = image + 3 * (y / ZOOM * W + x / ZOOM), *found = large->rgb + 3 * (y * W * ZOOM + x);
			u8 grey = (u8)((pixel[0] + 2 * pixel[1] + pixel[2]) / 12);
			for (u32 c = 0; c < 3; c++) assert_int_equal(found[c], (y * W * ZOOM + x) % 5 == 0 ? 9 : grey);
		}
	}
	for (u32 i = 0; i < W * H * 3; i++) assert_int_equal(whole->rgb[i], 9);
	ts_stage_pictures_free(&pictures);
}

/* A run whose pictures were taken. */
typedef struct {
	ts_scene *scene;
	ts_run run;
	ts_stage_pictures pictures;
} pictured;

static ts_status take(const ts_run *run, const ts_stage *stage, void *user)
{
	return ts_stage_pictures_take(user, run, stage);
}

static const void *data(const pictured *p, ts_buffer_id id) { return ts_frame_data(&p->run.frame, id); }
static u64 count(const pictured *p, ts_buffer_id id) { return ts_frame_n(&p->run.frame, id); }

static void draw(pictured *p, const char *effect, const char *method, const ts_params *params)
{
	*p = (pictured){.scene = small_scene(params)};
	ts_run_begin(&p->run, p->scene, params, 2);
	p->run.hook = take;
	p->run.hook_user = &p->pictures;
	assert_int_equal(ts_pipeline_run(ts_pipeline_find(effect, method), &p->run), TS_OK);
}

static void drop(pictured *p)
{
	ts_stage_pictures_free(&p->pictures);
	ts_run_end(&p->run);
	ts_scene_free(p->scene);
}

static const ts_stage_picture *named(pictured *p, const char *name, const char *words)
{
	const ts_stage_picture *found = ts_stage_pictures_find(&p->pictures, name);
	assert_non_null(found);
	if (strstr(found->caption, words) == NULL) fail_msg("%s: %s", name, found->caption);
	return found;
}

static void assert_pixel(const ts_stage_picture *p, u64 x, u64 y, const u8 *rgb)
{
	const u8 *found = p->rgb + 3 * (y * p->width + x);
	if (memcmp(found, rgb, 3) != 0) {
		fail_msg("%s (%u, %u): %u %u %u, not %u %u %u", p->name, (unsigned)x, (unsigned)y, found[0], found[1], found[2],
		         rgb[0], rgb[1], rgb[2]);
	}
}

/* The cross: the sides in the middle row, +Y above and -Y below +Z. rgb: colours by face and texel. */
static void assert_cross(const ts_stage_picture *p, u32 n, const u8 *rgb)
{
	static const int faces[3][4] = {{-1, 2, -1, -1}, {1, 4, 0, 5}, {-1, 3, -1, -1}};
	static const u8 black[3];
	assert_true(p->width == 4 * n && p->height == 3 * n && p->mask == NULL);
	for (u32 y = 0; y < 3 * n; y++) {
		for (u32 x = 0; x < 4 * n; x++) {
			int face = faces[y / n][x / n];
			assert_pixel(p, x, y, face < 0 ? black : rgb + 3 * ((size_t)face * n * n + y % n * n + x % n));
		}
	}
}

static void names_of(u8 *rgb, const u64 *keys, u64 n)
{
	for (u64 i = 0; i < n; i++) {
		memset(rgb + 3 * i, 40, 3);
		if (keys[i] != TS_EMPTY) ts_falsecolour_name(rgb + 3 * i, (u32)keys[i]);
	}
}

/* The first of the largest cubes. */
static u32 largest(const pictured *p)
{
	const ts_face *faces = data(p, TS_B_cube_size_face);
	u32 most = 0;
	for (u32 r = (u32)count(p, TS_B_cube_size_face); r-- > 0;) most = faces[r].n >= faces[most].n ? r : most;
	assert_true(faces[most].n > 0);
	return most;
}

static void cubes_are_laid_out_as_a_cross(void **state)
{
	(void)state;
	pictured p;
	ts_params params = small_params_of_all();
	u8 rgb[6 * 16 * 16 * 3];
	params.reflectors_count = 3;
	draw(&p, "reflections", "epr", &params);
	const ts_face *cube = (const ts_face *)data(&p, TS_B_cube_size_face) + largest(&p);
	u64 n = (u64)6 * cube->n * cube->n;
	names_of(rgb, (const u64 *)data(&p, TS_B_splat_depth_index) + cube->offset, n);
	assert_cross(named(&p, "index", "a colour a point"), cube->n, rgb);
	drop(&p);
	draw(&p, "reflections", "epr-forward", &params);
	cube = (const ts_face *)data(&p, TS_B_cube_size_face) + largest(&p);
	const u64 *keys = (const u64 *)data(&p, TS_B_splat_depth_colour) + cube->offset;
	for (u64 i = 0; i < n; i++) {
		ts_v3 light = ts_k_shared_radiance((u32)keys[i]);
		const f32 of[3] = {light.x, light.y, light.z};
		for (u32 c = 0; c < 3; c++) rgb[3 * i + c] = keys[i] == TS_EMPTY ? 40 : (u8)ts_srgb_byte(of[c]);
	}
	assert_cross(named(&p, "cube", "radiance of points"), cube->n, rgb);
	drop(&p);
	params.reflectors_count = 1; /* all in one batch, which the frame keeps */
	draw(&p, "reflections", "mvr", &params);
	cube = data(&p, TS_B_cube_size_face);
	n = (u64)6 * cube->n * cube->n;
	names_of(rgb, data(&p, TS_B_cube_face_depth_triangle), n);
	assert_cross(named(&p, "index", "a colour a triangle"), cube->n, rgb);
	const f32 *mip = data(&p, TS_B_cube_face_mip);
	for (u64 i = 0; i < 3 * n; i++) rgb[i] = (u8)ts_srgb_byte(mip[i / 3 * 4 + i % 3]);
	assert_cross(named(&p, "cube", "radiance"), cube->n, rgb);
	drop(&p);
}

/* From white at the nearest to dark grey at the farthest depth; empty texels are blue. */
static void greys_of(u8 *rgb, const u32 *depths, u64 n)
{
	static const u8 empty[3] = {24, 24, 64};
	f32 least = INFINITY, most = 0;
	for (u64 i = 0; i < n; i++) {
		if (depths[i] == TS_NONE) continue;
		least = fminf(least, ts_u2f(depths[i]));
		most = fmaxf(most, ts_u2f(depths[i]));
	}
	assert_true(least < most);
	for (u64 i = 0; i < n; i++) {
		memcpy(rgb + 3 * i, empty, 3);
		if (depths[i] == TS_NONE) continue;
		memset(rgb + 3 * i, (int)(255 - 215 * ((ts_u2f(depths[i]) - least) / (most - least))), 3);
	}
}

static void assert_lit(pictured *p)
{
	const u32 *lit = data(p, TS_B_shadow_test_lit);
	const ts_lamp *lamps = data(p, TS_B_lamp_shape);
	u64 n = count(p, TS_B_lamp_shape), n_grey = 0;
	const ts_stage_picture *found = named(p, "lit", "samples that reach each pixel");
	for (u64 i = 0; i < (u64)found->width * found->height; i++) {
		double share = 0;
		for (u64 k = 0; k < n; k++) share += (double)lit[i * n + k] / lamps[k].samples / (double)n;
		bool seen = ((const u64 *)data(p, TS_B_eye_depth_triangle))[i] != TS_EMPTY;
		u8 grey = seen ? (u8)(255 * share + 0.5) : 40;
		assert_pixel(found, i % found->width, i / found->width, (const u8[]){grey, grey, grey});
		n_grey += grey > 40 && grey < 255;
	}
	assert_true(n_grey > 0);
}

static void depths_and_light_are_greys(void **state)
{
	(void)state;
	pictured p;
	ts_params params = small_params_of_all();
	u8 rgb[6 * 16 * 16 * 3];
	params.lamp_views_a_pass = params.lamp_views;
	draw(&p, "soft-shadows", "mvr", &params);
	greys_of(rgb, data(&p, TS_B_depth_map_depth), 16 * 16);
	const ts_stage_picture *map = named(&p, "depth", "depth map of the first light sample");
	for (u32 i = 0; i < 16 * 16; i++) assert_pixel(map, i % 16, i / 16, rgb + 3 * i);
	assert_lit(&p);
	drop(&p);
	params.lamp_cubes = 1;
	params.lamp_views_a_pass = 6;
	draw(&p, "omni-shadows", "mvr", &params);
	greys_of(rgb, data(&p, TS_B_depth_map_depth), sizeof rgb / 3);
	assert_cross(named(&p, "depth", "cube of the first light sample"), 16, rgb);
	drop(&p);
}

/* Both halves of the map behind the largest cube, side by side; corners beside the discs are black. */
static void the_map_of_a_view_is_two_discs(void **state)
{
	(void)state;
	pictured p;
	ts_params params = small_params_of_all();
	params.cube_view_px = 16;
	draw(&p, "reflections", "megaviews", &params);
	u32 n = p.run.plan.views.px;
	const f32 *colours = (const f32 *)data(&p, TS_B_view_map_colour) + (u64)largest(&p) * 2 * n * n * 3;
	const ts_stage_picture *found = named(&p, "view", "the half along +x, that along -x");
	assert_true(found->width == 2 * n && found->height == n);
	for (u32 y = 0; y < n; y++) {
		for (u32 x = 0; x < 2 * n; x++) {
			u32 texel = x / n * n * n + y * n + x % n;
			u8 rgb[3] = {0, 0, 0};
			double across = (2.0 * (x % n) + 1) / n - 1, down = (2.0 * y + 1) / n - 1;
			for (u32 c = 0; c < 3 && across * across + down * down <= 1; c++)
				rgb[c] = (u8)ts_srgb_byte(colours[3 * texel + c]);
			assert_pixel(found, x, y, rgb);
		}
	}
	drop(&p);
}

enum { GRID = 64, TEXEL = 2048 / GRID, BLOCK = 32 * TEXEL + 1 }; /* pixels; a block with the line before it */

/* Texels of the grid are squares, blocks are parted by black lines, and boxes are rings in the full colour. */
static void segments_stand_in_their_boxes(pictured *p)
{
	const ts_stage_picture *found = named(p, "segments", "32 pixels a texel");
	const u32 *labels = data(p, TS_B_segment_label);
	const f32 *depths = data(p, TS_B_depth_grid_depth);
	u32 side = 2 * BLOCK + 1;
	u8 *rgb = calloc((size_t)side * side, 3);
	assert_true(rgb != NULL && found->width == side && found->height == side);
	for (u32 y = 0; y < side; y++) {
		for (u32 x = 0; x < side; x++) {
			if (x % BLOCK == 0 || y % BLOCK == 0) continue;
			u32 column = x / BLOCK * 32 + (x % BLOCK - 1) / TEXEL, row = y / BLOCK * 32 + (y % BLOCK - 1) / TEXEL;
			u64 texel = (u64)row * GRID + column;
			u8 *to = rgb + 3 * ((size_t)y * side + x);
			ts_falsecolour_name(to, (row / 32 * 2 + column / 32) * 1024 + labels[texel]);
			for (u32 c = 0; c < 3; c++) to[c] = (u8)(to[c] / (depths[texel] == TS_SKY ? 8 : 2));
		}
	}
	const ts_segment *boxes = data(p, TS_B_segment_box);
	for (u64 b = 0; b < count(p, TS_B_segment_box); b++) {
		u32 low[2], high[2];
		for (u32 c = 0; c < 2; c++) {
			low[c] = boxes[b].low[c] * TEXEL + boxes[b].low[c] / 32 + 1;
			high[c] = (boxes[b].high[c] + 1) * TEXEL + boxes[b].high[c] / 32;
		}
		for (u32 y = low[1]; y <= high[1]; y++) {
			for (u32 x = low[0]; x <= high[0]; x++) {
				bool ring = x == low[0] || x == high[0] || y == low[1] || y == high[1];
				if (ring) ts_falsecolour_name(rgb + 3 * ((size_t)y * side + x), boxes[b].label);
			}
		}
	}
	for (u32 y = 0; y < side; y++) {
		for (u32 x = 0; x < side; x++) assert_pixel(found, x, y, rgb + 3 * ((size_t)y * side + x));
	}
	free(rgb);
}

/* How much of the brightest channel's peak a lobe sends along the direction of a disc's point. */
static double sent(const ts_view *eye, const ts_lobes *lobes, u32 c, double x, double y)
{
	double r = hypot(x, y), turned = acos(-1) * r, aside = r > 0 ? sin(turned) / r : 0, cosine = 0;
	double most = fmax(lobes->mu[0], fmax(lobes->mu[1], lobes->mu[2]));
	for (u32 k = 0; k < 3; k++) {
		double along = (double)eye->back[k] * cos(turned) + aside * (x * eye->right[k] + y * eye->up[k]);
		cosine += along * lobes->phi[3 * c + k];
	}
	return most > 0 ? lobes->mu[c] / most * exp(lobes->lambda[c] * (cosine - 1)) : 0;
}

/* In each corner of a box of 24 texels and more, the directions of its light; frames are grey. */
static void lobes_are_discs_in_corners(pictured *p)
{
	const ts_stage_picture *found = named(p, "lobes", "light by direction");
	const ts_segment *boxes = data(p, TS_B_segment_box);
	const ts_lobes *lobes = data(p, TS_B_corner_lobes);
	u32 n_discs = 0, zoom = found->zoom, width = p->run.params.width, height = p->run.params.height;
	double radius = (double)height * zoom * 32 / (GRID * 6);
	assert_true(zoom == 8 && found->width == 8 * width && found->height == 8 * height);
	for (u64 b = 0; b < count(p, TS_B_segment_box); b++) {
		u64 low[2], high[2];
		bool large = true;
		for (u32 c = 0; c < 2; c++) {
			u64 pixels = c == 0 ? found->width : found->height;
			low[c] = boxes[b].low[c] * pixels / GRID;
			high[c] = (boxes[b].high[c] + 1) * pixels / GRID;
			large &= boxes[b].high[c] - boxes[b].low[c] >= 23;
		}
		for (u32 k = 0; k < 4 && large; k++) {
			double x = k % 2 == 0 ? (double)low[0] + radius + 1 : (double)high[0] - radius - 1;
			double y = k < 2 ? (double)low[1] + radius + 1 : (double)high[1] - radius - 1;
			for (i64 j = (i64)y - 3; j < (i64)y + 3; j++) {
				for (i64 i = (i64)x - 3; i < (i64)x + 3; i++) {
					u64 at = (u64)j * found->width + (u64)i;
					assert_int_equal(found->mask[at], 1);
					for (u32 c = 0; c < 3; c++) {
						f32 light = (f32)sent(data(p, TS_B_eye_view), &lobes[4 * b + k], c,
						                      ((double)i + 0.5 - x) / radius, (y - (double)j - 0.5) / radius);
						assert_true(abs((int)found->rgb[3 * at + c] - (int)ts_srgb_byte(light)) <= 1);
					}
				}
			}
			n_discs++;
		}
		static const u8 grey[3] = {96, 96, 96};
		for (u64 x = low[0]; x < high[0] && large; x++) {
			assert_pixel(found, x, low[1], grey);
			assert_pixel(found, x, high[1] - 1, grey);
		}
		for (u64 y = low[1]; y < high[1] && large; y++) {
			assert_pixel(found, low[0], y, grey);
			assert_pixel(found, high[0] - 1, y, grey);
		}
	}
	assert_true(n_discs > 0);
}

static void hulls_show_segments_and_lobes(void **state)
{
	(void)state;
	pictured p;
	ts_params params = small_params(96, 54);
	params.depth_grid_px = GRID;
	params.rsm_px = 4;
	draw(&p, "indirect", "hulls", &params);
	segments_stand_in_their_boxes(&p);
	lobes_are_discs_in_corners(&p);
	drop(&p);
}

/* A picture that cannot be taken ends the run: nobody gets a page that silently lacks it. */
static void a_picture_that_is_not_taken_ends_the_run(void **state)
{
	(void)state;
	pictured p = {.pictures.n = TS_MAX_STAGE_PICTURES};
	ts_params params = small_params(16, 9);
	p.scene = small_scene(&params);
	ts_run_begin(&p.run, p.scene, &params, 2);
	p.run.hook = take;
	p.run.hook_user = &p.pictures;
	assert_int_equal(ts_pipeline_run(ts_pipeline_find("reflections", "epr"), &p.run), TS_ERROR);
	if (strstr(ts_error_message(), "one more than") == NULL) fail_msg("%s", ts_error_message());
	drop(&p);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(pictures_are_found_by_their_names),
		cmocka_unit_test(what_a_mask_leaves_out_is_grey),
		cmocka_unit_test(cubes_are_laid_out_as_a_cross),
		cmocka_unit_test(depths_and_light_are_greys),
		cmocka_unit_test(the_map_of_a_view_is_two_discs),
		cmocka_unit_test(hulls_show_segments_and_lobes),
		cmocka_unit_test(a_picture_that_is_not_taken_ends_the_run),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
