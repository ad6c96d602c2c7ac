/* The margins of surfels against ports that round otherwise: rays in double precision, in which every number is off
 * by some ulps, each its own way. Pixels that show another nearest surfel or blend others are undecided; few are;
 * and a port whose thresholds are off by more than rounding differs in pixels that are decided. */
#include "kernels/surfels/surfel_margin.h"
#include "kernels/surfels/surfel_setup.h"
#include "methods/stages.h"
#include "methods/surfels/surfel.h"
#include "tests/methods/surfels/surfels.h"

enum { N_PORTS = 3, WIDTH = 96, HEIGHT = 64, N_PIXELS = WIDTH * HEIGHT };

/* How its thresholds are off: r3D squared, r2D squared and exact EWA, epsilon, and what turns its back. */
typedef struct {
	double rim, flat, eps, turned;
} faults;
static const faults none = {1, 1, 1, 0};

typedef struct {
	const ts_run *run;
	faults faults;
	u32 number; /* which way its numbers are off */
	bool ewa;
} port;

/* From -1 to 1, the same for the same. */
static double noise(const port *p, u32 what) { return ts_uniform(ts_random(what, 3, p->number)) * 2 - 1; }

/* Off by up to 4 ulps, and by so much of a number that it came from. */
static double off(const port *p, double x) { return x * (1 + noise(p, ts_f2u((f32)x)) / 2097152); }
static double off_of(const port *p, double x, double of) { return x + of * noise(p, ts_f2u((f32)x)) / 2097152; }

static double length(d3 a) { return sqrt(d3_dot(a, a)); }

/* In the port's view space: X, Y and the depth. */
static d3 to_view(const port *p, const ts_view *view, d3 a, double of)
{
	return (d3){off_of(p, d3_dot(a, d3_of(view->right)), of), off_of(p, d3_dot(a, d3_of(view->up)), of),
	            off_of(p, -d3_dot(a, d3_of(view->back)), of)};
}

/* A surfel as the port has it; and what exact EWA has of it. */
typedef struct {
	d3 c, u, v, n;
	double x, y, radius, xx, xy, yy, peak;
	bool drawn, ahead, flat;
} splat;

static void blur(const port *p, splat *s, const ts_filter *filter, double f)
{
	double z2 = s->c.z * s->c.z, object2 = filter->object2, screen2 = filter->screen2;
	double xa = f * (s->u.x * s->c.z - s->c.x * s->u.z) / z2, xb = f * (s->v.x * s->c.z - s->c.x * s->v.z) / z2;
	double ya = -f * (s->u.y * s->c.z - s->c.y * s->u.z) / z2, yb = -f * (s->v.y * s->c.z - s->c.y * s->v.z) / z2;
	double xx = off(p, object2 * (xa * xa + xb * xb) + screen2), xy = object2 * (xa * ya + xb * yb);
	double yy = off(p, object2 * (ya * ya + yb * yb) + screen2), det = xx * yy - xy * xy;
	s->xx = yy / det;
	s->xy = -xy / det;
	s->yy = xx / det;
	s->peak = fmin(off(p, object2 * fabs(xa * yb - xb * ya) / sqrt(det)), 1);
	s->drawn = s->drawn && (s->u.z * s->u.z + s->v.z * s->v.z) / z2 * fmax(4 * object2, 1) < 1;
}

static splat splat_of(const port *p, const ts_surfel *surfel, const ts_filter *filter)
{
	const ts_view *view = ts_frame_data(&p->run->frame, TS_B_eye_view);
	d3 u = d3_of(surfel->u), v = d3_of(surfel->v), from = d3_sub(d3_of(surfel->centre), d3_of(view->eye)),
	   n = d3_cross(u, v);
	splat s = {.radius = fmax(length(u), length(v))};
	double slant = off(p, -d3_dot(n, from) / (length(n) * length(from))), f = view->focal;
	s.c = to_view(p, view, from, length(from));
	s.u = to_view(p, view, u, length(u));
	s.v = to_view(p, view, v, length(v));
	s.n = d3_cross(s.u, s.v);
	s.x = view->width / 2.0 + f * s.c.x / s.c.z;
	s.y = view->height / 2.0 - f * s.c.y / s.c.z;
	s.ahead = s.c.z >= (double)view->near;
	bool crosses = filter->filter < TS_FILTER_SCREEN && s.c.z + hypot(s.u.z, s.v.z) >= (double)view->near;
	s.drawn = slant > p->faults.turned && (s.ahead || crosses);
	s.flat = slant < 1e-6;
	if (p->ewa && s.drawn) blur(p, &s, filter, f);
	return s;
}

