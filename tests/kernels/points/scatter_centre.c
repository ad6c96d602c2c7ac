/* Points that count at the centre of their texel: the plane's depth there in double precision, MVR's maps bit for bit,
 * what MVR shades, and pieces that stand for culled ones (METHODS 9 and 10). */
#include "kernels/raster/depth_map.h"
#include "tests/kernels/points/views.h"
#include "tests/whole.h"

enum { N_VIEWS = 6, SIDE = 40, N_TEXELS = SIDE * SIDE, N_MESHES = 40 };

static u32 texels[2][N_VIEWS * N_TEXELS];
static ts_offscreen views[N_VIEWS];

static void clear(u32 *to) { memset(to, 0xff, sizeof texels[0]); }

/* Looking at about the middle of the mesh. */
static void random_views(void)
{
	for (u32 v = 0; v < N_VIEWS; v++) {
		ts_v3 back = unit3(), eye = ts_mad(uniform3(-1, 1), back, uniform(2, 6));
		u32 parallel = random_bits() % 3 == 0;
		f32 reach = parallel != 0 ? uniform(1, 4) : uniform(0.3f, 1.5f);
		views[v] = view_from(eye, back, reach, SIDE, 0.125f, parallel);
		views[v].offset = v * N_TEXELS;
	}
}

static void see(mesh *m)
{
	ts_offscreen_args args = {
		.scene = mesh_arrays(m), .views = views, .bits = m->bits, .n_views = N_VIEWS, .n_words = 2};
	for (u32 t = 0; t < m->n_triangles; t++) ts_k_offscreen_visibility_item(&args, t);
}

/* From triangles to maps, by points as dense as `rate` asks for. */
static ts_scatter_args make(mesh *m, u32 rate, i64 tally[3])
{
	i64 n_capped = 0;
	see(m);
	mesh_split(m, views_density(m, views, N_VIEWS, rate, &n_capped));
	mesh_align(m);
	assert_int_equal(n_capped, 0);
	return views_scatter(m, views, N_VIEWS, (ts_points_args){.half_size = 129, .snap = 1}, tally);
}

static void scatter(ts_scatter_args args, u32 n_pieces, u32 *to, bool colours)
{
	clear(to);
	*(colours ? &args.colours : &args.depths) = to;
	for (u32 p = 0; p < n_pieces; p++) ts_k_scatter_pieces_item(&args, p);
}

/* The plane's depths at a texel's centre and at 1/128 texel to all sides: all of that lies in the triangle, or beyond
 * one of its edges. */
typedef struct {
	double least, most;
	bool inside, outside;
} answer;

static answer ask(const ts_offscreen *view, const ts_v3 corner[3], u32 texel)
{
	answer r = {.least = INFINITY, .most = -INFINITY};
	bool inside[3] = {true, true, true}, outside[3] = {true, true, true};
	for (u32 k = 0; k < 9; k++) {
		double weight[3], x = texel % SIDE + 0.5, y = texel / SIDE + 0.5;
		d3_ray ray = view_ray(view, x + (k % 3 - 1.0) / 128, y + (k / 3 - 1.0) / 128);
		double z = ray_meets(&ray, d3_of(corner[0]), d3_of(corner[1]), d3_of(corner[2]), weight);
		r.least = fmin(r.least, z);
		r.most = fmax(r.most, z);
		for (u32 c = 0; c < 3; c++) {
			inside[c] = inside[c] && weight[c] > 0;
			outside[c] = outside[c] && weight[c] < 0;
		}
	}
	bool ahead = r.least > (double)view->near;
	r.inside = ahead && inside[0] && inside[1] && inside[2];
	r.outside = ahead && (outside[0] || outside[1] || outside[2]);
	return r;
}

/* An empty mesh, views and the corners of a triangle for it; false if that has no area. */
static bool begin_one(mesh *m, ts_v3 corner[3], f32 reach, f32 least, f32 most)
{
	mesh_begin(m);
	random_views();
	random_corners(corner, reach, least, most);
	return !is_degenerate(corner);
}

/* A triangle alone: its plane's depth where it covers the centre, and nothing elsewhere. By their own place its points
 * fill more texels, and no fewer. */
