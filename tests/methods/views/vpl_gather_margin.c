/* The margins of gathered light against ports that round otherwise: the gather in double precision, in which every
 * number is off by up to 2 ulps, each its own way. What it compares is off by no more than the step that margins are
 * counted in. Pixels that draw from another list, or with a light that one sees and the other does not, are
 * undecided, and few are; and a port that is off by more differs in pixels that are decided. */
#include <math.h>
#include "kernels/views/vpl_gather_margin.h"
#include "methods/stages.h"
#include "methods/views/views.h"
#include "tests/methods/small.h"
#include "tests/whole.h"

enum { N_PORTS = 4, N_TIES = 3000, WIDTH = 64, HEIGHT = 48 };

static u32 n_ports(void) { return whole_or(N_PORTS, 2); }
static u32 n_ties(void) { return whole_or(N_TIES, 1500); }

/* How a port is off: by its slack, depths of maps, places in maps, in texels, sides of nodes, in nodes, and how far
 * above a tangent plane is clear of it. */
typedef struct {
	double slack, depth, place, side, clear;
} faults;

typedef struct {
	ts_vpl_gather_args of; /* the buffers and settings; no kernel is asked */
	faults faults;
	u32 number; /* which way its numbers are off */
} port;

typedef struct {
	double x, y, z;
} d3;
static u32 n_random;

/* The same number is off the same way. */
static double off(const port *p, double x)
{
	return x * (1 + (ts_uniform(ts_random(ts_f2u((f32)x), 3, p->number)) * 2 - 1) / 8388608.0);
}

static d3 make3(const f32 *v) { return (d3){(double)v[0], (double)v[1], (double)v[2]}; }
static d3 apart(const port *p, d3 a, d3 b) { return (d3){off(p, a.x - b.x), off(p, a.y - b.y), off(p, a.z - b.z)}; }

static double dot(const port *p, d3 a, d3 b)
{
	return off(p, off(p, off(p, a.x * b.x) + off(p, a.y * b.y)) + off(p, a.z * b.z));
}

static double length(const port *p, d3 a) { return off(p, sqrt(dot(p, a, a))); }
/* a b - c d */
static double part(const port *p, double a, double b, double c, double d)
{
	return off(p, off(p, a * b) - off(p, c * d));
}

static d3 cross(const port *p, d3 a, d3 b)
{
	return (d3){part(p, a.y, b.z, a.z, b.y), part(p, a.z, b.x, a.x, b.z), part(p, a.x, b.y, a.y, b.x)};
}

static double leaf_side(const port *p) { return (double)p->of.root->side / (double)(1u << p->of.levels); }

/* Diagonals of a leaf, and texels as far as the surface reaches back in them. */
static double slack_of(const port *p, d3 way, d3 n)
{
	double d = length(p, way), texel = off(p, d + fabs(way.x)) * 2 / p->of.n;
	double slope = off(p, length(p, cross(p, way, n)) / fmax(fabs(dot(p, way, n)), d / 16));
	double texels = off(p, off(p, (double)p->of.bias_slope * slope) + (double)p->of.bias_px);
	return (off(p, texel * texels) + off(p, (double)p->of.bias * sqrt(3) * leaf_side(p))) * p->faults.slack;
}

/* Where the middle of a texel is that a leaf shows at a depth, seen from the light. */
static double depth_of(const port *p, u32 view, u32 texel)
{
	u32 n = p->of.n, leaf = p->of.leaves[view];
	double depth = (double)ts_u2f(p->of.depths[(u64)leaf * 2 * n * n + texel]) * p->faults.depth;
	double u = (2.0 * (texel % n) + 1) / n - 1, v = (2.0 * (texel / n % n) + 1) / n - 1, square = u * u + v * v;
	double along = (texel < n * n ? 1 : -1) * off(p, (1 - square) / (1 + square));
	d3 way = {along, off(p, 2 * u / (1 + square)), off(p, 2 * v / (1 + square))},
	   centre = make3(p->of.nodes[leaf].centre);
	d3 at = {off(p, centre.x + way.x * depth), off(p, centre.y + way.y * depth), off(p, centre.z + way.z * depth)};
	return length(p, apart(p, at, make3(p->of.lights[view].position)));
}

