/* Limits of a machine: scattered minima and streams of memory; and a bare point renderer, a lower limit of drawing as
 * many points into cubes. */
#include "study/speed_limits.h"
#include <math.h>
#include <stdlib.h>
#include "backends/wide.h"

enum { BLOCK = 64, OFFERS = 1 << 24, STREAM_WORDS = 1 << 24, PASSES = 4 };

/* Texels for a block of offers, and the offers' keys, from a hash of their numbers. */
static void choose(u32 *at, u64 *key, u32 first, u32 n_texels)
{
	for (u32 i = 0; i < BLOCK; i++) {
		u32 hash = (first + i) * 747796405u + 2891336453u;
		hash = (hash ^ hash >> 15) * 277803737u;
		hash ^= hash >> 13;
		at[i] = (u32)((u64)hash * n_texels >> 32);
		key[i] = (u64)(hash * 2246822519u) << 32 | i;
	}
}

/* The next block's texels are prefetched while this one's are lowered. */
TS_WIDE(void, offer, (u64 * texels, u32 n_texels, u32 first, u32 n), (texels, n_texels, first, n))
{
	u32 at[2][BLOCK];
	u64 key[2][BLOCK];
	choose(at[0], key[0], first, n_texels);
	for (u32 i = 0; i < n; i += BLOCK) {
		const u32 *here = at[i / BLOCK % 2], *next = at[(i / BLOCK + 1) % 2];
		const u64 *offered = key[i / BLOCK % 2];
		choose(at[(i / BLOCK + 1) % 2], key[(i / BLOCK + 1) % 2], first + i + BLOCK, n_texels);
		for (u32 k = 0; k < BLOCK; k++) __builtin_prefetch(&texels[next[k]], 1);
		for (u32 k = 0; k < BLOCK; k++) {
			u64 has = texels[here[k]];
			texels[here[k]] = offered[k] < has ? offered[k] : has;
		}
	}
}

ts_status ts_limit_minima(double *a_second, u64 bytes, u32 threads)
{
	u32 n = (u32)(bytes / sizeof(u64));
	u64 *texels = ts_alloc(n, threads * sizeof *texels, "texels to scatter to");
	if (texels == NULL) return TS_ERROR;
	double seconds = 0;
#pragma omp parallel for num_threads((int)threads) schedule(static, 1) reduction(max : seconds)
	for (u32 t = 0; t < threads; t++) {
		u64 *own = texels + (size_t)t * n;
		memset(own, 0xff, n * sizeof *own);
		offer(own, n, 0, OFFERS / 8);
		double begin = ts_seconds();
		offer(own, n, OFFERS, OFFERS);
		seconds = ts_seconds() - begin;
	}
	*a_second = OFFERS / seconds;
	free(texels);
	return TS_OK;
}

TS_WIDE(void, stream, (u64 *restrict to, const u64 *restrict from, u32 n), (to, from, n))
{
	for (u32 i = 0; i < n; i++) to[i] = from[i] + 1;
}

ts_status ts_limit_stream(double *a_second, u32 threads)
{
	u64 *from = ts_alloc_zero(STREAM_WORDS, sizeof *from, "an array to read");
	u64 *to = ts_alloc_zero(STREAM_WORDS, sizeof *to, "an array to write");
	ts_status status = from != NULL && to != NULL ? TS_OK : TS_ERROR;
	u32 each = STREAM_WORDS / threads;
	double begin = 0;
	for (u32 pass = 0; status == TS_OK && pass <= PASSES; pass++) {
		if (pass == 1) begin = ts_seconds();
#pragma omp parallel for num_threads((int)threads) schedule(static, 1)
		for (u32 t = 0; t < threads; t++) stream(to + (size_t)t * each, from + (size_t)t * each, each);
	}
	if (status == TS_OK) *a_second = 2.0 * PASSES * (double)each * threads * sizeof *to / (ts_seconds() - begin);
	free(from);
	free(to);
	return status;
}

enum { POINT_BLOCK = 256 };

static double area_of(const ts_corners *corner) { return 0.5 * (double)ts_length(corner->n); }

static void place(ts_limit_points *points, const ts_corners *corner, u32 triangle, u64 i)
{
	f32 u = (f32)(ts_random((u32)i, 0, 0) >> 8) / 16777216.0f, v = (f32)(ts_random((u32)i, 1, 0) >> 8) / 16777216.0f;
	bool outside = u + v > 1;
	ts_v3 weights = {outside ? u + v - 1 : 1 - u - v, outside ? 1 - u : u, outside ? 1 - v : v};
	ts_v3 p = ts_blend(weights, corner->a, corner->b, corner->c);
	points->x[i] = p.x;
	points->y[i] = p.y;
	points->z[i] = p.z;
	points->triangle[i] = triangle;
}

