/* Surfels that are shaded before they are blended: against shading and sums in double precision; the same as deferred
 * shading where nothing varies; a ball, whose shading is known, better from flat to Gouraud to Phong; how often each
 * shades; and the same bits on any number of threads, in any order of the surfels, and from the buffers that stages
 * claim to read. */
#include "kernels/surfels/surfel_shade.h"
#include "tests/methods/surfels/surfels.h"
#include "trace/emitted/sums.h"

enum { FLAT, GOURAUD, PHONG, DEFERRED, METHODS };
static const char *const methods[] = {"flat", "gouraud", "phong", "deferred"};

static ts_params tiny_params(void)
{
	ts_params params = small_params(96, 64);
	params.reflectors_count = 0;
	return params;
}

static void threads_change_no_picture(void **state)
{
	(void)state;
	static ts_sums one, seven;
	ts_params params = tiny_params();
	ts_scene *scene = surfels_balls(&params, 3000);
	for (u32 m = FLAT; m <= PHONG; m++) {
		const ts_pipeline *pipeline = ts_pipeline_find("surfels", methods[m]);
		const ts_how alone = {.threads = 1}, many = {.threads = 7};
		assert_int_equal(ts_sums_of(&one, pipeline, scene, &params, &alone), TS_OK);
		assert_int_equal(ts_sums_of(&seven, pipeline, scene, &params, &many), TS_OK);
		for (u32 id = 0; id < TS_N_BUFFERS; id++) assert_string_equal(one.hex[id], seven.hex[id]);
		assert_int_equal(strlen(one.hex[TS_B_image_radiance]), 64);
	}
	ts_scene_free(scene);
}

static void stages_read_only_what_they_claim(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	for (u32 m = FLAT; m <= PHONG; m++) surfels_assert_claims(&params, methods[m]);
}

static void the_order_of_surfels_changes_no_picture(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = surfels_balls(&params, 3000);
	ts_scene backwards = *scene;
	backwards.surfels = malloc(scene->n_surfels * sizeof *scene->surfels);
	assert_non_null(backwards.surfels);
	for (u32 i = 0; i < scene->n_surfels; i++) backwards.surfels[i] = scene->surfels[scene->n_surfels - 1 - i];
	for (u32 m = FLAT; m <= PHONG; m++) {
		ts_run run, turned;
		surfels_run(&run, scene, &params, methods[m], 2);
		surfels_run(&turned, &backwards, &params, methods[m], 1);
		u64 n = ts_frame_n(&run.frame, TS_B_image_radiance);
		assert_memory_equal(ts_frame_data(&run.frame, TS_B_image_radiance),
		                    ts_frame_data(&turned.frame, TS_B_image_radiance), n * sizeof(f32));
		ts_run_end(&run);
		ts_run_end(&turned);
	}
	free(backwards.surfels);
	ts_scene_free(scene);
}

/* ---- in double precision, of one sun ---- */
static d3 d3_mad(d3 a, d3 b, double s) { return (d3){a.x + b.x * s, a.y + b.y * s, a.z + b.z * s}; }
static d3 d3_unit(d3 a) { return d3_mad((d3){0, 0, 0}, a, 1 / sqrt(d3_dot(a, a))); }

typedef struct {
	double value[3];
} colour3;

static colour3 shaded(const ts_run *run, d3 p, d3 n, const f32 *albedo)
{
	colour3 c;
	const ts_view *view = ts_frame_data(&run->frame, TS_B_eye_view);
	const ts_light *sun = ts_frame_data(&run->frame, TS_B_lamp_light);
	d3 l = d3_mad((d3){0, 0, 0}, d3_of(sun->direction), -1), v = d3_unit(d3_sub(d3_of(view->eye), p));
	double cosine = d3_dot(n, l), shine = 0;
	d3 r = d3_mad(d3_mad((d3){0, 0, 0}, l, -1), n, 2 * cosine);
	if (cosine > 0) shine = 0.25 * pow(fmax(d3_dot(r, v), 0), 32);
	for (u32 k = 0; k < 3; k++) {
		double lit = (albedo[k] * fmax(cosine, 0) + shine) * sun->intensity[k] / acos(-1);
		c.value[k] = fmin((albedo[k] * run->scene->info.ambient + lit) * run->params.image_exposure, 1);
	}
	return c;
}

typedef struct {
	const ts_run *run;
	const f32 *slopes;
	u32 method;
	double eps;
} world;