static u32 place_of(const port *p, double component, double sum)
{
	double u = component == 0 ? 0 : off(p, component / sum);
	f32 at = (f32)((0.5 + u / 2) * p->of.n + p->faults.place);
	return (u32)ts_min_i32(ts_max_i32(ts_floor_i32(at), 0), (i32)p->of.n - 1);
}

static u32 texel_of(const port *p, d3 way)
{
	double sum = off(p, length(p, way) + fabs(way.x));
	return ((way.x < 0 ? p->of.n : 0) + place_of(p, way.z, sum)) * p->of.n + place_of(p, way.y, sum);
}

/* How far behind what a texel shows, and its slack, a place is. The texel is not empty. */
static double behind(const port *p, u32 view, u32 texel, d3 at, d3 n)
{
	d3 way = apart(p, at, make3(p->of.lights[view].position));
	return length(p, way) - off(p, depth_of(p, view, texel) + slack_of(p, way, n));
}

static u32 shown(const port *p, u32 view, u32 texel)
{
	return p->of.shown[(u64)p->of.leaves[view] * 2 * p->of.n * p->of.n + texel];
}

/* How far above the tangent plane of a place what a texel shows is, and clear of that. */
static double above(const port *p, u32 view, u32 texel, d3 at, d3 n)
{
	const ts_node *node = &p->of.scene[shown(p, view, texel)];
	double clear = off(p, (double)p->of.bias_plane * (double)node->radius) * p->faults.clear;
	return dot(p, apart(p, make3(node->centre), at), n) - clear;
}

static bool is_seen(const port *p, u32 view, d3 at, d3 n)
{
	u32 texel = texel_of(p, apart(p, at, make3(p->of.lights[view].position)));
	if (shown(p, view, texel) == TS_NONE || behind(p, view, texel, at, n) <= 0) return true;
	return p->of.by_plane != 0 && above(p, view, texel, at, n) <= 0;
}

/* The node of the lists' level: places are snapped to the lattice first. */
static u32 side_of(const port *p, double coordinate, double lower)
{
	double share = off(p, off(p, coordinate - lower) / (double)p->of.root->side);
	double steps = floor(share * (double)((u64)TS_VOXEL << p->of.levels) + 0.5);
	double node = floor(steps / (double)((u64)TS_VOXEL << (p->of.levels - p->of.level)) + p->faults.side);
	return (u32)fmin(fmax(node, 0), (1u << p->of.level) - 1);
}

static u32 node_of(const port *p, d3 at)
{
	const f32 *lower = p->of.root->lower;
	ts_i3 voxel = ts_i3_make((i32)side_of(p, at.x, (double)lower[0]), (i32)side_of(p, at.y, (double)lower[1]),
	                         (i32)side_of(p, at.z, (double)lower[2]));
	u64 code = ts_k_morton(voxel);
	bool there = (p->of.mask[ts_k_mask_word(p->of.level, code)] & ts_k_mask_bit(code)) != 0;
	return there ? ts_k_mask_id(p->of.mask, p->of.before, p->of.level, code) : TS_NONE;
}

/* Ours: whether the light gives something, and is asked for at all. */
static bool gives(const ts_vpl_gather_args *args, u32 view, ts_v3 at, ts_v3 n, bool *asked)
{
	const ts_vpl *light = &args->lights[view];
	ts_v3 way = ts_sub(at, ts_load3(light->position));
	*asked = ts_k_vpl_form(way, ts_load3(light->normal), n, args->near * ts_k_leaf_side(args)) > 0.0f;
	return *asked && ts_k_vpl_reaches(args, view, ts_k_paraboloid_texel(way, args->n), at, n);
}

/* loose: pixels that differ at a sixteenth of the margin or more. Ratios: by how much ours is off, in the step of
 * its margin, and in what is left of that without one of its terms; and by how much the height above a plane is, in
 * its step. */
typedef struct {
	u64 pixels, undecided, differ, wrong, loose;
	double ratio, no_slack, no_distance, height;
} sums;

static bool differs(const port *p, u32 pixel, const ts_view_list *list)
{
	const ts_gpixel *of = &p->of.pixels[pixel];
	d3 at = make3(of->position), n = make3(of->normal);
	if (node_of(p, at) != ts_k_list_node(&p->of, ts_load3(of->position))) return true;
	for (u32 k = 0; list->views > 0 && k < ts_k_list_draws(&p->of, list); k++) {
		bool asked;
		u32 view = ts_k_drawn_view(&p->of, list, pixel, k);
		bool ours = gives(&p->of, view, ts_load3(of->position), ts_load3(of->normal), &asked);
		if (asked && ours != is_seen(p, view, at, n)) return true;
	}
	return false;
}

