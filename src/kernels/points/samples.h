/* The samples of a reflective pixel: 25 offsets of a toroidal Poisson-disc set, the same in every pixel; later bounces
 * use the first four (EPR section 4.1.3; METHODS 2). */
#ifndef TS_KERNELS_POINTS_SAMPLES_H
#define TS_KERNELS_POINTS_SAMPLES_H
#include "kernels/base/records.h"
#include "kernels/base/vec.h"

#define TS_N_SAMPLES 25u
#define TS_N_BOUNCE_SAMPLES 4u

/* Offset k is ((x + 1/2) / 128, (y + 1/2) / 128) pixels. */
TS_CONSTANT i32 ts_sample_offset[25][2] = {
	{0, -23},  {19, 30},  {45, 48},  {-37, 10},  {-9, 56},   {43, 10},  {-33, 59},  {-63, 6}, {-55, -38},
	{-14, 17}, {63, -17}, {-62, 35}, {-28, -26}, {-56, -64}, {23, -4},  {-21, 38},  {13, 54}, {-35, -47},
	{7, -49},  {47, -59}, {21, -25}, {7, 10},    {-10, -4},  {32, -43}, {-14, -46},
};

TS_FN ts_v2 ts_k_sample_offset(u32 k)
{
	f32 x = (f32)ts_sample_offset[k][0] + 0.5f;
	f32 y = (f32)ts_sample_offset[k][1] + 0.5f;
	return ts_v2_make(x * 0.0078125f, y * 0.0078125f);
}

typedef struct {
	ts_v3 p, direction;
} ts_ray;

/* p_k = p + o_x dp/dx + o_y dp/dy, n_k likewise, r_k = i_k - 2 (i_k.n_k) n_k with i_k from the eye to p_k; o in
 * pixels. */
TS_FN ts_ray ts_k_offset_ray(TS_GLOBAL const ts_pixel *pixel, ts_v3 eye, ts_v2 o)
{
	ts_v3 p = ts_load3(pixel->position);
	ts_v3 n = ts_load3(pixel->normal);
	p = ts_mad(ts_mad(p, ts_load3(pixel->position_dx), o.x), ts_load3(pixel->position_dy), o.y);
	n = ts_mad(ts_mad(n, ts_load3(pixel->normal_dx), o.x), ts_load3(pixel->normal_dy), o.y);
	ts_ray r;
	r.p = p;
	r.direction = ts_normalize(ts_reflect(ts_normalize(ts_sub(p, eye)), ts_normalize(n)));
	return r;
}

TS_FN ts_ray ts_k_sample_ray(TS_GLOBAL const ts_pixel *pixel, ts_v3 eye, u32 k)
{
	return ts_k_offset_ray(pixel, eye, ts_k_sample_offset(k));
}

/* A later bounce has no pixel: the ray from the centre of the cube in which p was found is reflected at the tile's
 * normal, which is turned by the offset times `spread`, the tile's width over the radius of the next reflector. u, v:
 * the tile's axes. */
TS_FN ts_v3 ts_k_bounce_direction(ts_v3 p, ts_v3 n, ts_v3 u, ts_v3 v, ts_v3 from, f32 spread, u32 k)
{
	ts_v2 o = ts_k_sample_offset(k);
	ts_v3 turned = ts_normalize(ts_mad(ts_mad(n, u, o.x * spread), v, o.y * spread));
	return ts_normalize(ts_reflect(ts_normalize(ts_sub(p, from)), turned));
}

#endif