/* It at a pixel. */
typedef struct {
	double r2, flat, z, weight;
	bool inside, covers;
} hit;

static hit hit_at(const port *p, const splat *s, const ts_filter *filter, u32 x, u32 y)
{
	const ts_view *view = ts_frame_data(&p->run->frame, TS_B_eye_view);
	double f = view->focal, dx = x + 0.5 - s->x, dy = y + 0.5 - s->y;
	d3 way = {(x + 0.5 - view->width / 2.0) / f, (view->height / 2.0 - y - 0.5) / f, 1};
	hit h = {.z = off(p, d3_dot(s->c, s->n) / d3_dot(way, s->n))};
	d3 d = {way.x * h.z - s->c.x, way.y * h.z - s->c.y, h.z - s->c.z};
	double a = d3_dot(d, s->u) / d3_dot(s->u, s->u), b = d3_dot(d, s->v) / d3_dot(s->v, s->v);
	h.r2 = off(p, a * a + b * b);
	h.inside = !s->flat && h.z >= (double)view->near && h.r2 <= p->faults.rim;
	h.z = h.inside ? h.z : s->c.z;
	h.flat = off(p, (dx * dx + dy * dy) * (double)filter->per_sigma2);
	if (p->ewa) {
		double q = off(p, s->xx * dx * dx + 2 * s->xy * dx * dy + s->yy * dy * dy);
		h.covers = q <= 4 * p->faults.flat && s->peak > 0;
		h.weight = s->peak * exp(-0.5 * q);
		return h;
	}
	bool object = h.inside && filter->filter != TS_FILTER_SCREEN;
	bool screen = s->ahead && filter->per_sigma2 > 0 && filter->filter != TS_FILTER_OBJECT && h.flat <= p->faults.flat;
	h.covers = object || screen;
	h.weight = exp(-(double)filter->fall * (object && screen ? fmin(h.r2, h.flat) : object ? h.r2 : h.flat));
	return h;
}

/* What the port has at a pixel. */
typedef struct {
	double nearest, heaviest;
	u32 surfel, heavy;
	u64 fragments;
} pixel_sums;

/* Rows or columns that a splat may cover, and some more. */
static void reach(const splat *s, double f, double place, u32 n, u32 *from, u32 *to)
{
	bool near = s->c.z < 1.5 * s->radius;
	double room = near ? n : f * s->radius / (s->c.z - s->radius) * 1.5 + 6;
	*from = (u32)fmin(fmax(place - room, 0), n);
	*to = near ? n : (u32)fmin(fmax(place + room + 1, 0), n);
}

static bool is_in_box(const ts_disc *disc, i32 x, i32 y)
{
	return x >= disc->low[0] && x <= disc->high[0] && y >= disc->low[1] && y <= disc->high[1];
}

static void add(const port *p, pixel_sums *pixels, u32 i, const ts_filter *filter)
{
	const ts_frame *frame = &p->run->frame;
	const ts_view *view = ts_frame_data(frame, TS_B_eye_view);
	const u64 *keys = ts_frame_data(frame, TS_B_surfel_depth_surfel);
	splat s = splat_of(p, (const ts_surfel *)ts_frame_data(frame, TS_B_scene_surfel) + i, filter);
	u32 x0, x1, y0, y1;
	if (!s.drawn) return;
	reach(&s, view->focal, s.x, WIDTH, &x0, &x1);
	reach(&s, view->focal, s.y, HEIGHT, &y0, &y1);
	const ts_disc *disc = (const ts_disc *)ts_frame_data(frame, TS_B_surfel_setup_disc) + i;
	double eps = *(const f32 *)ts_frame_data(frame, TS_B_surfel_setup_epsilon), f = view->focal;
	for (u32 k = 0; k < (y1 - y0) * (x1 - x0); k++) {
		u32 x = x0 + k % (x1 - x0), y = y0 + k / (x1 - x0), pixel = y * WIDTH + x;
		pixel_sums *sums = &pixels[pixel];
		if (p->ewa && !is_in_box(disc, (i32)x, (i32)y)) continue; /* boxes cut it off */
		hit h = hit_at(p, &s, filter, x, y);
		double way = hypot(1, hypot((x + 0.5 - WIDTH / 2.0) / f, (y + 0.5 - HEIGHT / 2.0) / f));
		double limit = (double)ts_u2f((u32)(keys[pixel] >> 32)) + (p->faults.eps - 1) * eps / way;
		if (h.inside && h.z < sums->nearest) {
			sums->nearest = h.z;
			sums->surfel = i;
		}
		if (!h.covers || (keys[pixel] == TS_EMPTY ? filter->opens == 0 : h.z > limit)) continue;
		sums->fragments++;
		if (h.weight <= sums->heaviest) continue;
		sums->heaviest = h.weight;
		sums->heavy = i;
	}
}