static colour3 fragment_of(const world *w, u32 k, const ray_hit *hit, double x, double y)
{
	const ts_surfel *s = &w->run->scene->surfels[k];
	const ts_view *view = ts_frame_data(&w->run->frame, TS_B_eye_view);
	d3 u = d3_of(s->u), v = d3_of(s->v), p = d3_of(s->centre), n = d3_unit(d3_cross(u, v));
	if (w->method != PHONG || !(hit->r3 <= 1)) return shaded(w->run, p, n, s->colour);
	d3 q = {(x - view->width / 2.0) / view->focal, -(y - view->height / 2.0) / view->focal, -1};
	d3 d = d3_sub(d3_mad(d3_of(view->eye), q, hit->z), p);
	double a = d3_dot(d, u) / d3_dot(u, u), b = d3_dot(d, v) / d3_dot(v, v);
	n = d3_mad(d3_mad(n, d3_of(w->slopes + 6 * k), a), d3_of(w->slopes + 6 * k + 3), b);
	return shaded(w->run, d3_mad(d3_mad(p, u, a), v, b), d3_unit(n), s->colour);
}

/* The mean of shaded colours at a pixel; false: undecided, or of no surfel's ellipse. */
static bool truth_of(const world *w, u32 column, u32 row, colour3 *mean)
{
	const ts_scene *scene = w->run->scene;
	const ts_params *params = &w->run->params;
	const ts_view *view = ts_frame_data(&w->run->frame, TS_B_eye_view);
	double x = column + 0.5, y = row + 0.5, nearest = 1e30, second = 1e30, weights = 0;
	double way = hypot(1, hypot((x - view->width / 2.0) / view->focal, (y - view->height / 2.0) / view->focal));
	u32 least = TS_NONE;
	bool decided = true;
	*mean = (colour3){{0, 0, 0}};
	for (u32 k = 0; k < scene->n_surfels; k++) {
		ray_hit hit = hit_of(view, &scene->surfels[k], x, y);
		if (fabs(hit.r3 - 1) < 1e-4) decided = false;
		if (!(hit.r3 <= 1)) continue;
		second = fmin(second, fmax(hit.z, nearest));
		if (hit.z < nearest) least = k;
		nearest = fmin(nearest, hit.z);
	}
	if (least == TS_NONE || (w->method == FLAT && second - nearest < 1e-5)) return false;
	for (u32 k = 0; k < scene->n_surfels; k++) {
		ray_hit hit = hit_of(view, &scene->surfels[k], x, y);
		double r2 = hit.r2 / params->ewa_screen_radius, r = fmin(hit.r3, r2), far = nearest + w->eps / way;
		double z = hit.r3 <= 1 ? hit.z : view->eye[2] - scene->surfels[k].centre[2];
		if (fabs(r2 - 1) < 1e-4 || fabs(z - far) < 1e-4) decided = false;
		if (!(r <= 1) || z > far || (w->method == FLAT && k != least)) continue;
		double weight = exp(-0.5 * r * r / (params->ewa_sigma_k * params->ewa_sigma_k));
		colour3 c = fragment_of(w, k, &hit, x, y);
		for (u32 m = 0; m < 3; m++) mean->value[m] += weight * c.value[m];
		weights += weight;
	}
	for (u32 m = 0; m < 3; m++) mean->value[m] /= weights;
	return decided;
}

static void pixels_match_sums_in_double_precision(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.image_exposure = 1.5f;
	ts_scene *scene = surfels_balls(&params, 1200);
	for (u32 m = FLAT; m <= PHONG; m++) {
		ts_run run;
		surfels_run(&run, scene, &params, methods[m], 2);
		const f32 *image = ts_frame_data(&run.frame, TS_B_image_radiance);
		const f32 *slopes = m == PHONG ? ts_frame_data(&run.frame, TS_B_normal_field_slope) : NULL;
		world w = {&run, slopes, m, (double)*(const f32 *)ts_frame_data(&run.frame, TS_B_surfel_setup_epsilon)};
		u32 n_decided = 0, n_all = 0;
		double worst = 0;
		for (u32 p = 0; p < params.width * params.height; p += 5, n_all++) {
			colour3 mean;
			if (!truth_of(&w, p % params.width, p / params.width, &mean)) continue;
			for (u32 k = 0; k < 3; k++)
				worst = fmax(worst, fabs((double)image[3 * p + k] * params.image_exposure - mean.value[k]));
			n_decided++;
		}
		print_message("# %s: %u of %u pixels within %.2g\n", methods[m], n_decided, n_all, worst);
		assert_true(n_decided > n_all / 2 && worst < 1e-4);
		ts_run_end(&run);
	}
	ts_scene_free(scene);
}

/* ---- ports ---- */

