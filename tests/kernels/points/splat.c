/* Splats: the tiles of a triangle cover every texel whose centre sees it, or every texel that it touches, and nothing
 * beyond their boxes is written; keys; plane depth. */
#include "tests/kernels/points/mesh.h"
#include "tests/whole.h"

static u32 n_cases(void) { return whole_or(3000, 1200); }

/* Right, up and ahead, as the face has them. */
static d3 to_face(const ts_face *cube, u32 face, d3 p)
{
	ts_camera_k view = ts_k_cube_view(cube, face);
	d3 d = d3_sub(p, d3_load(cube->centre));
	return (d3){d3_dot(d, d3_of(view.right)), d3_dot(d, d3_of(view.up)), -d3_dot(d, d3_of(view.back))};
}

/* The ray through the centre of a texel meets the triangle, in front of near: its sides as seen from the eye. */
static bool centre_meets(const ts_face *cube, u32 face, const d3 corner[3], i32 i, i32 j)
{
	double f = cube->n / 2.0, sum = 0, least = INFINITY, most = -INFINITY;
	d3 p[3], ray = {(i + 0.5 - f) / f, (f - j - 0.5) / f, 1};
	for (u32 k = 0; k < 3; k++) p[k] = to_face(cube, face, corner[k]);
	for (u32 k = 0; k < 3; k++) {
		double side = d3_dot(ray, d3_cross(p[k], p[(k + 1) % 3]));
		least = fmin(least, side);
		most = fmax(most, side);
		sum += side;
	}
	return sum != 0 && (least >= 0 || most <= 0) && d3_dot(p[0], d3_cross(p[1], p[2])) / sum > cube->near;
}

/* A texel of a face, grown by `margin` texels, meets the part of the triangle in front of near: clipped in view space,
 * so that nothing needs a projection. *depth: the least axial depth of what is left. */
static bool texel_meets(const ts_face *cube, u32 face, const d3 corner[3], i32 i, i32 j, double margin, double *depth)
{
	double f = cube->n / 2.0, x0 = i - f - margin, x1 = i + 1 - f + margin, y0 = f - j + margin,
		   y1 = f - j - 1 - margin;
	d3_polygon p = {.n = 3};
	for (u32 k = 0; k < 3; k++) p.p[k] = to_face(cube, face, corner[k]);
	p = d3_clip(&p, (d3){0, 0, 1}, -(double)cube->near);
	p = d3_clip(&p, (d3){f, 0, -x0}, 0);
	p = d3_clip(&p, (d3){-f, 0, x1}, 0);
	p = d3_clip(&p, (d3){0, -f, y0}, 0);
	p = d3_clip(&p, (d3){0, f, -y1}, 0);
	*depth = INFINITY;
	for (int k = 0; k < p.n; k++) *depth = fmin(*depth, p.p[k].z);
	return p.n > 0;
}

typedef struct {
	const char *name;
	u32 clip;
	i32 half_size;
	f32 inset;
} splat_case;

static const splat_case plain = {"plain", 1, 129, TS_SPLAT_INSET};

/* Rounding moves the triangle and its tiles by this many texels at this depth. */
static double rounding(const ts_face *cube, double depth) { return 2e-3 + 1e-5 * cube->n / depth; }

/* Texels of one face: each whose centre sees the triangle is written, and if boxes touch, each that it surely meets;
 * with clip, none that it surely misses. `reach`: how far the exact cover may fall short, in world units. */
static void assert_face(const mesh *m, const u64 *texels, u32 face, const splat_case *how, const d3 corner[3],
                        double reach, u32 *n_met)
{
	const ts_face *cube = m->cubes;
	for (i32 j = 0; j < (i32)cube->n; j++) {
		for (i32 i = 0; i < (i32)cube->n; i++) {
			double depth;
			bool written = texels[((u64)face * cube->n + (u32)j) * cube->n + (u32)i] != TS_EMPTY;
			bool may = texel_meets(cube, face, corner, i, j, 0.25, &depth);
			double error = rounding(cube, depth);
			if (written && how->clip != 0) {
				assert_true(may && texel_meets(cube, face, corner, i, j, 3.0 / 512 + error, &depth));
			}
			if (written || !may) continue;
			bool must = reach == 0 && centre_meets(cube, face, corner, i, j);
			error += reach * cube->n / depth;
			if (how->inset == 0 && error <= 0.2)
				must |= texel_meets(cube, face, corner, i, j, -fmin(error, 0.5), &depth);
			if (must) print_error("%s: a hole at %d %d of face %u, random %u\n", how->name, i, j, face, n_random);
			assert_false(must);
		}
	}
	for (u32 k = 0; k < cube->n * cube->n; k++) *n_met += texels[face * cube->n * cube->n + k] != TS_EMPTY;
}

