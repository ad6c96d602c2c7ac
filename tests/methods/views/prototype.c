/* Whole maps of a grove show what each view by itself would, as often as in the prototype that FIGURES 11 comes
 * from. */
#include <math.h>
#include "methods/views/traverse.h"
#include "tests/methods/views/grove.h"
#include "tests/whole.h"

/* The prototype's row. Shares are in percent. */
typedef struct {
	u32 levels, n, n_views;
	grove_source *view;
	u32 field; /* of the parameter view_map.field */
	double pairs, ratio, sharing, wide, same, near;
} prototype;

/* Shares of texels: of the same depth, and with one beside them that has it. */
typedef struct {
	double same, near, missing;
	u64 n;
} likeness;

static bool like(u32 a, u32 b, f32 slack)
{
	if (a == TS_NONE || b == TS_NONE) return a == b;
	return ts_abs(ts_u2f(a) - ts_u2f(b)) < 0.05f * ts_u2f(a) + slack;
}

static bool like_near(const u32 *fused, u32 texel, u32 n, u32 own, f32 slack)
{
	i32 side = (i32)n, row = (i32)(texel / n % n), column = (i32)(texel % n);
	for (i32 y = ts_max_i32(row - 1, 0); y <= ts_min_i32(row + 1, side - 1); y++) {
		for (i32 x = ts_max_i32(column - 1, 0); x <= ts_min_i32(column + 1, side - 1); x++) {
			if (like(own, fused[texel / (n * n) * n * n + (u32)(y * side + x)], slack)) return true;
		}
	}
	return false;
}

/* Texels in the middle of the view's field: the prototype's measure. */
static void compare(likeness *sum, const u64 *alone, const u32 *fused, const grove_place *place, u32 n, f32 slack)
{
	for (u32 t = 0; t < 2 * n * n; t++) {
		if (!ts_k_paraboloid_is_used(t, n) || ts_dot(ts_k_paraboloid_direction(t, n), place->n) < 0.15f) continue;
		u32 own = (u32)(alone[t] >> 32);
		bool same = like(own, fused[t], slack);
		sum->n++;
		sum->same += same;
		sum->near += same || like_near(fused, t, n, own, slack);
		sum->missing += own != TS_NONE && fused[t] == TS_NONE;
	}
}

/* Where views see the nodes of rendered pairs that are equivalent, beside where the map of their node has them. */
typedef struct {
	u64 n, same, next, far, other, at;
} prototype_places;

/* A place in a leaf below a node of views. */
static ts_v3 prototype_view_below(const ts_node *views, u32 v)
{
	while (views[v].children != 0) v = views[v].child + grove_below(ts_k_count_bits(views[v].children));
	f32 side = views[v].radius / 0.8660254f;
	ts_v3 off = grove_v3(grove_uniform() - 0.5, grove_uniform() - 0.5, grove_uniform() - 0.5);
	return ts_mad(ts_load3(views[v].centre), off, side);
}

static u32 prototype_apart(u32 a, u32 b) { return a > b ? a - b : b - a; }

static void prototype_place(prototype_places *sum, const ts_traverse_args *args, u64 pair)
{
	const ts_node *views = args->views;
	u32 n = args->n, v = ts_k_pair_views(pair);
	ts_v3 s = ts_load3(args->nodes[ts_k_pair_node(pair)].centre);
	u32 a = ts_k_paraboloid_texel(ts_sub(s, ts_load3(views[v].centre)), n);
	u32 b = ts_k_paraboloid_texel(ts_sub(s, prototype_view_below(views, v)), n);
	u32 columns = prototype_apart(a % n, b % n), rows = prototype_apart(a / n % n, b / n % n);
	u32 far = columns > rows ? columns : rows;
	bool other = a / (n * n) != b / (n * n);
	sum->n++;
	sum->other += other;
	sum->same += !other && far == 0;
	sum->next += !other && far == 1;
	sum->far += !other && far > 1;
}

/* A sink: one pair in some hundred. */
static ts_status prototype_place_some(ts_run *run, ts_traverse_piece *piece, void *user)
{
	(void)run;
	prototype_places *sum = user;
	for (u64 i = 0; i < piece->n; i++) {
		u64 pair = piece->args.queue[i];
		if (pair >= TS_STRUCK || sum->at++ % 101 != 0 || ts_k_pair_is_wide(&piece->args, pair)) continue;
		prototype_place(sum, &piece->args, pair);
	}
	return TS_OK;
}

/* No node is farther than a texel from where its views see it in the same of the two maps. */
static void check_places(ts_run *run)
{
	prototype_places sum = {.n = 0};
	ts_traverse_args how;
	assert_int_equal(ts_traverse_arguments(run, &how), TS_OK);
	assert_int_equal(ts_traverse(run, &how, prototype_place_some, &sum), TS_OK);
	double all = 0.01 * (double)sum.n;
	print_message("the same texel %.2f %%, the next %.2f %%, the other map %.3f %%\n", (double)sum.same / all,
	              (double)sum.next / all, (double)sum.other / all);
	assert_true(sum.n > 5000);
	assert_int_equal(sum.far, 0);
	assert_true((double)sum.other / all < 3 && (double)sum.same / all > 70);
}

