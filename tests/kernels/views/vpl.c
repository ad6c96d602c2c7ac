/* Paths of light in a box whose walls differ, each step in double precision; texels that paths begin at, in every small
 * map; directions by their moments. */
#include <string.h>
#include "kernels/views/vpl.h"
#include "tests/kernels/small.h"
#include "tests/kernels/sums.h"

enum { N_PATCHES = 2000, BOUNCES = 6, MOST = N_PATCHES * BOUNCES };

/* Walls of the unit box are 2 axis + side. The lid is open, one wall is black, one looks away and has two sides. */
enum { LID = 5, BLACK = 1, TURNED = 3, N_WALLS = 6 };

typedef struct {
	small_scene scene;
	ts_v3 colour[N_WALLS];
	ts_node node;
	u32 offset[2], triangles[2 * N_WALLS];
	ts_patch patches[N_PATCHES];
	u32 lit[N_PATCHES + 1], paths[N_PATCHES + 1];
	ts_vpl lights[MOST];
	ts_vpl_args args;
} world;

static ts_v3 unit(u32 axis, f32 length)
{
	return ts_v3_make(axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0);
}

static ts_v3 inward(u32 wall) { return unit(wall / 2, wall % 2 == 0 ? 1 : -1); }

static void add_wall(world *w, u32 wall)
{
	u32 axis = wall / 2;
	ts_v3 o = unit(axis, (f32)(wall % 2)), u = unit((axis + 1) % 3, 1), v = unit((axis + 2) % 3, 1);
	bool swap = (wall % 2 != 0) != (wall == TURNED);
	ts_v3 b = ts_add(o, swap ? v : u), c = ts_add(o, swap ? u : v), far = ts_add(ts_add(o, u), v);
	w->colour[wall] = wall == BLACK ? ts_v3_make(0, 0, 0) : uniform3(0.2f, 0.9f);
	for (u32 half = 0; half < 2; half++) {
		u32 t = small_add(&w->scene, half == 0 ? o : far, half == 0 ? b : c, half == 0 ? c : b, wall == TURNED, 0);
		for (u32 k = 0; k < 3; k++) ts_store3(w->scene.vertices[3 * t + k].colour, w->colour[wall]);
	}
}

/* A patch in the box that shines any way, or one in three that does not. */
static void add_patch(ts_patch *patch)
{
	ts_v3 p = uniform3(0.1f, 0.9f), a = ts_mad(p, direction(), 0.05f), b = ts_mad(p, direction(), 0.05f);
	*patch = (ts_patch){.pad = 0};
	if (below(3) == 0) return;
	ts_store3(patch->a, a);
	ts_store3(patch->b, b);
	ts_store3(patch->c, p);
	ts_store3(patch->normal, direction());
	ts_store3(patch->exitance, unit(below(3), uniform(0.1f, 5)));
	if (below(2) == 0) ts_store3(patch->exitance, uniform3(0.1f, 5));
}

static void begin(world *w)
{
	memset(w, 0, sizeof *w);
	small_clear(&w->scene);
	w->scene.materials[1].flags = TS_DOUBLE_SIDED;
	for (u32 wall = 0; wall < N_WALLS; wall++) {
		if (wall != LID) add_wall(w, wall);
	}
	for (u32 i = 0; i < w->scene.n_triangles; i++) w->triangles[i] = i;
	w->offset[1] = w->scene.n_triangles;
	w->node = (ts_node){.centre = {0.5f, 0.5f, 0.5f}, .radius = 0.8660254f, .child = TS_NONE, .parent = TS_NONE};
	for (u32 i = 0; i < N_PATCHES; i++) add_patch(&w->patches[i]);
	w->args = (ts_vpl_args){.cast = {.scene = small_arrays(&w->scene),
	                                 .nodes = &w->node,
	                                 .offset = w->offset,
	                                 .triangles = w->triangles,
	                                 .leaf = 0.01f},
	                        .patches = w->patches,
	                        .offset = w->lit,
	                        .paths = w->paths,
	                        .lights = w->lights,
	                        .n_patches = N_PATCHES,
	                        .seed = 3,
	                        .bounces = BOUNCES};
}