static u64 *splat_all(const mesh *m, const splat_case *how, u32 plane_depth, i64 *writes)
{
	u64 n = mesh_texels(m), *texels = mesh_alloc(n, sizeof *texels);
	memset(texels, 0xff, n * sizeof *texels);
	i64 scatters = 0;
	ts_splat_args args = mesh_splat(m, texels, &scatters, writes);
	args.clip = how->clip;
	args.inset = how->inset;
	args.plane_depth = plane_depth;
	for (u32 i = 0; i < m->n_points; i++) ts_k_splat_item(&args, i);
	return texels;
}

static void assert_tiles(mesh *m, const splat_case *how, const ts_v3 corner[3], u32 *n_met)
{
	d3 c[3] = {d3_of(corner[0]), d3_of(corner[1]), d3_of(corner[2])};
	i64 writes = 0;
	u64 *texels = splat_all(m, how, 0, &writes);
	double reach = how->half_size == 128 ? 1.0 / 128 / m->scale[0] : 0;
	for (u32 face = 0; face < 6; face++) assert_face(m, texels, face, how, c, reach, n_met);
	free(texels);
}

/* Triangles of every sort about a cube: slivers, through the near plane, tiny beside their tiles and much larger. */
static void tiles_cover_every_texel_that_sees_them(void **state)
{
	(void)state;
	static const splat_case cases[] = {
		{"clip, safe", 1, 129, TS_SPLAT_INSET}, {"clip, safe, touched", 1, 129, 0},
		{"box, safe", 0, 129, TS_SPLAT_INSET},  {"clip, exact, touched", 1, 128, 0},
		{"box, exact, touched", 0, 128, 0},
	};
	enum { N_CASES = sizeof cases / sizeof *cases };
	n_random = 0;
	u32 n_met = 0, n_tiny = 0;
	for (u32 i = 0; i < n_cases(); i++) {
		mesh m;
		ts_v3 corner[3];
		mesh_begin(&m);
		mesh_cube(&m, uniform3(-1, 1), uniform_power(0, 6), 4 + random_bits() % 29);
		random_corners(corner, 6, 0.01f, 16);
		f32 samples = uniform_power(-4, 6), length;
		if (is_degenerate(corner)) continue;
		ts_k_longest_edge(corner[0], corner[1], corner[2], &length);
		mesh_triangle(&m, corner[0], corner[1], corner[2], 0, 0);
		mesh_whole(&m, samples / length);
		mesh_points(&m, cases[i % N_CASES].half_size, 0);
		n_tiny += m.points[0].flags;
		assert_tiles(&m, &cases[i % N_CASES], corner, &n_met);
		mesh_clear(&m);
	}
	assert_true(n_met > n_cases() * 8 && n_tiny > n_cases() / 8);
}

/* Room that a texel's centre has beside the box of a point's square, on the worse axis, and what rounding may change of
 * it; negative: the centre is outside. Squares behind near: no room. */
static double room_in_box(const mesh *m, u32 face, const ts_point *point, i32 i, i32 j, double *slack)
{
	const ts_face *cube = m->cubes;
	const ts_align *frame = &m->frames[point->piece];
	double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, f = cube->n / 2.0,
		   half = point->length / 2.0;
	double z = INFINITY, at[2] = {i + 0.5, j + 0.5}, room = INFINITY;
	for (u32 k = 0; k < 4; k++) {
		d3 corner = d3_mad(d3_load(point->centre), d3_load(frame->u), k % 2 != 0 ? half : -half);
		d3 p = to_face(cube, face, d3_mad(corner, d3_load(frame->v), k / 2 != 0 ? half : -half));
		double image[2] = {f + f * p.x / p.z, f - f * p.y / p.z};
		z = fmin(z, p.z);
		for (u32 axis = 0; axis < 2; axis++) {
			low[axis] = fmin(low[axis], image[axis]);
			high[axis] = fmax(high[axis], image[axis]);
		}
	}
	for (u32 axis = 0; axis < 2; axis++) room = fmin(room, fmin(at[axis] - low[axis], high[axis] - at[axis]));
	*slack = 2 * (1.0 / 256 + f * ts_k_piece_slack(&m->pieces[point->piece]) / z);
	return z > cube->near ? room : -INFINITY;
}