static ts_status place_all(ts_limit_points *points, const ts_arrays *scene, u64 n)
{
	double area = 0, owed = 0;
	u64 padded = points->n = (n + POINT_BLOCK - 1) / POINT_BLOCK * POINT_BLOCK, placed = 0;
	points->x = ts_alloc_zero(padded, sizeof *points->x, "points");
	points->y = ts_alloc_zero(padded, sizeof *points->y, "points");
	points->z = ts_alloc_zero(padded, sizeof *points->z, "points");
	points->triangle = ts_alloc(padded, sizeof *points->triangle, "points");
	if (points->x == NULL || points->y == NULL || points->z == NULL || points->triangle == NULL) return TS_ERROR;
	memset(points->triangle, 0xff, padded * sizeof *points->triangle);
	for (u32 t = 0; t < scene->n_triangles; t++) {
		ts_corners corner = ts_k_corners(scene, t);
		area += area_of(&corner);
	}
	for (u32 t = 0; t < scene->n_triangles; t++) {
		ts_corners corner = ts_k_corners(scene, t);
		owed += area_of(&corner) / area * (double)n;
		for (; owed >= 0.5 && placed < n; owed--) place(points, &corner, t, placed++);
	}
	return TS_OK;
}

ts_status ts_limit_points_place(ts_limit_points *points, const ts_run *run, u64 n)
{
	ts_arrays scene = ts_run_arrays(run);
	scene.vertices = ts_frame_data(&run->frame, TS_B_pose_vertex);
	points->n_cubes = (u32)ts_frame_n(&run->frame, TS_B_cube_size_face);
	points->cubes = ts_alloc(points->n_cubes, sizeof *points->cubes, "cubes");
	points->texels = ts_alloc(ts_run_n_texels(run, 0, points->n_cubes), sizeof *points->texels, "texels of cubes");
	if (points->cubes == NULL || points->texels == NULL) return TS_ERROR;
	memcpy(points->cubes, ts_frame_data(&run->frame, TS_B_cube_size_face), points->n_cubes * sizeof *points->cubes);
	return place_all(points, &scene, n);
}

/* Texels and keys of a block in a cube: the axis of the greatest coordinate chooses the face. */
static void project(u32 *restrict at, u64 *restrict key, const ts_limit_points *points, u64 first, const ts_face *cube)
{
	const f32 *restrict xs = points->x + first, *restrict ys = points->y + first, *restrict zs = points->z + first;
	const u32 *restrict triangles = points->triangle + first;
	f32 cx = cube->centre[0], cy = cube->centre[1], cz = cube->centre[2];
	f32 half = 0.5f * (f32)cube->n, last = (f32)cube->n - 1;
	i32 side = (i32)cube->n;
	for (u32 i = 0; i < POINT_BLOCK; i++) {
		f32 x = xs[i] - cx, y = ys[i] - cy, z = zs[i] - cz;
		f32 ax = fabsf(x), ay = fabsf(y), az = fabsf(z), d = ax >= ay ? ax : ay;
		f32 m = ax >= ay ? x : y, u = ax >= ay ? z : x, v = ax >= ay ? y : z;
		i32 face = ax >= ay ? 0 : 2;
		m = az > d ? z : m;
		u = az > d ? -x : u;
		v = az > d ? y : v;
		face = az > d ? 4 : face;
		d = az > d ? az : d;
		face += m < 0 ? 1 : 0;
		f32 r = half / (d > 0 ? d : 1), px = u * r + half, py = v * r + half;
		px = px < last ? px : last;
		py = py < last ? py : last;
		at[i] = (u32)((face * side + (i32)py) * side + (i32)px);
		key[i] = triangles[i] == TS_NONE ? ~(u64)0 : (u64)ts_f2u(d) << 32 | triangles[i];
	}
}

TS_WIDE(void, draw_cube, (const ts_limit_points *points, const ts_face *cube), (points, cube))
{
	u32 at[POINT_BLOCK];
	u64 key[POINT_BLOCK], *texels = points->texels + cube->offset;
	memset(texels, 0xff, (u64)6 * cube->n * cube->n * sizeof *texels);
	for (u64 first = 0; first < points->n; first += POINT_BLOCK) {
		project(at, key, points, first, cube);
		for (u32 i = 0; i < POINT_BLOCK; i++) __builtin_prefetch(&texels[at[i]], 1);
		for (u32 i = 0; i < POINT_BLOCK; i++) texels[at[i]] = key[i] < texels[at[i]] ? key[i] : texels[at[i]];
	}
}

void ts_limit_points_draw(const ts_limit_points *points, u32 threads)
{
#pragma omp parallel for num_threads((int)threads) schedule(dynamic, 1)
	for (u32 cube = 0; cube < points->n_cubes; cube++) {
		if (points->cubes[cube].n > 0) draw_cube(points, &points->cubes[cube]);
	}
}

void ts_limit_points_free(ts_limit_points *points)
{
	free(points->x);
	free(points->y);
	free(points->z);
	free(points->triangle);
	free(points->cubes);
	free(points->texels);
	*points = (ts_limit_points){.n = 0};
}
