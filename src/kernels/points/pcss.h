/* Percentage-closer soft shadows from one depth map per light (PCSS; METHODS 10). Blockers are the texels nearer than
 * the receiver within the width w_L (d_R - near) / d_R around it on the plane at depth near; w_L is the light's width,
 * d_R the receiver's depth. With the blockers' mean depth d_B the penumbra has the width w = (d_R - d_B) w_L / d_B. The
 * light that arrives is the share of taps without a blocker within the width w near / d_R of that plane. Parallel light
 * of tangent t has the widths 2 t (d_R - near) and w = 2 t (d_R - d_B).
 *
 * Taps may lie far from the receiver, so their depths are compared with the depth of the receiver's plane there, where
 * that is nearer than the receiver: a surface does not shade itself, however steep. The bias is that of all methods
 * (shadow_map.h). */
#ifndef TS_KERNELS_POINTS_PCSS_H
#define TS_KERNELS_POINTS_PCSS_H
#include "kernels/base/args.h"
#include "kernels/points/plane.h"
#include "kernels/raster/shadow_test.h"

#define TS_N_SEARCH 32u
#define TS_N_FILTER 64u

/* Taps, in 1/128 of the radius: placed like the seeds of a sunflower (Vogel 1979). */
TS_CONSTANT i32 ts_pcss_search[32][2] = {
	{16, 0},   {-20, -19}, {3, 36},   {26, -34},   {-47, 8},   {45, 28},   {-15, -56},  {-29, 55},
	{62, -23}, {-64, -27}, {31, 66},  {23, -73},   {-69, 40},  {81, 18},   {-50, -70},  {-11, 88},
	{70, -59}, {-95, -4},  {69, 69},  {-5, -100},  {-66, 79},  {104, -14}, {-88, -61},  {24, 107},
	{56, -97}, {-109, 35}, {106, 49}, {-46, -109}, {-41, 114}, {109, -57}, {-121, -32}, {69, 107},
};
TS_CONSTANT i32 ts_pcss_filter[64][2] = {
	{11, 0},     {-14, -13}, {2, 25},    {18, -24},   {-33, 6},  {32, 20},    {-11, -39}, {-20, 39},
	{44, -16},   {-46, -19}, {22, 47},   {16, -52},   {-49, 28}, {57, 13},    {-35, -50}, {-8, 62},
	{50, -42},   {-67, -3},  {49, 49},   {-3, -71},   {-46, 56}, {74, -10},   {-62, -43}, {17, 76},
	{39, -69},   {-77, 25},  {75, 35},   {-32, -77},  {-29, 80}, {77, -40},   {-85, -23}, {49, 76},
	{15, -90},   {-73, 57},  {94, 8},    {-65, -70},  {0, 97},   {66, -73},   {-99, 9},   {80, 61},
	{-18, -100}, {-55, 87},  {101, -28}, {-94, -48},  {37, 100}, {41, -100},  {-99, 47},  {105, 32},
	{-56, -96},  {-24, 110}, {93, -66},  {-114, -14}, {75, 88},  {4, -117},   {-83, 84},  {119, -6},
	{-93, -77},  {17, 120},  {69, -101}, {-120, 28},  {108, 61}, {-39, -119}, {-52, 115}, {117, -50},
};

#define TS_ROWS_ts_pcss_args(ARG) \
	ARG(INNER, ts_shadow_test_args, of, none) /* one view per light */ \
	ARG(IN, ts_lamp, lamps, lamp_shape) \
	ARG(VALUE, f32, near, none) /* depth of the plane of the search, as a share of the receiver's */
TS_ARGS(ts_pcss_args);

/* A receiver in a light's view. */
typedef struct {
	ts_camera_k view;
	ts_v2 place;
	ts_image_plane plane;
	f32 z, bias;
	TS_GLOBAL const u32 *depths; /* of the view */
} ts_shaded;

TS_FN ts_shaded ts_k_shaded(const ts_shadow_test_args *args, TS_GLOBAL const ts_offscreen *offscreen,
                            const ts_receiver *at)
{
	ts_shaded r;
	r.view = ts_k_offscreen(offscreen);
	ts_corner p = ts_k_to_view(&r.view, at->p);
	r.place = ts_k_project(&r.view, &p);
	r.plane = ts_k_image_plane(&r.view, at->p, at->n);
	r.z = p.z;
	r.bias = ts_k_shadow_bias(args, &r.view, at, ts_max(p.z, r.view.near));
	r.depths = args->depths + (offscreen->offset - args->views[args->first_view].offset);
	return r;
}

