/* Points of any density in depth maps: no holes and the plane's depth whatever the rate, the points alone where they
 * are dense and no hole there, nothing of what misses a view, and nothing that depends on order, batches or storing. */
#include "kernels/points/shadow_splat.h"
#include "tests/kernels/points/views.h"

enum { N_VIEWS = 40, SIDE = 64, N_TEXELS = SIDE * SIDE, N_SINGLE = 400, STRIDE = 1000003 };
enum { N_PLANES = 50000, N_BESIDE = 40000 };

static u32 texels[2][N_VIEWS * N_TEXELS];

static void clear(u32 *to) { memset(to, 0xff, sizeof texels[0]); }

static void random_views(ts_offscreen *views, u32 n)
{
	u64 offset = 0;
	for (u32 v = 0; v < n; v++) {
		ts_v3 back = unit3(), eye = ts_mad(uniform3(-2, 2), back, uniform(0, 8));
		views[v] = view_from(eye, back, uniform(0.3f, 1.5f), 1 + random_bits() % SIDE, uniform_power(-7, 0), 0);
		views[v].offset = offset;
		offset += (u64)views[v].width * views[v].height;
	}
}

static ts_shadow_splat_args arguments(const mesh *m, const ts_offscreen *views, u32 n, ts_points_args how, i64 tally[5],
                                      u32 *to)
{
	ts_shadow_splat_args r = {.of = views_scatter(m, views, n, how, tally),
	                          .n_splats = &tally[3],
	                          .n_texels = &tally[4],
	                          .clip = 1,
	                          .inset = TS_SPLAT_INSET,
	                          .plane_depth = 1};
	r.of.depths = to;
	return r;
}

static void random_mesh(mesh *m, ts_offscreen *views)
{
	mesh_begin(m);
	random_views(views, N_VIEWS);
	for (u32 k = 0; k < MESH_TRIANGLES; k++) {
		ts_v3 corner[3];
		random_corners(corner, 4, 0.01f, 1);
		u32 t = mesh_triangle(m, corner[0], corner[1], corner[2], k % 5, 0);
		m->bits[t * 2] = ((u64)random_bits() << 32 | random_bits()) & ((1UL << N_VIEWS) - 1);
	}
	mesh_whole(m, 8);
	for (u32 i = 0; i < m->n_pieces; i++) m->scale[i] = uniform_power(-2, 5);
}

/* The same bits and counts from stored points in any order, and from points made on the spot; also in batches. */
static void stored_points_splat_as_fresh_ones_do(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < 6; i++) {
		mesh m;
		static ts_offscreen views[N_VIEWS];
		i64 tally[2][5] = {{0}};
		ts_points_args how = {.half_size = i % 2 == 0 ? 128 : 129, .snap = i & 1, .paper_splat = i / 3};
		random_mesh(&m, views);
		mesh_make_points(&m, how);
		ts_shadow_splat_args stored = arguments(&m, views, N_VIEWS, how, tally[0], texels[0]);
		ts_shadow_splat_args made = arguments(&m, views, N_VIEWS, how, tally[1], texels[1]);
		stored.clip = made.clip = i % 3 != 0;
		stored.inset = made.inset = i % 5 == 0 ? 0 : TS_SPLAT_INSET;
		stored.plane_depth = made.plane_depth = i % 4 != 0;
		made.of.from.points = NULL;
		clear(texels[1]);
		for (u32 p = m.n_pieces; p-- > 0;) ts_k_shadow_splat_pieces_item(&made, p);
		for (u32 order = 0; order < 2; order++) {
			clear(texels[0]);
			memset(tally[0], 0, sizeof tally[0]);
			for (u32 p = 0; p < m.n_points; p++) {
				ts_k_shadow_splat_item(&stored, order == 0 ? p : (u32)((u64)p * STRIDE % m.n_points));
			}
			assert_memory_equal(texels[0], texels[1], sizeof texels[0]);
			assert_memory_equal(tally[0], tally[1], sizeof tally[0]);
			assert_true(tally[0][0] == m.n_points && tally[0][2] > 100 && tally[0][3] > 50 &&
			            tally[0][4] >= tally[0][3]);
		}
		for (u32 first = 0; first < N_VIEWS; first += 7) {
			made.of.first_view = first;
			made.of.n_views = first + 7 < N_VIEWS ? 7 : N_VIEWS - first;
			made.of.depths = texels[1] + views[first].offset;
			clear(texels[1]);
			for (u32 p = 0; p < m.n_pieces; p++) ts_k_shadow_splat_pieces_item(&made, p);
			const ts_offscreen *last = &views[first + made.of.n_views - 1];
			u64 n = last->offset + (u64)last->width * last->height - views[first].offset;
			assert_memory_equal(made.of.depths, texels[0] + views[first].offset, n * sizeof(u32));
		}
		mesh_clear(&m);
	}
}

