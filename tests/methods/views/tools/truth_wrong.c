/* Why maps of virtual point lights are wrong: maps of one texel's content, planted, have the one reason that geometry
 * in double precision gives; reasons of a whole run add up to its wrong answers, and light that is said to go through
 * cut-outs meets a triangle with alpha. */
#include <math.h>
#include "kernels/views/vpl_gather.h"
#include "methods/views/tools/tools.h"
#include "methods/views/views.h"
#include "tests/methods/small.h"
#include "truth/truth.h"

typedef struct {
	double x, y, z;
} place;

static place of(const f32 *v) { return (place){(double)v[0], (double)v[1], (double)v[2]}; }
static place minus(place a, place b) { return (place){a.x - b.x, a.y - b.y, a.z - b.z}; }
static double dot(place a, place b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static double far(place a) { return sqrt(dot(a, a)); }
static place cross(place a, place b)
{
	return (place){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

typedef struct {
	ts_scene *scene;
	ts_run run;
	ts_truth *truth;
	ts_vpl_gather_args of;
	u32 *depths, *shown;
	double radius; /* of a leaf */
	f32 reach;
	u64 n_texels, n_pixels, n_leaves;
	u32 first_leaf;
} world;

static ts_params params_of(void)
{
	ts_params params = small_params(96, 64);
	params.reflectors_count = 0;
	params.rsm_px = 24;
	params.octree_levels = 7;
	params.vpl_paths = 150;
	params.view_map_px = 16;
	return params;
}

static void begin(world *w)
{
	ts_params params = params_of();
	w->scene = small_scene(&params);
	ts_run_begin(&w->run, w->scene, &params, 2);
	assert_int_equal(ts_pipeline_run(ts_pipeline_find("indirect", "megaviews"), &w->run), TS_OK);
	assert_int_equal(ts_truth_new(&w->truth, &w->run), TS_OK);
	assert_int_equal(ts_vpl_gather_ask(&w->run, &w->of), TS_OK);
	w->depths = ts_frame_data(&w->run.frame, TS_B_view_map_fused_depth);
	w->shown = ts_frame_data(&w->run.frame, TS_B_view_map_fused_node);
	w->n_texels = (u64)2 * w->of.n * w->of.n;
	w->n_pixels = ts_frame_n(&w->run.frame, TS_B_gbuffer_pixel);
	w->reach = ts_k_leaf_diagonal(&w->of);
	w->radius = (double)w->reach / 2;
	u64 n = ts_frame_n(&w->run.frame, TS_B_octree_node);
	for (w->first_leaf = 0; w->of.scene[w->first_leaf].children != 0;) w->first_leaf++;
	w->n_leaves = n - w->first_leaf;
}

static void end(world *w)
{
	ts_truth_free(w->truth);
	ts_run_end(&w->run);
	ts_scene_free(w->scene);
}

/* A light and a place that it would light, and its texel. */
typedef struct {
	u32 view;
	ts_v3 p, n;
	place light, to, normal, lights_normal;
	u64 texel;
	bool sees;
} question;

static bool ask(const world *w, u32 k, question *q)
{
	q->view = ts_random(k, 1, 0) % w->of.n_lights;
	const ts_gpixel *pixel = &w->of.pixels[ts_random(k, 2, 0) % w->n_pixels];
	const ts_vpl *light = &w->of.lights[q->view];
	q->p = ts_load3(pixel->position);
	q->n = ts_load3(pixel->normal);
	q->light = of(light->position);
	q->to = of(pixel->position);
	q->normal = of(pixel->normal);
	q->lights_normal = of(light->normal);
	ts_v3 way = ts_sub(q->p, ts_load3(light->position));
	q->texel = (u64)w->of.leaves[q->view] * w->n_texels + ts_k_paraboloid_texel(way, w->of.n);
	if (pixel->depth == TS_SKY || far(minus(q->to, q->light)) < 12 * w->radius) return false;
	if (!(ts_k_vpl_form(way, ts_load3(light->normal), q->n, 0) > 0.0f)) return false;
	q->sees = ts_truth_sees(w->truth, q->p, ts_load3(light->position), w->reach);
	return true;
}

static ts_wrong told(const world *w, const question *q, bool lit)
{
	return ts_truth_wrong(w->truth, &w->of, q->view, q->p, q->n, w->reach, TS_PARAM(&w->run.params, view_map_apart),
	                      lit);
}

/* The reason why a leaf between a light and a place that see each other is wrong; TS_N_WRONG: near two. */
static ts_wrong blamed(const world *w, const question *q, const ts_node *node)
{
	const double apart = (double)TS_PARAM(&w->run.params, view_map_apart) * w->radius, near = w->radius / 1000;
	place c = of(node->centre), from = minus(c, q->light), way = minus(q->to, q->light);
	double to_place = far(minus(c, q->to)), to_light = far(from), height = dot(from, q->lights_normal);
	double off = far(cross(from, way)) / far(way), clear = (double)w->of.bias_plane * w->radius;
	bool undecided = fabs(to_place - apart) < near || fabs(to_light - apart) < near || fabs(height - clear) < near ||
	                 fabs(off - w->radius) < near;
	if (undecided) return TS_N_WRONG;
	if (to_place < apart) return TS_WRONG_place;
	if (to_light < apart || height < clear) return TS_WRONG_light;
	return off < w->radius ? TS_WRONG_way : TS_WRONG_texel;
}

/* Every leaf is shown by the one texel in turn. */
static void wrong_shadows_have_the_reason_of_geometry(void **state)
{
	(void)state;
	world w;
	question q;
	u64 seen[TS_N_WRONG] = {0};
	begin(&w);
	for (u32 k = 0; k < 60; k++) {
		if (!ask(&w, k, &q) || !q.sees) continue;
		u32 was = w.shown[q.texel];
		for (u32 node = w.first_leaf; node < w.first_leaf + w.n_leaves; node++) {
			ts_wrong expected = blamed(&w, &q, &w.of.scene[node]);
			w.shown[q.texel] = node;
			ts_wrong is = told(&w, &q, false);
			if (expected == TS_N_WRONG || is == TS_WRONG_cut) continue;
			if (is != expected) fail_msg("question %u, node %u: %u, not %u", k, node, is, expected);
			seen[is]++;
		}
		w.shown[q.texel] = was;
	}
	for (u32 i = TS_WRONG_place; i < TS_N_WRONG; i++) assert_true(seen[i] > 20);
	end(&w);
}

/* Texels that show no node, one behind the place, and one before the place but not above its plane. */
static void wrong_light_has_the_reason_of_geometry(void **state)
{
	(void)state;
	world w;
	question q;
	u64 seen[TS_N_WRONG] = {0};
	begin(&w);
	for (u32 k = 0; k < 4000; k++) {
		if (!ask(&w, k, &q) || q.sees) continue;
		u32 depth = w.depths[q.texel], node = w.shown[q.texel];
		w.shown[q.texel] = TS_NONE;
		ts_wrong empty = told(&w, &q, true);
		w.shown[q.texel] = w.first_leaf;
		w.depths[q.texel] = ts_f2u(1000.0f);
		ts_wrong behind = told(&w, &q, true);
		w.depths[q.texel] = ts_f2u((f32)w.radius);
		ts_wrong before = told(&w, &q, true);
		w.depths[q.texel] = depth;
		w.shown[q.texel] = node;
		bool by_slack = empty == TS_WRONG_slack, is_near = empty == TS_WRONG_near;
		assert_int_equal(behind, by_slack || is_near ? empty : TS_WRONG_leak);
		assert_int_equal(before, by_slack ? TS_WRONG_slack : TS_WRONG_plane);
		assert_true(by_slack || is_near || empty == TS_WRONG_empty);
		seen[empty]++;
	}
	assert_true(seen[TS_WRONG_slack] > 20 && seen[TS_WRONG_near] > 0 && seen[TS_WRONG_empty] > 20);
	end(&w);
}

static bool meets(const ts_corners *corner, place from, place way)
{
	f32 v[3][3];
	ts_store3(v[0], corner->a);
	ts_store3(v[1], corner->b);
	ts_store3(v[2], corner->c);
	place a = of(v[0]), ab = minus(of(v[1]), a), ac = minus(of(v[2]), a), p = cross(way, ac), t = minus(from, a);
	double det = dot(ab, p), u = dot(t, p) / det, s = dot(way, cross(t, ab)) / det, at = dot(ac, cross(t, ab)) / det;
	return u > -1e-4 && s > -1e-4 && u + s < 1 + 1e-4 && at > 0 && at < 1;
}

static bool meets_masked(const world *w, const question *q)
{
	const ts_arrays *arrays = ts_truth_scene(w->truth);
	for (u32 t = 0; t < arrays->n_triangles; t++) {
		if ((arrays->materials[arrays->triangles[t].material].flags & TS_MASKED) == 0) continue;
		ts_corners corner = ts_k_corners(arrays, t);
		if (meets(&corner, q->light, minus(q->to, q->light))) return true;
	}
	return false;
}

static void light_through_cut_outs_meets_alpha(void **state)
{
	(void)state;
	world w;
	question q;
	u32 n_cut = 0;
	begin(&w);
	for (u32 k = 0; k < 20000 && n_cut < 40; k++) {
		if (!ask(&w, k, &q) || !q.sees) continue;
		u32 was = w.shown[q.texel];
		w.shown[q.texel] = w.first_leaf;
		bool cut = told(&w, &q, false) == TS_WRONG_cut;
		w.shown[q.texel] = was;
		n_cut += cut;
		if (cut && !meets_masked(&w, &q)) fail_msg("question %u meets nothing with alpha", k);
	}
	print_message("%u through cut-outs\n", n_cut);
	assert_true(n_cut >= 10);
	end(&w);
}

static void reasons_add_up_to_wrong_answers(void **state)
{
	(void)state;
	world w;
	ts_texel_counts counts = {.asked = 0};
	u64 lit = 0, dark = 0;
	begin(&w);
	assert_int_equal(ts_truth_maps(&counts, w.truth, &w.run, TS_B_vpl_gather_irradiance), TS_OK);
	for (u32 i = 0; i < TS_N_WRONG; i++) *(i < TS_WRONG_cut ? &lit : &dark) += counts.because[i];
	assert_true(counts.lit > 0 && counts.dark > 0 && lit == counts.lit && dark == counts.dark);
	end(&w);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(wrong_shadows_have_the_reason_of_geometry),
	                                   cmocka_unit_test(wrong_light_has_the_reason_of_geometry),
	                                   cmocka_unit_test(light_through_cut_outs_meets_alpha),
	                                   cmocka_unit_test(reasons_add_up_to_wrong_answers)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
