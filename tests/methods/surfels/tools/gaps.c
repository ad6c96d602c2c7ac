/* Surfels against rays through the middles of pixels: no pixel whose ray meets a surfel shows the sky, and nothing is
 * blended that lies farther behind the nearest than epsilon. Of balls, and of the dragon in $TS_SCENES at full size. */
#include "kernels/raster/gbuffer.h"
#include "kernels/surfels/surfel_blend_order.h"
#include "methods/surfels/tools/discs.h"
#include "tests/methods/surfels/surfels.h"
#include "tests/scene/folder.h"

#define ROUNDING 0x1p-20 /* of the distance: the kernels' depths are 32-bit floats */

typedef struct {
	u64 seen, holes,
		gaps; /* pixels whose ray meets a surfel; of these the sky; sky amid at least 6 of 8 that are not */
	u64 fragments, behind; /* in their ellipse; of these too far behind */
	double farthest;       /* of fragments behind the nearest, epsilons */
} counts;

static ts_disc_ray ray_of(const ts_view *eye, u32 p)
{
	double i = (p % eye->width + 0.5 - eye->width / 2.0) / (double)eye->focal;
	double j = (eye->height / 2.0 - p / eye->width - 0.5) / (double)eye->focal, length = sqrt(i * i + j * j + 1);
	ts_disc_ray ray = {.near = (double)eye->near * length};
	for (u32 k = 0; k < 3; k++) {
		ray.origin[k] = (double)eye->eye[k];
		ray.direction[k] = (i * (double)eye->right[k] + j * (double)eye->up[k] - (double)eye->back[k]) / length;
	}
	return ray;
}

/* Where the ray meets its plane, in radii from the centre; t along the ray. */
static double radius_at(const ts_surfel *s, const ts_disc_ray *ray, double *t)
{
	double n[3], to[3], a = 0, b = 0, uu = 0, vv = 0, across = 0, facing = 0;
	for (u32 k = 0; k < 3; k++) {
		u32 y = (k + 1) % 3, z = (k + 2) % 3;
		n[k] = (double)s->u[y] * (double)s->v[z] - (double)s->u[z] * (double)s->v[y];
		across += n[k] * ((double)s->centre[k] - ray->origin[k]);
		facing += n[k] * ray->direction[k];
	}
	*t = across / facing;
	for (u32 k = 0; k < 3; k++) {
		to[k] = ray->origin[k] + *t * ray->direction[k] - (double)s->centre[k];
		a += to[k] * (double)s->u[k];
		b += to[k] * (double)s->v[k];
		uu += (double)s->u[k] * (double)s->u[k];
		vv += (double)s->v[k] * (double)s->v[k];
	}
	return hypot(a / uu, b / vv);
}

static bool is_gap(const ts_gpixel *pixels, u32 width, u32 height, u32 p)
{
	u32 x = p % width, y = p / width, n = 0;
	if (pixels[p].depth != TS_SKY || x == 0 || y == 0 || x + 1 == width || y + 1 == height) return false;
	for (u32 k = 0; k < 9; k++) n += pixels[(y + k / 3 - 1) * width + x + k % 3 - 1].depth != TS_SKY;
	return n >= 6;
}

static void count_blended(counts *c, const ts_run *run, const ts_disc_ray *ray, double nearest, u32 p)
{
	double epsilon = (double)*(const f32 *)ts_frame_data(&run->frame, TS_B_surfel_setup_epsilon);
	const u32 *offset = ts_frame_data(&run->frame, TS_B_fragment_list_offset);
	const u32 *list = ts_frame_data(&run->frame, TS_B_fragment_list_surfel);
	for (u32 at = offset[p]; at < offset[p + 1]; at++) {
		double t, r = radius_at(&run->scene->surfels[list[at]], ray, &t);
		if (r > 1) continue;
		c->fragments++;
		c->behind += t - nearest > epsilon + ROUNDING * t;
		c->farthest = fmax(c->farthest, (t - nearest) / epsilon);
	}
}

static counts count(const ts_scene *scene, ts_params *params)
{
	ts_run run;
	ts_discs *discs;
	counts c = {0};
	params->surfel_blend_accumulation = TS_ACCUMULATION_FLOAT32; /* for its lists */
	surfels_run(&run, scene, params, "deferred", 2);
	if (ts_discs_new(&discs, scene->surfels, scene->n_surfels, 2) != TS_OK) fail_msg("%s", ts_error_message());
	const ts_gpixel *pixels = ts_frame_data(&run.frame, TS_B_gbuffer_pixel);
	for (u32 p = 0; p < params->width * params->height; p++) {
		ts_disc_ray ray = ray_of(ts_frame_data(&run.frame, TS_B_eye_view), p);
		ts_disc_met met = ts_discs_nearest(discs, &ray);
		c.gaps += is_gap(pixels, params->width, params->height, p);
		if (met.surfel == TS_NONE) continue;
		c.seen++;
		c.holes += pixels[p].depth == TS_SKY;
		count_blended(&c, &run, &ray, met.t, p);
	}
	print_message(
		"# %llu pixels meet surfels, %llu holes, %llu gaps; %llu fragments, %llu behind, at most %.5f epsilon\n",
		(unsigned long long)c.seen, (unsigned long long)c.holes, (unsigned long long)c.gaps,
		(unsigned long long)c.fragments, (unsigned long long)c.behind, c.farthest);
	assert_int_equal(c.holes, 0);
	assert_int_equal(c.behind, 0);
	ts_discs_free(discs);
	ts_run_end(&run);
	return c;
}

static void balls_have_no_gaps(void **state)
{
	(void)state;
	ts_params params = small_params(160, 120);
	params.reflectors_count = 0;
	ts_scene *scene = surfels_balls(&params, 4000);
	counts c = count(scene, &params);
	assert_true(c.seen == 160 * 120 && c.gaps == 0 && c.farthest > 0.9);
	ts_scene_free(scene);
}

static void the_dragon_has_hardly_a_gap(void **state)
{
	(void)state;
	char path[512];
	ts_scene *scene;
	const ts_scene_options circle = {.camera = TS_CAMERA_CIRCLE};
	ts_params params = small_params(1920, 1080);
	params.reflectors_count = 0;
	params.eye_distance = TS_EYE_OUTSIDE;
	snprintf(path, sizeof path, "%s/dragon_splats.glb", scenes_folder());
	FILE *file = fopen(path, "rb");
	if (file == NULL) {
		print_message("%s is absent; set TS_SCENES\n", path);
		skip();
	}
	fclose(file);
	if (ts_scene_load(&scene, path, &params, &circle) != TS_OK) fail_msg("%s", ts_error_message());
	counts c = count(scene, &params);
	assert_true(c.seen > 100000 && c.gaps < c.seen / 500 && c.farthest > 0.99);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(balls_have_no_gaps),
	                                   cmocka_unit_test(the_dragon_has_hardly_a_gap)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
