/* Brings the rows of composites into the domain of their functions: shares, directions, frames, triangles without area,
 * and values at which a function branches. Values are stored as kernels store them, so that ranges hold. */
#ifndef TS_VECTORS_RELATE_H
#define TS_VECTORS_RELATE_H
#include "kernels/base/hit.h"
#include "kernels/raster/patch.h"
#include "vectors/row.h"

/* Columns: places and lengths near each other; values that are only divided or multiplied; parts of 1; directions. */
/* clang-format off */
#define NEAR(name, count) { name, TS_VECTOR_F32, count, 119, 131, true }
#define LENGTH(name, count) { name, TS_VECTOR_F32, count, 119, 131, false }
#define SHARE(name, count) { name, TS_VECTOR_F32, count, 119, 127, false }
#define UNIT(name) { name, TS_VECTOR_F32, 3, 88, 127, true }
/* clang-format on */
#define FLAG(name) UNSIGNED(name, 1, 0, 1)
#define ZERO(name, count) UNSIGNED(name, count, 0, 0)
#define ANY_INDEX(name, count) UNSIGNED(name, count, 0, UINT32_MAX) /* without effect on the result */

/* One more random number. */
static inline u32 ts_more(u32 *random) { return *random = ts_pcg(*random + 1); }
static inline bool ts_once_in(u32 *random, u32 n) { return (ts_more(random) >> 8) % n == 0; }

static inline void ts_relate_f32(u32 *at, f32 x) { at[0] = ts_f2u(ts_san(x)); }
static inline void ts_relate_v3(u32 *at, ts_v3 a)
{
	ts_relate_f32(at, a.x);
	ts_relate_f32(at + 1, a.y);
	ts_relate_f32(at + 2, a.z);
}
/* Stores a vector clamped to the range of NEAR, for values computed from other columns. */
static inline void ts_relate_near(u32 *at, ts_v3 a)
{
	const f32 of[3] = {a.x, a.y, a.z};
	for (u32 k = 0; k < 3; k++) at[k] = ts_f2u(ts_abs(of[k]) < 0.00390625f ? 0 : ts_clamp(of[k], -31, 31));
}

/* Maps n numbers from [0, 2) to [0, 1], with 1 among the results. */
static inline void ts_relate_shares(u32 *at, u32 n)
{
	for (u32 k = 0; k < n; k++) ts_relate_f32(at + k, ts_min(ts_u2f(at[k]), 1.0f));
}

/* Makes three weights, none below 0, of sum 1. */
static inline void ts_relate_weights(u32 *at)
{
	ts_relate_v3(at, ts_k_hit_weights(ts_u2f(at[0]), ts_u2f(at[1]), ts_u2f(at[2])));
}

/* Makes a vector unit length; a zero vector becomes +z. */
static inline ts_v3 ts_relate_unit(u32 *at)
{
	ts_v3 n = ts_normalize(ts_row_v3(at, 0));
	if (!(ts_length(n) > 0)) n = ts_v3_make(0, 0, 1);
	ts_relate_v3(at, n);
	return ts_row_v3(at, 0);
}

/* Makes a unit vector at a right angle to n, which is unit length. */
static inline ts_v3 ts_relate_across(u32 *at, ts_v3 n)
{
	ts_v3 v = ts_row_v3(at, 0);
	ts_v3 across = ts_mad(v, n, -ts_dot(n, v));
	if (!(ts_length(across) > 0.0625f * ts_length(v))) across = ts_k_across(n);
	ts_relate_v3(at, ts_normalize(across));
	return ts_row_v3(at, 0);
}

/* A ts_view's columns, of images up to 4096 pixels a side, and of half to twice their size as focal length. */
/* clang-format off */
#define VIEW(name) NEAR(name ".eye", 3), POSITIVE(name ".focal", 1, 126, 140), UNIT(name ".right"), \
	UNSIGNED(name ".width", 1, 1, 4096), UNIT(name ".up"), UNSIGNED(name ".height", 1, 1, 4096), UNIT(name ".back"), \
	POSITIVE(name ".near", 1, 117, 127)
/* clang-format on */
enum {
	TS_VIEW_FOCAL = 3,
	TS_VIEW_RIGHT = 4,
	TS_VIEW_WIDTH = 7,
	TS_VIEW_UP = 8,
	TS_VIEW_HEIGHT = 11,
	TS_VIEW_BACK = 12,
	TS_VIEW_NEAR = 15,
	TS_VIEW_WORDS = 16,
};

