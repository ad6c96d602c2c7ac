/* The margins of depth maps against rasterizers and receivers that decide otherwise: in double precision without
 * snapping, with corners cut off at 1/256 texel, and with everything up to one step away. Whatever they change is
 * undecided, and most is decided. The figures themselves where they can be told. */
#include "kernels/raster/depth_map.h"
#include "kernels/raster/margin.h"
#include "kernels/raster/shadow_test_margin.h"
#include "tests/kernels/points/views.h"

enum { SIZE = 64, N_TEXELS = SIZE * SIZE, N_MESHES = 200, N_TRIANGLES = 24, N_RECEIVERS = 1000, N_STEPS = 12 };

static u32 depths[N_TEXELS];
static u64 keys[N_TEXELS], margin[N_TEXELS * 2];

static f32 figure(u64 bits) { return bits == TS_EMPTY ? INFINITY : ts_u2f((u32)bits); }
static bool is_decided(const u64 of[2]) { return figure(of[0]) > 1 && figure(of[1]) > 1; }

static ts_offscreen random_view(u32 orthographic)
{
	return view_from(uniform3(-1, 1), unit3(), orthographic != 0 ? 2 : uniform(0.3f, 1), SIZE, 0.0078125f,
	                 orthographic);
}

/* The point of the view at a place of its image. */
static ts_v3 point_at(const ts_offscreen *view, double x, double y, double z)
{
	d3_ray ray = view_ray(view, x, y);
	d3 p = d3_mad(ray.from, ray.way, z);
	return ts_v3_make((f32)p.x, (f32)p.y, (f32)p.z);
}

static ts_v3 random_point(const ts_offscreen *view)
{
	double x = uniform(-16, SIZE + 16), y = uniform(-16, SIZE + 16);
	return point_at(view, x, y, uniform(1, 3));
}

static void draw(const mesh *m, const ts_offscreen *view)
{
	ts_arrays scene = mesh_arrays(m);
	ts_depth_map_args drawn = {.scene = scene, .views = view, .depths = depths, .n_views = 1};
	ts_margin_args args = {.scene = scene, .views = view, .depths = depths, .margin = margin, .n_units = 1};
	ts_camera_k camera = ts_k_offscreen(view);
	const ts_band whole = ts_k_band(0, 0);
	ts_target target = ts_k_keys(keys);
	memset(depths, 0xff, sizeof depths);
	memset(keys, 0xff, sizeof keys);
	memset(margin, 0xff, sizeof margin);
	for (u32 t = 0; t < m->n_triangles; t++) {
		ts_corners corners = ts_k_corners(&scene, t);
		ts_k_depth_map_item(&drawn, t);
		ts_k_draw(&scene, &camera, &corners, t, &whole, &target);
	}
	for (u32 t = 0; t < m->n_triangles; t++) ts_k_depth_map_margin_item(&args, t);
	for (u32 k = 0; k < N_TEXELS; k++) assert_int_equal(depths[k], keys[k] >> 32);
}

/* A triangle in the image. */
typedef struct {
	d3_place corner[3];
} shown;

static shown show(const mesh *m, u32 t, const ts_offscreen *view, bool truncates)
{
	shown r;
	for (u32 k = 0; k < 3; k++) {
		r.corner[k] = view_place(view, d3_load(m->vertices[t * 3 + k].position));
		if (!truncates) continue;
		r.corner[k].x = floor(r.corner[k].x * 256) / 256;
		r.corner[k].y = floor(r.corner[k].y * 256) / 256;
	}
	return r;
}

