/* Percentage-closer soft shadows: the taps, and worlds of a floor and a half plane above it, in which PCSS is what a
 * disc of light does: the share of the disc that is seen past a straight edge. */
#include <stdlib.h>
#include "kernels/points/pcss.h"
#include "tests/kernels/seeded.h"

#define PI 3.14159265358979323846

enum { SIDE = 384, N_WORLDS = 40, N_RECEIVERS = 60 };

/* A floor seen from a light above it, along -back; a half plane at a height above the floor covers x < edge. Depths are
 * from the light; x is along the view's right. */
typedef struct {
	ts_offscreen view;
	ts_lamp lamp;
	double floor, blocker, edge; /* depths; x; blocker 0: none */
	double slope;                /* of the floor's depth along x */
	u32 depths[SIDE * SIDE];
} world;

static void random_axes(ts_offscreen *view)
{
	ts_v3 back = direction(), other = direction();
	ts_v3 right = ts_normalize(ts_cross(other, back));
	ts_store3(view->back, back);
	ts_store3(view->right, right);
	ts_store3(view->up, ts_cross(back, right));
	ts_store3(view->eye, uniform3(-3, 3));
}

static void random_world(world *w, bool parallel)
{
	memset(w, 0, sizeof *w);
	random_axes(&w->view);
	w->view.width = w->view.height = SIDE;
	w->view.near = 0.0009765625f;
	w->view.orthographic = parallel;
	w->floor = uniform(2, 8);
	w->view.focal = parallel ? uniform(60, 90) : uniform(300, 500);
	w->lamp.radius = parallel ? uniform(0.05f, 0.2f) : uniform(0.1f, 0.3f);
	w->blocker = w->floor * uniform(0.55f, 0.9f);
	w->edge = uniform(-0.2f, 0.2f);
}

/* Depth at which the light's ray through a texel meets the floor: z = floor + slope x. */
static double floor_depth(const world *w, double x)
{
	bool parallel = w->view.orthographic != 0;
	return parallel ? w->floor + w->slope * x : w->floor / (1 - w->slope * x);
}

static void fill(world *w)
{
	for (u32 i = 0; i < SIDE * SIDE; i++) {
		double across = (i % SIDE + 0.5 - SIDE / 2.0) / w->view.focal; /* parallel: x; else x of depth 1 */
		double at_blocker = w->view.orthographic != 0 ? across : across * w->blocker;
		bool blocked = w->blocker > 0 && at_blocker < w->edge;
		w->depths[i] = ts_f2u((f32)(blocked ? w->blocker : floor_depth(w, across)));
	}
}

static ts_receiver receiver(const world *w, double x, double y)
{
	double z = w->floor + w->slope * x;
	ts_v3 right = ts_load3(w->view.right), up = ts_load3(w->view.up), back = ts_load3(w->view.back);
	ts_receiver r = {.seen = true};
	ts_v3 across = ts_mad(ts_mad(ts_load3(w->view.eye), right, (f32)x), up, (f32)y);
	r.p = ts_mad(across, back, (f32)-z);
	r.n = ts_normalize(ts_mad(back, right, (f32)w->slope));
	return r;
}

static u32 lit(const world *w, ts_receiver at, f32 bias, f32 slope)
{
	ts_pcss_args args = {
		.of = {.views = &w->view, .depths = w->depths, .n_views = 1, .n_lamps = 1, .bias = bias, .slope = slope},
		.lamps = &w->lamp,
		.near = 0.5f};
	return ts_k_pcss(&args, &w->view, &at);
}

/* The share of the unit disc where x > -t. */
static double share(double t)
{
	if (t >= 1 || t <= -1) return t > 0;
	return 0.5 + (t * sqrt(1 - t * t) + asin(t)) / PI;
}

/* Half the width of the penumbra on the floor, and where the middle of the light has its shadow's border. */
static double penumbra(const world *w)
{
	double above = w->floor - w->blocker;
	return w->lamp.radius * (w->view.orthographic != 0 ? above : above / w->blocker);
}

static double border(const world *w) { return w->view.orthographic != 0 ? w->edge : w->edge * w->floor / w->blocker; }

static double texel(const world *w) { return (w->view.orthographic != 0 ? 1 : w->floor) / w->view.focal; }

/* From shadow to light as the disc comes out behind the edge. */
static void light_grows_as_the_disc_comes_out(void **state)
{
	(void)state;
	static world w;
	double worst = 0, contrast = 0;
	for (u32 i = 0; i < N_WORLDS; i++) {
		random_world(&w, i % 2);
		fill(&w);
		double width = penumbra(&w), rough = texel(&w) / width;
		for (u32 k = 0; k < N_RECEIVERS; k++) {
			double t = uniform(-1.4f, 1.4f);
			double got = lit(&w, receiver(&w, border(&w) + t * width, uniform(-0.3f, 0.3f)), 1, 1.5f) / 64.0;
			if (fabs(t) > 1 + 2 * rough) assert_true(got == (t > 0));
			worst = fmax(worst, fabs(got - share(t)) - rough);
			contrast += fabs(got - 0.5) - fabs(share(t) - 0.5);
		}
	}
	assert_true(worst < 0.04);
	assert_true(fabs(contrast) < 0.005 * N_WORLDS * N_RECEIVERS); /* a twentieth wider or narrower is 0.007 */
}