/* Makes the axes of a view orthogonal, and its focal length and near plane not 0. */
static inline void ts_relate_view(u32 *view)
{
	ts_v3 back = ts_relate_unit(view + TS_VIEW_BACK);
	ts_v3 right = ts_relate_across(view + TS_VIEW_RIGHT, back);
	ts_relate_v3(view + TS_VIEW_UP, ts_cross(back, right));
	if (view[TS_VIEW_FOCAL] == 0) ts_relate_f32(view + TS_VIEW_FOCAL, 0.5f * (f32)view[TS_VIEW_WIDTH]);
	if (view[TS_VIEW_NEAR] == 0) ts_relate_f32(view + TS_VIEW_NEAR, 0.0009765625f);
}

/* Relates the three corners of a triangle: now and then two in one place, all on a line, or two edges of the same
 * length. */
static inline void ts_relate_triangle(u32 *a, u32 *b, u32 *c, u32 *random)
{
	ts_v3 pa = ts_row_v3(a, 0), ab = ts_sub(ts_row_v3(b, 0), pa);
	u32 k = (ts_more(random) >> 8) % 32;
	if (k == 0) memcpy(b, a, 3 * sizeof *a);
	if (k == 1) memcpy(c, b, 3 * sizeof *b);
	if (k == 2) ts_relate_near(c, ts_mad(pa, ab, 2));
	if (k == 3) ts_relate_near(c, ts_add(pa, ts_v3_make(-ab.x, ab.y, ab.z)));
	if (k == 4) ts_relate_near(c, ts_add(pa, ts_v3_make(ab.y, -ab.x, ab.z)));
	if (k == 5) memcpy(b, a, 3 * sizeof *a), memcpy(c, a, 3 * sizeof *a);
}

/* Gives a triangle an area: corners b and c beside a, along two axes. */
static inline void ts_relate_area(u32 *a, u32 *b, u32 *c)
{
	ts_v3 pa = ts_row_v3(a, 0), n = ts_cross(ts_sub(ts_row_v3(b, 0), pa), ts_sub(ts_row_v3(c, 0), pa));
	if (!ts_k_is_degenerate(n)) return;
	ts_relate_near(b, ts_sub(pa, ts_v3_make(pa.x < 0 ? -1 : 1, 0, 0)));
	ts_relate_near(c, ts_sub(pa, ts_v3_make(0, pa.y < 0 ? -1 : 1, 0)));
}

/* A ts_piece's columns. */
/* clang-format off */
#define PIECE(name) NEAR(name ".a", 3), ALL_U32(name ".triangle", 1), NEAR(name ".b", 3), ALL_U32(name ".path", 1), \
	NEAR(name ".c", 3), ZERO(name ".pad", 1)
/* clang-format on */

static inline void ts_relate_piece(u32 *piece, u32 *random) { ts_relate_triangle(piece, piece + 4, piece + 8, random); }

/* A ts_light's columns: a unit direction, a cone that is no wider inside than outside. */
/* clang-format off */
#define LIGHT(name) NEAR(name ".position", 3), UNSIGNED(name ".kind", 1, 0, 2), UNIT(name ".direction"), \
	LENGTH(name ".range", 1), LENGTH(name ".intensity", 3), POSITIVE(name ".spot_scale", 1, 127, 134), \
	{ name ".spot_offset", TS_VECTOR_F32, 1, 88, 134, true }, ZERO(name ".pad", 3)
/* clang-format on */
enum { TS_LIGHT_DIRECTION = 4, TS_LIGHT_RANGE = 7, TS_LIGHT_SCALE = 11, TS_LIGHT_OFFSET = 12, TS_LIGHT_WORDS = 16 };

/* Relates a light: in half of the rows without a range, and in half turned to p. */
static inline void ts_relate_light(u32 *light, ts_v3 p, u32 *random)
{
	ts_v3 way = ts_sub(p, ts_row_v3(light, 0)), d = ts_relate_unit(light + TS_LIGHT_DIRECTION);
	if (ts_once_in(random, 2)) light[TS_LIGHT_RANGE] = 0;
	if (ts_once_in(random, 2)) ts_relate_v3(light + TS_LIGHT_DIRECTION, ts_mad(ts_normalize(way), d, 0.25f));
	ts_relate_unit(light + TS_LIGHT_DIRECTION);
	if (light[TS_LIGHT_SCALE] == 0) ts_relate_f32(light + TS_LIGHT_SCALE, 1);
	f32 outer = ts_uniform(ts_more(random));
	ts_relate_f32(light + TS_LIGHT_OFFSET, -outer * ts_u2f(light[TS_LIGHT_SCALE]));
}

#endif