/* All paths, from last to first. */
static void follow(world *w)
{
	for (u64 i = N_PATCHES; i-- > 0;) ts_k_vpl_count_item(&w->args, i);
	prefix_sums(w->lit, N_PATCHES);
	w->args.n_lit = w->args.n = w->lit[N_PATCHES];
	for (u64 i = w->args.n; i-- > 0;) ts_k_vpl_path_item(&w->args, i);
	prefix_sums(w->paths, w->args.n);
	for (u64 i = w->args.n; i-- > 0;) ts_k_vpl_item(&w->args, i);
}

static bool is_lit(const ts_patch *p) { return p->exitance[0] > 0 || p->exitance[1] > 0 || p->exitance[2] > 0; }
static double3 loaded(const f32 *v) { return d3_of(ts_load3(v)); }

/* Half a leaf above the patch's middle, with all that leaves its area. */
static void check_first(const ts_vpl *light, const ts_patch *patch)
{
	double3 a = loaded(patch->a), b = loaded(patch->b), c = loaded(patch->c), n = loaded(patch->normal);
	double3 middle = d3_scale(d3_add(d3_add(a, b), c), 1.0 / 3);
	double area = d3_length(d3_cross(d3_sub(b, a), d3_sub(c, a))) / 2;
	assert_true(d3_distance(loaded(light->position), d3_mad(middle, n, 0.005)) < 1e-6);
	assert_true(d3_distance(loaded(light->flux), d3_scale(loaded(patch->exitance), area)) < 1e-6);
	assert_memory_equal(light->normal, patch->normal, sizeof light->normal);
	assert_int_equal(light->bounce, 1);
}

/* How far it is to a wall; from so near an edge that rounding decides, `unsure`. */
static double leaves_at(double3 o, double3 d, u32 *wall, bool *unsure)
{
	const double from[3] = {o.x, o.y, o.z}, way[3] = {d.x, d.y, d.z};
	double least = 1e9, next = 1e9;
	for (u32 k = 0; k < 3; k++) {
		double t = way[k] == 0 ? 1e9 : ((way[k] > 0) - from[k]) / way[k];
		next = fmin(next, fmax(t, least));
		if (t >= least) continue;
		least = t;
		*wall = 2 * k + (way[k] > 0);
	}
	*unsure = next - least < 1e-4;
	return least;
}

/* What follows a light of path k; NULL: nothing does. */
static void check_next(const world *w, u32 k, const ts_vpl *light, const ts_vpl *next, u32 hits[N_WALLS])
{
	ts_v3 d = ts_k_vpl_direction(&w->args, k, light->bounce, ts_load3(light->normal));
	bool unsure;
	u32 wall = N_WALLS;
	double t = leaves_at(loaded(light->position), d3_of(d), &wall, &unsure);
	if (unsure) return;
	hits[wall]++;
	assert_int_equal(next != NULL, wall != LID && wall != BLACK);
	if (next == NULL) return;
	double3 p = d3_mad(loaded(light->position), d3_of(d), t), n = d3_of(inward(wall));
	ts_v3 flux = ts_mul(ts_load3(light->flux), w->colour[wall]);
	assert_true(d3_distance(loaded(next->position), d3_mad(p, n, 0.005)) < 2e-6);
	assert_true(d3_distance(loaded(next->normal), n) < 1e-6);
	assert_true(d3_distance(loaded(next->flux), d3_of(flux)) < 1e-6);
	assert_int_equal(next->bounce, light->bounce + 1);
}