/* One triangle before one view, with density s. */
typedef struct {
	mesh m;
	ts_offscreen view;
	ts_v3 corner[3];
	i64 tally[5];
} single;

/* The rate at which each texel gets a sample, where the triangle is nearest. */
static f32 make_single(single *w)
{
	mesh_begin(&w->m);
	do {
		w->view = view_from(uniform3(-2, 2), unit3(), uniform(0.5f, 1.2f), SIDE, 0.0625f, 0);
		ts_v3 ahead = ts_mad(ts_load3(w->view.eye), ts_load3(w->view.back), -uniform(0.25f, 4));
		f32 size = uniform_power(-4, 2);
		for (u32 k = 0; k < 3; k++) w->corner[k] = ts_mad(ahead, uniform3(-1, 1), size);
	} while (is_degenerate(w->corner));
	u32 t = mesh_triangle(&w->m, w->corner[0], w->corner[1], w->corner[2], 1, 0);
	w->m.bits[t * 2] = 1;
	ts_density_args args = {.views = &w->view, .n_views = 1, .n_words = 2, .rate = TS_RATE_WATERTIGHT};
	return ts_k_view_density(&args, w->m.bits, w->corner[0], w->corner[1], w->corner[2]).s;
}

static void run_single(single *w, f32 s, u32 plane_depth, u32 *to)
{
	ts_points_args how = {.half_size = 129, .snap = 1};
	memset(w->tally, 0, sizeof w->tally);
	mesh_whole(&w->m, s);
	mesh_align(&w->m);
	ts_shadow_splat_args args = arguments(&w->m, &w->view, 1, how, w->tally, to);
	args.plane_depth = plane_depth;
	clear(to);
	ts_k_shadow_splat_pieces_item(&args, 0);
}

static bool lattice_fits(const single *w, f32 s)
{
	f32 length;
	ts_k_longest_edge(w->corner[0], w->corner[1], w->corner[2], &length);
	return s > 0 && length * s < 2000;
}

/* Depth at which the ray through a texel's centre meets the triangle; 0: it does not. */
static double seen(const single *w, u32 texel)
{
	double weight[3];
	d3_ray ray = view_ray(&w->view, texel % SIDE + 0.5, texel / SIDE + 0.5);
	double z = ray_meets(&ray, d3_of(w->corner[0]), d3_of(w->corner[1]), d3_of(w->corner[2]), weight);
	bool in = weight[0] > 1e-3 && weight[1] > 1e-3 && weight[2] > 1e-3;
	return in && z > w->view.near * 1.001 ? z : 0;
}

/* From one sample to one a texel: every texel that sees the triangle has a depth, of splats alone the plane's; and none
 * is nearer or farther than the triangle. */
static void no_seen_texel_is_a_hole(void **state)
{
	(void)state;
	static single w;
	u32 n_seen = 0, n_direct = 0, n_mixed = 0, n_splats = 0;
	n_random = 0;
	for (u32 i = 0; i < N_SINGLE; i++) {
		f32 most = make_single(&w), s = most * uniform_power(-6, 0.5f);
		if (!lattice_fits(&w, s)) continue;
		run_single(&w, s, 1, texels[0]);
		double nearest = INFINITY, farthest = w.view.near;
		for (u32 k = 0; k < 3; k++) {
			double z = view_place(&w.view, d3_of(w.corner[k])).z;
			nearest = fmin(nearest, z);
			farthest = fmax(farthest, z);
		}
		for (u32 k = 0; k < N_TEXELS; k++) {
			double z = seen(&w, k), depth = texels[0][k] != TS_NONE ? ts_u2f(texels[0][k]) : 0;
			assert_true(depth == 0 || (depth >= fmax(nearest, w.view.near) * 0.9999 && depth <= farthest * 1.0001));
			if (z == 0) continue;
			assert_true(depth > 0);
			if (w.tally[2] == 0) assert_true(fabs(depth - z) <= 2e-3 * z);
			n_seen++;
		}
		n_direct += w.tally[2] > 0 && w.tally[3] == 0;
		n_mixed += w.tally[2] > 0 && w.tally[3] > 0;
		n_splats += w.tally[2] == 0 && w.tally[3] > 0;
		mesh_clear(&w.m);
	}
	assert_true(n_seen > 20000 && n_direct > 10 && n_mixed > 20 && n_splats > 50);
}