/* Axial depth of its plane at a place of the image; *covers: it is there. */
static double depth_at(const shown *t, bool orthographic, double x, double y, bool *covers)
{
	double weight[3], area = 0, sum = 0;
	for (u32 k = 0; k < 3; k++) {
		const d3_place *a = &t->corner[(k + 1) % 3], *b = &t->corner[(k + 2) % 3];
		weight[k] = (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
		area += weight[k];
	}
	*covers = area != 0;
	for (u32 k = 0; k < 3; k++) {
		*covers = *covers && weight[k] / area > 0;
		sum += weight[k] / area * (orthographic ? t->corner[k].z : 1 / t->corner[k].z);
	}
	return orthographic ? sum : 1 / sum;
}

/* What a step along both axes changes in that depth. */
static double step_of(const shown *t, bool orthographic, double x, double y)
{
	bool covers;
	double z = depth_at(t, orthographic, x, y, &covers), step = 1.0 / 256;
	return fabs(depth_at(t, orthographic, x + step, y, &covers) - z) +
	       fabs(depth_at(t, orthographic, x, y + step, &covers) - z);
}

/* The depth that another rasterizer finds; infinite where there is nothing. */
static double other_depth(const shown *t, u32 n, bool orthographic, double x, double y)
{
	double least = INFINITY;
	for (u32 i = 0; i < n; i++) {
		bool covers;
		double z = depth_at(&t[i], orthographic, x, y, &covers);
		if (covers && z < least) least = z;
	}
	return least;
}

/* The texel's own surface, no more than two steps away. */
static bool is_same(const shown *exact, u32 k, bool orthographic, double z)
{
	double x = k % SIZE + 0.5, y = k / SIZE + 0.5, held = ts_u2f(depths[k]);
	if (depths[k] == TS_NONE || isinf(z)) return depths[k] == TS_NONE && isinf(z);
	return fabs(z - held) <= 2 * step_of(&exact[(u32)keys[k]], orthographic, x, y) + held * 1e-6;
}

static void depths_that_differ_are_undecided(void **state)
{
	(void)state;
	u32 n_different[2] = {0}, n_undecided = 0, n_drawn = 0;
	n_random = 0;
	for (u32 i = 0; i < N_MESHES; i++) {
		mesh m;
		shown exact[N_TRIANGLES], other[N_TRIANGLES];
		u32 orthographic = i & 1, truncates = i >> 1 & 1;
		ts_offscreen view = random_view(orthographic);
		mesh_begin(&m);
		for (u32 t = 0; t < N_TRIANGLES; t++) {
			ts_v3 a = random_point(&view), b = random_point(&view);
			mesh_triangle(&m, a, b, random_point(&view), 1, 0);
			exact[t] = show(&m, t, &view, false);
			other[t] = show(&m, t, &view, truncates != 0);
		}
		draw(&m, &view);
		for (u32 k = 0; k < N_TEXELS; k++) {
			double z = other_depth(other, N_TRIANGLES, orthographic, k % SIZE + 0.5, k / SIZE + 0.5);
			bool same = is_same(exact, k, orthographic, z);
			if (!same && is_decided(&margin[k * 2])) {
				fail_msg("mesh %u, texel %u: %g for %g is decided by %g and %g", i, k, z, ts_u2f(depths[k]),
				         figure(margin[k * 2]), figure(margin[k * 2 + 1]));
			}
			n_different[truncates] += !same;
			n_undecided += !is_decided(&margin[k * 2]);
			n_drawn += depths[k] != TS_NONE;
		}
	}
	assert_true(n_different[0] > 25 && n_different[1] > 50);
	assert_true(n_drawn > N_MESHES * N_TEXELS / 2 && n_undecided < n_drawn / 100);
}

/* A flat triangle and a slanted one behind it, by an orthographic view of 16 texels a unit. */
static void margins_are_the_figures_of_two_triangles(void **state)
{
	(void)state;
	mesh m;
	ts_offscreen view = {.right = {1, 0, 0},
	                     .up = {0, 1, 0},
	                     .back = {0, 0, 1},
	                     .width = SIZE,
	                     .height = SIZE,
	                     .focal = 16,
	                     .near = 0.5f,
	                     .reach = {2, 2},
	                     .orthographic = 1,
	                     .object = TS_NONE};
	mesh_begin(&m);
	mesh_triangle(&m, ts_v3_make(-1, -1, -2), ts_v3_make(31, -1, -2), ts_v3_make(-1, 31, -2), 1, 0);
	mesh_triangle(&m, ts_v3_make(-8, -8, -1.9f), ts_v3_make(24, -8, -2.3f), ts_v3_make(-8, 24, -1.9f), 1, 0);
	draw(&m, &view);
	for (u32 j = 0; j < 48; j++) {
		for (u32 i = 16; i < SIZE; i++) {
			u32 k = j * SIZE + i;
			double x = (i + 0.5 - 32) / 16, z = 1.9 + 0.0125 * (x + 8), step = 2 * 0.0125 / 16 / 256;
			double behind = (z - 2) / (step + z * 0x1p-20);
			if (z < 2.01 || z > 2.03) continue;
			assert_true(fabs(figure(margin[k * 2 + 1]) - behind) < 0.01 * behind);
			assert_true(figure(margin[k * 2]) == (f32)(fmin(i - 15.5, 47.5 - j) * 256));
		}
	}
	u32 aside = 50 * SIZE + 15;
	assert_true(figure(margin[aside * 2]) >= 128 && figure(margin[aside * 2 + 1]) == INFINITY);
}

/* A point of a triangle's plane, or, `near`, one about as deep as what the map shows and the bias. */
static ts_receiver random_receiver(const mesh *m, const ts_offscreen *view, const ts_shadow_test_args *args, bool near)
{
	ts_camera_k camera = ts_k_offscreen(view);
	const ts_vertex *corner = &m->vertices[random_bits() % m->n_triangles * 3];
	d3 a = d3_load(corner[0].position), b = d3_load(corner[1].position), c = d3_load(corner[2].position);
	double x = uniform(-1, SIZE + 1), y = uniform(-1, SIZE + 1), weight[3];
	d3_ray ray = view_ray(view, x, y);
	double z = ray_meets(&ray, a, b, c, weight);
	bool in = x > 0 && y > 0 && x < SIZE && y < SIZE;
	u32 held = in ? depths[(u32)y * SIZE + (u32)x] : TS_NONE;
	d3 n = d3_unit(d3_cross(d3_sub(b, a), d3_sub(c, a)));
	ts_receiver r = {.n = {(f32)n.x, (f32)n.y, (f32)n.z}, .seen = true};
	r.p = point_at(view, x, y, held != TS_NONE && near ? ts_u2f(held) : z);
	if (held == TS_NONE || !near) return r;
	double bias = ts_k_shadow_bias(args, &camera, &r, ts_u2f(held));
	r.p = point_at(view, x, y, ts_u2f(held) + bias * uniform(0.9f, 1.1f));
	return r;
}

/* What a port may answer that has the receiver up to a step of the eye aside, `pixel` world units wide on the surface,
 * the map a step of its own, and depths that went with the surface. */
static bool other_reaches(const ts_shadow_test_args *args, const ts_offscreen *view, const ts_receiver *at,
                          double pixel, double z, double slope)
{
	ts_shadow_test_args other = *args;
	ts_offscreen aside = *view;
	ts_receiver there = *at;
	double width = (view->orthographic != 0 ? 1 : z) / view->focal, step = 1.0 / 256;
	d3 n = d3_of(at->n), on = d3_unit(d3_cross(n, d3_of(unit3()))), eye = d3_load(view->eye);
	eye = d3_mad(eye, d3_load(view->right), uniform(-0.99f, 0.99f) * width * step);
	eye = d3_mad(eye, d3_load(view->up), uniform(-0.99f, 0.99f) * width * step);
	d3 p = d3_mad(d3_of(at->p), on, uniform(0, 0.99f) * pixel * step);
	aside.eye[0] = (f32)eye.x;
	aside.eye[1] = (f32)eye.y;
	aside.eye[2] = (f32)eye.z;
	there.p = ts_v3_make((f32)p.x, (f32)p.y, (f32)p.z);
	other.bias += (f32)(uniform(-1.4f, 1.4f) * slope * step / width);
	return ts_k_reaches(&other, &aside, &there, 0);
}

typedef struct {
	u32 n, n_different, n_edges, n_undecided;
} tally;

static void try_receiver(const ts_shadow_test_args *args, const ts_offscreen *view, const ts_receiver *at, tally *tried)
{
	u64 of[2] = {TS_EMPTY, TS_EMPTY};
	ts_camera_k camera = ts_k_offscreen(view);
	ts_shadow_test_args slope = {.slope = 1};
	d3 way = d3_sub(d3_load(view->eye), d3_of(at->p));
	double z = view_place(view, d3_of(at->p)).z, width = (view->orthographic != 0 ? 1 : z) / view->focal;
	double pixel = uniform(0, 2) * width;
	d3 ahead = view->orthographic != 0 ? d3_load(view->back) : d3_unit(way);
	if (!(z > 0.25 && z < 8) || fabs(d3_dot(ahead, d3_of(at->n))) < 0.1) return;
	ts_k_reach_margin(args, view, at, (f32)pixel, 0, of);
	bool reaches = ts_k_reaches(args, view, at, 0), differs = false;
	double deeper = ts_k_shadow_bias(&slope, &camera, at, (f32)z);
	for (u32 k = 0; k < N_STEPS; k++) differs |= other_reaches(args, view, at, pixel, z, deeper) != reaches;
	if (differs && is_decided(of)) fail_msg("decided by %g and %g", figure(of[0]), figure(of[1]));
	tried->n++;
	tried->n_different += differs;
	tried->n_edges += differs && figure(of[1]) > 1;
	tried->n_undecided += !is_decided(of);
}

static void receivers_that_differ_are_undecided(void **state)
{
	(void)state;
	tally tried[2] = {{0}};
	n_random = 0;
	for (u32 i = 0; i < N_MESHES; i++) {
		mesh m;
		ts_offscreen view = random_view(i & 1);
		ts_shadow_test_args args = {.depths = depths, .views = &view, .bias = 1, .slope = 1.5f};
		mesh_begin(&m);
		for (u32 t = 0; t < 6; t++) {
			ts_v3 a = random_point(&view), b = random_point(&view);
			mesh_triangle(&m, a, b, random_point(&view), 1, 0);
		}
		draw(&m, &view);
		for (u32 k = 0; k < N_RECEIVERS; k++) {
			ts_receiver at = random_receiver(&m, &view, &args, (k & 1) != 0);
			try_receiver(&args, &view, &at, &tried[k & 1]);
		}
	}
	assert_true(tried[0].n > N_MESHES * N_RECEIVERS / 4 && tried[0].n_undecided < tried[0].n / 100);
	assert_true(tried[1].n > N_MESHES * N_RECEIVERS / 4 && tried[1].n_undecided < tried[1].n / 10);
	assert_true(tried[1].n_different > 500 && tried[0].n_edges + tried[1].n_edges > 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(depths_that_differ_are_undecided),
		cmocka_unit_test(margins_are_the_figures_of_two_triangles),
		cmocka_unit_test(receivers_that_differ_are_undecided),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