/* Without clip the texels whose centres lie in the boxes of points are written, and no others. */
static void texels_with_centres_in_boxes_are_written(void **state)
{
	(void)state;
	static const splat_case how = {"centres", 0, 129, TS_SPLAT_INSET};
	n_random = 0;
	u32 n_in = 0, n_out = 0;
	for (u32 i = 0; i < 400; i++) {
		mesh m;
		i64 writes = 0;
		mesh_begin(&m);
		mesh_cube(&m, uniform3(-1, 1), 0.25f, 8);
		ts_v3 ahead = ts_v3_make(0, 0, uniform(3, 8)), a = ts_add(uniform3(-2, 2), ahead);
		mesh_triangle(&m, a, ts_add(uniform3(-2, 2), ahead), ts_add(uniform3(-2, 2), ahead), 0, 0);
		mesh_whole(&m, uniform_power(-1, 1));
		mesh_points(&m, 129, 0);
		u64 *texels = splat_all(&m, &how, 0, &writes);
		for (u32 k = 0; k < 64 && (m.points[0].flags & TS_POINT_TINY) == 0; k++) {
			bool in = false, near = false, written = texels[4 * 64 + k] != TS_EMPTY;
			for (u32 p = 0; p < m.n_points; p++) {
				double slack, room = room_in_box(&m, 4, &m.points[p], (i32)(k % 8), (i32)(k / 8), &slack);
				in |= room > 0;
				near |= room > -slack;
			}
			assert_true(written ? near : !in);
			n_in += in;
			n_out += !near;
		}
		free(texels);
		mesh_clear(&m);
	}
	assert_true(n_in > 1000 && n_out > 10000);
}

/* All triangles on a grid of half texels before a face of 8 texels, so that squares meet at the centres of texels, here
 * and far from the origin, where coordinates are rounded by more than the margin of 1/256. */
static void no_centre_falls_between_squares(void **state)
{
	(void)state;
	static const f32 shifts[] = {0, 0.3125f, 131072}, densities[] = {0.5f, 1, 3, 5, 6, 7};
	enum { SIDE = 5, GRID = SIDE * SIDE, N_SHIFTS = 3, N_DENSITIES = 6, N_HOW = N_SHIFTS * N_DENSITIES };
	u32 n_met = 0;
	for (u32 of = 0; of < GRID * GRID * GRID * N_HOW; of++) {
		u32 at[3] = {of / N_HOW % GRID, of / N_HOW / GRID % GRID, of / N_HOW / GRID / GRID};
		if (at[0] >= at[1] || at[1] >= at[2]) continue;
		ts_v3 corner[3], shift = ts_v3_make(shifts[of % 3], shifts[of % 3], shifts[of % 3]);
		for (u32 k = 0; k < 3; k++) {
			corner[k] =
				ts_v3_make((f32)(at[k] % SIDE) - 2.0f, (f32)(at[k] / SIDE) - 1.5f, at[0] % 2 != 0 ? 4.0f : 2.03125f);
			corner[k] = ts_add(corner[k], shift);
		}
		if (is_degenerate(corner)) continue;
		mesh m;
		d3 c[3] = {d3_of(corner[0]), d3_of(corner[1]), d3_of(corner[2])};
		mesh_begin(&m);
		mesh_cube(&m, shift, 1, 8);
		mesh_triangle(&m, corner[0], corner[1], corner[2], 0, 0);
		mesh_whole(&m, densities[of / N_SHIFTS % N_DENSITIES]);
		mesh_points(&m, 129, 0);
		i64 writes = 0;
		u64 *texels = splat_all(&m, &plain, 0, &writes);
		for (i32 k = 0; k < 64; k++) {
			if (!centre_meets(m.cubes, 4, c, k % 8, k / 8)) continue;
			n_met++;
			if (texels[4 * 64 + k] == TS_EMPTY) fail_msg("triangle %u: a hole at %d %d", of, k % 8, k / 8);
		}
		free(texels);
		mesh_clear(&m);
	}
	print_message("%u centres\n", n_met);
	assert_true(n_met > 5000);
}

static bool holds(ts_box box, i32 i, i32 j) { return i >= box.x0 && i <= box.x1 && j >= box.y0 && j <= box.y1; }