static void paths_reflect_as_double_precision_says(void **state)
{
	(void)state;
	static world w;
	u32 k = 0, n_long = 0, hits[N_WALLS] = {0};
	begin(&w);
	follow(&w);
	for (u32 i = 0; i < N_PATCHES; i++) {
		if (!is_lit(&w.patches[i])) continue;
		u32 from = w.paths[k], n = w.paths[k + 1] - from;
		check_first(&w.lights[from], &w.patches[i]);
		assert_true(n >= 1 && n <= BOUNCES);
		for (u32 at = 0; at < n && at + 1 < BOUNCES; at++) {
			check_next(&w, k, &w.lights[from + at], at + 1 < n ? &w.lights[from + at + 1] : NULL, hits);
		}
		n_long += n == BOUNCES;
		k++;
	}
	assert_int_equal(k, w.args.n);
	assert_true(n_long > 100);
	for (u32 wall = 0; wall < N_WALLS; wall++) assert_true(hits[wall] > 100);
}

/* Of every map of a few texels: the path of each rank begins at the texel of that rank. Random paths begin at all of
 * them alike, and each has its share of the flux. */
static void each_path_begins_at_its_texel(void **state)
{
	(void)state;
	enum { N = 9, N_DRAWS = 9000 };
	for (u32 map = 1; map < 1 << N; map++) {
		ts_patch patches[N];
		u32 lit[N + 1], at[N], n = 0, drawn[N] = {0};
		memset(patches, 0, sizeof patches);
		for (u32 i = 0; i < N; i++) {
			if ((map >> i & 1) == 0) continue;
			patches[i].exitance[i % 3] = 2;
			patches[i].b[0] = patches[i].c[1] = 1;
			at[n++] = i;
		}
		ts_vpl_args args = {.patches = patches, .offset = lit, .n_patches = N, .n_lit = n, .n = n, .seed = map};
		for (u32 i = 0; i < N; i++) ts_k_vpl_count_item(&args, i);
		prefix_sums(lit, N);
		assert_int_equal(lit[N], n);
		for (u32 k = 0; k < n; k++) assert_int_equal(ts_k_vpl_start(&args, k), at[k]);
		if (map % 37 != 0) continue;
		args.random = 1;
		args.n = N_DRAWS;
		for (u32 k = 0; k < N_DRAWS; k++) drawn[ts_k_vpl_start(&args, k)]++;
		for (u32 k = 0; k < n; k++) assert_near(drawn[at[k]], N_DRAWS / (double)n, 5 * sqrt(N_DRAWS / (double)n));
		ts_light_k light = ts_k_vpl_first(&args, 7);
		assert_near(light.flux.x + light.flux.y + light.flux.z, (double)n / N_DRAWS, 1e-9);
	}
}

/* Directions about a normal: mean cosine 2/3, of its square 1/2, and nothing to one side. */
static void directions_have_the_moments_of_a_cosine(void **state)
{
	(void)state;
	enum { N = 100000 };
	const ts_vpl_args args = {.seed = 5};
	for (u32 k = 0; k < 3; k++) {
		double up = 0, square = 0, aside[3] = {0, 0, 0};
		ts_v3 n = k == 0 ? ts_v3_make(0, 1, 0) : ts_normalize(ts_v3_make(0.3f, (f32)k - 2, 0.7f));
		for (u32 i = 0; i < N; i++) {
			ts_v3 d = ts_k_vpl_direction(&args, i, 1 + k, n), across = ts_mad(d, n, -ts_dot(d, n));
			double cosine = (double)ts_dot(d, n);
			assert_true(cosine >= 0 && fabsf(ts_length(d) - 1) < 1e-6f);
			up += cosine / N;
			square += cosine * cosine / N;
			aside[0] += (double)across.x / N;
			aside[1] += (double)across.y / N;
			aside[2] += (double)across.z / N;
		}
		assert_true(fabs(up - 2.0 / 3) < 0.004 && fabs(square - 0.5) < 0.005);
		for (u32 c = 0; c < 3; c++) assert_true(fabs(aside[c]) < 0.008);
	}
}

/* Lamps inside the box and behind its wall of two sides, which stops the light of either. */
static const ts_light lamps[] = {
	{.position = {0.4f, 0.3f, 0.7f}, .kind = TS_LIGHT_KIND_POINT, .intensity = {2, 3, 4}},
	{.position = {0.5f, 2, 0.5f}, .kind = TS_LIGHT_KIND_POINT, .intensity = {5, 7, 1}},
};

