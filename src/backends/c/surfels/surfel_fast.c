/* Fast paths of the surfel kernels, with the same bits: a thread owns a tile of the image and draws the surfels of its
 * bin, so there are no atomics. The order is that of the surfels, though integer sums and minima do not depend on it.
 * Counts of all items are kept per thread first. */
#include <math.h>
#include "backends/c/surfels/surfel_bins.h"
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/surfels/deferred.h"
#include "kernels/surfels/surfel_blend.h"
#include "kernels/surfels/surfel_depth.h"

enum { ITEMS = 1024 };

/* Pixels of a box side by side, and a surfel's values there. Vectors are full, and the last pixels not used, so that
 * compilers vectorize the loops. */
enum { BLOCK = 64, VECTOR = 16 };
typedef struct {
	u32 n;
	i32 x[BLOCK], y[BLOCK], covers[BLOCK];
	f32 dx[BLOCK], dy[BLOCK], r2[BLOCK], z[BLOCK], weight[BLOCK];
} block;

static u32 padded(u32 n) { return (n + VECTOR - 1) / VECTOR * VECTOR; }

/* The pixels of a box in a tile from `first` on. Rows are exact: a tile has 2^12 pixels and is 2^6 wide, and
 * `inverse` is less than 1 above 2^20 / width. */
static void place_block(block *b, const ts_disc *disc, u32 first, u32 n)
{
	u32 width = (u32)(disc->high[0] - disc->low[0] + 1), inverse = ((1u << 20) + width - 1) / width;
	i32 left = disc->low[0], top = disc->low[1];
	b->n = n < BLOCK ? n : BLOCK;
	for (u32 i = 0; i < padded(b->n); i++) {
		u32 row = (first + i) * inverse >> 20;
		b->x[i] = left + (i32)(first + i - row * width);
		b->y[i] = top + (i32)row;
	}
}

static u32 box_pixels(const ts_disc *disc)
{
	return (u32)(disc->high[0] - disc->low[0] + 1) * (u32)(disc->high[1] - disc->low[1] + 1);
}

static u64 pixel_of(const block *b, u32 i, i32 width) { return (u64)b->y[i] * (u64)width + (u64)b->x[i]; }

/* ts_k_disc_hit, by selects; `covers`: whether the hit is inside. */
static void cast_block(block *b, ts_disc disc, f32 near)
{
	i32 faces = (disc.flags & TS_DISC_FLAT) == 0 ? 1 : 0;
	bool parallel = (disc.flags & TS_DISC_PARALLEL) != 0, crosses = (disc.flags & TS_DISC_CROSSES) != 0;
	f32 a = crosses ? disc.conic[0] : 0.0f, c = crosses ? disc.conic[1] : 0.0f;
	for (u32 i = 0; i < padded(b->n); i++) {
		f32 dx = (f32)(b->x[i] - disc.pixel[0]) - disc.fraction[0];
		f32 dy = (f32)(b->y[i] - disc.pixel[1]) - disc.fraction[1];
		f32 tilt = disc.g[0] * dx + disc.g[1] * dy;
		f32 divisor = parallel ? 1.0f : 1.0f + tilt;
		i32 in = divisor > 0.0f ? faces : 0;
		f32 inverse = 1.0f / (in != 0 ? divisor : 1.0f);
		f32 across = (disc.a[0] * dx + disc.a[1] * dy) * inverse + a;
		f32 along = (disc.b[0] * dx + disc.b[1] * dy) * inverse + c;
		f32 r2 = across * across + along * along;
		f32 z = disc.depth * (parallel ? 1.0f - tilt : inverse);
		in = r2 <= 1.0f ? in : 0;
		in = z >= near ? in : 0;
		b->dx[i] = dx;
		b->dy[i] = dy;
		b->r2[i] = r2;
		b->z[i] = z;
		b->covers[i] = in;
	}
}

static void shift_block(block *b, ts_camera_k view, f32 epsilon)
{
	for (u32 i = 0; i < padded(b->n); i++) {
		b->z[i] = ts_put(b->z[i] + ts_k_pixel_shift(&view, epsilon, b->x[i], b->y[i]));
	}
}

static void depth_surfel(block *b, u64 *keys, const ts_camera_k *view, ts_disc disc, f32 epsilon, u32 surfel)
{
	u32 n = box_pixels(&disc);
	for (u32 first = 0; first < n; first += BLOCK) {
		place_block(b, &disc, first, n - first);
		cast_block(b, disc, view->near);
		shift_block(b, *view, epsilon);
		for (u32 i = 0; i < b->n; i++) {
			u64 *at = &keys[pixel_of(b, i, view->width)], key = ((u64)ts_f2u(b->z[i]) << 32) | surfel;
			*at = b->covers[i] != 0 && key < *at ? key : *at;
		}
	}
}