/* Radii and cosines are rounded otherwise here than in the prototype. */
static void check(const ts_scene *scene, const prototype *expected)
{
	enum { SAMPLE = 200 };
	static ts_vpl lights[SAMPLE];
	u32 n = expected->n, n_texels = 2 * n * n;
	ts_params params = small_params(64, 64);
	params.reflectors_count = 0;
	params.view_map_px = n;
	params.view_map_texel = TS_TEXEL_POINT;
	params.view_map_multipixel = TS_MULTIPIXEL_OFF;
	params.view_map_apart = 2;
	params.view_map_field = expected->field;
	grove g;
	ts_run run, alone;
	grove_state = 1234567;
	grove_plant(&g, expected->levels, expected->levels, 40ull << 2 * expected->levels, grove_surface, expected->n_views,
	            expected->view);
	grove_begin(&run, scene, &params, 2, &g);
	grove_stage(&run, "view_map");
	grove_stage(&run, "view_map.fuse");
	grove_begin_alone(&alone, scene, &params, &g, lights, SAMPLE);
	grove_stage(&alone, "view_map");
	const u32 *fused = ts_frame_data(&run.frame, TS_B_view_map_fused_depth);
	const u64 *maps = ts_frame_data(&alone.frame, TS_B_view_map_depth_node);
	likeness sum = {0, 0, 0, 0};
	for (u64 i = 0; i < SAMPLE; i++) {
		u64 place = i * g.n_places / SAMPLE;
		compare(&sum, maps + i * n_texels, fused + (u64)g.leaf[place] * n_texels, &g.places[place], n,
		        3 / (f32)(1u << expected->levels));
	}
	double pairs = (double)ts_run_counter(&run, "pairs"), rendered = (double)ts_run_counter(&run, "pairs rendered");
	double ratio = (double)ts_run_counter(&alone, "pairs") / SAMPLE * expected->n_views / pairs;
	double sharing = (double)ts_run_counter(&run, "views served") / rendered;
	double wide = 100 * (double)ts_run_counter(&run, "pairs wider than a texel") / rendered;
	double same = 100 * sum.same / (double)sum.n, near = 100 * sum.near / (double)sum.n;
	print_message(
		"%u levels, %u views of %u: %.0f pairs, saved %.2f times, shared by %.2f, wide %.2f %%, same %.2f %%, "
		"near %.2f %%, missing %.3f %%\n",
		expected->levels, expected->n_views, n, pairs, ratio, sharing, wide, same, near,
		100 * sum.missing / (double)sum.n);
	assert_true(fabs(pairs / expected->pairs - 1) < 0.01);
	assert_true(fabs(ratio / expected->ratio - 1) < 0.02);
	assert_true(fabs(sharing / expected->sharing - 1) < 0.02);
	assert_true(fabs(wide - expected->wide) < 0.5);
	assert_true(same > expected->same - 0.5 && near > expected->near - 0.2);
	check_places(&run);
	ts_run_end(&run);
	ts_run_end(&alone);
	grove_free(&g);
}

static void check_rows(const prototype *rows, size_t n)
{
	ts_params params = small_params(64, 64);
	ts_scene *scene = small_scene(&params);
	for (size_t i = 0; i < n; i++) check(scene, &rows[i]);
	ts_scene_free(scene);
}

/* In the air, all looking up. */
static grove_place air(void)
{
	double x = 0.05 + 0.9 * grove_uniform(), y = 0.05 + 0.9 * grove_uniform(), z = 0.05 + 0.9 * grove_uniform();
	return (grove_place){grove_v3(x, y, z), {0, 0, 1}};
}

/* The later rows are of more views, deeper octrees, larger maps and views anywhere. */
static void whole_maps_repeat_the_prototype(void **state)
{
	static const prototype rows[] = {
		{7, 16, 256, grove_floor, TS_VIEW_FIELD_HALF, 1704665, 1.22, 1.51, 6.98, 92.58, 98.69},
		{7, 16, 4096, grove_floor, TS_VIEW_FIELD_HALF, 6502386, 5.12, 5.82, 13.92, 92.76, 98.69},
		{7, 16, 16384, grove_floor, TS_VIEW_FIELD_HALF, 7608328, 17.50, 19.63, 15.13, 92.76, 98.68},
		{7, 16, 4096, grove_surface, TS_VIEW_FIELD_HALF, 27685533, 0.93, 1.29, 7.63, 92.96, 98.57},
		{7, 16, 4096, air, TS_VIEW_FIELD_ALL, 39371199, 0.87, 1.10, 2.73, 93.39, 98.71},
		{9, 16, 1024, grove_floor, TS_VIEW_FIELD_HALF, 6762791, 1.55, 1.95, 6.61, 87.04, 95.96},
		{9, 16, 4096, grove_floor, TS_VIEW_FIELD_HALF, 17409636, 2.43, 2.98, 9.76, 87.21, 96.05},
		{9, 32, 1024, grove_floor, TS_VIEW_FIELD_HALF, 30192572, 1.27, 1.50, 5.61, 95.91, 99.11},
		{9, 64, 1024, grove_floor, TS_VIEW_FIELD_HALF, 131737640, 1.02, 1.20, 5.22, 98.30, 99.83},
	};
	(void)state;
	check_rows(rows, whole_or(sizeof rows / sizeof *rows, 2));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(whole_maps_repeat_the_prototype)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
