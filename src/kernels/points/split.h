/* Splitting of triangles that are too large for one density (METHODS 2): a part is bisected while it has more than 2^16
 * samples, or more than 2^14 along an edge; for the watertight rate of iVIR also while some view needs 1.5 times as
 * many samples at one end as at the other (METHODS 9). */
#ifndef TS_KERNELS_POINTS_SPLIT_H
#define TS_KERNELS_POINTS_SPLIT_H
#include "kernels/base/bisect.h"
#include "kernels/points/shadow_density.h"

#define TS_MAX_SPLITS 12u
#define TS_UNEVEN 1.5f
#define TS_UNEVEN_SAMPLES 64.0f    /* parts with fewer samples are not bisected for unevenness */
#define TS_MOST_SAMPLES 1048576.0f /* 2^20 */

/* The density that a part of a triangle needs: for shadows, for off-screen views, or for the eye. */
TS_CALL ts_need ts_k_need(const ts_density_args *args, TS_GLOBAL const u64 *words, ts_v3 a, ts_v3 b, ts_v3 c)
{
	if (args->shadow != TS_SHADOW_NONE) return ts_k_shadow_density(args, words, a, b, c);
	if (args->views != NULL) return ts_k_view_density(args, words, a, b, c);
	ts_need r;
	r.s = ts_k_density(args, words, a, b, c).s;
	r.uneven = 1.0f;
	return r;
}

/* The density that a part needs; that of a whole triangle is known. */
TS_FN ts_need ts_k_part_need(const ts_density_args *args, TS_GLOBAL const u64 *words, u32 triangle, const ts_part *part)
{
	ts_need r;
	r.s = args->whole[triangle];
	r.uneven = 1.0f;
	bool known = part->path == 1u && (args->views == NULL || args->rate != TS_RATE_WATERTIGHT);
	return known ? r : ts_k_need(args, words, part->v[0], part->v[1], part->v[2]);
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

/* Lowers the density of a part that is still too large after the last bisection, and counts the part. */
TS_FN f32 ts_k_density_limit(const ts_density_args *args, f32 s, f32 area, f32 edge)
{
	f32 most = s;
	if ((area * s) * s > TS_MOST_SAMPLES) most = ts_sqrt(TS_MOST_SAMPLES / area);
	if (edge * most > TS_MOST_WIDTH) most = TS_MOST_WIDTH / edge;
	if (most < s) ts_add_i64(args->n_capped, 1);
	return most;
}

/* Walks the bisections of a triangle whose own density is known, children in order; writes the pieces if `write` is
 * true. Returns the number of pieces. */
TS_FN u32 ts_k_split(const ts_density_args *args, u32 triangle, bool write)
{
	TS_GLOBAL const u64 *words = args->bits + (u64)triangle * args->n_words;
	ts_corners t = ts_k_corners(&args->scene, triangle);
	ts_part stack[TS_MAX_SPLITS + 1u];
	u32 n = 1u;
	u32 count = 0u;
	/* Begin with the whole triangle. */
	stack[0].v[0] = t.a;
	stack[0].v[1] = t.b;
	stack[0].v[2] = t.c;
	stack[0].path = 1u;
	while (n != 0u) {
		/* Take the next part: its density, its longest edge and its area. */
		ts_part part = stack[--n];
		ts_need need = ts_k_part_need(args, words, triangle, &part);
		f32 s = need.s;
		f32 length;
		u32 edge = ts_k_longest_edge(part.v[0], part.v[1], part.v[2], &length);
		f32 area = ts_k_area(part.v[0], part.v[1], part.v[2]);
		/* Bisect a part that is too large or uneven; the child pushed last comes first. */
		bool large = (area * s) * s > TS_SPLIT_SAMPLES || length * s > TS_MOST_WIDTH;
		bool uneven = need.uneven > TS_UNEVEN && (area * s) * s > TS_UNEVEN_SAMPLES;
		if ((large || uneven) && args->split != 0u && part.path < (1u << TS_MAX_SPLITS)) {
			stack[n++] = ts_k_child(&part, edge, 1u);
			stack[n++] = ts_k_child(&part, edge, 0u);
			continue;
		}
		/* Write the piece, at a lower density if it is still too large. */
		if (write) {
			u64 index = args->offset[triangle] + count;
			ts_k_piece_write(args, index, triangle, &part, large ? ts_k_density_limit(args, s, area, length) : s);
		}
		count++;
	}
	return count;
}

/* The density of a whole triangle. Counts the triangle if the densest cube limits its density. */
TS_FN f32 ts_k_whole_density(const ts_density_args *args, TS_GLOBAL const u64 *words, ts_v3 a, ts_v3 b, ts_v3 c)
{
	if (args->views != NULL) return ts_k_need(args, words, a, b, c).s;
	ts_eye_density d = ts_k_density(args, words, a, b, c);
	if (d.limited != 0u) ts_add_i64(args->n_limited, 1);
	return d.s;
}

/* map over triangles: density and number of pieces; no pieces if no view sees the triangle */
TS_FN void ts_k_split_count_item(const ts_density_args *args, u64 i)
{
	ts_corners t = ts_k_corners(&args->scene, (u32)i);
	args->whole[i] = ts_put(ts_k_whole_density(args, args->bits + i * args->n_words, t.a, t.b, t.c));
	args->offset[i] = args->whole[i] > 0.0f ? ts_k_split(args, (u32)i, false) : 0u;
}

/* emit over triangles */
TS_FN void ts_k_split_item(const ts_density_args *args, u64 i)
{
	if (args->offset[i + 1u] != args->offset[i]) ts_k_split(args, (u32)i, true);
}

#endif