/* A texel of a face, the face's view, and a point that the texel's centre sees: near the origin, where coordinates are
 * fine and the eye is far, or anywhere. */
typedef struct {
	ts_camera_k view;
	i32 i, j;
	d3 at;
	double pitch; /* of texels there */
} seen_place;

static seen_place random_place(void)
{
	ts_face cube = {.n = 16U << random_bits() % 9, .near = 0.0009765625f};
	u32 face = random_bits() % 6;
	double f = cube.n / 2.0, z = uniform_power(-4, 6);
	seen_place r = {.view = ts_k_cube_view(&cube, face), .pitch = z / f};
	r.i = (i32)(random_bits() % cube.n);
	r.j = (i32)(random_bits() % cube.n);
	d3 way = d3_mad(d3_scale(d3_of(r.view.back), -1), d3_of(r.view.right), (r.i + 0.5 - f) / f);
	way = d3_scale(d3_mad(way, d3_of(r.view.up), (f - r.j - 0.5) / f), z);
	ts_v3 eye = ts_v3_make(-(f32)way.x, -(f32)way.y, -(f32)way.z);
	r.view.eye = random_bits() % 2 != 0 ? eye : ts_scale(uniform3(-1, 1), uniform_power(-2, 12));
	r.at = d3_add(d3_of(r.view.eye), way);
	return r;
}

/* Two squares of a lattice that meet at the centre of a texel, on faces up to the largest: one of them has the texel,
 * unless coordinates are so coarse that the lattice may stand elsewhere. */
static void one_of_two_squares_has_the_texel(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_coarse = 0, n = whole_or(2000000, 200000);
	for (u32 k = 0; k < n; k++) {
		seen_place p = random_place();
		bool held = false, turned = random_bits() % 2 != 0;
		i32 x = (i32)(random_bits() % 64);
		double side = uniform_power(-1, 4) * p.pitch;
		ts_align frame = {.s = (f32)(1 / side)};
		ts_store3(frame.u, turned ? p.view.up : p.view.right);
		ts_store3(frame.v, turned ? p.view.right : p.view.up);
		d3 c = d3_mad(d3_mad(p.at, d3_load(frame.u), -(x + 0.5) * side), d3_load(frame.v), uniform(-0.4f, 0.4f) * side);
		ts_store3(frame.c, ts_v3_make((f32)c.x, (f32)c.y, (f32)c.z));
		ts_piece piece = {.triangle = 0};
		ts_store3(piece.a, ts_k_lattice_point(&frame, 0, 0));
		ts_store3(piece.b, ts_k_lattice_point(&frame, x + 1, 0));
		ts_store3(piece.c, ts_k_lattice_point(&frame, x, 1));
		for (i32 of = x; of <= x + 1; of++) {
			ts_square square = ts_k_square(&piece, &frame, ts_k_lattice_point(&frame, of, 0), 1 / frame.s);
			held |= holds(ts_k_splat_box(&p.view, &square, TS_SPLAT_INSET), p.i, p.j);
		}
		bool is_coarse = 0x1p-20 * d3_length(c) > side;
		if (!held && !is_coarse) fail_msg("pair %u: neither square has texel %d %d", k, p.i, p.j);
		n_coarse += is_coarse;
	}
	assert_true(n_coarse < n / 2);
}

/* Tiles of many texels, their edges along the texels': nothing hides a gap between them. */
static void aligned_tiles_leave_no_gaps(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_met = 0;
	for (u32 i = 0; i < 24; i++) {
		mesh m;
		splat_case how = {"aligned", i % 2, 129, i % 3 == 0 ? 0 : TS_SPLAT_INSET};
		mesh_begin(&m);
		mesh_cube(&m, ts_v3_make(0, 0, 0), 1, 128);
		f32 z = uniform(1, 4), x = uniform(-0.5f, 0);
		ts_v3 corner[3] = {ts_v3_make(x, x, z), ts_v3_make(x + z, x, z), ts_v3_make(x, x + z * uniform(0.2f, 0.9f), z)};
		if (i % 4 < 2) corner[2].x += z * 0.5f;
		mesh_triangle(&m, corner[0], corner[1], corner[2], 0, 0);
		mesh_whole(&m, uniform_power(-2, 3) / z);
		mesh_points(&m, 129, 0);
		i64 writes = 0;
		u64 *texels = splat_all(&m, &how, 0, &writes);
		d3 c[3] = {d3_of(corner[0]), d3_of(corner[1]), d3_of(corner[2])};
		assert_face(&m, texels, 4, &how, c, 0, &n_met);
		free(texels);
		mesh_clear(&m);
	}
	assert_true(n_met > 24 * 500);
}

