/* Texels of maps of views, as the probe tells of them, against the buffers of the run and the same in double
 * precision. */
#include "kernels/views/view_map.h"
#include "methods/views/views.h"
#include "tests/probe/probed.h"
#include "tests/whole.h"

static u32 n_tries(void) { return whole_or(250, 100); }

static const struct {
	const char *effect, *method;
	u32 vpls, px, fusion, multipixel, field;
	f32 apart;
	u32 hierarchies;
} methods[] = {
	{"indirect", "megaviews", 60, 4, TS_FUSION_MIN, TS_MULTIPIXEL_OFF, TS_VIEW_FIELD_HALF, 3, TS_HIERARCHIES_BOTH},
	{"indirect", "megaviews", 200, 4, TS_FUSION_PAPER, TS_MULTIPIXEL_MIPS, TS_VIEW_FIELD_HALF, 0, TS_HIERARCHIES_BOTH},
	{"particles", "megaviews", 0, 4, TS_FUSION_MIN, TS_MULTIPIXEL_TEXELS, TS_VIEW_FIELD_ALL, 3, TS_HIERARCHIES_BOTH},
	{"indirect", "manylods", 40, 16, TS_FUSION_MIN, TS_MULTIPIXEL_MIPS, TS_VIEW_FIELD_HALF, 3, TS_HIERARCHIES_BOTH},
	{"indirect", "megaviews", 60, 4, TS_FUSION_MIN, TS_MULTIPIXEL_OFF, TS_VIEW_FIELD_HALF, 3, TS_HIERARCHIES_VIEWS},
	{"indirect", "bruteforce", 40, 16, TS_FUSION_MIN, TS_MULTIPIXEL_OFF, TS_VIEW_FIELD_HALF, 3, TS_HIERARCHIES_BOTH},
};
enum { N_METHODS = sizeof methods / sizeof *methods, BRUTE_FORCE = N_METHODS - 1 };
static traced views[N_METHODS];

static int make_all(void **state)
{
	(void)state;
	ts_params params = small_params(32, 24);
	params.rsm_px = 8;
	params.octree_levels = 5;
	params.vpl_gather_level = 3;
	params.particle_count = 200;
	for (u32 i = 0; i < N_METHODS; i++) {
		params.vpl_paths = methods[i].vpls;
		params.view_map_px = methods[i].px;
		params.view_map_fusion = methods[i].fusion;
		params.view_map_texel = methods[i].multipixel == TS_MULTIPIXEL_MIPS ? TS_TEXEL_MIDDLE : TS_TEXEL_POINT;
		params.view_map_multipixel = methods[i].multipixel;
		params.view_map_field = methods[i].field;
		params.view_map_apart = methods[i].apart;
		params.traverse_hierarchies = methods[i].hierarchies;
		make(&views[i], methods[i].effect, methods[i].method, &params);
	}
	return 0;
}

static int drop_all(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_METHODS; i++) drop(&views[i]);
	return 0;
}

/* Not sure: so near to an edge or a threshold that rounding decides. */
typedef enum { NO, YES, NOT_SURE } answer;

static answer either(answer a, answer b) { return a == YES || b == YES ? YES : a == NO && b == NO ? NO : NOT_SURE; }
static answer both(answer a, answer b) { return a == NO || b == NO ? NO : a == YES && b == YES ? YES : NOT_SURE; }
static answer more(double a, double b, double scale)
{
	return fabs(a - b) < 1e-5 * scale ? NOT_SURE : a > b ? YES : NO;
}

/* Is the place, in texels, in [i, i + 1)? Places behind the last are of it. */
static answer is_in(double component, double sum, u32 n, u32 i)
{
	double at = (component / sum / 2 + 0.5) * n;
	answer above = component == 0 ? (at >= i ? YES : NO) : more(at, i, n);
	return both(above, i == n - 1 ? YES : component == 0 ? (at < i + 1 ? YES : NO) : more(i + 1, at, n));
}

typedef struct {
	double x, y, z, d, radius;
} apart;

static apart between(const ts_node *s, const ts_node *v)
{
	apart a = {(double)s->centre[0] - (double)v->centre[0], (double)s->centre[1] - (double)v->centre[1],
	           (double)s->centre[2] - (double)v->centre[2], 0, s->radius};
	a.d = sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
	return a;
}