/* At iVIR's rate and above the nearest splats are points, and the map is that of scattering, to the bit. */
static void dense_points_give_the_map_of_scattering(void **state)
{
	(void)state;
	static single w;
	u32 n_same = 0;
	n_random = 0;
	for (u32 i = 0; i < N_SINGLE; i++) {
		f32 s = make_single(&w) * uniform(1.02f, 1.5f);
		if (!lattice_fits(&w, s)) continue;
		run_single(&w, s, 1, texels[0]);
		if (w.tally[3] == 0) {
			i64 tally[3] = {0};
			ts_points_args how = {.half_size = 129, .snap = 1};
			ts_scatter_args scatter = views_scatter(&w.m, &w.view, 1, how, tally);
			scatter.depths = texels[1];
			clear(texels[1]);
			ts_k_scatter_pieces_item(&scatter, 0);
			assert_memory_equal(texels[0], texels[1], sizeof texels[0]);
			assert_true(tally[2] == w.tally[2]);
			n_same += tally[2] > 0;
		}
		mesh_clear(&w.m);
	}
	assert_true(n_same > 50);
}

/* The paper's depth: a splat has that of its point everywhere; of one sample the centroid's. */
static void the_papers_splats_have_their_points_depth(void **state)
{
	(void)state;
	static single w;
	u32 n_filled = 0;
	n_random = 0;
	for (u32 i = 0; i < N_SINGLE; i++) {
		f32 length;
		make_single(&w);
		ts_k_longest_edge(w.corner[0], w.corner[1], w.corner[2], &length);
		run_single(&w, 0.25f / length, 0, texels[0]);
		d3 middle = d3_scale(d3_add(d3_add(d3_of(w.corner[0]), d3_of(w.corner[1])), d3_of(w.corner[2])), 1.0 / 3);
		double z = fmax(view_place(&w.view, middle).z, w.view.near);
		for (u32 k = 0; k < N_TEXELS; k++) {
			if (texels[0][k] == TS_NONE) continue;
			assert_true(fabs(ts_u2f(texels[0][k]) - z) <= 1e-4 * (1 + z));
			n_filled++;
		}
		mesh_clear(&w.m);
	}
	assert_true(n_filled > 10000);
}

/* What the middle of a texel of a cube's face of n texels sees at q, of a plane that has a lattice with the diagonals u
 * and v, unit, and its square about q; `most`: the side of squares that are just written alone at q. Half of them at
 * the border of the face, and half with the diagonal along which a row or column of the image is shortest. */
typedef struct {
	ts_offscreen view;
	u32 i, j;
	d3 q, u, v;
	double most;
} seen_plane;

static u32 random_texel(u32 n, bool at_border) { return at_border ? random_bits() % 2 * (n - 1) : random_bits() % n; }

static seen_plane random_plane(u32 n)
{
	seen_plane r = {.view = view_from(ts_v3_make(0, 0, 0), unit3(), 1, n, 1e-6f, 0)};
	r.i = random_texel(n, random_bits() % 2 != 0);
	r.j = random_texel(n, random_bits() % 2 != 0);
	d3_ray ray = view_ray(&r.view, r.i + 0.5, r.j + 0.5);
	double z = uniform(0.25f, 8);
	r.q = d3_scale(ray.way, z);
	d3 axis = d3_load(random_bits() % 2 != 0 ? r.view.right : r.view.up);
	d3 steep = d3_mad(axis, ray.way, -d3_dot(axis, ray.way) / d3_dot(ray.way, ray.way));
	r.u = random_bits() % 2 != 0 ? d3_unit(steep) : d3_of(unit3());
	r.v = d3_unit(d3_cross(r.u, d3_of(unit3())));
	r.most = z / (1.42526209354400634765625 * r.view.focal * d3_length(ray.way));
	return r;
}

static bool is_written_alone(const seen_plane *w, d3 p, f32 length)
{
	ts_camera_k view = ts_k_offscreen(&w->view);
	ts_corner at = ts_k_to_view(&view, ts_v3_make((f32)p.x, (f32)p.y, (f32)p.z));
	return ts_k_is_within_texel(&view, &at, length);
}

/* Of faces of n texels, and points that are the nearest to q in their lattice and written alone: how many lie beside
 * its texel, and leave a hole there. */
static u32 count_holes(u32 n)
{
	u32 alone = 0, beside = 0;
	for (u32 k = 0; k < N_PLANES; k++) {
		seen_plane w = random_plane(n);
		double length = w.most * uniform(1 - 4.0f / (f32)n, 1 + 4.0f / (f32)n), half = length * sqrt(0.5);
		double a = random_bits() % 2 != 0 ? 1 : uniform(-1, 1), b = (1 - fabs(a)) * uniform(-1, 1);
		d3 p = d3_mad(d3_mad(w.q, w.u, a * half), w.v, b * half);
		if (!is_written_alone(&w, p, (f32)length)) continue;
		d3_place at = view_place(&w.view, p);
		alone++;
		beside += at.x < w.i || at.y < w.j || at.x > w.i + 1 || at.y > w.j + 1;
	}
	assert_true(alone > N_PLANES / 4);
	return beside;
}