static void try_pixel(sums *r, const port *p, u32 pixel, f32 margin)
{
	if (p->of.pixels[pixel].depth == TS_SKY) return;
	ts_view_list list = ts_k_pixel_list(&p->of, ts_load3(p->of.pixels[pixel].position));
	bool differ = differs(p, pixel, &list);
	r->pixels++;
	r->undecided += margin <= 1;
	r->differ += differ;
	r->wrong += differ && margin > 1;
	r->loose += differ && margin > 0.0625f;
}

static void try_term(sums *r, const port *p, u32 view, const ts_gpixel *of)
{
	ts_v3 at = ts_load3(of->position), n = ts_load3(of->normal), from = ts_load3(p->of.lights[view].position);
	ts_v3 way = ts_sub(at, from);
	u32 texel = ts_k_paraboloid_texel(way, p->of.n), node = shown(p, view, texel);
	if (node == TS_NONE) return;
	u64 key = ts_k_vpl_shown(&p->of, view, texel);
	f32 reach = ts_k_vpl_reach(&p->of, view, key, texel, at, n), d = ts_length(way);
	f32 margin = ts_k_vpl_depth_answer(&p->of, view, key, texel, at, n).margin;
	double ours = (double)(d - reach);
	double apart = fabs(ours - behind(p, view, texel, make3(of->position), make3(of->normal)));
	double step = fabs(ours) / (double)margin;
	double of_distance = (double)(d + reach - ts_k_vpl_slack(&p->of, way, n) + ts_length(at)) / 1048576;
	r->ratio = fmax(r->ratio, apart / step);
	r->no_slack = fmax(r->no_slack, apart / of_distance);
	r->no_distance = fmax(r->no_distance, apart / fmax(step - of_distance, 1e-12));
	if (p->of.by_plane == 0) return;
	double height = (double)(ts_k_node_height(&p->of.scene[node], at, n) - ts_k_vpl_clear(&p->of, &p->of.scene[node]));
	double of_height = fabs(height) / (double)ts_k_vpl_plane_answer(&p->of, node, at, n).margin;
	r->height =
		fmax(r->height, fabs(height - above(p, view, texel, make3(of->position), make3(of->normal))) / of_height);
}

static double random_below(double most) { return most * ts_uniform(ts_random(n_random++, 3, 99)); }

/* On the light's way to the pixel, where its map shows what is in the way. */
static bool tie_depth(const port *p, ts_gpixel *pixel, u32 view)
{
	d3 from = make3(p->of.lights[view].position), at = make3(pixel->position), n = make3(pixel->normal);
	u32 texel = texel_of(p, apart(p, at, from));
	double low = 0.1, high = 10;
	if (shown(p, view, texel) == TS_NONE) return false;
	for (u32 k = 0; k < 40; k++) {
		double middle = (low + high) / 2;
		d3 there = {from.x + middle * (at.x - from.x), from.y + middle * (at.y - from.y),
		            from.z + middle * (at.z - from.z)};
		if (behind(p, view, texel, there, n) > 0)
			high = middle;
		else
			low = middle;
	}
	pixel->position[0] = (f32)(from.x + low * (at.x - from.x));
	pixel->position[1] = (f32)(from.y + low * (at.y - from.y));
	pixel->position[2] = (f32)(from.z + low * (at.z - from.z));
	return true;
}

/* As far from the light as it was, on an edge of two columns or rows of its map. */
static bool tie_place(const port *p, ts_gpixel *pixel, u32 view)
{
	const f32 *from = p->of.lights[view].position;
	double d = length(p, apart(p, make3(pixel->position), make3(from)));
	double u = floor(random_below(p->of.n)) * 2 / p->of.n - 1, v = random_below(2) - 1, square = u * u + v * v;
	double side = random_below(2) < 1 ? 1 : -1;
	u32 axis = random_below(2) < 1 ? 1 : 2;
	if (square >= 1) return false;
	pixel->position[0] = (f32)((double)from[0] + side * d * (1 - square) / (1 + square));
	pixel->position[axis] = (f32)((double)from[axis] + d * 2 * u / (1 + square));
	pixel->position[3 - axis] = (f32)((double)from[3 - axis] + d * 2 * v / (1 + square));
	return true;
}