typedef struct {
	u64 n, undecided[2], differ[2], wrong[2];
} sums;

static bool is_undecided(const u64 *margin, u32 n)
{
	bool undecided = false;
	for (u32 k = 0; k < n; k++) undecided = undecided || (margin[k] != TS_EMPTY && ts_u2f((u32)margin[k]) <= 1);
	return undecided;
}

static void note(sums *r, u32 k, bool differs, bool undecided)
{
	r->undecided[k] += undecided;
	r->differ[k] += differs;
	r->wrong[k] += differs && !undecided;
}

/* Pixels in which the port differs from the run: [0] of what is nearest, [1] of what is blended. */
static void count(sums *r, const port *p)
{
	static pixel_sums pixels[N_PIXELS];
	const ts_frame *frame = &p->run->frame;
	const u64 *keys = ts_frame_data(frame, TS_B_surfel_depth_surfel);
	const u64 *heaviest = ts_frame_data(frame, TS_B_surfel_blend_heaviest);
	const u64 *blended = ts_frame_data(frame, TS_B_surfel_blend_sum),
			  *depths = ts_frame_data(frame, TS_B_surfel_depth_margin);
	const u64 *blends = ts_frame_data(frame, TS_B_surfel_blend_margin);
	ts_filter filter = ts_surfel_filter(p->run);
	for (u32 i = 0; i < N_PIXELS; i++) pixels[i] = (pixel_sums){.nearest = 1e30, .surfel = TS_NONE, .heavy = TS_NONE};
	for (u32 i = 0; i < ts_frame_n(frame, TS_B_scene_surfel); i++) add(p, pixels, i, &filter);
	for (u32 i = 0; i < N_PIXELS; i++) {
		if (keys[i] == TS_EMPTY && pixels[i].surfel == TS_NONE && pixels[i].fragments + blended[i * 8 + 7] == 0)
			continue;
		r->n++;
		note(r, 0, pixels[i].surfel != (u32)keys[i], is_undecided(&depths[i * 2], 2));
		bool other = pixels[i].fragments != blended[i * 8 + 7] || pixels[i].heavy != (u32)heaviest[i];
		note(r, 1, other, is_undecided(&blends[i * 2], 2));
	}
}

static void check(sums *r, const ts_scene *scene, const ts_params *params, const faults *how, const char *method)
{
	ts_run run;
	ts_run_begin(&run, scene, params, 2);
	run.traced = run.margins = true;
	if (ts_pipeline_run(ts_pipeline_find("surfels", method), &run) != TS_OK) fail_msg("%s", ts_error_message());
	for (u32 k = 0; k < N_PORTS; k++) count(r, &(port){&run, *how, k, strcmp(method, "ewa") == 0});
	ts_run_end(&run);
}

/* Surfels before an eye in the origin that looks along -z: of each three one has a pixel's middle on its rim, one
 * has it sigma from its centre, and one is seen from the side. */
