/* Why iVIR's depth maps differ from rays through the centres of their texels: each point is scattered again, and each
 * wrong texel asked for the point that it has (FIGURES 13). Nearly all come from a triangle beside the centre, whose
 * depth is right where the point is; few are left where points count at the centre, and without culling as few as
 * MVR has. */
#include "kernels/points/scatter.h"
#include "kernels/raster/shadow_test.h"
#include "methods/pipeline.h"
#include "methods/points/points.h"
#include "methods/points/tools/tools.h"
#include "tests/model/test.h"
#include "truth/truth.h"

/* The nearest point of a texel. */
typedef struct {
	u32 depth, triangle;
	f32 x, y;
} winner;

typedef struct {
	ts_truth *truth;
	const ts_arrays *scene;
	ts_shadow_test_args rule; /* its bias */
	ts_camera_k view;
	winner *won;
	u64 wrong, too_far, own_triangle, covers, beside, right_there;
} judge;

static void win(judge *j, const ts_points_args *from, u64 piece, i32 x, i32 y)
{
	ts_flight point = {.piece = piece};
	ts_k_flight_start(from, &point, x, y);
	ts_corner p = ts_k_to_view(&j->view, point.centre);
	if (!(p.z >= j->view.near)) return;
	ts_v2 at = ts_k_project(&j->view, &p);
	i32 i = ts_floor_i32(at.x), k = ts_floor_i32(at.y);
	if (i < 0 || k < 0 || i >= j->view.width || k >= j->view.height) return;
	winner *w = &j->won[k * j->view.width + i];
	u32 depth = ts_f2u(ts_put(p.z));
	if (depth < w->depth) *w = (winner){depth, from->pieces[piece].triangle, at.x, at.y};
}

static void scatter_again(judge *j, const ts_run *run, u32 v)
{
	ts_points_args from = ts_points_values(run);
	const u64 *bits = ts_frame_data(&run->frame, TS_B_visibility_bits);
	from.scene = *j->scene;
	from.pieces = ts_frame_data(&run->frame, TS_B_split_piece);
	from.frames = ts_frame_data(&run->frame, TS_B_align_frame);
	for (u64 p = 0; p < ts_frame_n(&run->frame, TS_B_split_piece); p++) {
		const u64 *words = bits + (u64)from.pieces[p].triangle * ts_run_size(run, TS_DIM_view_words);
		if (!(from.frames[p].s > 0) || !ts_k_offscreen_bit(words, v)) continue;
		ts_cover cover = ts_k_lattice_cover(&from.frames[p], from.half_size);
		for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
			for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
				if (ts_k_is_point(&from, &cover, p, x, y)) win(j, &from, p, x, y);
			}
		}
	}
}

/* What a ray through a place of the image says of a depth: -1 it is nearer than the hit and the bias allow, 1 farther,
 * 0 right. *hit: the triangle, TS_NONE: nothing, or one with a mask. */
static int ask(const judge *j, f32 x, f32 y, f32 depth, u32 *hit)
{
	const ts_camera_k *view = &j->view;
	f32 right = (x - (f32)view->width * 0.5f) / view->focal, up = ((f32)view->height * 0.5f - y) / view->focal;
	ts_v3 ahead = ts_sub(ts_mad(ts_scale(view->right, right), view->up, up), view->back);
	ts_truth_query ray = {.origin = view->eye,
	                      .direction = ts_normalize(ahead),
	                      .near = view->near * ts_length(ahead),
	                      .masked = TS_NONE,
	                      .from = view->eye,
	                      .spread = 1 / view->focal};
	ts_truth_hit at = ts_truth_cast(j->truth, &ray);
	*hit = at.triangle != TS_NONE && !ts_k_is_masked(j->scene, at.triangle) ? at.triangle : TS_NONE;
	if (at.triangle == TS_NONE) return 1;
	ts_corners t = ts_k_corners(j->scene, at.triangle);
	ts_receiver there = {ts_mad(ray.origin, ray.direction, at.t), ts_normalize(t.n), true};
	f32 z = at.t * -ts_dot(view->back, ray.direction), bias = ts_k_shadow_bias(&j->rule, view, &there, z);
	return depth < (z - bias) / 1.00001f ? -1 : depth > (z + bias) * 1.00001f ? 1 : 0;
}

static void classify(judge *j, const winner *w, i32 x, i32 y)
{
	u32 hit, there;
	f32 depth = ts_u2f(w->depth);
	int at_centre = ask(j, (f32)x + 0.5f, (f32)y + 0.5f, depth, &hit);
	if (hit == TS_NONE || w->depth == TS_NONE || at_centre == 0) return;
	j->wrong++;
	j->too_far += at_centre > 0;
	bool covers = ts_k_fragment_drawn(j->scene, &j->view, w->triangle, x, y).z > 0;
	j->own_triangle += w->triangle == hit;
	j->covers += w->triangle != hit && covers;
	j->beside += w->triangle != hit && !covers;
	j->right_there += ask(j, w->x, w->y, depth, &there) == 0;
}

