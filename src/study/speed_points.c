/* A bare point renderer: a lower limit of drawing as many points into cubes. */
#include <math.h>
#include <stdlib.h>
#include "backends/wide.h"
#include "study/speed_limits.h"

enum { BLOCK = 256 };

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
	u64 padded = points->n = (n + BLOCK - 1) / BLOCK * BLOCK, placed = 0;
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
	for (u32 i = 0; i < BLOCK; i++) {
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
	u32 at[BLOCK];
	u64 key[BLOCK], *texels = points->texels + cube->offset;
	memset(texels, 0xff, (u64)6 * cube->n * cube->n * sizeof *texels);
	for (u64 first = 0; first < points->n; first += BLOCK) {
		project(at, key, points, first, cube);
		for (u32 i = 0; i < BLOCK; i++) __builtin_prefetch(&texels[at[i]], 1);
		for (u32 i = 0; i < BLOCK; i++) texels[at[i]] = key[i] < texels[at[i]] ? key[i] : texels[at[i]];
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