TS_WIDE(void, depth_tile, (const ts_surfel_depth_args *args, const ts_surfel_bins *b, u32 tile), (args, b, tile))
{
	block pixels = {.n = 0};
	ts_camera_k view = ts_k_view(args->view);
	for (u64 k = ts_surfel_bin_begin(b, tile); k < ts_surfel_bin_end(b, tile); k++) {
		depth_surfel(&pixels, args->keys, &view, ts_surfel_bins_disc(b, tile, k), args->epsilon[0], b->surfel[k]);
	}
}

/* False where surfels are as large as the image. */
bool ts_c_fast_surfel_depth(const void *of, u64 n, u32 threads)
{
	const ts_surfel_depth_args *args = of;
	ts_surfel_bins b;
	bool made = ts_surfel_bins_make(&b, args->view, args->discs, n, -(double)INFINITY, threads);
	ts_stop *stop = ts_stop_here();
	if (made) {
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
		for (i64 tile = 0; tile < (i64)b.n_tiles; tile++) {
			if (!ts_stopped(stop)) depth_tile(args, &b, (u32)tile);
		}
	}
	ts_surfel_bins_free(&b);
	return made;
}

/* A surfel's terms for a weight of 1, and those for any weight. */
typedef struct {
	f32 value[TS_BLEND_SUMS];
	i64 each[TS_BLEND_SUMS];
} terms;

/* False where ts_fix may saturate. */
static bool make_terms(terms *t, const ts_attributes *attributes)
{
	bool small = true;
	memcpy(t->value, attributes->value, sizeof attributes->value);
	t->value[TS_BLEND_WEIGHT] = 1.0f;
	t->value[TS_BLEND_FRAGMENTS] = 0.0f;
	memset(t->each, 0, sizeof t->each);
	t->each[TS_BLEND_FRAGMENTS] = 1;
	for (u32 k = 0; k < TS_BLEND_WEIGHT; k++) small &= ts_abs(t->value[k]) < 1.5f;
	return small;
}

/* ts_k_blend_add for weights up to 1: adding `grid`, of which grid_bits are the bits, rounds to multiples of 2^-30. */
static void blend_add(const ts_surfel_blend_args *args, u64 pixel, u32 surfel, const terms *t, f32 weight)
{
	const double grid = 6291456.0;
	const i64 grid_bits = 0x4158000000000000;
	i64 *sums = args->sums + pixel * TS_BLEND_SUMS;
#pragma omp simd
	for (u32 k = 0; k < TS_BLEND_SUMS; k++) {
		double number = (double)(weight * t->value[k]) + grid;
		i64 bits;
		memcpy(&bits, &number, sizeof bits);
		sums[k] += bits - grid_bits + t->each[k];
	}
	u64 heavy = ts_k_heavy(weight, surfel);
	args->heaviest[pixel] = heavy < args->heaviest[pixel] ? heavy : args->heaviest[pixel];
}

/* ts_k_fragment_radius, by selects. */
static void radius_block(block *b, const ts_disc *disc, ts_filter filter)
{
	f32 depth = disc->depth;
	i32 objects = filter.filter != TS_FILTER_SCREEN ? 1 : 0;
	i32 screens = ts_k_has_screen(disc, &filter) ? 1 : 0;
	for (u32 i = 0; i < padded(b->n); i++) {
		f32 object2 = b->r2[i], z = b->z[i];
		f32 screen2 = (b->dx[i] * b->dx[i] + b->dy[i] * b->dy[i]) * filter.per_sigma2;
		i32 inside = b->covers[i];
		i32 object = inside & objects, screen = (screen2 <= 1.0f ? 1 : 0) & screens;
		f32 lesser = screen2 < object2 ? screen2 : object2;
		f32 both = screen != 0 ? lesser : object2;
		f32 r2 = object != 0 ? both : screen2;
		b->r2[i] = r2;
		b->z[i] = inside != 0 ? z : depth;
		b->covers[i] = object | screen;
	}
}

