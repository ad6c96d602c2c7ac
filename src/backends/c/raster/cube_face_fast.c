/* Fast path of MVR's cube faces, with the same bits. Triangles are read once per cube: the axes of its faces are the
 * world's except for sign and order, so six sums per corner show which faces a triangle is outside of, as in
 * ts_k_is_outside. Each thread draws into its own texels, and the smallest are kept; there are fewer threads where
 * these texels would be too many. */
#include <omp.h>
#include <stdlib.h>
#include "backends/c/raster/draw_batch.h"
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/raster/cube_face.h"

enum {
	TRIANGLES = TS_DRAW_TRIANGLES,
	LANES = TS_DRAW_LANES,
	BLOCKS_A_CHUNK = 8,
	PART = 1 << 12,
	MOST_COPIED = 1 << 25
};

/* Which faces may show the triangles of a block. */
typedef struct {
	u32 faces[TRIANGLES];
	ts_draw_corners corners; /* from the cube's centre */
} sight;

/* What a thread works with. */
typedef struct {
	u64 *texels;
	ts_row row[6][3]; /* right, up, ahead */
	ts_draw_batch batch[6];
	ts_draw_block block;
	sight sight;
} worker;

/* For x + y and x - y of a corner, or of all corners: bits 0 and 1, is below 0; bits 2 and 3, is above. */
static inline u32 sides(f32 x, f32 y)
{
	f32 sum = x + y, difference = x - y;
	u32 below = ts_draw_is_below(sum) | ts_draw_is_below(difference) << 1;
	return below | ts_draw_is_above(sum) << 2 | ts_draw_is_above(difference) << 3;
}

static inline u32 corner_behind(f32 x, f32 y, f32 z, f32 half_size, f32 near)
{
	f32 hx = half_size * x, hy = half_size * y, hz = half_size * z;
	u32 behind = ts_draw_is_below(x - near) | ts_draw_is_below(-x - near) << 1 | ts_draw_is_below(y - near) << 2;
	behind |= ts_draw_is_below(-y - near) << 3 | ts_draw_is_below(z - near) << 4 | ts_draw_is_below(-z - near) << 5;
	return behind | sides(hx, hy) << 6 | sides(hx, hz) << 10 | sides(hy, hz) << 14;
}

/* Planes that all corners are behind, as faces that do not show the triangle. */
static inline u32 faces_outside(u32 behind)
{
	u32 xy = behind >> 6, xz = behind >> 10, yz = behind >> 14;
	u32 px = xy | xy >> 1 | xz | xz >> 1;           /* x + y, x - y, x + z, x - z < 0 */
	u32 nx = xy >> 2 | xy >> 3 | xz >> 2 | xz >> 3; /* > 0 */
	u32 py = xy | xy >> 3 | yz | yz >> 1;
	u32 ny = xy >> 2 | xy >> 1 | yz >> 2 | yz >> 3;
	u32 pz = xz | xz >> 3 | yz | yz >> 3;
	u32 nz = xz >> 2 | xz >> 1 | yz >> 2 | yz >> 1;
	u32 sides = (px & 1u) | (nx & 1u) << 1 | (py & 1u) << 2 | (ny & 1u) << 3 | (pz & 1u) << 4 | (nz & 1u) << 5;
	return sides | (behind & 63u);
}

TS_WIDE(void, see_faces,
        (sight *restrict to, const ts_draw_block *restrict b, ts_v3 centre, f32 half_size, f32 near, u32 object),
        (to, b, centre, half_size, near, object))
{
	u32 n = (b->n + LANES - 1) / LANES * LANES;
	for (u32 i = 0; i < n; i++) {
		ts_v3 p = ts_draw_corner(&b->corners, 0, i), q = ts_draw_corner(&b->corners, 1, i);
		ts_v3 r = ts_draw_corner(&b->corners, 2, i);
		ts_v3 normal = ts_cross(ts_sub(q, p), ts_sub(r, p));
		u32 shown = ts_draw_is_above(ts_dot(normal, normal));
		u32 facing = ts_draw_is_above(ts_dot(normal, ts_sub(centre, p)));
		shown &= (facing | b->two_sided[i]) & (b->object[i] != object ? 1u : 0u);
		ts_v3 dp = ts_sub(p, centre), dq = ts_sub(q, centre), dr = ts_sub(r, centre);
		u32 behind = corner_behind(dp.x, dp.y, dp.z, half_size, near);
		behind &= corner_behind(dq.x, dq.y, dq.z, half_size, near);
		behind &= corner_behind(dr.x, dr.y, dr.z, half_size, near);
		to->faces[i] = (faces_outside(behind) ^ 63u) & (0u - shown);
		ts_draw_set_corner(&to->corners, 0, i, dp.x, dp.y, dp.z);
		ts_draw_set_corner(&to->corners, 1, i, dq.x, dq.y, dq.z);
		ts_draw_set_corner(&to->corners, 2, i, dr.x, dr.y, dr.z);
	}
}

