/* Rays into the tree: closed forms in a room and around a sphere, the three filters, all triangles tried in double. */
#include <math.h>
#include "tests/model/test.h"
#include "tests/truth/world.h"
#include "truth/tree.h"
#include "truth/truth.h"

enum { SEED = 7, STREAM = 6 };

static u32 n_random;

static f32 uniform(f32 low, f32 high) { return low + (high - low) * ts_uniform(ts_random(n_random++, STREAM, SEED)); }

static ts_v3 uniform3(f32 low, f32 high)
{
	f32 x = uniform(low, high), y = uniform(low, high);
	return ts_v3_make(x, y, uniform(low, high));
}

static ts_v3 uniform_direction(void)
{
	for (;;) {
		ts_v3 d = uniform3(-1, 1);
		f32 l = ts_length(d);
		if (l > 0.1f && l <= 1) return ts_normalize(d);
	}
}

static world *world_new(void)
{
	world *w = malloc(sizeof(*w));
	assert_non_null(w);
	world_begin(w);
	n_random = 0;
	return w;
}

static ts_truth *grow(world *w)
{
	ts_truth *truth;
	world_pose(w);
	if (ts_truth_new(&truth, &w->run) != TS_OK) fail_msg("%s", ts_error_message());
	return truth;
}

static void end(world *w, ts_truth *truth)
{
	ts_truth_free(truth);
	ts_run_end(&w->run);
	free(w);
}

static ts_truth_hit cast(const ts_truth *truth, ts_v3 o, ts_v3 d, f32 near, u32 masked)
{
	ts_truth_query query = {.origin = o, .direction = d, .near = near, .masked = masked, .from = o};
	return ts_truth_cast(truth, &query);
}

/* Two small quads and the room behind them, seen from the origin along +x. */
static u32 first_along_x(const ts_truth *truth, u32 masked)
{
	return cast(truth, ts_v3_make(0, 0, 0), ts_v3_make(1, 0.001f, 0.002f), 0, masked).triangle;
}

static void wall_at(world *w, f32 x, u32 material, u32 object, bool front_to_origin)
{
	ts_v3 a = ts_v3_make(x, -1, -1), b = ts_v3_make(x, -1, 1), c = ts_v3_make(x, 1, 1), d = ts_v3_make(x, 1, -1);
	if (front_to_origin)
		world_quad(w, a, b, c, d, material, object);
	else
		world_quad(w, a, d, c, b, material, object);
}

static void rays_in_a_room_meet_its_walls(void **state)
{
	(void)state;
	world *w = world_new();
	ts_v3 low = ts_v3_make(-2, -3, -5), high = ts_v3_make(7, 11, 13);
	world_room(w, low, high, ONE_SIDED, 0);
	ts_truth *truth = grow(w);
	static const f32 distance[6] = {2.5f, 6.5f, 3.25f, 10.75f, 5.125f, 12.875f};
	ts_v3 o = ts_v3_make(0.5f, 0.25f, 0.125f);
	for (u32 f = 0; f < 6; f++) {
		f32 step = f & 1 ? 1 : -1;
		ts_v3 d = ts_v3_make(f / 2 == 0 ? step : 0, f / 2 == 1 ? step : 0, f / 2 == 2 ? step : 0);
		ts_truth_hit hit = cast(truth, o, d, 0, TS_NONE);
		assert_int_equal(hit.triangle / 2, f);
		assert_true(hit.t == distance[f]);
		assert_true(ts_abs(hit.path - distance[f]) <= 1e-5f * distance[f]);
		assert_int_equal(cast(truth, o, d, distance[f] * 1.001f, TS_NONE).triangle, TS_NONE);
		assert_int_equal(cast(truth, ts_mad(o, d, 100), ts_neg(d), 0, TS_NONE).triangle / 2, f ^ 1);
	}
	for (u32 i = 0; i < 10000; i++) {
		ts_v3 from = ts_v3_make(uniform(-1.9f, 6.9f), uniform(-2.9f, 10.9f), uniform(-4.9f, 12.9f));
		assert_int_not_equal(cast(truth, from, uniform_direction(), 0, TS_NONE).triangle, TS_NONE);
	}
	end(w, truth);
}

