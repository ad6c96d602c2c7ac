/* Shadows in the small map of one light, over a floor and before a wall of voxels, held against straight lines in
 * double precision: what stops light by its tangent plane, and by distance alone. */
#include "kernels/views/vpl_gather.h"
#include "tests/kernels/small.h"

enum { LEVELS = 6, SIDE = 1 << LEVELS, WALL = 32, TOP = 40, MOST = 2 * SIDE * SIDE, N = 16, N_LIGHTS = 12 };

typedef struct {
	ts_root root;
	ts_node scene[MOST], view;
	ts_vpl light;
	u64 texels[2 * N * N];
	u32 depths[2 * N * N], shown[2 * N * N], leaf, n_nodes;
	ts_vpl_gather_args args;
} world;

static void put_voxel(world *w, u32 x, u32 y, u32 z)
{
	f32 side = 1.0f / SIDE;
	w->scene[w->n_nodes++] =
		(ts_node){.centre = {((f32)x + 0.5f) * side, ((f32)y + 0.5f) * side, ((f32)z + 0.5f) * side},
	              .radius = 0.8660254f * side,
	              .level = LEVELS};
}

/* Every voxel of the floor, and of the wall if there is one, in the light's map. */
static void make(world *w, ts_v3 at, bool wall)
{
	*w = (world){.root.side = 1, .view = {.radius = 0.8660254f / SIDE, .parent = TS_NONE}};
	for (u32 i = 0; i < SIDE * SIDE; i++) put_voxel(w, i % SIDE, i / SIDE, 0);
	for (u32 i = 0; wall && i < SIDE * (TOP - 1); i++) put_voxel(w, WALL, i % SIDE, 1 + i / SIDE);
	ts_store3(w->view.centre, at);
	ts_store3(w->light.position, at);
	memset(w->texels, 0xff, sizeof w->texels);
	const ts_view_map_args map = {
		.nodes = w->scene, .views = &w->view, .texels = w->texels, .pyramid = {N, 1, .point = 1}};
	for (u32 i = 0; i < w->n_nodes; i++) ts_k_map_pair(&map, ts_k_pair(i, 0));
	ts_view_map_fuse_args fuse = {
		.views = &w->view, .texels = w->texels, .depths = w->depths, .nodes = w->shown, .pyramid = {N, 1, .point = 1}};
	for (u32 i = 0; i < 2 * N * N; i++) ts_k_view_map_fuse_item(&fuse, i);
	w->args = (ts_vpl_gather_args){.root = &w->root,
	                               .leaves = &w->leaf,
	                               .nodes = &w->view,
	                               .lights = &w->light,
	                               .depths = w->depths,
	                               .shown = w->shown,
	                               .scene = w->scene,
	                               .levels = LEVELS,
	                               .n = N,
	                               .bias = 1,
	                               .bias_px = 1};
}

/* Places of the floor that light reaches though a line to them crosses the wall, and that it does not reach
 * otherwise. */
typedef struct {
	u32 leaks, shadows, behind, open;
} faults;

static void add_floor(faults *r, const world *w, bool wall)
{
	const f32 *from = w->light.position;
	ts_v3 up = ts_v3_make(0, 0, 1);
	for (u32 i = 0; i < 200 * 200; i++) {
		ts_v3 p = ts_v3_make(((f32)(i % 200) + 0.5f) / 200, ((f32)(i / 200) + 0.5f) / 200, 0.3f / SIDE);
		double edge = ((double)WALL + 0.5) / SIDE, t = (edge - (double)from[0]) / ((double)p.x - (double)from[0]);
		double height = (double)from[2] + t * ((double)p.z - (double)from[2]);
		bool hidden = wall && (double)p.x > edge && height < (double)TOP / SIDE;
		u32 texel = ts_k_paraboloid_texel(ts_sub(p, ts_load3(from)), N);
		bool lit = ts_k_vpl_reaches(&w->args, 0, texel, p, up);
		r->behind += hidden;
		r->open += !hidden;
		r->leaks += hidden && lit;
		r->shadows += !hidden && !lit;
	}
}

/* Of lights at several places, low and high; slope: texels of bias.slope. */
static faults judge(bool wall, bool by_plane, f32 slope)
{
	static world w;
	faults r = {0, 0, 0, 0};
	for (u32 k = 0; k < N_LIGHTS; k++) {
		make(&w, ts_v3_make(0.1f + 0.03f * (f32)k, 0.5f, 0.1f + 0.05f * (f32)(k % 4)), wall);
		w.args.by_plane = by_plane;
		w.args.bias_plane = 2;
		w.args.bias_slope = slope;
		add_floor(&r, &w, wall);
	}
	print_message("by %s, slope %.1f: %.2f %% of %u leaks, %.2f %% of %u shadows\n", by_plane ? "plane" : "distance",
	              (double)slope, 100.0 * r.leaks / (r.behind + 1), r.behind, 100.0 * r.shadows / r.open, r.open);
	return r;
}

/* A floor throws no shadow on itself, however little of it a texel tells apart; by distance alone it does, unless
 * places far behind what is shown are lit as well. */
static void a_floor_throws_no_shadow_on_itself(void **state)
{
	(void)state;
	assert_int_equal(judge(false, true, 0).shadows, 0);
	assert_int_equal(judge(false, false, 1.5f).shadows, 0);
	faults alone = judge(false, false, 0);
	assert_true(alone.shadows > alone.open / 5);
}

/* And then most of what a wall hides is lit, but little by the plane: where a texel shows the floor before the wall. */
static void what_a_wall_hides_is_dark(void **state)
{
	(void)state;
	faults plane = judge(true, true, 0), distance = judge(true, false, 1.5f);
	assert_true(distance.leaks > distance.behind * 9 / 10);
	assert_true(plane.leaks < plane.behind / 4 && plane.shadows < plane.open / 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(a_floor_throws_no_shadow_on_itself),
	                                   cmocka_unit_test(what_a_wall_hides_is_dark)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
