/* Density of the points from the eye's resolution (EPR section 4.1.1, eqs 2 and 3; SPEC 2.3), and splitting of triangles
 * too large for one density (SPEC 1.4): s = min(rho f_e / min_r d_r, max_r f_r / d_rt) samples a world unit over the
 * reflectors r that may see the triangle. */
#ifndef TS_KERNELS_DENSITY_H
#define TS_KERNELS_DENSITY_H
#include "closest.h"
#include "visibility.h"

typedef struct {
	ts_arrays scene;
	TS_GLOBAL const ts_face *cubes;
	TS_GLOBAL const ts_view *view;
	TS_GLOBAL const u64 *bits;    /* visibility.bits */
	TS_GLOBAL f32 *whole;         /* split.scale */
	TS_GLOBAL u32 *offset;        /* pieces before each triangle: counts, then their prefix sums */
	TS_GLOBAL ts_piece *pieces;   /* split.triangle */
	TS_GLOBAL f32 *scale;         /* density.scale */
	TS_GLOBAL i64 *n_capped;      /* pieces whose density was lowered at the end of splitting */
	f32 rho;                      /* samples a pixel a side */
	u32 n_cubes, n_words;
	u32 paper, cap, offaxis, split;
} ts_density_args;

#define TS_MAX_SPLITS 12u
#define TS_SPLIT_SAMPLES 65536.0f   /* 2^16 */
#define TS_MOST_SAMPLES 1048576.0f  /* 2^20 */
#define TS_MOST_WIDTH 16384.0f      /* samples along an edge, so that the lattice stays within 2^15 */

/* Shortest way of light from the triangle to the eye by the ball of a reflector. */
TS_FN f32 ts_k_path_length(ts_v3 eye, ts_v3 centre, f32 radius, ts_v3 a, ts_v3 b, ts_v3 c, bool paper)
{
	if (ts_length(ts_sub(eye, centre)) <= radius) return ts_length(ts_sub(eye, ts_k_closest_on_triangle(eye, a, b, c)));
	ts_v3 t = paper ? ts_k_circumcentre(a, b, c) : ts_k_closest_on_triangle(centre, a, b, c);
	ts_v3 cp = t;
	for (u32 step = 0u; step < 2u; step++) {
		ts_v3 near = ts_k_closest_on_segment(centre, t, eye);
		ts_v3 out = ts_sub(near, centre);
		f32 distance = ts_length(out);
		bool meets = distance <= radius;
		if (meets && (paper || step == 1u)) return ts_length(ts_sub(eye, t));
		cp = meets ? near : ts_mad(centre, out, radius / distance);
		if (paper) break;
		if (step == 0u) t = ts_k_closest_on_triangle(cp, a, b, c);
	}
	return ts_length(ts_sub(eye, cp)) + ts_length(ts_sub(cp, t));
}

/* Samples a world unit on triangle a b c, seen by the reflectors of `words`; 0: by none. */
TS_FN f32 ts_k_density(const ts_density_args *args, TS_GLOBAL const u64 *words, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_camera_k view = ts_k_view(args->view);
	f32 shortest = 0.0f;
	f32 densest = 0.0f;
	bool any = false;
	for (u32 r = 0u; r < args->n_cubes; r++) {
		if (ts_k_cube_bits(words, r) == 0u) continue;
		TS_GLOBAL const ts_face *cube = &args->cubes[r];
		ts_v3 centre = ts_load3(cube->centre);
		f32 least = ts_flush(cube->radius * 0.0009765625f);
		f32 way = ts_k_path_length(view.eye, centre, cube->radius, a, b, c, args->paper != 0u);
		if (args->offaxis != 0u) {
			ts_corner p = ts_k_to_view(&view, centre);
			f32 distance = ts_length(ts_sub(centre, view.eye));
			bool ahead = p.z > 0.0f && distance > 0.0f; /* behind the eye there is no pixel to be finer than */
			way = way * ts_clamp(ahead ? p.z / distance : 1.0f, 0.015625f, 1.0f);
		}
		way = ts_max(way, least);
		f32 to_triangle = ts_length(ts_sub(ts_k_closest_on_triangle(centre, a, b, c), centre));
		f32 need = ((f32)cube->n * 0.5f) / ts_max(to_triangle, least);
		shortest = any ? ts_min(shortest, way) : way;
		densest = any ? ts_max(densest, need) : need;
		any = true;
	}
	if (!any) return 0.0f;
	f32 wanted = (args->rho * view.focal) / shortest;
	return args->cap != 0u ? ts_min(wanted, densest) : wanted;
}

typedef struct { ts_v3 v[3]; u32 path; } ts_part;

