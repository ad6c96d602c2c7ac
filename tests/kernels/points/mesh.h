/* What the tests of points and cubes share: random numbers, vectors in double precision, and a small mesh on its way
 * from densities to points. Everything here is independent of the kernels but the chain itself. */
#ifndef TS_TESTS_KERNELS_POINTS_MESH_H
#define TS_TESTS_KERNELS_POINTS_MESH_H
#include "kernels/points/align.h"
#include "kernels/points/cull.h"
#include "kernels/points/splat.h"
#include "kernels/points/split.h"
#include "kernels/raster/cube.h"
#include "tests/model/test.h"

enum { MESH_SEED = 2022, MESH_STREAM = 6, MESH_TRIANGLES = 64, MESH_CUBES = 12 };

static u32 n_random;

static inline u32 random_bits(void) { return ts_random(n_random++, MESH_STREAM, MESH_SEED); }

static inline f32 uniform(f32 low, f32 high) { return low + (high - low) * ts_uniform(random_bits()); }

static inline ts_v3 uniform3(f32 low, f32 high)
{
	f32 x = uniform(low, high), y = uniform(low, high);
	return ts_v3_make(x, y, uniform(low, high));
}

/* 2^x, x uniform. */
static inline f32 uniform_power(f32 low, f32 high) { return (f32)exp2(uniform(low, high)); }

/* Vectors in double precision. */
typedef struct {
	double x, y, z;
} d3;

