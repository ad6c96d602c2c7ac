/* Seams of hulls (FIGURES 24). */
#include "methods/hulls/tools/borders.h"
#include <math.h>

static const double like_depth = 0.02, like_normal = 0.99;

typedef struct {
	double changes, light;
} sums;

/* The reciprocal of depth is 1 - zn, up to a factor. */
static bool are_alike(const ts_gpixel *a, const ts_gpixel *b)
{
	double u = 1 - (double)a->depth, v = 1 - (double)b->depth, cosine = 0;
	for (int c = 0; c < 3; c++) cosine += (double)a->normal[c] * (double)b->normal[c];
	return u > 0 && v > 0 && fabs(u - v) <= like_depth * fmax(u, v) && cosine >= like_normal;
}

static u32 block_of(const ts_borders_of *of, u64 i)
{
	u32 x = ts_k_resample((u32)(i % of->width), of->width, of->grid);
	u32 y = ts_k_resample((u32)(i / of->width), of->height, of->grid);
	return ts_k_block_of(of->grid, x, y);
}

static void add_pair(sums *s, const ts_borders_of *of, u64 i, u64 j)
{
	for (u64 c = 0; c < 3; c++) {
		double change = (double)of->hulls[3 * j + c] - (double)of->hulls[3 * i + c];
		double right = (double)of->direct[3 * j + c] - (double)of->direct[3 * i + c];
		s->changes += fabs(change - right);
		s->light += ((double)of->direct[3 * i + c] + (double)of->direct[3 * j + c]) / 2;
	}
}

static void offer_pair(sums *across, sums *within, const ts_borders_of *of, u64 i, u64 j)
{
	if (!are_alike(&of->pixels[i], &of->pixels[j])) return;
	if (block_of(of, i) != block_of(of, j)) {
		add_pair(across, of, i, j);
	} else if (of->boxes[i] == of->boxes[j]) {
		add_pair(within, of, i, j);
	}
}

static double share(sums s) { return s.light > 0 ? s.changes / s.light : NAN; }

ts_borders ts_borders_measure(const ts_borders_of *of)
{
	sums across = {0}, within = {0};
	for (u64 y = 0; y < of->height; y++) {
		for (u64 x = 0; x < of->width; x++) {
			u64 i = y * of->width + x;
			if (x + 1 < of->width) offer_pair(&across, &within, of, i, i + 1);
			if (y + 1 < of->height) offer_pair(&across, &within, of, i, i + of->width);
		}
	}
	return (ts_borders){share(across), share(within)};
}

ts_facing_pairs ts_facing_count(const ts_moment *corners, u64 n_corners, const ts_patch *patches, u64 n_patches)
{
	ts_facing_pairs pairs = {0};
	for (u64 k = 0; k < n_patches; k++) {
		ts_v3 a = ts_load3(patches[k].a), normal = ts_load3(patches[k].normal);
		f32 side = ts_length(ts_sub(ts_load3(patches[k].b), a));
		for (u64 i = 0; i < n_corners; i++) {
			f32 height = ts_flush(ts_dot(normal, ts_sub(ts_load3(corners[i].position), a)));
			f32 facing = ts_k_facing(height, side);
			pairs.facing += ts_k_is_in_front(ts_load3(corners[i].position), a, normal);
			pairs.counted += facing > 0.0f;
			pairs.full += facing == 1.0f;
		}
	}
	return pairs;
}