/* Moved along an axis, to a side of a node of the lists. */
static bool tie_side(const port *p, ts_gpixel *pixel)
{
	u32 axis = (u32)random_below(3), nodes = 1u << p->of.level;
	double side = floor(random_below(nodes)) / nodes - 0.5 / (double)((u64)TS_VOXEL << p->of.levels);
	pixel->position[axis] = (f32)((double)p->of.root->lower[axis] + side * (double)p->of.root->side);
	return true;
}

/* On the light's way to the pixel, behind what its map shows, where that is just clear of the tangent plane. */
static bool tie_plane(const port *p, ts_gpixel *pixel, u32 view)
{
	d3 from = make3(p->of.lights[view].position), at = make3(pixel->position), n = make3(pixel->normal);
	d3 way = apart(p, at, from);
	u32 texel = texel_of(p, way);
	if (p->of.by_plane == 0 || shown(p, view, texel) == TS_NONE) return false;
	double far = above(p, view, texel, from, n) / dot(p, way, n);
	d3 there = {from.x + far * way.x, from.y + far * way.y, from.z + far * way.z};
	if (!(far > 0.05 && far < 20) || behind(p, view, texel, there, n) <= 0) return false;
	pixel->position[0] = (f32)there.x;
	pixel->position[1] = (f32)there.y;
	pixel->position[2] = (f32)there.z;
	return true;
}

/* A pixel that is nearly something else. */
static ts_gpixel tie(const port *p, u32 kind)
{
	for (;;) {
		ts_gpixel pixel = p->of.pixels[(u32)random_below(WIDTH * HEIGHT)];
		u32 view = (u32)random_below(p->of.n_lights);
		if (pixel.depth == TS_SKY) continue;
		bool made = kind == 0   ? tie_depth(p, &pixel, view)
		            : kind == 1 ? tie_place(p, &pixel, view)
		            : kind == 2 ? tie_side(p, &pixel)
		                        : tie_plane(p, &pixel, view);
		if (made) return pixel;
	}
}

static const struct {
	const char *effect, *method;
	u32 px, draws, test;
	f32 bias, slope, light_bias;
} cases[] = {
	{"indirect", "megaviews", 16, 0, TS_SHADOW_TEST_DISTANCE, 0.25f, 0.25f, 0.5f},
	{"indirect", "megaviews", 8, 16, TS_SHADOW_TEST_DISTANCE, 0, 2, 0},
	{"indirect", "manylods", 16, 0, TS_SHADOW_TEST_DISTANCE, 0, 0, 1},
	{"particles", "megaviews", 32, 0, TS_SHADOW_TEST_PLANE, 0, 0, 0},
	{"indirect", "megaviews", 16, 0, TS_SHADOW_TEST_PLANE, 0.25f, 0, 0.5f},
};
enum { N_CASES = sizeof cases / sizeof *cases };
static ts_run runs[N_CASES];
static ts_scene *scene;

static int make_all(void **state)
{
	(void)state;
	ts_params params = small_params(WIDTH, HEIGHT);
	params.reflectors_count = 0;
	params.octree_levels = 5;
	params.vpl_gather_level = 4;
	params.rsm_px = 16;
	params.vpl_paths = params.particle_count = 60;
	scene = small_scene(&params);
	for (u32 i = 0; i < N_CASES; i++) {
		params.view_map_px = cases[i].px;
		params.vpl_gather_lights = cases[i].draws;
		params.vpl_gather_test = cases[i].test;
		params.depth_map_bias = cases[i].bias;
		params.depth_map_bias_slope = cases[i].slope;
		params.vpl_gather_bias = cases[i].light_bias;
		ts_run_begin(&runs[i], scene, &params, 2);
		runs[i].traced = runs[i].margins = true;
		assert_int_equal(ts_pipeline_run(ts_pipeline_find(cases[i].effect, cases[i].method), &runs[i]), TS_OK);
	}
	return 0;
}

static int drop_all(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_CASES; i++) ts_run_end(&runs[i]);
	ts_scene_free(scene);
	return 0;
}

