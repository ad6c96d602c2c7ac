/* The margins of maps of views against ports that round otherwise: a traversal in double precision, in which every
 * number that is compared is off by up to 2 ulps, each its own way. Texels that show another node, or none, are
 * undecided; few are; and a port whose thresholds are off by more than rounding differs in texels that are decided. */
#include "../../../src/methods/views/views.h"
#include "grove.h"
#include "../../../src/kernels/views/view_map_margin.h"
#include "../../../src/methods/stages.h"

enum { N_PORTS = 4 };

/* How its thresholds are off: of figure 4, of figure 6, and of leaves that touch. */
typedef struct {
	double cull, size, touch;
} faults;

typedef struct {
	const grove *g;
	ts_params params;
	faults faults;
	u32 number; /* which way its numbers are off */
	u64 *map;
	u64 n_pairs;
} port;

/* The same number is off the same way. */
static double off(const port *p, double x)
{
	return x * (1 + (ts_uniform(ts_random(ts_f2u((f32)x), 3, p->number)) * 2 - 1) / 8388608.0);
}

/* From the middle of a node of views to that of a node of the scene. */
typedef struct {
	double x, y, z, d;
} way;

static way way_of(const port *p, const ts_node *s, const ts_node *v)
{
	way w = {(double)s->centre[0] - (double)v->centre[0], (double)s->centre[1] - (double)v->centre[1],
	         (double)s->centre[2] - (double)v->centre[2], 0};
	w.d = off(p, sqrt(w.x * w.x + w.y * w.y + w.z * w.z));
	return w;
}

static bool is_culled(const port *p, const way *w, const ts_node *s, const ts_node *v, const ts_cone *cone)
{
	if (p->params.view_map_field == TS_VIEW_FIELD_ALL) return false;
	double c = (double)cone->cosine - (double)TS_CULL_COSINE, sine = sqrt(fmax(0, 1 - off(p, c * c)));
	if (c <= 0) return false;
	double x = (double)cone->axis[0], y = (double)cone->axis[1], z = (double)cone->axis[2];
	double along = off(p, w->x * x + w->y * y + w->z * z);
	double a = w->y * z - w->z * y, b = w->z * x - w->x * z, e = w->x * y - w->y * x;
	double aside = off(p, sqrt(a * a + b * b + e * e));
	double fs = -aside * sine - along * c, ahead = -along * sine + aside * c;
	if (fs > 0 && ahead <= 0) fs = w->d;
	return fs > off(p, (double)s->radius + (double)v->radius) + (w->d * (double)TS_CULL_DISTANCE) * p->faults.cull;
}

static double size_of(const port *p, const way *w, double sine)
{
	return off(p, p->params.view_map_px * sine / (off(p, fabs(w->x) / w->d) + sqrt(1 - off(p, sine * sine))));
}

static bool is_equivalent(const port *p, const way *w, const ts_node *s, const ts_node *v)
{
	double nearest = off(p, w->d - (double)v->radius), r = (double)s->radius;
	return nearest > r && v->radius <= s->radius && size_of(p, w, off(p, r / nearest)) < p->faults.size;
}

static bool touches(const port *p, const way *w, const ts_node *s, const ts_node *v)
{
	bool leaves = s->children == 0 && v->children == 0 && p->params.view_map_touching == TS_TOUCHING_SKIP;
	return leaves && w->d < ((double)s->radius + fmax((double)s->radius, (double)v->radius)) * p->faults.touch;
}

static u32 place_of(const port *p, double component, const way *w)
{
	double u = component == 0 ? 0 : off(p, component / off(p, w->d + fabs(w->x)));
	f32 at = (f32)(0.5 + u / 2) * (f32)p->params.view_map_px;
	return (u32)ts_min_i32(ts_max_i32(ts_floor_i32(at), 0), (i32)p->params.view_map_px - 1);
}

static void render(port *p, const way *w, u32 s, u32 v)
{
	ts_pyramid pyramid = ts_view_pyramid(&p->params);
	u32 n = p->params.view_map_px, level = 0;
	double r = (double)p->g->scene.nodes[s].radius, size = w->d > r ? size_of(p, w, r / w->d) : n;
	while (level + 1 < pyramid.levels && (1u << level) < size) level++;
	u32 texel = ((w->x < 0 ? n : 0) + place_of(p, w->z, w)) * n + place_of(p, w->y, w);
	u64 *there = &p->map[(u64)v * ts_k_pyramid_texels(&pyramid) + ts_k_pyramid_above(&pyramid, texel, level)];
	u64 key = (u64)ts_f2u((f32)w->d) << 32 | s;
	*there = key < *there ? key : *there;
}

