/* Margins of shadow_map.h, for ports that round or snap otherwise (PORTING 7): a second pass, which changes no
 * decision. One step is 1/256 texel of the map, plus the distance that the receiver moves in the map if the
 * eye's pixel moves by 1/256. The margins assume that depths of the map change as the receiver's surface does. margin.h
 * judges the maps themselves and the eye's triangle. */
#ifndef TS_KERNELS_RASTER_SHADOW_MAP_MARGIN_H
#define TS_KERNELS_RASTER_SHADOW_MAP_MARGIN_H
#include "kernels/raster/margin_bounds.h"
#include "kernels/raster/shadow_map.h"

/* The greatest distance, in world units, of the receivers of two neighbouring pixels of the eye. */
TS_FN f32 ts_k_receiver_step(const ts_camera_k *eye, const ts_receiver *at)
{
	ts_v3 way = ts_sub(at->p, eye->eye);
	f32 z = ts_k_to_view(eye, at->p).z;
	f32 facing = ts_max(ts_abs(ts_dot(way, at->n)) / ts_max(ts_length(way), z), TS_LEAST_FACING);
	return (z / eye->focal) / facing;
}

/* A receiver in a view's map, and its steps: in 1/256 texel, and in depth. */
typedef struct {
	ts_v2 place;
	f32 z, bias, step, deeper;
} ts_asking;

TS_FN ts_asking ts_k_asking(const ts_shadow_test_args *args, const ts_camera_k *view, const ts_receiver *at, f32 moves)
{
	/* Ask the bias for the slope alone: the change of depth from texel to texel. */
	ts_shadow_test_args slope = *args;
	slope.bias = 0.0f;
	slope.slope = 1.0f;
	ts_corner p = ts_k_to_view(view, at->p);
	/* Measure a texel at the receiver, and how much a step aside lengthens away from the axis. */
	bool parallel = view->orthographic != 0u;
	f32 width = parallel ? 1.0f / view->focal : p.z / view->focal;
	f32 aside = parallel ? 1.0f : ts_length(ts_sub(at->p, view->eye)) / p.z;
	ts_asking r;
	/* Find the receiver in the map as the shadow test does. */
	r.place = ts_k_project(view, &p);
	r.z = p.z;
	r.bias = ts_k_shadow_bias(args, view, at, p.z);
	/* Add the receiver's own movement to 1/256 texel; both depths change with it, and round. */
	r.step = 1.0f + (moves / width) * aside;
	r.deeper = (2.0f * r.step) * (ts_k_shadow_bias(&slope, view, at, p.z) * 0.00390625f) + p.z * TS_MARGIN_ROUNDING;
	return r;
}

/* The distance to the nearest edge of the texel along an axis, in 1/256 texel, and the texel beyond that edge; far
 * outside the map all texels are empty. */
typedef struct {
	i32 own, next;
	f32 distance;
} ts_beside;

TS_FN ts_beside ts_k_beside(f32 place)
{
	f32 near = ts_clamp(place, -65536.0f, 65536.0f);
	ts_beside r;
	r.own = ts_floor_i32(near);
	f32 in = near - (f32)r.own;
	r.next = in < 0.5f ? r.own - 1 : r.own + 1;
	r.distance = (in < 0.5f ? in : 1.0f - in) * 256.0f;
	return r;
}

TS_FN void ts_k_least_margin(TS_GLOBAL u64 *margin, f32 distance)
{
	u64 bits = ts_f2u(ts_put(distance));
	*margin = bits < *margin ? bits : *margin;
}

/* Margins in one view: tests the texel that the point falls into, and those beyond its nearest edges. moves: that of
 * ts_k_receiver_step. */
TS_FN void ts_k_reach_margin(const ts_shadow_test_args *args, TS_GLOBAL const ts_offscreen *offscreen,
                             const ts_receiver *at, f32 moves, u64 first_texel, TS_GLOBAL u64 *margin)
{
	/* Leave out receivers before the near plane, which are lit. */
	ts_camera_k view = ts_k_offscreen(offscreen);
	if (!(ts_k_to_view(&view, at->p).z >= view.near)) return;
	/* Find the receiver's texel, its nearest edges, and the answer there. */
	ts_asking r = ts_k_asking(args, &view, at, moves);
	ts_beside x = ts_k_beside(r.place.x);
	ts_beside y = ts_k_beside(r.place.y);
	bool reaches = ts_k_reaches(args, offscreen, at, first_texel);
	for (u32 k = 0u; k < 4u; k++) {
		/* Visit the texel and those beyond these edges, where a step may reach them. */
		bool right = (k & 1u) != 0u;
		bool down = (k & 2u) != 0u;
		f32 distance = ts_max(right ? x.distance : 0.0f, down ? y.distance : 0.0f) / r.step;
		if (distance > TS_MARGIN_REACH) continue;
		/* Offer the distance to another answer, and the gap between both depths. */
		u32 depth = ts_k_map_texel(args, offscreen, first_texel, right ? x.next : x.own, down ? y.next : y.own);
		f32 free = depth == TS_NONE ? r.z : ts_u2f(depth) + r.bias;
		if ((r.z <= free) != reaches) ts_k_least_margin(&margin[0], distance);
		if (depth != TS_NONE && distance <= 1.0f) ts_k_least_margin(&margin[1], ts_abs(free - r.z) / r.deeper);
	}
}

#endif