/* Rings of a sphere of radius 1, fronts outwards. */
static ts_v3 on_sphere(u32 ring, u32 step, u32 n_rings, u32 n_steps)
{
	f32 up = (f32)ring / (f32)(2 * n_rings), around = (f32)(step % n_steps) / (f32)n_steps;
	f32 s = ts_sin_turn(up);
	return ts_v3_make(s * ts_cos_turn(around), ts_cos_turn(up), s * ts_sin_turn(around));
}

static void sphere(world *w, u32 n_rings, u32 n_steps, u32 material, u32 object)
{
	for (u32 r = 0; r < n_rings; r++)
		for (u32 s = 0; s < n_steps; s++)
			world_quad(w, on_sphere(r, s, n_rings, n_steps), on_sphere(r, s + 1, n_rings, n_steps),
			           on_sphere(r + 1, s + 1, n_rings, n_steps), on_sphere(r + 1, s, n_rings, n_steps), material,
			           object);
}

static void rays_meet_the_front_of_a_sphere(void **state)
{
	(void)state;
	world *w = world_new();
	sphere(w, 40, 80, ONE_SIDED, 1);
	ts_truth *truth = grow(w);
	f32 sagitta = 0.002f; /* (pi / 80)^2 / 2 in each direction */
	for (u32 i = 0; i < 10000; i++) {
		ts_v3 d = uniform_direction();
		ts_v3 outside = ts_scale(d, -3);
		ts_truth_hit hit = cast(truth, outside, d, 0, TS_NONE);
		assert_int_not_equal(hit.triangle, TS_NONE);
		assert_true(hit.t >= 1.99999f && hit.t <= 2 + sagitta);
		assert_int_equal(cast(truth, ts_v3_make(0, 0, 0), d, 0, TS_NONE).triangle, TS_NONE);
		assert_int_equal(cast(truth, outside, d, 0, 0).triangle, TS_NONE);
		assert_int_equal(cast(truth, outside, d, 0, 1).triangle, hit.triangle);
	}
	end(w, truth);
}

/* Packets through all of both walls: it is the same that stops them. */
static void check_wall(const ts_truth *truth, u32 masked, u32 wall)
{
	enum { SIDE = 8 };
	ts_truth_query queries[SIDE * SIDE];
	ts_truth_hit hits[SIDE * SIDE];
	for (u32 i = 0; i < SIDE * SIDE; i++) {
		f32 y = (f32)(i % SIDE) * 0.1f - 0.33f, z = (f32)(i / SIDE) * 0.1f - 0.36f;
		queries[i] = (ts_truth_query){.direction = ts_normalize(ts_v3_make(1, y, z)), .masked = masked};
	}
	ts_truth_cast_all(hits, truth, queries, SIDE * SIDE);
	for (u32 i = 0; i < SIDE * SIDE; i++) assert_int_equal(hits[i].triangle / 2, wall);
}

static void filters_let_through_what_stops_no_light(void **state)
{
	(void)state;
	static const struct {
		u32 material, object, masked;
		bool front, stops;
	} cases[] = {
		{TWO_SIDED, 0, TS_NONE, true, true}, {TWO_SIDED, 0, TS_NONE, false, true},
		{ONE_SIDED, 0, TS_NONE, true, true}, {ONE_SIDED, 0, TS_NONE, false, false},
		{CUT, 0, TS_NONE, true, false},      {UNCUT, 0, TS_NONE, true, true},
		{TWO_SIDED, 2, 1, true, false},      {TWO_SIDED, 2, 0, true, true},
		{TWO_SIDED, 2, TS_NONE, true, true}, {TWO_SIDED, 0, 0, true, true},
	};
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		world *w = world_new();
		wall_at(w, 2, TWO_SIDED, 0, true);
		wall_at(w, 1, cases[i].material, cases[i].object, cases[i].front);
		ts_truth *truth = grow(w);
		u32 hit = first_along_x(truth, cases[i].masked);
		assert_int_equal(hit / 2, cases[i].stops ? 1 : 0);
		check_wall(truth, cases[i].masked, cases[i].stops ? 1 : 0);
		end(w, truth);
	}
}

