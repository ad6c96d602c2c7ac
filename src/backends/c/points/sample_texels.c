/* The texels that the samples of a reflective pixel read, side by side. */
#include "backends/c/points/sample_texels.h"
#include "backends/wide.h"
#include "kernels/raster/cube.h"

enum { SAMPLES = TS_SAMPLE_ROOM };

/* What the samples of a pixel have in common. */
typedef struct {
	ts_v3 position, position_dx, position_dy, normal, normal_dx, normal_dy, eye;
	u32 n; /* of the cube */
} pixel;

ts_sample_offsets ts_sample_offsets_of(u32 n_samples)
{
	ts_sample_offsets r = {{0}, {0}};
	for (u32 k = 0; k < n_samples; k++) {
		ts_v2 o = ts_k_sample_offset(k);
		r.x[k] = o.x;
		r.y[k] = o.y;
	}
	return r;
}

/* 1 or -1. */
static inline f32 sign_of(u32 negative) { return 1.0f - 2.0f * (f32)negative; }

/* ts_k_cube_texel of a place on a face. */
static inline u32 texel_of(f32 s, u32 n)
{
	i32 at = ts_k_floor_within(((s + 1.0f) * 0.5f) * (f32)(i32)n, (f32)(i32)n);
	return (u32)ts_min_i32(ts_max_i32(at, 0), (i32)n - 1);
}

/* ts_k_cube_index of a direction, without branches. */
static inline u32 index_of(ts_v3 d, u32 n)
{
	f32 x = ts_abs(d.x), y = ts_abs(d.y), z = ts_abs(d.z);
	u32 on_x = (x >= y ? 1u : 0u) & (x >= z ? 1u : 0u);
	u32 on_y = (y >= z ? 1u : 0u) & (on_x ^ 1u);
	f32 along = on_x != 0u ? d.x : on_y != 0u ? d.y : d.z;
	u32 negative = along < 0.0f ? 1u : 0u;
	f32 sign = sign_of(negative), major = ts_abs(along);
	f32 s = on_x != 0u ? -d.z * sign : on_y != 0u ? d.x : d.x * sign;
	f32 t = on_y != 0u ? d.z * sign : -d.y;
	major = major > 0.0f ? major : 1.0f;
	u32 face = (2u - 2u * on_x) + (2u - 2u * (on_x | on_y)) + negative;
	return (face * n + texel_of(t / major, n)) * n + texel_of(s / major, n);
}

TS_WIDE(void, find_texels, (u32 *restrict to, const ts_sample_offsets *restrict o, pixel of), (to, o, of))
{
	for (u32 k = 0; k < SAMPLES; k++) {
		ts_v3 p = ts_mad(ts_mad(of.position, of.position_dx, o->x[k]), of.position_dy, o->y[k]);
		ts_v3 n = ts_mad(ts_mad(of.normal, of.normal_dx, o->x[k]), of.normal_dy, o->y[k]);
		ts_v3 r = ts_reflect(ts_normalize(ts_sub(p, of.eye)), ts_normalize(n));
		to[k] = index_of(ts_normalize(r), of.n);
	}
}

static pixel pixel_of(const ts_pixel *from, ts_v3 eye, u32 n)
{
	return (pixel){ts_load3(from->position),
	               ts_load3(from->position_dx),
	               ts_load3(from->position_dy),
	               ts_load3(from->normal),
	               ts_load3(from->normal_dx),
	               ts_load3(from->normal_dy),
	               eye,
	               n};
}

void ts_sample_texels(u32 to[TS_SAMPLE_ROOM], const ts_sample_offsets *o, const ts_pixel *of, ts_v3 eye, u32 n)
{
	find_texels(to, o, pixel_of(of, eye, n));
}

#include "backends/selftest.h"