/* Is the middle of the texel a direction that meets the ball, which by points must be wider than a texel? */
static answer is_covered(const traced *t, const apart *a, u32 texel)
{
	u32 n = t->run.params.view_map_px;
	double r = a->radius * (double)ts_view_pyramid(&t->run.params, &t->run.plan).fill;
	if (!(r > 0) || r >= a->d) return r > 0 ? YES : NO;
	double u = (2.0 * (texel % n) + 1) / n - 1, v = (2.0 * (texel / n % n) + 1) / n - 1, s = u * u + v * v;
	double x = texel < n * n ? 1 - s : s - 1, edge = sqrt((a->d - r) * (a->d + r));
	answer meets = more((x * a->x + 2 * u * a->y + 2 * v * a->z) / (1 + s), edge, 10 * a->d);
	bool point = t->run.params.view_map_texel == TS_TEXEL_POINT;
	return point ? both(meets, more(n * r / (fabs(a->x) + edge), 1, 1)) : meets;
}

/* METHODS 13: does the pair come to a texel of the map? */
static answer comes_to(const traced *t, const apart *a, u32 texel)
{
	u32 n = t->run.params.view_map_px;
	double sum = fmax(a->d + fabs(a->x), 1e-30);
	answer half = (a->x < 0) == (texel >= n * n) ? YES : NO;
	answer middle = both(half, both(is_in(a->y, sum, n, texel % n), is_in(a->z, sum, n, texel / n % n)));
	bool point = t->run.params.view_map_texel == TS_TEXEL_POINT;
	return either(point ? middle : NO, is_covered(t, a, texel));
}

/* Of one light: not all of the leaf is behind it. The kernels allow the cosine of a cone, here 1, to be rounded. */
static answer is_seen(const traced *t, const apart *a, u32 view)
{
	const ts_cone *cone = (const ts_cone *)data(t, TS_B_view_octree_cone) + view;
	double along = a->x * (double)cone->axis[0] + a->y * (double)cone->axis[1] + a->z * (double)cone->axis[2];
	return more(a->radius, -along, 100 * (a->d + 1));
}

/* Of two leaves. */
static answer is_near(const traced *t, const apart *a)
{
	return more((double)t->run.params.view_map_apart * a->radius, a->d, a->d + 1);
}

static answer is_not(answer a) { return a == NOT_SURE ? a : a == NO ? YES : NO; }

/* How many pairs come to the texel of the node's own map: at least, at most. */
static void count_pairs(const traced *t, u32 view, u32 texel, u64 n[2])
{
	const ts_node *nodes = data(t, TS_B_octree_node), *v = (const ts_node *)data(t, TS_B_view_octree_node) + view;
	bool all = !t->run.frame.buffer[TS_B_traverse_rendered].made;
	const u64 *pairs = all ? NULL : data(t, TS_B_traverse_rendered);
	u64 n_pairs = count(t, all ? TS_B_octree_node : TS_B_traverse_rendered);
	n[0] = n[1] = 0;
	for (u64 i = 0; i < n_pairs; i++) {
		const ts_node *s = &nodes[all ? i : pairs[i] >> 32];
		if (all ? s->children != 0 : (u32)pairs[i] != view) continue;
		apart a = between(s, v);
		answer comes = both(all ? both(is_seen(t, &a, view), is_not(is_near(t, &a))) : YES, comes_to(t, &a, texel));
		n[0] += comes == YES;
		n[1] += comes != NO;
	}
}

/* The nearest of all levels of the map. */
static u64 own_key(const traced *t, u32 view, u32 texel)
{
	const u64 *map =
		(const u64 *)data(t, TS_B_view_map_depth_node) + view * t->run.frame.buffer[TS_B_view_map_depth_node].shape[1];
	u32 n = t->run.params.view_map_px, first = 0;
	u64 nearest = TS_EMPTY;
	for (u32 mip = 0; mip < ts_view_pyramid(&t->run.params, &t->run.plan).levels; mip++) {
		u32 side = n >> mip;
		u64 key = map[first + (texel / (n * n) * side + (texel / n % n >> mip)) * side + (texel % n >> mip)];
		nearest = key < nearest ? key : nearest;
		first += 2 * side * side;
	}
	return nearest;
}

static u32 depth_of(const json_t *v, const char *key)
{
	const json_t *found = json_object_get(v, key);
	return json_is_string(found) ? TS_NONE : bits_of(json_object_get(found, "bits"));
}

/* Distance from the middle of b to what a shows at that depth in the middle of the texel. */
static double moved(const ts_node *a, double depth, const ts_node *b, u32 texel, u32 n)
{
	double u = (2.0 * (texel % n) + 1) / n - 1, v = (2.0 * (texel / n % n) + 1) / n - 1, square = u * u + v * v;
	double way[3] = {(1 - square) / (1 + square), 2 * u / (1 + square), 2 * v / (1 + square)}, sum = 0;
	if (texel >= n * n) way[0] = -way[0];
	for (u32 k = 0; k < 3; k++) {
		double side = (double)a->centre[k] + way[k] * depth - (double)b->centre[k];
		sum += side * side;
	}
	return sqrt(sum);
}