/* The wall that a light at random stands on, and the lamp that it sees. */
static u32 wall_of(const ts_vpl *light, u32 *lamp)
{
	for (u32 wall = 0; wall < N_WALLS; wall++) {
		f32 at = light->position[wall / 2], side = (f32)(wall % 2), n = light->normal[wall / 2];
		if (fabsf(n) < 0.999f || fabsf(at - side - 0.005f * n) > 1e-6f) continue;
		*lamp = n * (side - 0.5f) > 0 ? 1 : 0;
		assert_true(*lamp == 0 || wall == TURNED);
		return wall;
	}
	fail_msg("a light is on no wall");
	return N_WALLS;
}

/* What reaches the wall below it, in double precision, of its share of the area of six sides. */
static void check_flux(const world *w, const ts_vpl *light, u32 wall, u32 lamp)
{
	double3 n = loaded(light->normal), p = d3_mad(loaded(light->position), n, -0.005);
	double3 way = d3_sub(loaded(lamps[lamp].position), p);
	double d = d3_length(way), form = d3_dot(way, n) / (d * d * d) * 6 / w->args.n;
	for (u32 k = 0; k < 3; k++) {
		const f32 colour[3] = {w->colour[wall].x, w->colour[wall].y, w->colour[wall].z};
		assert_near(light->flux[k], form * (double)lamps[lamp].intensity[k] * (double)colour[k], 2e-5 * form);
	}
}

/* Lights at random stand as dense on every wall, and on both sides of the one that has two. */
static void random_lights_cover_all_walls_alike(void **state)
{
	(void)state;
	enum { N = 9600, SIDES = 6 };
	static world w;
	static u32 areas[2 * N_WALLS + 1], paths[N + 1];
	u32 n[N_WALLS][2] = {{0}};
	double sum[N_WALLS] = {0}, square[N_WALLS] = {0};
	ts_root root = {.side = 1.25f};
	begin(&w);
	const ts_vpl_area_args measure = {.scene = w.args.cast.scene, .root = &root, .areas = areas};
	for (u32 i = 0; i < w.scene.n_triangles; i++) ts_k_vpl_area_item(&measure, i);
	prefix_sums(areas, w.scene.n_triangles);
	w.args.areas = areas;
	w.args.lamps = lamps;
	w.args.n_lamps = 2;
	w.args.paths = paths;
	w.args.n = N;
	w.args.bounces = 1;
	for (u64 i = N; i-- > 0;) ts_k_vpl_path_item(&w.args, i);
	prefix_sums(paths, N);
	assert_int_equal(paths[N], N);
	for (u64 i = N; i-- > 0;) ts_k_vpl_item(&w.args, i);
	for (u32 i = 0; i < N; i++) {
		const ts_vpl *light = &w.lights[i];
		u32 lamp = 0, wall = wall_of(light, &lamp);
		f32 at = light->position[(wall / 2 + 1) % 3];
		check_flux(&w, light, wall, lamp);
		n[wall][lamp]++;
		sum[wall] += (double)at;
		square[wall] += (double)(at * light->position[(wall / 2 + 2) % 3]);
	}
	for (u32 wall = 0; wall < N_WALLS; wall++) {
		double both = n[wall][0] + n[wall][1];
		if (wall == LID) assert_int_equal(both, 0);
		if (wall == LID) continue;
		assert_near(n[wall][0], (double)N / SIDES, 5 * sqrt((double)N / SIDES));
		assert_near(n[wall][1], wall == TURNED ? (double)N / SIDES : 0, 5 * sqrt((double)N / SIDES));
		assert_near(sum[wall] / both, 0.5, 0.03);
		assert_near(square[wall] / both, 0.25, 0.03);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(paths_reflect_as_double_precision_says),
		seeded_test(each_path_begins_at_its_texel),
		seeded_test(directions_have_the_moments_of_a_cosine),
		seeded_test(random_lights_cover_all_walls_alike),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
