/* Fast path of the look-ups of reflective pixels, with the same bits: a pixel's samples side by side, and the texels of
 * some pixels on their way before they are read. */
#include "../../../kernels/points/lookup.h"
#include "../../../kernels/points/splat_pieces.h"
#include "../../fast.h"
#include "../../wide.h"

enum { SAMPLES = 32, PIXELS = 8 }; /* samples: room for whole vectors */

typedef struct {
	f32 x[SAMPLES], y[SAMPLES];
} offsets;

/* What the samples of a pixel have in common. */
typedef struct {
	ts_v3 position, position_dx, position_dy, normal, normal_dx, normal_dy, eye;
	u32 n; /* of the cube */
} pixel;

static offsets offsets_of(u32 n_samples)
{
	offsets r = {{0}, {0}};
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

TS_WIDE static void find_texels(u32 *restrict to, const offsets *restrict o, pixel of)
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

/* A pixel of a mirror without a cube finds nothing. */
static const u64 nothing = TS_EMPTY;

static void look_up(const ts_lookup_args *args, const offsets *o, u64 first, u32 n)
{
	u32 at[PIXELS][SAMPLES];
	const u64 *texels[PIXELS];
	ts_v3 eye = ts_load3(args->view->eye);
	for (u32 i = 0; i < n; i++) {
		const ts_pixel *from = &args->pixels[first + i];
		const ts_face *cube = &args->cubes[from->reflector];
		texels[i] = cube->n != 0 ? args->texels + cube->offset : &nothing;
		find_texels(at[i], o, pixel_of(from, eye, cube->n));
		for (u32 k = 0; k < args->n_samples; k++) {
			at[i][k] = cube->n != 0 ? at[i][k] : 0;
			__builtin_prefetch(&texels[i][at[i][k]]);
		}
	}
	for (u32 i = 0; i < n; i++) {
		u32 *found = args->found + (first + i) * args->n_samples;
		for (u32 k = 0; k < args->n_samples; k++) found[k] = (u32)texels[i][at[i][k]];
	}
}

bool ts_c_fast_lookup(const void *of, u64 n, u32 threads)
{
	const ts_lookup_args *args = of;
	if (args->n_samples > SAMPLES) return false;
	offsets o = offsets_of(args->n_samples);
#pragma omp parallel for schedule(dynamic, 64) num_threads(threads)
	for (i64 first = 0; first < (i64)n; first += PIXELS) {
		look_up(args, &o, (u64)first, (i64)n - first < PIXELS ? (u32)((i64)n - first) : PIXELS);
	}
	return true;
}