static void covered_centres_have_the_planes_depth(void **state)
{
	(void)state;
	u32 n_inside = 0, n_outside = 0, n_beside = 0;
	n_random = 0;
	for (u32 i = 0; i < 100; i++) {
		mesh m;
		ts_v3 corner[3];
		i64 tally[3] = {0};
		if (!begin_one(&m, corner, 1, 0.1f, 4)) continue;
		mesh_triangle(&m, corner[0], corner[1], corner[2], 1, 0);
		ts_scatter_args args = make(&m, TS_RATE_WATERTIGHT, tally);
		scatter(args, m.n_pieces, texels[0], false);
		args.centre = 1;
		scatter(args, m.n_pieces, texels[1], false);
		for (u32 k = 0; k < N_VIEWS * N_TEXELS; k++) {
			answer at = ask(&views[k / N_TEXELS], corner, k % N_TEXELS);
			bool has = texels[1][k] != TS_NONE;
			double z = has ? (double)ts_u2f(texels[1][k]) : 0, room = 1e-5 * (1 + fabs(at.most));
			if (has) assert_true(texels[0][k] != TS_NONE);
			n_beside += texels[0][k] != TS_NONE && !has;
			if (at.outside) assert_false(has);
			if (at.inside) assert_true(has && z >= at.least - room && z <= at.most + room);
			n_inside += at.inside;
			n_outside += at.outside;
		}
		mesh_clear(&m);
	}
	assert_true(n_inside > 5000 && n_outside > 50000 && n_beside > 1000);
}

static void random_mesh(mesh *m, f32 least, f32 most)
{
	mesh_begin(m);
	random_views();
	while (m->n_triangles < MESH_TRIANGLES) {
		ts_v3 corner[3];
		random_corners(corner, 1.5f, least, most);
		if (is_degenerate(corner)) continue;
		u32 t = mesh_triangle(m, corner[0], corner[1], corner[2], m->n_triangles % 2, 0);
		for (u32 k = 0; k < 9; k++) m->vertices[t * 3 + k / 3].colour[k % 3] = uniform(0, 1);
	}
}

static void draw(const mesh *m, u32 *to)
{
	ts_depth_map_args args = {.scene = mesh_arrays(m), .views = views, .depths = to, .n_views = N_VIEWS};
	clear(to);
	for (u32 t = 0; t < m->n_triangles; t++) ts_k_depth_map_item(&args, t);
}

/* What MVR draws, bit for bit: all that covers a centre has a point in the texel, and no other point counts. */
static void scattered_centres_are_what_mvr_draws(void **state)
{
	(void)state;
	u32 n_seen = 0, n_wrong = 0;
	n_random = 0;
	for (u32 i = 0; i < N_MESHES; i++) {
		mesh m;
		i64 tally[3] = {0};
		random_mesh(&m, 0.01f, 4);
		ts_scatter_args args = make(&m, TS_RATE_WATERTIGHT, tally);
		args.centre = 1;
		scatter(args, m.n_pieces, texels[0], false);
		draw(&m, texels[1]);
		for (u32 k = 0; k < N_VIEWS * N_TEXELS; k++) {
			n_seen += texels[1][k] != TS_NONE;
			n_wrong += texels[0][k] != texels[1][k];
		}
		mesh_clear(&m);
	}
	assert_true(n_seen > 50000 && n_wrong == 0);
}

/* One triangle in front of all texels. */
static void a_wall_fills_all_texels(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < whole_or(5, 2); i++) {
		mesh m;
		i64 tally[3] = {0};
		mesh_begin(&m);
		ts_v3 back = unit3();
		for (u32 v = 0; v < N_VIEWS; v++) {
			ts_v3 eye = ts_mad(uniform3(-0.5f, 0.5f), back, 3);
			ts_v3 aside = ts_normalize(ts_mad(back, uniform3(-1, 1), 0.3f));
			views[v] = view_from(eye, aside, uniform(0.3f, 0.6f), SIDE, 0.0009765625f, v % 2);
			views[v].offset = v * N_TEXELS;
		}
		ts_v3 u = ts_normalize(ts_cross(back, uniform3(-1, 1))), w = ts_cross(back, u);
		mesh_triangle(&m, ts_mad(ts_scale(u, -16), w, -12), ts_mad(ts_scale(u, 16), w, -12), ts_scale(w, 16), 1, 0);
		ts_scatter_args args = make(&m, TS_RATE_WATERTIGHT, tally);
		args.centre = 1;
		scatter(args, m.n_pieces, texels[0], false);
		draw(&m, texels[1]);
		for (u32 k = 0; k < N_VIEWS * N_TEXELS; k++) assert_true(texels[0][k] != TS_NONE);
		assert_memory_equal(texels[0], texels[1], sizeof texels[0]);
		mesh_clear(&m);
	}
}