static ts_scene *ties(const ts_params *params, u32 n)
{
	ts_build *build = ts_build_new("ties");
	const double f = HEIGHT; /* see yfov */
	surfels_random = 0;
	for (u32 i = 0; i < n; i++) {
		double z = 2 + 6 * (double)surfels_uniform(), x = floor((double)surfels_uniform() * WIDTH) + 0.5 - WIDTH / 2;
		double y = floor((double)surfels_uniform() * HEIGHT) + 0.5 - HEIGHT / 2;
		double turn = 6.2831853 * (double)surfels_uniform();
		d3 n3 = {(double)surfels_uniform() - 0.5, (double)surfels_uniform() - 0.5, 0.6};
		d3 at = {(x + (i % 3 == 1 ? cos(turn) : 0)) * z / f, (y + (i % 3 == 1 ? sin(turn) : 0)) * z / f, -z}, c = at;
		double radius = z / f * (1 + 5 * (double)surfels_uniform()), r = length(n3);
		if (i % 3 == 2) n3 = d3_cross(n3, at), r = length(n3);
		ts_v3 unit = ts_v3_make((f32)(n3.x / r), (f32)(n3.y / r), (f32)(n3.z / r));
		ts_v3 u = ts_normalize(ts_cross(ts_v3_make(0, 1, 0), unit));
		if (i % 3 == 0) c = (d3){at.x + radius * (double)u.x, at.y + radius * (double)u.y, at.z + radius * (double)u.z};
		surfels_add(build, ts_v3_make((f32)c.x, (f32)c.y, (f32)c.z), unit, (f32)radius, 0.5f,
		            ts_v3_make(0.5f, 0.5f, 0.5f));
	}
	return surfels_finish(build, params, ts_v3_make(0, 0, 0), 0.14758362f); /* 2 atan(1/2) */
}

static ts_params margin_params(u32 filter)
{
	ts_params params = small_params(WIDTH, HEIGHT);
	params.reflectors_count = 0;
	params.surfel_depth_epsilon = 0.05f;
	params.ewa_filter = filter;
	return params;
}

static const struct {
	const char *method;
	u32 filter;
} methods[] = {
	{"deferred", TS_FILTER_MIN},
	{"deferred", TS_FILTER_OBJECT},
	{"deferred", TS_FILTER_SCREEN},
	{"ewa", TS_FILTER_MIN},
};

static void show(const sums *r, const char *method, const char *what)
{
	for (u32 k = 0; k < 2; k++) {
		print_message("# %s, %s, %s: of %u pixels %u undecided, %u differ, %u of these decided\n", method, what,
		              k == 0 ? "nearest" : "blended", (unsigned)r->n, (unsigned)r->undecided[k], (unsigned)r->differ[k],
		              (unsigned)r->wrong[k]);
	}
}

/* Surfels of a plane are all nearest. */
static void rounding_differs_only_where_undecided(void **state)
{
	(void)state;
	for (u32 m = 0; m < sizeof methods / sizeof *methods; m++) {
		sums r = {.n = 0}, t = {.n = 0};
		ts_params params = margin_params(methods[m].filter);
		ts_scene *balls = surfels_balls(&params, 3000), *tied = ties(&params, 3000);
		params.surfels_from_mesh = 6000;
		ts_scene *room = small_scene(&params);
		check(&r, balls, &params, &none, methods[m].method);
		check(&r, room, &params, &none, methods[m].method);
		check(&t, tied, &params, &none, methods[m].method);
		show(&r, methods[m].method, "balls and a room");
		show(&t, methods[m].method, "ties");
		for (u32 k = 0; k < 2; k++) assert_true(r.wrong[k] == 0 && t.wrong[k] == 0 && t.differ[k] > 200);
		assert_true(r.undecided[0] < r.n / 4 && r.undecided[1] < r.n / 100 && t.undecided[1] < t.n / 4);
		ts_scene_free(tied);
		ts_scene_free(balls);
		ts_scene_free(room);
	}
}

static void wrong_thresholds_differ_where_decided(void **state)
{
	(void)state;
	static const struct {
		const char *method;
		faults faults;
		bool nearest;
	} all[] = {
		{"deferred", {1.0201, 1, 1, 0}, true}, {"deferred", {1, 1.0201, 1, 0}, false},
		{"deferred", {1, 1, 2, 0}, false},     {"deferred", {1, 1, 1, 0.1}, true},
		{"ewa", {1, 1.0201, 1, 0}, false},     {"ewa", {1, 1, 0.5, 0}, false},
	};
	ts_params params = margin_params(TS_FILTER_MIN);
	ts_scene *balls = surfels_balls(&params, 3000);
	for (u32 i = 0; i < sizeof all / sizeof *all; i++) {
		sums r = {.n = 0};
		check(&r, balls, &params, &all[i].faults, all[i].method);
		if (r.wrong[1] < 20 || (all[i].nearest && r.wrong[0] < 5)) fail_msg("fault %u is not found", (unsigned)i);
	}
	ts_scene_free(balls);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(rounding_differs_only_where_undecided),
	                                   cmocka_unit_test(wrong_thresholds_differ_where_decided)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