/* A diagonal within a texel by 1/128 leaves no texel without its nearest point from 64 texels on; of smaller faces,
 * down to the least, some where the image is stretched most. */
static void lone_points_leave_large_faces_whole(void **state)
{
	(void)state;
	n_random = 0;
	u32 holes = 0;
	for (u32 n = 16; n < 64; n += 8) holes += count_holes(n);
	print_message("%u holes in faces of 16 to 56 texels\n", (unsigned)holes);
	assert_true(holes > 10 && holes < N_PLANES / 100);
	for (u32 n = 64; n <= 1024; n += n / 8) assert_int_equal(count_holes(n), 0);
}

/* A piece about a border of a view's image, or its near plane, of few samples. */
static void make_beside(single *w)
{
	mesh_begin(&w->m);
	do {
		w->view = view_from(uniform3(-2, 2), unit3(), uniform_power(-2, 2), SIDE, uniform_power(-5, -2), 0);
		bool beside = random_bits() % 2 != 0;
		f32 z = beside ? uniform(0, 4) : w->view.near * uniform(0.5f, 1), size = z * uniform_power(-8, -1);
		d3_ray ray = view_ray(&w->view, uniform(0, SIDE), beside ? random_bits() % 2 * SIDE : SIDE / 2);
		d3 middle = d3_mad(ray.from, ray.way, z);
		ts_v3 at = ts_v3_make((f32)middle.x, (f32)middle.y, (f32)middle.z);
		for (u32 k = 0; k < 3; k++) w->corner[k] = ts_mad(at, uniform3(-1, 1), size);
	} while (is_degenerate(w->corner));
	f32 length;
	w->m.bits[mesh_triangle(&w->m, w->corner[0], w->corner[1], w->corner[2], 1, 0) * 2] = 1;
	ts_k_longest_edge(w->corner[0], w->corner[1], w->corner[2], &length);
	mesh_whole(&w->m, uniform_power(-2, 3) / length);
	mesh_align(&w->m);
}

/* The texels that all points of the piece offer a depth to, whether it misses the view or not. */
static i64 count_offers(const ts_shadow_splat_args *args, bool *misses)
{
	ts_cover cover = ts_k_lattice_cover(&args->of.from.frames[0], args->of.from.half_size);
	ts_flight point = ts_k_flight_of_piece(&args->of.from, 0);
	ts_shadow_tally tally = ts_k_shadow_none();
	ts_shadow_group group = {.caster = {ts_k_shadow_caster(&args->of, 0, &point)}, .n = 1};
	const ts_band all = ts_k_band(0, 0);
	*misses = group.caster[0].misses;
	ts_k_shadow_piece_into(args, &cover, &point, &all, &group, &tally);
	return tally.of.writes + tally.texels;
}

/* A piece that misses a view leaves nothing there, whatever its points; few others leave nothing. */
static void what_misses_a_view_leaves_nothing(void **state)
{
	(void)state;
	static single w;
	u32 n_missing = 0, n_in_vain = 0;
	n_random = 0;
	for (u32 i = 0; i < N_BESIDE; i++) {
		bool misses;
		make_beside(&w);
		ts_points_args how = {.half_size = 129, .snap = i & 1};
		ts_shadow_splat_args args = arguments(&w.m, &w.view, 1, how, w.tally, texels[0]);
		args.clip = 0;
		i64 n_offers = count_offers(&args, &misses);
		assert_true(!misses || n_offers == 0);
		n_missing += misses;
		n_in_vain += !misses && n_offers == 0;
		mesh_clear(&w.m);
	}
	print_message("%u pieces miss the view, %u are tried in vain\n", (unsigned)n_missing, (unsigned)n_in_vain);
	assert_true(n_missing > N_BESIDE / 20 && n_in_vain < N_BESIDE / 4);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(stored_points_splat_as_fresh_ones_do),
		cmocka_unit_test(no_seen_texel_is_a_hole),
		cmocka_unit_test(dense_points_give_the_map_of_scattering),
		cmocka_unit_test(the_papers_splats_have_their_points_depth),
		cmocka_unit_test(lone_points_leave_large_faces_whole),
		cmocka_unit_test(what_misses_a_view_leaves_nothing),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