/* The least code of all triangles that are drawn at a centre. */
static u32 colour_at(const mesh *m, const ts_scatter_args *args, u32 k)
{
	u32 r = TS_NONE;
	ts_camera_k view = ts_k_offscreen(&views[k / N_TEXELS]);
	i32 x = (i32)(k % N_TEXELS % SIDE), y = (i32)(k % N_TEXELS / SIDE);
	for (u32 t = 0; t < m->n_triangles; t++) {
		if (!ts_k_offscreen_bit(m->bits + t * 2, k / N_TEXELS)) continue;
		if (!(ts_k_fragment_drawn(&args->from.scene, &view, t, x, y).z > 0)) continue;
		ts_surface s = ts_k_surface_seen(&args->from.scene, &view, t, x, y);
		ts_v3 way = ts_sub(view.eye, s.p), radiance = ts_k_shade(&args->from.scene, &s, ts_normalize(way));
		u32 code = ts_k_depth_code(ts_length(way), view.near) << 19 | ts_k_colour_code(radiance, args->exposure);
		r = code < r ? code : r;
	}
	return r;
}

static void centres_have_the_least_colour_drawn(void **state)
{
	(void)state;
	u32 n_seen = 0, n_wrong = 0;
	n_random = 0;
	for (u32 i = 0; i < N_MESHES / 4; i++) {
		mesh m;
		i64 tally[3] = {0};
		random_mesh(&m, 0.01f, 4);
		ts_scatter_args args = make(&m, TS_RATE_WATERTIGHT, tally);
		args.centre = 1;
		scatter(args, m.n_pieces, texels[0], true);
		for (u32 k = 0; k < N_VIEWS * N_TEXELS; k++) {
			u32 expected = colour_at(&m, &args, k);
			n_seen += expected != TS_NONE;
			n_wrong += texels[0][k] != expected;
		}
		mesh_clear(&m);
	}
	assert_true(n_seen > 20000 && n_wrong == 0);
}

/* Masks cut at the centre: of a triangle that its texture's clear half cuts, no texel has that half. */
static void masks_cut_at_the_centre(void **state)
{
	(void)state;
	u32 n_wrong[2] = {0}, n_seen = 0;
	n_random = 0;
	for (u32 i = 0; i < 100; i++) {
		mesh m;
		ts_v3 corner[3];
		i64 tally[3] = {0};
		if (!begin_one(&m, corner, 0.5f, 1, 3)) continue;
		u32 t = mesh_triangle(&m, corner[0], corner[1], corner[2], 4, 0);
		m.materials[4].flags |= TS_DOUBLE_SIDED;
		ts_scatter_args args = make(&m, TS_RATE_WATERTIGHT, tally);
		for (u32 centre = 0; centre < 2; centre++) {
			args.centre = centre;
			scatter(args, m.n_pieces, texels[centre], false);
			for (u32 k = 0; k < N_VIEWS * N_TEXELS; k++) {
				ts_camera_k view = ts_k_offscreen(&views[k / N_TEXELS]);
				i32 x = (i32)(k % N_TEXELS % SIDE), y = (i32)(k % N_TEXELS / SIDE);
				bool is_there = ts_k_fragment_drawn(&args.from.scene, &view, t, x, y).z > 0;
				n_seen += texels[centre][k] != TS_NONE;
				n_wrong[centre] += texels[centre][k] != TS_NONE && !is_there;
			}
		}
		mesh_clear(&m);
	}
	assert_true(n_seen > 10000 && n_wrong[0] > 500 && n_wrong[1] == 0);
}

/* Triangles of less than a tenth of a sample, which culling thins out, stay where they are; without culling they are
 * asked like all others. */
static void triangles_that_culling_thins_stay(void **state)
{
	(void)state;
	u32 n_own = 0, n_centre = 0;
	n_random = 0;
	for (u32 i = 0; i < N_MESHES; i++) {
		mesh m;
		i64 tally[3] = {0};
		static u32 own[N_VIEWS * N_TEXELS];
		random_mesh(&m, 0.0005f, 0.001f);
		ts_scatter_args args = make(&m, TS_RATE_WATERTIGHT, tally);
		scatter(args, m.n_pieces, own, false);
		args.centre = args.culled = 1;
		scatter(args, m.n_pieces, texels[0], false);
		assert_memory_equal(texels[0], own, sizeof own);
		args.culled = 0;
		scatter(args, m.n_pieces, texels[1], false);
		for (u32 k = 0; k < N_VIEWS * N_TEXELS; k++) {
			n_own += own[k] != TS_NONE;
			n_centre += texels[1][k] != TS_NONE;
		}
		mesh_clear(&m);
	}
	assert_true(n_own > 5000 && n_centre < n_own / 10);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(covered_centres_have_the_planes_depth),
		cmocka_unit_test(scattered_centres_are_what_mvr_draws),
		cmocka_unit_test(a_wall_fills_all_texels),
		cmocka_unit_test(centres_have_the_least_colour_drawn),
		cmocka_unit_test(masks_cut_at_the_centre),
		cmocka_unit_test(triangles_that_culling_thins_stay),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