static void visit(port *p, u32 s, u32 v)
{
	const ts_node *node = &p->g->scene.nodes[s], *view = &p->g->views.nodes[v];
	bool leaf = node->children == 0, view_leaf = view->children == 0;
	way w = way_of(p, node, view);
	p->n_pairs++;
	if (is_culled(p, &w, node, view, &p->g->cones[v])) return;
	if (is_equivalent(p, &w, node, view)) {
		render(p, &w, s, v);
	} else if (leaf && view_leaf) {
		if (!touches(p, &w, node, view)) render(p, &w, s, v);
	} else if (leaf || (!view_leaf && node->radius * 0.5f < view->radius)) {
		for (u32 k = 0; k < ts_k_count_bits(view->children); k++) visit(p, s, view->child + k);
	} else {
		for (u32 k = 0; k < ts_k_count_bits(node->children); k++) visit(p, node->child + k, v);
	}
}

typedef struct {
	u64 shown, undecided, differ, wrong;
} sums;

/* What differs in a port, and of that what is decided. */
static void count(sums *r, port *p, const u64 *map, const u32 *margin, u64 n)
{
	memset(p->map, 0xff, n * sizeof *p->map);
	visit(p, 0, 0);
	for (u64 i = 0; i < n; i++) {
		bool undecided = margin[i] != TS_NONE && ts_u2f(margin[i]) <= 1, differs = (u32)map[i] != (u32)p->map[i];
		r->shown += map[i] != TS_EMPTY;
		r->undecided += undecided;
		r->differ += differs;
		r->wrong += differs && !undecided;
	}
}

static ts_scene *scene;

static void check(sums *r, const faults *how, u32 n_px, u32 choice)
{
	grove g;
	ts_run run;
	ts_params params = small_params(64, 64);
	params.reflectors_count = 0;
	params.view_map_px = n_px;
	params.view_map_field = choice == 1;
	params.view_map_multipixel = choice == 2;
	params.view_map_touching = choice == 1;
	grove_plant(&g, 5, 5, 20000, grove_surface, 120, grove_surface);
	grove_begin(&run, scene, &params, 2, &g);
	grove_stage(&run, "view_map");
	grove_stage(&run, "view_map.margin");
	u64 n = ts_frame_n(&run.frame, TS_B_view_map_depth_node);
	port p = {.g = &g, .params = params, .faults = *how, .map = malloc(n * sizeof *p.map)};
	assert_non_null(p.map);
	for (p.number = 0; p.number < N_PORTS; p.number++) {
		count(r, &p, ts_frame_data(&run.frame, TS_B_view_map_depth_node),
		      ts_frame_data(&run.frame, TS_B_view_map_margin), n);
	}
	free(p.map);
	ts_run_end(&run);
	grove_free(&g);
}

static int open_scene(void **state)
{
	(void)state;
	ts_params params = small_params(64, 64);
	params.reflectors_count = 0;
	scene = small_scene(&params);
	return 0;
}

static int close_scene(void **state)
{
	(void)state;
	ts_scene_free(scene);
	return 0;
}

static void test_rounding(void **state)
{
	(void)state;
	for (u32 choice = 0; choice < 3; choice++) {
		sums r = {0, 0, 0, 0};
		for (u32 px = 8; px <= 32; px *= 2) check(&r, &(faults){1, 1, 1}, px, choice);
		print_message("of %u texels %u undecided, %u differ, %u of these decided\n", (unsigned)r.shown,
		              (unsigned)r.undecided, (unsigned)r.differ, (unsigned)r.wrong);
		assert_true(r.wrong == 0 && r.differ > 100 && r.undecided < r.shown / 6);
	}
}

static void test_faults(void **state)
{
	(void)state;
	static const faults all[] = {{5000, 1, 1}, {1, 1.01, 1}, {1, 1, 1.2}};
	for (u32 i = 0; i < sizeof all / sizeof *all; i++) {
		sums r = {0, 0, 0, 0};
		check(&r, &all[i], 16, 0);
		if (r.wrong == 0) fail_msg("fault %u is not found", (unsigned)i);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup(test_rounding, grove_restart),
		cmocka_unit_test_setup(test_faults, grove_restart),
	};
	return cmocka_run_group_tests(tests, open_scene, close_scene);
}