/* The cut runs along the middle of the texture: u < 1/2 is gone at the finest level, all is half there far away. */
static void rays_pass_where_alpha_cuts(void **state)
{
	(void)state;
	world *w = world_new();
	world_triangle(w, ts_v3_make(1, 0, 0), ts_v3_make(1, 1, 0), ts_v3_make(1, 1, 1), HALF_CUT, 0);
	ts_truth *truth = grow(w);
	for (u32 i = 0; i < 2000; i++) {
		f32 u = uniform(0.01f, 0.99f);
		ts_truth_query query = {
			.origin = ts_v3_make(0, u, u * 0.5f), .direction = ts_v3_make(1, 0, 0), .masked = TS_NONE};
		query.from = query.origin;
		if (ts_abs(u - 0.5f) > 0.004f) assert_int_equal(ts_truth_cast(truth, &query).triangle, u < 0.5f ? TS_NONE : 0);
		query.spread = 100;
		assert_int_equal(ts_truth_cast(truth, &query).triangle, 0);
	}
	end(w, truth);
}

static void degenerate_triangles_are_never_hit(void **state)
{
	(void)state;
	world *w = world_new();
	ts_v3 a = ts_v3_make(1, -1, -1), b = ts_v3_make(1, 1, 1);
	world_triangle(w, a, b, ts_v3_make(1, 0, 0), TWO_SIDED, 0);
	world_triangle(w, a, a, b, TWO_SIDED, 0);
	world_triangle(w, ts_v3_make(1, 0, 0), ts_v3_make(1, 0, 0), ts_v3_make(1, 0, 0), ONE_SIDED, 1);
	ts_truth *truth = grow(w);
	for (u32 i = 0; i < 1000; i++) {
		f32 s = uniform(-1, 1);
		assert_int_equal(cast(truth, ts_v3_make(0, s, s), ts_v3_make(1, 0, 0), 0, TS_NONE).triangle, TS_NONE);
	}
	assert_int_equal(cast(truth, a, ts_v3_make(0, 0, 0), 0, TS_NONE).triangle, TS_NONE);
	end(w, truth);
	w = world_new();
	truth = grow(w);
	assert_int_equal(first_along_x(truth, TS_NONE), TS_NONE);
	end(w, truth);
}

/* Moeller and Trumbore in double: t and how far inside, the least barycentric. */
typedef struct {
	double t, inside;
	bool front;
} exact;

static void sub(double r[3], const f32 a[3], const f32 b[3])
{
	for (u32 i = 0; i < 3; i++) r[i] = (double)a[i] - (double)b[i];
}