/* A surface in the map blocks the light if its depth is less than this: the depth of the receiver's plane at (x, y),
 * and at most the receiver's own depth, which also stands in where the plane is not met. */
TS_FN f32 ts_k_free_depth(const ts_shaded *r, f32 x, f32 y)
{
	return ts_min(ts_k_plane_depth(&r->view, &r->plane, x, y, r->z), r->z);
}

/* The depth of a tap, if it lies between the light and the receiver's plane; otherwise 0. */
TS_CALL f32 ts_k_blocker(const ts_shaded *r, f32 radius, i32 tap_x, i32 tap_y)
{
	f32 x = r->place.x + radius * ((f32)tap_x * 0.0078125f);
	f32 y = r->place.y + radius * ((f32)tap_y * 0.0078125f);
	i32 i = ts_floor_i32(x);
	i32 j = ts_floor_i32(y);
	if (i < 0 || j < 0 || i >= r->view.width || j >= r->view.height) return 0.0f;
	u32 depth = r->depths[(u64)j * (u64)r->view.width + (u64)i];
	f32 free = ts_k_free_depth(r, (f32)i + 0.5f, (f32)j + 0.5f);
	bool blocks = depth != TS_NONE && free > ts_u2f(depth) + r->bias;
	return blocks ? ts_u2f(depth) : 0.0f;
}

/* Mean depth of the blockers; 0: there are none. */
TS_FN f32 ts_k_blocker_depth(const ts_shaded *r, f32 radius)
{
	f32 sum = 0.0f;
	u32 n = 0u;
	for (u32 k = 0u; k < TS_N_SEARCH; k++) {
		f32 depth = ts_k_blocker(r, radius, ts_pcss_search[k][0], ts_pcss_search[k][1]);
		sum = sum + depth;
		n += depth > 0.0f ? 1u : 0u;
	}
	return n != 0u ? sum / (f32)n : 0.0f;
}

/* The radius of the search in texels: the light's radius as seen from the receiver, at depth near. One world unit is
 * focal / near texels there, and focal texels in an orthographic view. */
TS_FN f32 ts_k_search_radius(const ts_shaded *r, f32 light, f32 near)
{
	if (r->view.orthographic != 0u) return (light * (r->z - near)) * r->view.focal;
	return (light * (r->z - near) / r->z) * (r->view.focal / near);
}

TS_FN f32 ts_k_filter_radius(const ts_shaded *r, f32 light, f32 blocker)
{
	f32 above = r->z - blocker;
	if (r->view.orthographic != 0u) return (light * above) * r->view.focal;
	return ((above * light) / blocker) * (r->view.focal / r->z);
}

/* Number of the filter's taps that see no blocker. */
TS_CALL u32 ts_k_pcss(const ts_pcss_args *args, TS_GLOBAL const ts_offscreen *offscreen, const ts_receiver *at)
{
	/* Let all light reach a receiver before the near plane. */
	ts_shaded r = ts_k_shaded(&args->of, offscreen, at);
	f32 light = args->lamps[offscreen->light].radius;
	if (!(r.z >= r.view.near)) return TS_N_FILTER;
	/* Search for blockers; a receiver without any is lit. */
	f32 blocker = ts_k_blocker_depth(&r, ts_k_search_radius(&r, light, args->near * r.z));
	if (!(blocker > 0.0f)) return TS_N_FILTER;
	/* Count the taps without a blocker within the penumbra's width. */
	f32 radius = ts_k_filter_radius(&r, light, blocker);
	u32 lit = 0u;
	for (u32 k = 0u; k < TS_N_FILTER; k++) {
		lit += ts_k_blocker(&r, radius, ts_pcss_filter[k][0], ts_pcss_filter[k][1]) > 0.0f ? 0u : 1u;
	}
	return lit;
}

/* map over pixels and their samples */
TS_FN void ts_k_pcss_item(const ts_pcss_args *args, u64 i)
{
	ts_receiver at = ts_k_receiver_at(&args->of, i);
	if (!at.seen) return;
	for (u32 v = args->of.first_view; v < args->of.first_view + args->of.n_views; v++) {
		TS_GLOBAL const ts_offscreen *view = &args->of.views[v];
		args->of.lit[i * args->of.n_lamps + view->light] += ts_k_pcss(args, view, &at);
	}
}

#endif