/* A triangle in pieces: no gap along the cuts either. */
static void a_triangle_in_pieces_has_no_gaps(void **state)
{
	(void)state;
	static const splat_case how = {"pieces", 1, 129, TS_SPLAT_INSET};
	n_random = 0;
	u32 n_met = 0, n_split = 0;
	for (u32 i = 0; i < 12; i++) {
		mesh m;
		ts_v3 corner[3];
		mesh_begin(&m);
		mesh_cube(&m, uniform3(-1, 1), uniform_power(-2, 1), 32);
		for (u32 k = 0; k < 3; k++) corner[k] = uniform3(-24, 24);
		mesh_triangle(&m, corner[0], corner[1], corner[2], 0, 0);
		ts_store3(m.view.eye, uniform3(-2, 2));
		m.view.focal = 512;
		i64 n_capped = 0;
		ts_density_args args = mesh_density(&m, &n_capped, 0.25f);
		args.cap = 0;
		mesh_split(&m, args);
		n_split += m.n_pieces > 1;
		mesh_points(&m, 129, 0);
		if (m.n_points < 1000000) assert_tiles(&m, &how, corner, &n_met);
		mesh_clear(&m);
	}
	assert_true(n_split > 3 && n_met > 4000);
}

/* One key a splat: the distance of the point's centre in its high half, the same in every face; the least one stays. */
static void the_least_key_of_a_splat_stays(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < 300; i++) {
		mesh m;
		splat_case how = {"keys", i % 2, 129, i % 4 < 2 ? 0 : TS_SPLAT_INSET};
		mesh_begin(&m);
		mesh_cube(&m, uniform3(-1, 1), 0.25f, 16);
		for (u32 k = 0; k < 8; k++) {
			ts_v3 corner[3];
			random_corners(corner, 6, 0.1f, 4);
			mesh_triangle(&m, corner[0], corner[1], corner[2], 0, 0);
		}
		mesh_whole(&m, uniform_power(-2, 2));
		mesh_points(&m, 129, 0);
		i64 writes = 0;
		u64 *texels = splat_all(&m, &how, 0, &writes);
		u64 n_written = 0;
		for (u64 k = 0; k < mesh_texels(&m); k++) {
			if (texels[k] == TS_EMPTY) continue;
			n_written++;
			const ts_point *p = &m.points[(u32)texels[k]];
			double d = d3_length(d3_sub(d3_load(p->centre), d3_load(m.cubes->centre)));
			assert_true((u32)texels[k] < m.n_points);
			assert_true(fabs(ts_u2f((u32)(texels[k] >> 32)) - d) <= 1e-6 * d + 1e-7);
		}
		assert_true((u64)writes >= n_written);
		free(texels);
		mesh_clear(&m);
	}
}

/* In any order of the points the same buffer, equal distances to the lowest; each point's texels beat or tie its
 * key. */
static void any_order_gives_the_same_buffer(void **state)
{
	(void)state;
	n_random = 7;
	mesh m;
	mesh_begin(&m);
	mesh_cube(&m, ts_v3_make(0, 0, 0), 0.25f, 32);
	for (u32 k = 0; k < 24; k++) {
		ts_v3 corner[3];
		random_corners(corner, 6, 0.1f, 8);
		for (u32 twice = 0; twice < 2; twice++) mesh_triangle(&m, corner[0], corner[1], corner[2], 0, 0);
	}
	mesh_whole(&m, 1);
	mesh_points(&m, 129, 0);
	i64 writes = 0, scatters = 0;
	u64 *forward = splat_all(&m, &plain, 0, &writes), *back = mesh_alloc(mesh_texels(&m), sizeof *back);
	memset(back, 0xff, mesh_texels(&m) * sizeof *back);
	ts_splat_args args = mesh_splat(&m, back, &scatters, &writes);
	for (u32 i = m.n_points; i-- > 0;) ts_k_splat_item(&args, i);
	assert_memory_equal(forward, back, mesh_texels(&m) * sizeof *back);
	for (u64 k = 0; k < mesh_texels(&m); k++) {
		if (forward[k] != TS_EMPTY) assert_int_equal(m.points[(u32)forward[k]].piece % 2, 0);
	}
	free(forward);
	free(back);
	mesh_clear(&m);
}