static void cross(double r[3], const double a[3], const double b[3])
{
	for (u32 i = 0; i < 3; i++) r[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static exact intersect(const world *w, u32 triangle, const f32 origin[3], const f32 direction[3])
{
	const ts_triangle *t = &w->triangles[triangle];
	const f32 *a = w->vertices[t->vertex[0]].position;
	double ab[3], ac[3], ao[3], n[3], p[3], q[3], d[3] = {direction[0], direction[1], direction[2]};
	sub(ab, w->vertices[t->vertex[1]].position, a);
	sub(ac, w->vertices[t->vertex[2]].position, a);
	sub(ao, origin, a);
	cross(n, ab, ac);
	cross(p, d, ac);
	cross(q, ao, ab);
	double det = dot(ab, p), u = dot(ao, p) / det, v = dot(d, q) / det;
	return (exact){dot(ac, q) / det, fmin(fmin(u, v), 1 - u - v), dot(n, ao) > 0};
}

typedef struct {
	u32 triangle;
	double t;
	bool decided;
} answer;

/* The nearest triangle by trying all; decided unless an edge, a facing or a second hit is near. */
static answer try_all(const world *w, const f32 origin[3], const f32 direction[3], u32 masked)
{
	answer best = {TS_NONE, INFINITY, true};
	double second = INFINITY;
	for (u32 i = 0; i < w->scene.n_triangles; i++) {
		exact hit = intersect(w, i, origin, direction);
		if (!(hit.t > 0) || hit.inside < -1e-4) continue;
		bool one_sided = w->triangles[i].material == ONE_SIDED;
		u32 object = w->vertices[w->triangles[i].vertex[0]].object;
		if ((one_sided && !hit.front) || (masked != TS_NONE && object == masked + 1)) continue;
		if (hit.inside < 1e-4) {
			if (hit.t < best.t * (1 + 1e-5)) best.decided = false;
		} else if (hit.t < best.t) {
			second = best.t;
			best.t = hit.t;
			best.triangle = i;
		} else if (hit.t < second) {
			second = hit.t;
		}
	}
	if (second < best.t * (1 + 1e-5)) best.decided = false;
	return best;
}

static void soup(world *w, u32 n)
{
	for (u32 i = 0; i < n; i++) {
		ts_v3 a = uniform3(-10, 10);
		f32 size = i % 3 == 0 ? 6 : 1.5f;
		world_triangle(w, a, ts_add(a, uniform3(-size, size)), ts_add(a, uniform3(-size, size)),
		               i % 2 ? TWO_SIDED : ONE_SIDED, i % WORLD_OBJECTS);
	}
}

static void rays_meet_what_trying_all_finds(void **state)
{
	(void)state;
	world *w = world_new();
	soup(w, 1000);
	ts_truth *truth = grow(w);
	u32 n_decided = 0, n_hits = 0;
	for (u32 i = 0; i < 10000; i++) {
		f32 o[3], d[3];
		ts_store3(o, uniform3(-12, 12));
		ts_store3(d, uniform_direction());
		u32 masked = i % 4 == 3 ? TS_NONE : i % 4;
		answer expected = try_all(w, o, d, masked);
		if (!expected.decided) continue;
		n_decided++;
		ts_truth_hit hit = cast(truth, ts_load3(o), ts_load3(d), 0, masked);
		assert_int_equal(hit.triangle, expected.triangle);
		if (expected.triangle == TS_NONE) continue;
		n_hits++;
		assert_true(fabs((double)hit.t - expected.t) <= 1e-4 * (1 + expected.t));
	}
	assert_true(n_decided > 9500 && n_hits > 5000);
	end(w, truth);
}

/* The same soup with its triangles in reverse order: the same distances. */
static void the_order_of_triangles_changes_no_distance(void **state)
{
	(void)state;
	world *w = world_new(), *back = world_new();
	soup(w, 2000);
	*back = *w;
	world_begin(back);
	memcpy(back->vertices, w->vertices, sizeof(w->vertices));
	back->scene.n_vertices = w->scene.n_vertices;
	back->scene.n_triangles = w->scene.n_triangles;
	for (u32 i = 0; i < w->scene.n_triangles; i++) back->triangles[i] = w->triangles[w->scene.n_triangles - 1 - i];
	ts_truth *one = grow(w), *two = grow(back);
	for (u32 i = 0; i < 20000; i++) {
		ts_v3 o = uniform3(-12, 12), d = uniform_direction();
		ts_truth_hit a = cast(one, o, d, 0, i % 3), b = cast(two, o, d, 0, i % 3);
		assert_int_equal(a.triangle == TS_NONE, b.triangle == TS_NONE);
		assert_true(ts_abs(a.t - b.t) <= 1e-5f * a.t);
	}
	end(w, one);
	end(back, two);
}

/* Triangles of all materials; every other one lies on another with its corners in another order, so that which is
 * nearer is a matter of roundings. */
static void pairs_of_triangles(world *w, u32 n)
{
	for (u32 i = 0; i < n; i++) {
		ts_v3 a = uniform3(-8, 8), b = ts_add(a, uniform3(-2, 2)), c = ts_add(a, uniform3(-2, 2));
		world_triangle(w, a, b, c, i % 5, i % WORLD_OBJECTS);
		world_triangle(w, c, a, b, (i + 1) % 5, i / 3 % WORLD_OBJECTS);
	}
}

/* Bundles of rays that lie close together, and some that go anywhere or nowhere. */
static void bundle(ts_truth_query *queries, u32 n)
{
	ts_v3 o = uniform3(-9, 9), d = uniform_direction();
	f32 spread = uniform(0, 1) < 0.5f ? 0.01f : 1;
	for (u32 i = 0; i < n; i++) {
		ts_v3 way = ts_normalize(ts_mad(d, uniform_direction(), spread));
		queries[i] = (ts_truth_query){.origin = o,
		                              .direction = i % 13 == 5 ? ts_v3_make(0, 0, 0) : way,
		                              .near = i % 3 == 0 ? uniform(0, 4) : 0,
		                              .masked = i % 5 < 3 ? i % 5 : TS_NONE,
		                              .from = o,
		                              .spread = 0.01f,
		                              .whole = i % 7 == 0};
	}
}

enum { MOST = 150 };

/* Packets find what each of their rays finds alone; how many hit something. */
static u32 check_packets(const ts_truth *truth, const ts_truth_query *queries, u32 n, u32 k)
{
	static ts_truth_hit hits[MOST];
	u64 before = ts_truth_cost_of(truth).rays;
	u32 n_hits = 0;
	ts_truth_cast_all(hits, truth, queries, n);
	assert_int_equal(ts_truth_cost_of(truth).rays - before, n);
	for (u32 i = 0; i < n; i++) {
		ts_truth_hit single = ts_truth_cast(truth, &queries[i]);
		if (memcmp(&single, &hits[i], sizeof single) != 0)
			fail_msg("bundle %u, ray %u of %u: %u at %.9g, not %u at %.9g", k, i, n, hits[i].triangle,
			         (double)hits[i].t, single.triangle, (double)single.t);
		n_hits += single.triangle != TS_NONE;
	}
	return n_hits;
}

/* Embree as it would be on a lesser machine, and how many rays were cast alone. */
static ts_rtc_calls own;
static const char *isa;
static u32 n_alone;

static RTCDevice device_of_isa(const char *options)
{
	char text[128];
	snprintf(text, sizeof text, "%s,isa=%s", options, isa);
	return own.NewDevice(text);
}

/* Whether this processor has the instructions. */
static bool has_isa(void)
{
	RTCDevice device = device_of_isa("threads=1");
	if (device == NULL) return false;
	ts_rtc.ReleaseDevice(device);
	return true;
}

#if TS_EMBREE == 4
static void alone(RTCScene in, struct RTCRayHit *ray, struct RTCIntersectArguments *how)
#else
static void alone(RTCScene in, struct RTCIntersectContext *how, struct RTCRayHit *ray)
#endif
{
	n_alone++;
#if TS_EMBREE == 4
	own.Intersect1(in, ray, how);
#else
	own.Intersect1(in, how, ray);
#endif
}

/* Of each machine's packets: where they are narrower, Embree deals them out. */
static void packets_find_what_each_ray_finds(void **state)
{
	(void)state;
	static const char *const machines[] = {"sse2", "avx", "avx2", "avx512"};
	static ts_truth_query queries[MOST];
	assert_int_equal(ts_rtc_open(), TS_OK);
	own = ts_rtc;
	ts_rtc.NewDevice = device_of_isa;
	for (u32 m = 0; m < 4; m++) {
		isa = machines[m];
		if (!has_isa()) continue;
		world *w = world_new();
		pairs_of_triangles(w, 2000);
		world_room(w, ts_v3_make(-9, -9, -9), ts_v3_make(9, 9, 9), ONE_SIDED, 0);
		ts_truth *truth = grow(w);
		u64 rays = 0;
		for (u32 k = 0; k < 600; k++) {
			u32 n = k % (MOST + 1);
			bundle(queries, n);
			check_packets(truth, queries, n, k);
			rays += n;
		}
		assert_true(rays > 40000 && ts_truth_cost_of(truth).seconds > 0);
		end(w, truth);
	}
	ts_rtc = own;
}

/* From inside a room no wall is in doubt, and packets say all; of two walls in one place every ray is. */
static void only_rays_in_doubt_are_cast_alone(void **state)
{
	(void)state;
	enum { RAYS = 4096 };
	static ts_truth_query queries[RAYS];
	static ts_truth_hit hits[RAYS];
	assert_int_equal(ts_rtc_open(), TS_OK);
	own = ts_rtc;
	ts_rtc.Intersect1 = alone;
	for (u32 rooms = 1; rooms <= 2; rooms++) {
		world *w = world_new();
		for (u32 k = 0; k < rooms; k++) {
			world_room(w, ts_v3_make(-9, -9, -9), ts_v3_make(9, 9, 9), ONE_SIDED, 0);
		}
		ts_truth *truth = grow(w);
		for (u32 i = 0; i < RAYS; i++) {
			queries[i] =
				(ts_truth_query){.origin = uniform3(-8, 8), .direction = uniform_direction(), .masked = TS_NONE};
		}
		n_alone = 0;
		ts_truth_cast_all(hits, truth, queries, RAYS);
		for (u32 i = 0; i < RAYS; i++) assert_int_not_equal(hits[i].triangle, TS_NONE);
		if (rooms == 1) assert_true(n_alone < RAYS / 100);
		if (rooms == 2) assert_int_equal(n_alone, RAYS);
		end(w, truth);
	}
	ts_rtc = own;
}

/* Triangles whose planes pass the eye to a rounding: which side it sees is a matter of roundings, too. */
static void packets_see_edge_on_as_rays_do(void **state)
{
	(void)state;
	enum { EYES = 50, EACH = 30 };
	static ts_truth_query queries[EYES][EACH];
	world *w = world_new();
	for (u32 k = 0; k < EYES; k++) {
		ts_v3 eye = uniform3(-8, 8), aside = ts_scale(uniform_direction(), exp2f(-uniform(12, 23)));
		for (u32 i = 0; i < EACH; i++) {
			ts_v3 d = uniform_direction(), a = ts_mad(eye, d, uniform(1, 9)), b = ts_mad(eye, d, uniform(1, 9));
			ts_v3 c = ts_mad(eye, ts_normalize(ts_add(d, aside)), uniform(1, 9));
			world_triangle(w, a, b, c, ONE_SIDED, 0);
			queries[k][i] = (ts_truth_query){.origin = eye,
			                                 .direction = ts_normalize(ts_mad(d, aside, uniform(0, 0.5f))),
			                                 .masked = TS_NONE,
			                                 .from = eye};
		}
	}
	ts_truth *truth = grow(w);
	u32 n_hits = 0;
	for (u32 k = 0; k < EYES; k++) n_hits += check_packets(truth, queries[k], EACH, k);
	assert_true(n_hits > EYES);
	end(w, truth);
}

/* More backs before a wall than a packet keeps in mind. */
static void packets_pass_more_backs_than_they_keep(void **state)
{
	(void)state;
	static ts_truth_query queries[MOST];
	world *w = world_new();
	for (u32 i = 0; i < 200; i++) {
		f32 z = -1 - (f32)i * 0.01f;
		world_triangle(w, ts_v3_make(-9, -9, z), ts_v3_make(0, 9, z), ts_v3_make(9, -9, z), ONE_SIDED, 0);
	}
	world_triangle(w, ts_v3_make(-90, -90, -9), ts_v3_make(90, -90, -9), ts_v3_make(0, 90, -9), ONE_SIDED, 0);
	ts_truth *truth = grow(w);
	for (u32 i = 0; i < MOST; i++) {
		ts_v3 d = ts_normalize(ts_v3_make(uniform(-2, 2), uniform(-2, 2), -1));
		queries[i] = (ts_truth_query){.direction = d, .masked = TS_NONE};
	}
	assert_int_equal(check_packets(truth, queries, MOST, 0), MOST);
	end(w, truth);
}

static void pairs_see_alike_in_packets(void **state)
{
	(void)state;
	world *w = world_new();
	pairs_of_triangles(w, 500);
	ts_truth *truth = grow(w);
	u32 n_free = 0;
	for (u32 k = 0; k < 500; k++) {
		ts_truth_pair pairs[TS_TRUTH_PAIRS];
		bool sees[TS_TRUTH_PAIRS];
		u32 n = k % (TS_TRUTH_PAIRS + 1);
		for (u32 i = 0; i < TS_TRUTH_PAIRS; i++)
			pairs[i] = (ts_truth_pair){uniform3(-8, 8), uniform3(-8, 8), i % 2 ? 0 : uniform(0, 2)};
		ts_truth_sees_all(sees, truth, pairs, n);
		for (u32 i = 0; i < n; i++) {
			assert_int_equal(sees[i], ts_truth_sees(truth, pairs[i].from, pairs[i].to, pairs[i].reach));
			n_free += sees[i];
		}
	}
	assert_true(n_free > 1000 && n_free < 15000);
	end(w, truth);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(rays_in_a_room_meet_its_walls),
		cmocka_unit_test(rays_meet_the_front_of_a_sphere),
		cmocka_unit_test(filters_let_through_what_stops_no_light),
		cmocka_unit_test(rays_pass_where_alpha_cuts),
		cmocka_unit_test(degenerate_triangles_are_never_hit),
		cmocka_unit_test(rays_meet_what_trying_all_finds),
		cmocka_unit_test(the_order_of_triangles_changes_no_distance),
		cmocka_unit_test(packets_find_what_each_ray_finds),
		cmocka_unit_test(pairs_see_alike_in_packets),
		cmocka_unit_test(packets_see_edge_on_as_rays_do),
		cmocka_unit_test(packets_pass_more_backs_than_they_keep),
		cmocka_unit_test(only_rays_in_doubt_are_cast_alone),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