static const faults none = {1, 1, 0, 0, 1};

/* The pixels of the picture. */
static sums check(u32 i, const faults *how)
{
	sums r = {.pixels = 0};
	port p = {.faults = *how};
	assert_int_equal(ts_vpl_gather_ask(&runs[i], &p.of), TS_OK);
	const f32 *margin = ts_frame_data(&runs[i].frame, TS_B_vpl_gather_margin);
	for (p.number = 0; p.number < n_ports(); p.number++) {
		for (u32 pixel = 0; pixel < WIDTH * HEIGHT; pixel++) try_pixel(&r, &p, pixel, margin[pixel]);
	}
	return r;
}

/* Ties of a kind. */
static sums check_ties(u32 i, u32 kind)
{
	sums r = {.pixels = 0};
	static ts_gpixel pixels[N_TIES];
	static f32 margins[N_TIES];
	port p = {.faults = none, .number = N_PORTS};
	assert_int_equal(ts_vpl_gather_ask(&runs[i], &p.of), TS_OK);
	for (u32 k = 0; k < n_ties(); k++) pixels[k] = tie(&p, kind);
	p.of.pixels = pixels;
	ts_vpl_gather_margin_args args = {.of = p.of, .margin = margins};
	for (u32 k = 0; k < n_ties(); k++) ts_k_vpl_gather_margin_item(&args, k);
	for (p.number = 0; p.number < n_ports(); p.number++) {
		for (u32 k = 0; k < n_ties(); k++) {
			try_pixel(&r, &p, k, margins[k]);
			try_term(&r, &p, k % p.of.n_lights, &pixels[k]);
		}
	}
	return r;
}

static void rounding_differs_only_where_undecided(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_CASES; i++) {
		sums r = check(i, &none);
		print_message("of %u pixels %u undecided, %u differ, %u of these decided\n", (unsigned)r.pixels,
		              (unsigned)r.undecided, (unsigned)r.differ, (unsigned)r.wrong);
		assert_true(r.wrong == 0 && r.pixels > 2000 * n_ports() && r.undecided < r.pixels / 100);
	}
}

/* Steps of a fourth would be found, and steps without one of their terms. */
static void ties_stay_within_a_step(void **state)
{
	(void)state;
	sums all = {.pixels = 0};
	for (u32 kind = 0; kind < 4; kind++) {
		u64 differ = 0;
		for (u32 i = 0; i < N_CASES; i++) {
			if (kind == 3 && cases[i].test != TS_SHADOW_TEST_PLANE) continue;
			sums r = check_ties(i, kind);
			print_message("of %u ties %u undecided, %u differ, %u decided; off by %.3f and %.3f of the step\n",
			              (unsigned)r.pixels, (unsigned)r.undecided, (unsigned)r.differ, (unsigned)r.wrong, r.ratio,
			              r.height);
			assert_true(r.wrong == 0 && r.ratio <= 1 && r.height <= 1);
			differ += r.differ;
			all.loose += r.loose;
			all.ratio = fmax(all.ratio, r.ratio);
			all.no_slack = fmax(all.no_slack, r.no_slack);
			all.height = fmax(all.height, r.height);
			all.no_distance = fmax(all.no_distance, r.no_distance);
		}
		assert_true(differ > 40);
	}
	assert_true(all.loose > 0 && all.ratio > 0.25 && all.no_slack > 1 && all.no_distance > 1);
	assert_true(all.height > 0.125);
}

static void wrong_thresholds_differ_where_decided(void **state)
{
	(void)state;
	static const faults wrong[] = {
		{1.01, 1, 0, 0, 1}, {1, 1.001, 0, 0, 1}, {1, 1, 0.01, 0, 1}, {1, 1, 0, 0.01, 1}, {1, 1, 0, 0, 1.01}};
	for (u32 i = 0; i < sizeof wrong / sizeof *wrong; i++) {
		if (check(i < 4 ? 0 : 4, &wrong[i]).wrong == 0) fail_msg("fault %u is not found", (unsigned)i);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(rounding_differs_only_where_undecided),
		cmocka_unit_test(ties_stay_within_a_step),
		cmocka_unit_test(wrong_thresholds_differ_where_decided),
	};
	return cmocka_run_group_tests(tests, make_all, drop_all);
}