/* Where all is decided a port that rounds otherwise shows the same; elsewhere a highlight may come or go. */
static f32 least_margin(const ts_run *run, u32 p)
{
	const u64 *depth = ts_frame_data(&run->frame, TS_B_surfel_depth_margin);
	const u64 *blend = ts_frame_data(&run->frame, TS_B_surfel_blend_margin);
	u64 least = depth[2 * p] < depth[2 * p + 1] ? depth[2 * p] : depth[2 * p + 1];
	least = blend[2 * p] < least ? blend[2 * p] : least;
	return least == TS_EMPTY ? 100 : ts_u2f((u32)least);
}

static void run_measured(ts_run *run, const ts_scene *scene, const ts_params *params, const char *method)
{
	ts_run_begin(run, scene, params, 2);
	run->traced = run->margins = true;
	if (ts_pipeline_run(ts_pipeline_find("surfels", method), run) != TS_OK) fail_msg("%s", ts_error_message());
}

/* Blinds that the sun grazes from behind, where highlights begin: one in 32 within rounding. */
static ts_scene *blinds(const ts_params *params)
{
	ts_build *build = ts_build_new("blinds");
	const ts_light sun = {.direction = {0.28f, 0, 0.96f}, .intensity = {3, 3, 3}};
	ts_build_light(build, &sun);
	for (u32 i = 0; i < 60 * 40; i++) {
		f32 noise = ts_uniform(ts_random(i, 6, 91)) - 0.5f, lean = i % 32 == 0 ? noise / 2097152 : noise / 4;
		ts_v3 centre = ts_v3_make((f32)(i % 60) * 0.05f - 1.5f, (f32)(i / 60) * 0.05f - 1, 0);
		surfels_add(build, centre, ts_normalize(ts_v3_make(lean - 0.96f, 0, 0.28f)), 0.06f, 1,
		            (ts_v3){0.2f, 0.4f, 0.6f});
	}
	return surfels_finish(build, params, ts_v3_make(0, 0, 2.5f), 40.0f / 360);
}

static void decided_pixels_stay_the_same(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.ewa_outline = TS_OUTLINE_FILTER;
	ts_scene *scene = blinds(&params);
	ts_scene moved = *scene;
	moved.surfels = malloc(scene->n_surfels * sizeof *scene->surfels);
	assert_non_null(moved.surfels);
	for (u32 m = FLAT; m <= PHONG; m++) {
		u32 n_decided = 0, n_otherwise = 0;
		ts_run run;
		run_measured(&run, scene, &params, methods[m]);
		const f32 *image = ts_frame_data(&run.frame, TS_B_image_radiance);
		for (u32 seed = 0; seed < 8; seed++) {
			ts_run port;
			for (u32 i = 0; i < scene->n_surfels; i++) {
				moved.surfels[i] = scene->surfels[i];
				for (u32 k = 0; k < 3; k++) {
					f32 noise = ts_uniform(ts_random(3 * i + k, 6, 80 + seed)) - 0.5f;
					moved.surfels[i].u[k] *= 1 + noise / 1048576;
					moved.surfels[i].v[k] *= 1 - noise / 1048576;
				}
			}
			surfels_run(&port, &moved, &params, methods[m], 2);
			const f32 *other = ts_frame_data(&port.frame, TS_B_image_radiance);
			for (u32 p = 0; p < params.width * params.height; p++) {
				bool decided = least_margin(&run, p) > 1;
				n_decided += decided;
				n_otherwise += fabsf(image[3 * p] - other[3 * p]) > 1e-3f;
				if (decided) assert_float_equal(image[3 * p], other[3 * p], 2e-5);
			}
			ts_run_end(&port);
		}
		print_message("# %s: %u decided, %u otherwise\n", methods[m], n_decided / 8, n_otherwise / 8);
		assert_true(n_decided > 8 * params.width * params.height / 2 && n_otherwise > 8 * 10);
		ts_run_end(&run);
	}
	free(moved.surfels);
	ts_scene_free(scene);
}

/* ---- properties ---- */

/* A floor of one colour in tones, which know no highlight: whenever it is shaded, it looks the same. */
static void without_variation_all_shadings_agree(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.deferred_shader = TS_SHADER_NPR;
	ts_build *build = ts_build_new("wall");
	const ts_light sun = {.direction = {0.48f, -0.64f, -0.6f}, .intensity = {2, 1, 0.5f}};
	ts_build_light(build, &sun);
	for (u32 i = 0; i < 40 * 30; i++) {
		ts_v3 centre = ts_v3_make((f32)(i % 40) * 0.1f - 2, (f32)(i / 40) * 0.1f - 1.5f, 0);
		surfels_add(build, centre, ts_v3_make(0, 0, 1), 0.12f, 1, ts_v3_make(0.25f, 0.5f, 0.75f));
	}
	ts_scene *scene = surfels_finish(build, &params, ts_v3_make(0.1f, 0.2f, 1.5f), 60.0f / 360);
	ts_run run[METHODS];
	for (u32 m = 0; m < METHODS; m++) surfels_run(&run[m], scene, &params, methods[m], 2);
	const f32 *deferred = ts_frame_data(&run[DEFERRED].frame, TS_B_image_radiance);
	for (u32 m = FLAT; m <= PHONG; m++) {
		const f32 *image = ts_frame_data(&run[m].frame, TS_B_image_radiance);
		for (u32 k = 0; k < 3 * params.width * params.height; k++) assert_float_equal(image[k], deferred[k], 1e-6);
	}
	assert_true(deferred[3 * (32 * 96 + 48)] > 0.1f);
	for (u32 m = 0; m < METHODS; m++) ts_run_end(&run[m]);
	ts_scene_free(scene);
}