/* Where thing and shadow touch the border is sharp, whatever the light's size. */
static void shadows_are_sharp_where_they_touch(void **state)
{
	(void)state;
	static world w;
	u32 n_lit = 0;
	for (u32 i = 0; i < N_WORLDS; i++) {
		random_world(&w, i % 2);
		w.blocker = w.floor - 4 * texel(&w);
		fill(&w);
		assert_true(penumbra(&w) < texel(&w) * 1.2);
		for (u32 k = 0; k < N_RECEIVERS; k++) {
			double aside = uniform(2.5f, 20) * texel(&w);
			bool light = bits() % 2;
			u32 got = lit(&w, receiver(&w, border(&w) + (light ? aside : -aside), uniform(-0.3f, 0.3f)), 1, 1.5f);
			assert_int_equal(got, light ? 64 : 0);
			n_lit += light;
		}
	}
	assert_true(n_lit > N_WORLDS * N_RECEIVERS / 4);
}

/* A plane alone is lit all over, however slanted, with a bias of a hundredth of a texel; what stands before it is
 * seen. */
static void a_slanted_plane_alone_is_lit(void **state)
{
	(void)state;
	static world w;
	u32 n_dark = 0;
	for (u32 i = 0; i < N_WORLDS; i++) {
		random_world(&w, i % 2);
		w.slope = uniform(-4, 4) * (w.view.orthographic != 0 ? 0.25 : 1);
		double before = w.blocker;
		w.blocker = 0;
		fill(&w);
		for (u32 k = 0; k < N_RECEIVERS; k++) {
			ts_receiver at = receiver(&w, uniform(-0.2f, 0.2f), uniform(-0.3f, 0.3f));
			assert_int_equal(lit(&w, at, 0.01f, 0), 64);
		}
		w.blocker = before * 0.5;
		w.edge = 100;
		fill(&w);
		n_dark += lit(&w, receiver(&w, 0, 0), 0.01f, 0) == 0;
	}
	assert_int_equal(n_dark, N_WORLDS);
}

/* Nothing is known outside the map and in empty texels: there is light. */
static void outside_the_map_there_is_light(void **state)
{
	(void)state;
	static world w;
	random_world(&w, false);
	w.edge = 100;
	fill(&w);
	assert_int_equal(lit(&w, receiver(&w, 0, 0), 1, 1.5f), 0);
	assert_int_equal(lit(&w, receiver(&w, 40, 0), 1, 1.5f), 64);
	memset(w.depths, 0xff, sizeof w.depths);
	assert_int_equal(lit(&w, receiver(&w, 0, 0), 1, 1.5f), 64);
	w.floor = -1;
	assert_int_equal(lit(&w, receiver(&w, 0, 0), 1, 1.5f), 64);
}

static void a_point_light_has_no_penumbra(void **state)
{
	(void)state;
	static world w;
	for (u32 i = 0; i < N_WORLDS; i++) {
		random_world(&w, i % 2);
		w.lamp.radius = 0;
		fill(&w);
		for (u32 k = 0; k < N_RECEIVERS; k++) {
			double aside = uniform(-20, 20) * texel(&w);
			u32 got = lit(&w, receiver(&w, border(&w) + aside, 0), 1, 1.5f);
			assert_true(got == 0 || got == 64);
			if (fabs(aside) > texel(&w)) assert_int_equal(got, aside > 0 ? 64 : 0);
		}
	}
}

static void assert_sunflower(const i32 tap[][2], u32 n, double most)
{
	double golden = (sqrt(5) - 1) / 2 * 2 * PI;
	for (u32 k = 0; k < n; k++) {
		double r = 128 * sqrt((k + 0.5) / n);
		assert_true(fabs(tap[k][0] - r * cos(golden * k)) <= 0.502 && fabs(tap[k][1] - r * sin(golden * k)) <= 0.502);
	}
	for (u32 angle = 0; angle < 64; angle++) {
		for (double t = -0.9; t < 1; t += 0.1) {
			u32 beyond = 0;
			for (u32 k = 0; k < n; k++) {
				double x = tap[k][0] * cos(angle * PI / 32) + tap[k][1] * sin(angle * PI / 32);
				beyond += x > -128 * t;
			}
			assert_true(fabs((double)beyond / n - share(t)) < most);
		}
	}
}

/* Past an edge of any direction lies nearly the share of the disc that should. */
static void taps_fill_the_disc_evenly(void **state)
{
	(void)state;
	assert_sunflower(ts_pcss_search, TS_N_SEARCH, 0.08);
	assert_sunflower(ts_pcss_filter, TS_N_FILTER, 0.05);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(light_grows_as_the_disc_comes_out), seeded_test(shadows_are_sharp_where_they_touch),
		seeded_test(a_slanted_plane_alone_is_lit),      seeded_test(outside_the_map_there_is_light),
		seeded_test(a_point_light_has_no_penumbra),     seeded_test(taps_fill_the_disc_evenly),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