static void try_rendered(const traced *t, const json_t *rendered, u32 view, u32 texel, u64 tally[2])
{
	u64 n[2], found = figure(rendered, "competitors"), key = own_key(t, view, texel);
	const json_t *first = json_array_get(json_object_get(rendered, "by_depth"), 0);
	count_pairs(t, view, texel, n);
	assert_in_range(found, n[0], n[1]);
	tally[0] += n[0];
	tally[1] += n[1] - n[0];
	assert_int_equal(found > 0, key != TS_EMPTY);
	if (key == TS_EMPTY) return;
	assert_int_equal(figure(first, "node"), (u32)key);
	assert_int_equal(figure(first, "views"), view);
	assert_int_equal(ts_f2u(shown(first, "distance", 0)), key >> 32);
	double wide = json_number_value(json_object_get(first, "texels_wide"));
	const char *why = json_string_value(json_object_get(first, "why"));
	assert_string_equal(why, wide >= 0 && wide < 1 ? "all of the views show it in one texel" : "both are leaves");
}

/* The nearer of the own and of what comes from above, or the own before it. Returns whether it came from above. */
static bool try_fused(const traced *t, const json_t *fused, u32 view, u32 texel)
{
	const ts_node *nodes = data(t, TS_B_view_octree_node);
	u32 n = t->run.params.view_map_px, parent = nodes[view].parent;
	const u32 *depths = data(t, TS_B_view_map_fused_depth);
	u32 own = depth_of(fused, "own"), above = depth_of(fused, "moved_from_above"), depth = depth_of(fused, "depth");
	u32 held = parent != TS_NONE ? depths[(u64)parent * 2 * n * n + texel] : TS_NONE;
	assert_int_equal(own, own_key(t, view, texel) >> 32);
	assert_int_equal(depth, depths[(u64)view * 2 * n * n + texel]);
	assert_int_equal(above == TS_NONE, held == TS_NONE);
	u32 shows = ((const u32 *)data(t, TS_B_view_map_fused_node))[(u64)view * 2 * n * n + texel];
	const json_t *node = json_object_get(json_object_get(fused, "shows"), "node");
	assert_true(shows == TS_NONE ? depth == TS_NONE : json_integer_value(node) == (json_int_t)shows);
	bool first = own != TS_NONE && t->run.params.view_map_fusion == TS_FUSION_PAPER;
	assert_int_equal(depth, first || own < above ? own : above);
	if (held == TS_NONE) return false;
	double right = moved(&nodes[parent], (double)ts_u2f(held), &nodes[view], texel, n);
	assert_true(fabs((double)ts_u2f(above) - right) <= 1e-5 * (right + (double)ts_u2f(held)));
	return depth == above;
}

/* Checks the chain of all nodes from the root on. Returns the number of texels that moved from above. */
static u32 try_chain(const traced *t, const json_t *told, u32 node, u32 texel, u64 tally[2])
{
	const ts_node *nodes = data(t, TS_B_view_octree_node);
	const json_t *chain = json_object_get(told, "from_the_root");
	u32 n_moved = 0;
	size_t n = json_array_size(chain);
	assert_int_equal(n, nodes[node].level + 1);
	for (u32 view = node; n-- > 0; view = nodes[view].parent) {
		const json_t *entry = json_array_get(chain, n);
		assert_int_equal(figure(entry, "views"), view);
		try_rendered(t, json_object_get(entry, "rendered"), view, texel, tally);
		n_moved += try_fused(t, json_object_get(entry, "fused"), view, texel);
	}
	return n_moved;
}

static json_t *ask(const traced *t, u32 index, bool of_light, u32 texel)
{
	json_t *told;
	u32 n = t->run.params.view_map_px;
	char view[32];
	snprintf(view, sizeof view, "%s%u.%s", of_light ? "" : "node", (unsigned)index, texel >= n * n ? "back" : "front");
	require(ask_texel(t, view, texel % n, texel / n % n, &told));
	assert_int_equal(assert_agrees(told), 3 * json_array_size(json_object_get(told, "from_the_root")));
	const json_t *place = json_object_get(told, "texel");
	assert_int_equal(json_integer_value(json_array_get(place, 0)), texel % n);
	assert_int_equal(json_integer_value(json_array_get(place, 1)), texel / n % n);
	assert_string_equal(json_string_value(json_object_get(told, "half")), texel >= n * n ? "back" : "front");
	return told;
}