/* Of a white ball, whose shading is known. */
static void phong_beats_gouraud_beats_flat(void **state)
{
	(void)state;
	double rms[METHODS];
	ts_params params = tiny_params();
	ts_build *build = ts_build_new("ball");
	const ts_light sun = {.direction = {0.48f, -0.64f, -0.6f}, .intensity = {2, 2, 2}};
	const f32 white[3] = {0.8f, 0.8f, 0.8f};
	ts_build_light(build, &sun);
	for (u32 i = 0; i < 1500; i++) {
		f32 y = 1 - (2 * (f32)i + 1) / 1500, across = ts_sqrt(1 - y * y), turn = (f32)i * 0.618034f;
		ts_v3 d = ts_v3_make(across * ts_cos_turn(turn), y, across * ts_sin_turn(turn));
		surfels_add(build, d, d, 0.12f, 1, ts_load3(white));
	}
	ts_scene *scene = surfels_finish(build, &params, ts_v3_make(0, 0, 3), 45.0f / 360);
	for (u32 m = 0; m < METHODS; m++) {
		ts_run run;
		u32 n = 0;
		double square = 0;
		surfels_run(&run, scene, &params, methods[m], 2);
		const ts_gpixel *pixels = ts_frame_data(&run.frame, TS_B_gbuffer_pixel);
		const f32 *image = ts_frame_data(&run.frame, TS_B_image_radiance);
		for (u32 p = 0; p < params.width * params.height; p++) {
			d3 at = d3_of(pixels[p].position);
			if (pixels[p].depth == TS_SKY || at.z < 0.5) continue;
			colour3 truth = shaded(&run, d3_unit(at), d3_unit(at), white);
			square += pow((double)image[3 * p] - truth.value[0], 2);
			n++;
		}
		rms[m] = sqrt(square / n);
		print_message("# %s: RMSE %.5f of %u pixels\n", methods[m], rms[m], n);
		ts_run_end(&run);
	}
	assert_true(rms[FLAT] > 3 * rms[GOURAUD] && rms[GOURAUD] > 2 * rms[PHONG] && rms[DEFERRED] < rms[FLAT] / 3);
	ts_scene_free(scene);
}

/* Once a surfel, once a fragment, once a pixel. */
static void each_way_shades_as_it_says(void **state)
{
	(void)state;
	ts_run run[METHODS];
	i64 shaded_by[METHODS], n_covered = 0;
	ts_params params = tiny_params();
	ts_scene *scene = surfels_balls(&params, 3000);
	for (u32 m = 0; m < METHODS; m++) {
		surfels_run(&run[m], scene, &params, methods[m], 2);
		shaded_by[m] = ts_run_counter(&run[m], "shading operations");
	}
	const u64 *heaviest = ts_frame_data(&run[DEFERRED].frame, TS_B_surfel_blend_heaviest);
	for (u32 p = 0; p < params.width * params.height; p++) n_covered += heaviest[p] != TS_EMPTY;
	assert_int_equal(shaded_by[FLAT], ts_run_counter(&run[FLAT], "surfels drawn"));
	assert_int_equal(shaded_by[GOURAUD], ts_run_counter(&run[GOURAUD], "surfels drawn"));
	assert_int_equal(shaded_by[PHONG], ts_run_counter(&run[DEFERRED], "fragments"));
	assert_int_equal(shaded_by[DEFERRED], n_covered);
	assert_true(shaded_by[PHONG] > 5 * n_covered);
	for (u32 m = 0; m < METHODS; m++) ts_run_end(&run[m]);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(threads_change_no_picture),
		cmocka_unit_test(stages_read_only_what_they_claim),
		cmocka_unit_test(the_order_of_surfels_changes_no_picture),
		cmocka_unit_test(pixels_match_sums_in_double_precision),
		cmocka_unit_test(without_variation_all_shadings_agree),
		cmocka_unit_test(phong_beats_gouraud_beats_flat),
		cmocka_unit_test(each_way_shades_as_it_says),
		cmocka_unit_test(decided_pixels_stay_the_same),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