static inline d3 d3_of(ts_v3 a) { return (d3){a.x, a.y, a.z}; }
static inline d3 d3_load(const f32 *p) { return (d3){p[0], p[1], p[2]}; }
static inline d3 d3_mad(d3 a, d3 b, double s) { return (d3){a.x + b.x * s, a.y + b.y * s, a.z + b.z * s}; }
static inline d3 d3_add(d3 a, d3 b) { return d3_mad(a, b, 1); }
static inline d3 d3_sub(d3 a, d3 b) { return d3_mad(a, b, -1); }
static inline d3 d3_scale(d3 a, double s) { return (d3){a.x * s, a.y * s, a.z * s}; }
static inline double d3_dot(d3 a, d3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline double d3_length(d3 a) { return sqrt(d3_dot(a, a)); }
static inline d3 d3_unit(d3 a) { return d3_scale(a, 1 / d3_length(a)); }
static inline d3 d3_cross(d3 a, d3 b)
{
	return (d3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline double d3_area(d3 a, d3 b, d3 c) { return 0.5 * d3_length(d3_cross(d3_sub(b, a), d3_sub(c, a))); }

/* The nearest point of a segment, and of a triangle: its plane's if that lies inside, else its nearest edge's. */
static inline d3 d3_on_segment(d3 p, d3 a, d3 b)
{
	d3 u = d3_sub(b, a);
	double k = d3_dot(d3_sub(p, a), u) / d3_dot(u, u);
	return d3_mad(a, u, k > 1 ? 1 : k > 0 ? k : 0);
}

static inline d3 d3_on_triangle(d3 p, d3 a, d3 b, d3 c)
{
	d3 corner[3] = {a, b, c}, n = d3_cross(d3_sub(b, a), d3_sub(c, a)), best = a;
	double least = INFINITY;
	bool inside = true;
	for (int k = 0; k < 3; k++) {
		d3 from = corner[k], to = corner[(k + 1) % 3], q = d3_on_segment(p, from, to);
		inside = inside && d3_dot(d3_cross(n, d3_sub(to, from)), d3_sub(p, from)) >= 0;
		if (d3_length(d3_sub(p, q)) < least) best = q;
		least = fmin(least, d3_length(d3_sub(p, q)));
	}
	return inside ? d3_mad(p, n, d3_dot(d3_sub(a, p), n) / d3_dot(n, n)) : best;
}

/* A convex polygon and a half space. */
typedef struct {
	d3 p[12];
	int n;
} d3_polygon;

static inline d3_polygon d3_clip(const d3_polygon *polygon, d3 normal, double d)
{
	d3_polygon r = {.n = 0};
	for (int i = 0; i < polygon->n; i++) {
		d3 p = polygon->p[i], q = polygon->p[(i + 1) % polygon->n];
		double dp = d3_dot(normal, p) + d, dq = d3_dot(normal, q) + d;
		if (dp >= 0) r.p[r.n++] = p;
		if ((dp >= 0) != (dq >= 0)) r.p[r.n++] = d3_mad(p, d3_sub(q, p), dp / (dp - dq));
	}
	return r;
}

/* A mesh, seen by an eye and by cubes. Every triangle has corners of its own. Materials: 0 one-sided, 1 two-sided,
 * 2 masked away, 3 masked but there, 4 masked by a texture that is clear where u < 1/2. Object 1 + r is reflector r. */
typedef struct {
	ts_vertex vertices[MESH_TRIANGLES * 3];
	ts_triangle triangles[MESH_TRIANGLES];
	ts_material materials[5];
	ts_object objects[1 + MESH_CUBES];
	ts_slot slot;
	ts_image image;
	u64 texels[4];
	ts_face cubes[MESH_CUBES];
	ts_view view;
	u64 bits[MESH_TRIANGLES * 2]; /* n_words = 2 */
	u32 n_triangles, n_cubes;
	i64 n_limited;
	/* From here on: what the chain makes. */
	u32 n_pieces, n_points;
	u32 *count;
	ts_piece *pieces;
	f32 *scale;
	u32 *keep;
	ts_align *frames;
	u64 *keys;
	ts_point *points;
} mesh;

static inline void mesh_begin(mesh *m)
{
	memset(m, 0, sizeof *m);
	for (u32 i = 0; i < 5; i++) {
		m->materials[i] = (ts_material){.base = {1, 1, 1, i == 2 ? 0.25f : 1},
		                                .roughness = 1,
		                                .alpha_cutoff = 0.5f,
		                                .slot = {TS_NONE, TS_NONE, TS_NONE, TS_NONE, TS_NONE}};
		m->materials[i].flags = i == 1 ? TS_DOUBLE_SIDED : i > 1 ? TS_MASKED : 0;
	}
	m->materials[4].slot[0] = 0;
	m->texels[0] = 0x0000ffffffffffffUL;
	m->texels[1] = 0xffffffffffffffffUL;
	m->texels[2] = 0x8000ffffffffffffUL;
	m->image = (ts_image){.width = 2, .height = 1, .n_levels = 2};
	m->slot = (ts_slot){.wrap = {TS_CLAMP, TS_CLAMP}, .transform = {1, 0, 0, 0, 1, 0}};
	for (u32 i = 0; i <= MESH_CUBES; i++) m->objects[i].reflector = i - 1;
	m->view = (ts_view){.focal = 256,
	                    .right = {1, 0, 0},
	                    .width = 512,
	                    .up = {0, 1, 0},
	                    .height = 512,
	                    .back = {0, 0, 1},
	                    .near = 0.0009765625f};
}

static inline ts_arrays mesh_arrays(const mesh *m)
{
	return (ts_arrays){.vertices = m->vertices,
	                   .triangles = m->triangles,
	                   .materials = m->materials,
	                   .slots = &m->slot,
	                   .images = &m->image,
	                   .texels = m->texels,
	                   .objects = m->objects,
	                   .n_triangles = m->n_triangles,
	                   .ambient = 1};
}

/* Seen in every face of every cube. uv: (0,0), (1,0), (1,1). */
static inline u32 mesh_triangle(mesh *m, ts_v3 a, ts_v3 b, ts_v3 c, u32 material, u32 object)
{
	u32 t = m->n_triangles++;
	ts_v3 corner[3] = {a, b, c};
	for (u32 k = 0; k < 3; k++) {
		ts_vertex v = {.object = object, .uv = {k > 0, k > 1, 0, 0}, .colour = {1, 1, 1, 1}};
		ts_store3(v.position, corner[k]);
		m->vertices[t * 3 + k] = v;
	}
	m->triangles[t] = (ts_triangle){{t * 3, t * 3 + 1, t * 3 + 2}, material};
	m->bits[t * 2] = m->n_cubes * 6 >= 64 ? UINT64_MAX : (1UL << m->n_cubes * 6) - 1;
	m->bits[t * 2 + 1] = m->n_cubes * 6 > 64 ? (1UL << (m->n_cubes * 6 - 64)) - 1 : 0;
	return t;
}

static inline ts_face *mesh_cube(mesh *m, ts_v3 centre, f32 radius, u32 n)
{
	ts_face *before = m->n_cubes != 0 ? &m->cubes[m->n_cubes - 1] : NULL, *cube = &m->cubes[m->n_cubes++];
	*cube = (ts_face){.radius = radius, .n = n, .near = radius * 0.0009765625f, .object = m->n_cubes};
	ts_store3(cube->centre, centre);
	cube->offset = before != NULL ? before->offset + (u64)6 * before->n * before->n : 0;
	return cube;
}

static inline u64 mesh_texels(const mesh *m)
{
	const ts_face *last = &m->cubes[m->n_cubes - 1];
	return last->offset + (u64)6 * last->n * last->n;
}

static inline void *mesh_alloc(size_t n, size_t size)
{
	void *r = calloc(n + 1, size);
	assert_non_null(r);
	return r;
}

static inline u32 mesh_scan(u32 *counts, u32 n)
{
	u32 sum = 0;
	for (u32 i = 0; i <= n; i++) {
		u32 count = i < n ? counts[i] : 0;
		counts[i] = sum;
		sum += count;
	}
	return sum;
}

static inline ts_density_args mesh_density(mesh *m, i64 *n_capped, f32 rho)
{
	return (ts_density_args){.scene = mesh_arrays(m),
	                         .cubes = m->cubes,
	                         .view = &m->view,
	                         .bits = m->bits,
	                         .n_capped = n_capped,
	                         .n_limited = &m->n_limited,
	                         .rho = rho,
	                         .n_cubes = m->n_cubes,
	                         .n_words = 2,
	                         .cap = 1,
	                         .split = 1};
}

/* One piece a triangle, all with density s. */
static inline void mesh_whole(mesh *m, f32 s)
{
	m->n_pieces = m->n_triangles;
	m->pieces = mesh_alloc(m->n_pieces, sizeof *m->pieces);
	m->scale = mesh_alloc(m->n_pieces, sizeof *m->scale);
	for (u32 t = 0; t < m->n_triangles; t++) {
		ts_piece *p = &m->pieces[t];
		*p = (ts_piece){.triangle = t, .path = 1};
		memcpy(p->a, m->vertices[t * 3].position, sizeof p->a);
		memcpy(p->b, m->vertices[t * 3 + 1].position, sizeof p->b);
		memcpy(p->c, m->vertices[t * 3 + 2].position, sizeof p->c);
		m->scale[t] = s;
	}
}

/* Pieces as the split kernel makes them. */
static inline void mesh_split(mesh *m, ts_density_args args)
{
	args.whole = mesh_alloc(m->n_triangles, sizeof *args.whole);
	args.offset = mesh_alloc(m->n_triangles + 1, sizeof *args.offset);
	for (u32 t = 0; t < m->n_triangles; t++) ts_k_split_count_item(&args, t);
	m->n_pieces = mesh_scan(args.offset, m->n_triangles);
	m->pieces = args.pieces = mesh_alloc(m->n_pieces, sizeof *m->pieces);
	m->scale = args.scale = mesh_alloc(m->n_pieces, sizeof *m->scale);
	for (u32 t = 0; t < m->n_triangles; t++) ts_k_split_item(&args, t);
	free(args.whole);
	free(args.offset);
}

static inline void mesh_align(mesh *m)
{
	m->keep = mesh_alloc(m->n_pieces, sizeof *m->keep);
	m->frames = mesh_alloc(m->n_pieces, sizeof *m->frames);
	ts_align_args align = {.pieces = m->pieces, .scale = m->scale, .keep = m->keep, .frames = m->frames};
	for (u32 i = 0; i < m->n_pieces; i++) {
		m->keep[i] = m->scale[i] > 0;
		ts_k_align_item(&align, i);
	}
}

/* From pieces to points; what is set of `args` stays. */
static inline void mesh_make_points(mesh *m, ts_points_args args)
{
	mesh_align(m);
	m->count = mesh_alloc(m->n_pieces + 1, sizeof *m->count);
	args.scene = mesh_arrays(m);
	args.pieces = m->pieces;
	args.frames = m->frames;
	args.offset = m->count;
	for (u32 i = 0; i < m->n_pieces; i++) ts_k_points_count_item(&args, i);
	m->n_points = mesh_scan(m->count, m->n_pieces);
	args.room = m->n_points;
	m->keys = args.keys = mesh_alloc(m->n_points, sizeof *m->keys);
	m->points = args.points = mesh_alloc(m->n_points, sizeof *m->points);
	for (u32 i = 0; i < m->n_pieces; i++) ts_k_points_item(&args, i);
}

static inline void mesh_points(mesh *m, i32 half_size, u32 paper_splat)
{
	mesh_make_points(m, (ts_points_args){.half_size = half_size, .paper_splat = paper_splat});
}

/* The mesh is there again as before the chain. */
static inline void mesh_clear(mesh *m)
{
	free(m->count);
	free(m->pieces);
	free(m->scale);
	free(m->keep);
	free(m->frames);
	free(m->keys);
	free(m->points);
	m->count = m->keep = NULL;
	m->pieces = NULL;
	m->scale = NULL;
	m->frames = NULL;
	m->keys = NULL;
	m->points = NULL;
	m->n_pieces = m->n_points = 0;
}

static inline ts_splat_args mesh_splat(const mesh *m, u64 *texels, i64 *n_scatters, i64 *n_writes)
{
	return (ts_splat_args){.from = {.pieces = m->pieces, .frames = m->frames, .points = m->points},
	                       .cubes = m->cubes,
	                       .bits = m->bits,
	                       .texels = texels,
	                       .n_scatters = n_scatters,
	                       .n_writes = n_writes,
	                       .n_cubes = m->n_cubes,
	                       .n_words = 2,
	                       .clip = 1,
	                       .inset = TS_SPLAT_INSET};
}

/* A triangle of every sort: plump, sliver, far from equal edges, tiny or large, anywhere about the origin. */
static inline void random_corners(ts_v3 corner[3], f32 reach, f32 least_size, f32 most_size)
{
	ts_v3 middle = uniform3(-reach, reach);
	f32 size = uniform_power((f32)log2(least_size), (f32)log2(most_size));
	for (u32 k = 0; k < 3; k++) corner[k] = ts_mad(middle, uniform3(-1, 1), size);
	u32 sort = random_bits() % 4;
	if (sort == 0) {
		ts_v3 between = ts_mad(corner[0], ts_sub(corner[1], corner[0]), uniform(0, 1));
		corner[2] = ts_mad(between, uniform3(-1, 1), size / 512);
	}
	if (sort == 1) corner[2] = ts_mad(corner[1], uniform3(-1, 1), size / 64);
}

static inline bool is_degenerate(const ts_v3 corner[3])
{
	return ts_k_is_degenerate(ts_cross(ts_sub(corner[1], corner[0]), ts_sub(corner[2], corner[0])));
}

#endif