static void draw_block(worker *w, const ts_arrays *scene, const ts_face *cube, u32 first, u32 n)
{
	ts_draw_block_read(&w->block, scene, first, n);
	see_faces(&w->sight, &w->block, ts_load3(cube->centre), (f32)cube->n * 0.5f, cube->near, cube->object);
	for (u32 k = 0; k < n; k++) {
		for (u32 faces = w->sight.faces[k]; faces != 0; faces &= faces - 1) {
			u32 face = (u32)__builtin_ctz(faces);
			ts_draw_add(&w->batch[face], &w->block, k, &w->sight.corners, w->row[face]);
		}
	}
}

static void begin(worker *w, const ts_arrays *scene, const ts_face *cube)
{
	for (u32 face = 0; face < 6; face++) {
		ts_draw_batch *b = &w->batch[face];
		b->scene = scene;
		b->view = ts_k_cube_view(cube, face);
		b->target = ts_k_keys(w->texels + (u64)face * cube->n * cube->n);
		b->owned = ts_k_view_box(&b->view);
		b->n = 0;
		w->row[face][0] = ts_k_row(b->view.right);
		w->row[face][1] = ts_k_row(b->view.up);
		w->row[face][2] = ts_k_row(ts_neg(b->view.back));
	}
}

TS_WIDE(void, keep_least_keys, (u64 *restrict to, const u64 *restrict from, u64 n), (to, from, n))
{
	for (u64 i = 0; i < n; i++) to[i] = from[i] < to[i] ? from[i] : to[i];
}

/* The first thread's texels are the cube's. */
static void draw_cube(worker *w, u32 n_workers, const ts_arrays *scene, const ts_face *cube, u64 n_texels,
                      ts_stop *stop)
{
	worker *own = &w[omp_get_thread_num()];
	i64 n_blocks = (i64)((scene->n_triangles + TRIANGLES - 1) / TRIANGLES);
	if (own != w) memset(own->texels, 0xff, n_texels * sizeof *own->texels);
	begin(own, scene, cube);
#pragma omp for schedule(dynamic, BLOCKS_A_CHUNK) nowait
	for (i64 block = 0; block < n_blocks; block++) {
		if (ts_stopped(stop)) continue;
		u32 first = (u32)block * TRIANGLES, left = scene->n_triangles - first;
		draw_block(own, scene, cube, first, left < TRIANGLES ? left : TRIANGLES);
	}
	for (u32 face = 0; face < 6; face++) ts_draw_flush(&own->batch[face]);
#pragma omp barrier
#pragma omp for schedule(static)
	for (i64 at = 0; at < (i64)n_texels; at += PART) {
		u64 n = n_texels - (u64)at < PART ? n_texels - (u64)at : PART;
		for (u32 k = 1; k < n_workers; k++) keep_least_keys(w[0].texels + at, w[k].texels + at, n);
	}
}

static u64 cube_texels(const ts_face *cube) { return 6 * (u64)cube->n * cube->n; }

static void draw_cubes(const ts_cube_face_args *args, worker *w, u32 n_workers)
{
	const ts_face *cubes = args->cubes + args->first_cube;
	ts_stop *stop = ts_stop_here();
	for (u32 r = 0; r < args->n_cubes; r++) {
		if (cubes[r].n == 0) continue;
		w[0].texels = args->texels + (cubes[r].offset - cubes[0].offset);
#pragma omp parallel num_threads(n_workers)
		draw_cube(w, n_workers, &args->scene, &cubes[r], cube_texels(&cubes[r]), stop);
	}
}

bool ts_c_fast_cube_face(const void *of, u64 n, u32 threads)
{
	const ts_cube_face_args *args = of;
	u64 most = 1;
	(void)n;
	for (u32 r = 0; r < args->n_cubes; r++) {
		u64 texels = cube_texels(&args->cubes[args->first_cube + r]);
		most = texels > most ? texels : most;
	}
	u64 copies = threads - 1 < MOST_COPIED / most ? threads - 1 : MOST_COPIED / most;
	worker *w = malloc((copies + 1) * sizeof *w);
	u64 *texels = copies > 0 ? malloc(copies * most * sizeof *texels) : NULL;
	bool made = w != NULL && (copies == 0 || texels != NULL);
	for (u64 k = 1; made && k <= copies; k++) w[k].texels = texels + (k - 1) * most;
	if (made) draw_cubes(args, w, (u32)copies + 1);
	free(texels);
	free(w);
	return made;
}

#include "backends/selftest.h"