/* Only faces whose bit is set are written, and empty cubes not at all. */
static void only_faces_with_their_bit_are_written(void **state)
{
	(void)state;
	for (u32 face = 0; face < 6; face++) {
		mesh m;
		mesh_begin(&m);
		mesh_cube(&m, ts_v3_make(0, 0, 0), 0.25f, 16);
		mesh_cube(&m, ts_v3_make(0, 0, 0), 0.25f, 0);
		mesh_cube(&m, ts_v3_make(0, 0, 0), 0.25f, 16);
		mesh_triangle(&m, ts_v3_make(-90, 1, 2), ts_v3_make(90, 10, 20), ts_v3_make(3, -70, -50), 0, 0);
		m.bits[0] = 1UL << (12 + face);
		mesh_whole(&m, 0.25f);
		mesh_points(&m, 129, 0);
		i64 writes = 0;
		u64 *texels = splat_all(&m, &plain, 0, &writes);
		for (u64 k = 0; k < mesh_texels(&m); k++) {
			if (k / 256 != 6 + face) assert_true(texels[k] == TS_EMPTY);
		}
		free(texels);
		mesh_clear(&m);
	}
}

/* Plane depth: where the texel's ray meets the plane, within a tile of the point's own distance; without it, on a
 * triangle seen at a slant, the nearest point's. */
static void plane_depth_is_where_rays_meet_it(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_free = 0;
	for (u32 i = 0; i < 300; i++) {
		mesh m;
		ts_v3 corner[3];
		mesh_begin(&m);
		ts_face *cube = mesh_cube(&m, uniform3(-1, 1), 0.25f, 16);
		for (u32 k = 0; k < 3; k++) corner[k] = uniform3(-8, 8);
		if (d3_area(d3_of(corner[0]), d3_of(corner[1]), d3_of(corner[2])) < 4) continue;
		mesh_triangle(&m, corner[0], corner[1], corner[2], 0, 0);
		mesh_whole(&m, 1);
		mesh_points(&m, 129, 0);
		i64 writes = 0;
		u64 *texels = splat_all(&m, &plain, 1, &writes);
		d3 n = d3_cross(d3_sub(d3_of(corner[1]), d3_of(corner[0])), d3_sub(d3_of(corner[2]), d3_of(corner[0])));
		for (u32 k = 0; k < 6 * 256; k++) {
			if (texels[k] == TS_EMPTY) continue;
			ts_v3 d = ts_k_cube_direction(k / 256, ((f32)(k % 16) + 0.5f) / 8 - 1, ((f32)(k / 16 % 16) + 0.5f) / 8 - 1);
			double distance = ts_u2f((u32)(texels[k] >> 32)), slope = d3_dot(n, d3_unit(d3_of(d)));
			double own = d3_length(d3_sub(d3_load(m.points[(u32)texels[k]].centre), d3_load(cube->centre)));
			assert_true(fabs(distance - own) <= 1 + 1e-5);
			double met = d3_dot(n, d3_sub(d3_of(corner[0]), d3_load(cube->centre))) / slope;
			assert_true(distance > 0);
			if (met <= 0 && fabs(slope) > 0.05 * d3_length(n)) assert_true(fabs(distance - own) <= 1e-5 * own);
			if (met <= 0 || fabs(distance - own) > 0.999 || fabs(slope) < 0.05 * d3_length(n)) continue;
			n_free++;
			assert_true(fabs(distance - met) <= 1e-4 * (1 + met));
		}
		free(texels);
		mesh_clear(&m);
	}
	assert_true(n_free > 3000);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(tiles_cover_every_texel_that_sees_them),
		cmocka_unit_test(texels_with_centres_in_boxes_are_written),
		cmocka_unit_test(no_centre_falls_between_squares),
		cmocka_unit_test(one_of_two_squares_has_the_texel),
		cmocka_unit_test(aligned_tiles_leave_no_gaps),
		cmocka_unit_test(a_triangle_in_pieces_has_no_gaps),
		cmocka_unit_test(the_least_key_of_a_splat_stays),
		cmocka_unit_test(any_order_gives_the_same_buffer),
		cmocka_unit_test(only_faces_with_their_bit_are_written),
		cmocka_unit_test(plane_depth_is_where_rays_meet_it),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