static void texels_are_told_with_their_ancestors(void **state)
{
	(void)state;
	u32 n_moved = 0;
	for (u32 i = 0; i < N_METHODS; i++) {
		const traced *t = &views[i];
		const u32 *depths = data(t, TS_B_view_map_fused_depth);
		u32 n = t->run.params.view_map_px, n_shown = 0;
		u64 tally[2] = {0, 0};
		for (u32 k = 0; k < n_tries(); k++) {
			u32 node = below((u32)count(t, TS_B_view_octree_node)), texel = below(2 * n * n);
			json_t *told = ask(t, node, false, texel);
			n_moved += try_chain(t, told, node, texel, tally);
			assert_int_equal(depth_of(told, "depth"), depths[(u64)node * 2 * n * n + texel]);
			n_shown += depth_of(told, "depth") != TS_NONE;
			json_decref(told);
		}
		assert_true(n_shown > n_tries() / 8 && tally[0] > n_tries() / 8 && tally[1] < tally[0] / 4);
	}
	assert_true(n_moved > n_tries() / 16);
}

/* Of a light the map of its leaf is told. */
static void a_light_shows_its_leafs_map(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_METHODS; i++) {
		const traced *t = &views[i];
		const u32 *leaf = data(t, TS_B_view_octree_leaf);
		for (u32 k = 0; k < 8; k++) {
			u32 n = t->run.params.view_map_px, light = below((u32)count(t, TS_B_vpl_light)), texel = below(2 * n * n);
			json_t *of_light = ask(t, light, true, texel), *of_node = ask(t, leaf[light], false, texel);
			assert_int_equal(figure(of_light, "light"), light);
			json_object_del(of_light, "light");
			assert_true(json_equal(of_light, of_node));
			json_decref(of_light);
			json_decref(of_node);
		}
	}
}

/* A pixel asks for more buffers than a texel, and a texel after it for no fewer. */
static void a_pixel_between_changes_no_texel(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_METHODS; i++) {
		json_t *before = ask(&views[i], 0, true, 37), *pixel, *after;
		require(ask_pixel(&views[i], 16, 18, &pixel));
		after = ask(&views[i], 0, true, 37);
		assert_true(assert_agrees(pixel) > 2 && json_equal(before, after));
		json_decref(before);
		json_decref(pixel);
		json_decref(after);
	}
}

/* Leaves near a light's leaf are told of, unless they are rendered; without a hierarchy these are just those that the
 * light sees. */
static void leaves_too_near_are_told(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_METHODS; i++) {
		const traced *t = &views[i];
		const ts_node *nodes = data(t, TS_B_octree_node), *all = data(t, TS_B_view_octree_node);
		u32 n = t->run.params.view_map_px, leaf = ((const u32 *)data(t, TS_B_view_octree_leaf))[0];
		bool alone = all[leaf].radius == 0;
		u64 n_near = 0, least = 0, most = 0;
		for (u32 texel = 0; texel < 2 * n * n; texel++) {
			json_t *told = ask(t, 0, true, texel);
			n_near += figure(told, "too_near");
			json_decref(told);
		}
		for (u64 s = 0; s < count(t, TS_B_octree_node); s++) {
			apart a = between(&nodes[s], &all[leaf]);
			answer is = nodes[s].children != 0 ? NO : both(is_near(t, &a), alone ? is_seen(t, &a, leaf) : YES);
			least += alone && is == YES;
			most += is != NO;
		}
		if (t->run.params.view_map_apart == 0)
			assert_int_equal(n_near, 0);
		else if (t->run.params.view_map_multipixel != TS_MULTIPIXEL_OFF)
			assert_true(n_near >= least && most > 0);
		else
			assert_true(n_near > 0 && n_near >= least && n_near <= most);
	}
}

static void what_is_not_there_is_refused(void **state)
{
	(void)state;
	json_t *told;
	const traced *t = &views[BRUTE_FORCE];
	u32 n = (u32)count(t, TS_B_vpl_light);
	static const struct {
		u32 index, x, y;
	} wrong[] = {{0, 16, 0}, {0, 0, 16}, {TS_NONE, 0, 0}};
	for (u32 i = 0; i < sizeof wrong / sizeof *wrong; i++) {
		char view[32];
		snprintf(view, sizeof view, "%u.front", wrong[i].index == TS_NONE ? (unsigned)n : 0);
		assert_int_equal(ask_texel(t, view, wrong[i].x, wrong[i].y, &told), TS_ERROR);
		assert_null(told);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(texels_are_told_with_their_ancestors), cmocka_unit_test(a_light_shows_its_leafs_map),
		cmocka_unit_test(a_pixel_between_changes_no_texel),     cmocka_unit_test(leaves_too_near_are_told),
		cmocka_unit_test(what_is_not_there_is_refused),
	};
	return cmocka_run_group_tests(tests, make_all, drop_all);
}