/* Its longest edge, from corner k to the next; the lowest index on ties. */
TS_FN u32 ts_k_longest_edge(ts_v3 a, ts_v3 b, ts_v3 c, f32 *length)
{
	f32 ab = ts_length(ts_sub(b, a));
	f32 bc = ts_length(ts_sub(c, b));
	f32 ca = ts_length(ts_sub(a, c));
	u32 k = bc > ab ? 1u : 0u;
	f32 longest = bc > ab ? bc : ab;
	k = ca > longest ? 2u : k;
	*length = ca > longest ? ca : longest;
	return k;
}

TS_FN f32 ts_k_area(ts_v3 a, ts_v3 b, ts_v3 c)
{
	return 0.5f * ts_length(ts_cross(ts_sub(b, a), ts_sub(c, a)));
}

/* The child of a bisected part: 0 keeps the edge's first corner, 1 its second. Both neighbours of an edge compute the
 * same midpoint. */
TS_FN ts_part ts_k_child(const ts_part *part, u32 edge, u32 child)
{
	u32 next = edge == 2u ? 0u : edge + 1u;
	ts_part r = *part;
	r.v[child == 0u ? next : edge] = ts_scale(ts_add(part->v[edge], part->v[next]), 0.5f);
	r.path = part->path * 2u + child;
	return r;
}

TS_FN void ts_k_piece_write(const ts_density_args *args, u64 index, u32 triangle, const ts_part *part, f32 s)
{
	TS_GLOBAL ts_piece *out = &args->pieces[index];
	ts_store3(out->a, part->v[0]);
	ts_store3(out->b, part->v[1]);
	ts_store3(out->c, part->v[2]);
	out->triangle = triangle;
	out->path = part->path;
	out->pad = 0u;
	args->scale[index] = ts_put(s);
}

/* What is still too large after the last bisection gets fewer samples, and is counted. */
TS_FN f32 ts_k_density_limit(const ts_density_args *args, f32 s, f32 area, f32 edge)
{
	f32 most = s;
	if ((area * s) * s > TS_MOST_SAMPLES) most = ts_sqrt(TS_MOST_SAMPLES / area);
	if (edge * most > TS_MOST_WIDTH) most = TS_MOST_WIDTH / edge;
	if (most < s) ts_add_i64(args->n_capped, 1);
	return most;
}

/* Walks the bisections of a triangle whose own density is known, children in order; writes the pieces if asked to.
 * Returns their number. */
TS_FN u32 ts_k_split(const ts_density_args *args, u32 triangle, bool write)
{
	TS_GLOBAL const u64 *words = args->bits + (u64)triangle * args->n_words;
	ts_corners t = ts_k_corners(&args->scene, triangle);
	ts_part stack[TS_MAX_SPLITS + 1u];
	u32 n = 1u;
	u32 count = 0u;
	stack[0].v[0] = t.a;
	stack[0].v[1] = t.b;
	stack[0].v[2] = t.c;
	stack[0].path = 1u;
	while (n != 0u) {
		ts_part part = stack[--n];
		f32 s = part.path == 1u ? args->whole[triangle]
		                        : ts_k_density(args, words, part.v[0], part.v[1], part.v[2]);
		f32 length;
		u32 edge = ts_k_longest_edge(part.v[0], part.v[1], part.v[2], &length);
		f32 area = ts_k_area(part.v[0], part.v[1], part.v[2]);
		bool large = (area * s) * s > TS_SPLIT_SAMPLES || length * s > TS_MOST_WIDTH;
		if (large && args->split != 0u && part.path < (1u << TS_MAX_SPLITS)) {
			stack[n++] = ts_k_child(&part, edge, 1u);
			stack[n++] = ts_k_child(&part, edge, 0u);
			continue;
		}
		if (write) {
			u64 index = args->offset[triangle] + count;
			ts_k_piece_write(args, index, triangle, &part, large ? ts_k_density_limit(args, s, area, length) : s);
		}
		count++;
	}
	return count;
}

/* map over triangles: density and number of pieces; none where nobody sees it */
TS_FN void ts_k_split_count_item(const ts_density_args *args, u64 i)
{
	ts_corners t = ts_k_corners(&args->scene, (u32)i);
	args->whole[i] = ts_put(ts_k_density(args, args->bits + i * args->n_words, t.a, t.b, t.c));
	args->offset[i] = args->whole[i] > 0.0f ? ts_k_split(args, (u32)i, false) : 0u;
}

/* emit over triangles */
TS_FN void ts_k_split_item(const ts_density_args *args, u64 i)
{
	if (args->offset[i + 1u] != args->offset[i]) ts_k_split(args, (u32)i, true);
}

#endif