static void judge_view(judge *j, const ts_run *run, u32 v)
{
	const ts_offscreen *views = ts_frame_data(&run->frame, TS_B_offscreen_view);
	const u32 *map = ts_frame_data(&run->frame, TS_B_depth_map_depth);
	j->view = ts_k_offscreen(&views[v]);
	i32 n = j->view.width * j->view.height;
	j->won = malloc((size_t)n * sizeof *j->won);
	assert_non_null(j->won);
	for (i32 k = 0; k < n; k++) j->won[k] = (winner){.depth = TS_NONE};
	scatter_again(j, run, v);
	for (i32 k = 0; k < n; k++) {
		assert_true(map[views[v].offset + (u32)k] == j->won[k].depth);
		classify(j, &j->won[k], k % j->view.width, k / j->view.width);
	}
	free(j->won);
}

static ts_status after_scatter(const ts_run *run, const ts_stage *stage, void *user)
{
	judge *j = user;
	if (ts_stage_outputs(stage)[0] != TS_B_depth_map_depth) return TS_OK;
	if (ts_truth_new(&j->truth, run) != TS_OK) return TS_ERROR;
	j->scene = ts_truth_scene(j->truth);
	for (u32 v = 0; v < run->n_units; v++) judge_view(j, run, v);
	ts_truth_free(j->truth);
	return TS_OK;
}

typedef struct {
	ts_truth *truth;
	ts_texel_counts counts;
} rays;

static ts_status count_texels(const ts_run *run, const ts_stage *stage, void *user)
{
	rays *r = user;
	if (ts_stage_outputs(stage)[0] != TS_B_depth_map_depth) return TS_OK;
	if (r->truth == NULL && ts_truth_new(&r->truth, run) != TS_OK) return TS_ERROR;
	return ts_truth_texels(&r->counts, r->truth, run, TS_B_depth_map_depth);
}

static ts_params maps_of_dining(void)
{
	ts_params p;
	ts_params_default(&p);
	p.width = 96;
	p.height = 54;
	p.reflectors_count = 0;
	p.lamp_views = 8;
	p.depth_map_px = 256;
	return p;
}

static ts_scene *scene;

static void run_method(const char *method, const ts_params *params, ts_stage_hook hook, void *user)
{
	ts_run run;
	ts_run_begin(&run, scene, params, 2);
	run.hook = hook;
	run.hook_user = user;
	if (ts_pipeline_run(ts_pipeline_find("soft-shadows", method), &run) != TS_OK) fail_msg("%s", ts_error_message());
	ts_run_end(&run);
}

static ts_texel_counts count(const char *method, u32 at, u32 cull)
{
	rays r = {0};
	ts_params params = maps_of_dining();
	params.scatter_at = at;
	params.points_cull = cull;
	run_method(method, &params, count_texels, &r);
	ts_truth_free(r.truth);
	print_message("%s, scatter.at %u, points.cull %u: %llu covered, %llu holes, %llu leaks, %llu wrong\n", method,
	              (unsigned)at, (unsigned)cull, (unsigned long long)r.counts.covered,
	              (unsigned long long)r.counts.holes, (unsigned long long)r.counts.leaks,
	              (unsigned long long)r.counts.apart);
	return r.counts;
}

static void wrong_texels_belong_to_triangles_beside(void **state)
{
	(void)state;
	ts_params params = maps_of_dining();
	judge j = {.rule = {.bias = params.depth_map_bias, .slope = params.depth_map_bias_slope}};
	run_method("ivir", &params, after_scatter, &j);
	print_message(
		"%llu wrong, %llu too far: %llu of the triangle at the centre, %llu of another that covers it, %llu of "
		"one beside it; %llu right where the point is\n",
		(unsigned long long)j.wrong, (unsigned long long)j.too_far, (unsigned long long)j.own_triangle,
		(unsigned long long)j.covers, (unsigned long long)j.beside, (unsigned long long)j.right_there);
	assert_true(j.wrong > 10000 && j.too_far == 0 && j.own_triangle == 0);
	assert_true(j.beside * 100 > j.wrong * 95 && j.right_there * 100 > j.wrong * 90);
}

static void counting_at_centres_leaves_few_wrong_texels(void **state)
{
	(void)state;
	ts_texel_counts own = count("ivir", TS_SCATTER_POINT, 1), centre = count("ivir", TS_SCATTER_CENTRE, 1);
	ts_texel_counts whole = count("ivir", TS_SCATTER_CENTRE, 0), mvr = count("mvr", TS_SCATTER_POINT, 1);
	assert_true(own.holes == 0 && own.leaks == 0 && centre.apart * 10 < own.apart);
	assert_true(whole.holes == mvr.holes && whole.leaks == mvr.leaks && whole.apart == mvr.apart);
}

static int begin(void **state)
{
	(void)state;
	ts_params params = maps_of_dining();
	return ts_scene_load(&scene, "dining:texels=16", &params, NULL) != TS_OK;
}

static int end(void **state)
{
	(void)state;
	ts_scene_free(scene);
	return 0;
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(wrong_texels_belong_to_triangles_beside),
	                                   cmocka_unit_test(counting_at_centres_leaves_few_wrong_texels)};
	return cmocka_run_group_tests(tests, begin, end);
}