/* Places of seen pixels, without a branch, for half of them are not seen; returns their number. */
static u32 list_seen(u32 seen[BLOCK], const block *b, const ts_filter *filter, const u64 *keys, i32 width)
{
	u32 n = 0;
	for (u32 i = 0; i < b->n; i++) {
		seen[n] = i;
		n += (u32)b->covers[i] & (ts_k_is_visible(filter, keys[pixel_of(b, i, width)], b->z[i]) ? 1u : 0u);
	}
	return n;
}

static void weigh_block(block *b, f32 fall)
{
	for (u32 i = 0; i < padded(b->n); i++) b->weight[i] = ts_exp(-(b->r2[i] * fall));
}

static u32 blend_surfel(block *b, const ts_surfel_blend_args *args, const ts_camera_k *view, ts_disc disc, u32 surfel)
{
	ts_attributes attributes = ts_k_attributes(&args->surfels[surfel], &disc);
	terms each;
	bool small = make_terms(&each, &attributes);
	u32 seen[BLOCK], n = box_pixels(&disc), fragments = 0;
	for (u32 first = 0; first < n; first += BLOCK) {
		place_block(b, &disc, first, n - first);
		cast_block(b, disc, view->near);
		radius_block(b, &disc, args->filter);
		u32 n_seen = list_seen(seen, b, &args->filter, args->keys, view->width);
		weigh_block(b, args->filter.fall);
		for (u32 k = 0; k < n_seen; k++) {
			u64 pixel = pixel_of(b, seen[k], view->width);
			if (small) {
				blend_add(args, pixel, surfel, &each, b->weight[seen[k]]);
			} else {
				ts_k_blend_add(args, pixel, surfel, &attributes, b->weight[seen[k]]);
			}
		}
		fragments += n_seen;
	}
	return fragments;
}

TS_WIDE(void, blend_tile, (const ts_surfel_blend_args *args, const ts_surfel_bins *b, u32 tile), (args, b, tile))
{
	block in = {.n = 0};
	ts_camera_k view = ts_k_view(args->view);
	i64 n = 0;
	for (u64 k = ts_surfel_bin_begin(b, tile); k < ts_surfel_bin_end(b, tile); k++) {
		ts_disc disc = ts_surfel_bins_disc(b, tile, k);
		__builtin_prefetch(args->surfels[b->surfel[k + TS_SURFELS_AHEAD]].colour);
		n += blend_surfel(&in, args, &view, disc, b->surfel[k]);
	}
	ts_add_i64(&args->tally[0], n);
}

/* How far from a centre the screen filter may cover a pixel. */
static double screen_reach(const ts_filter *filter)
{
	bool none = !(filter->per_sigma2 > 0.0f) || filter->filter == TS_FILTER_OBJECT;
	return none ? -(double)INFINITY : 1.0 + 1.001 / sqrt((double)filter->per_sigma2);
}

bool ts_c_fast_surfel_blend(const void *of, u64 n, u32 threads)
{
	const ts_surfel_blend_args *args = of;
	ts_surfel_bins b;
	if (args->filter.filter == TS_FILTER_EWA) return false;
	bool made = ts_surfel_bins_make(&b, args->view, args->discs, n, screen_reach(&args->filter), threads);
	ts_stop *stop = ts_stop_here();
	if (made) {
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
		for (i64 tile = 0; tile < (i64)b.n_tiles; tile++) {
			if (!ts_stopped(stop)) blend_tile(args, &b, (u32)tile);
		}
		ts_add_i64(&args->tally[1], b.pixels);
	}
	ts_surfel_bins_free(&b);
	return made;
}

/* All pixels of the sky are shown alike. */
bool ts_c_fast_deferred(const void *of, u64 n, u32 threads)
{
	const ts_deferred_args *args = of;
	f32 radiance[3];
	u8 srgb[3];
	ts_k_show(radiance, srgb, ts_k_background(), args->exposure);
	ts_stop *stop = ts_stop_here();
#pragma omp parallel num_threads(threads)
	{
		i64 tally = 0;
		ts_deferred_args own = *args;
		own.tally = &tally;
#pragma omp for schedule(dynamic, ITEMS)
		for (i64 i = 0; i < (i64)n; i++) {
			if (ts_stopped(stop)) continue;
			if (args->pixels[i].depth == TS_SKY) {
				memcpy(args->radiance + i * 3, radiance, sizeof radiance);
				memcpy(args->srgb + i * 3, srgb, sizeof srgb);
			} else {
				ts_k_deferred_item(&own, (u64)i);
			}
		}
		ts_add_i64(&args->tally[0], tally);
	}
	return true;
}

#include "backends/selftest.h"
