/* Fast path of gathering, with the same bits: the lights that a pixel draws are found, weighed and looked up side by
 * side, by the kernel's own functions in loops without branches, which compilers vectorize. Adding an unseen light
 * changes no sum. Only for fused maps. */
#include <stdlib.h>
#include "backends/c/raster/lanes.h"
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/views/vpl_gather.h"

enum { LOT = TS_ABREAST, PIXELS_A_CHUNK = 64, MOST_TEXELS = 64 }; /* side of maps with precomputed directions */

typedef struct {
	ts_vpl_gather_args args;
	ts_v3 *directions; /* of the texels of a map; NULL: too many */
	f32 near;          /* world units */
} job;

/* The pixel, and the list that it draws from. */
typedef struct {
	u32 index;
	ts_v3 p, n;
	ts_view_list list;
} place;

/* Draws of a pixel: the number of views before, its place in the list, the view, its form factor, and the texel of its
 * map. */
typedef struct {
	u32 n, rank[LOT], at[LOT], view[LOT], texel[LOT];
	ts_lanes3 way, from;
	f32 form[LOT];
} drawn;

/* The draws that send light towards the pixel, and their maps' values. */
typedef struct {
	u32 n, which[LOT], reaches[LOT];
	ts_lanes3 way, light, centre, direction;
	f32 depth[LOT];
} asked;

/* ts_k_drawn_view up to the rank. */
TS_WIDE(void, draw_ranks, (drawn *restrict d, u32 first, u32 seed, u32 views), (d, first, seed, views))
{
	for (u32 i = 0; i < LOT; i++) {
		u32 chance = ts_random(first + i, TS_STREAM_VPL, seed);
		d->rank[i] = (u32)(((u64)chance * views) >> 32);
	}
}

/* Skips the first half of what is left of a list where the ranked view is not in it. */
TS_WIDE(void, skip_half, (drawn *restrict d, const u32 *restrict sums, u32 half), (d, sums, half))
{
	for (u32 i = 0; i < LOT; i++) d->at[i] += sums[(i32)(d->at[i] + half - 1)] <= d->rank[i] ? half : 0u;
}

/* ts_k_list_view. */
static void find_views(drawn *d, const ts_vpl_gather_args *args, const ts_view_list *list)
{
	if (list->from == TS_NONE) {
		memcpy(d->view, d->rank, sizeof d->view);
		return;
	}
	const u32 *sums = args->sums + list->from;
	for (u32 i = 0; i < LOT; i++) d->at[i] = 0;
	for (u32 n = list->to - list->from; n > 1; n -= n / 2) skip_half(d, sums, n / 2);
	for (u32 i = 0; i < d->n; i++) {
		u32 before = d->at[i] > 0 ? sums[d->at[i] - 1] : 0;
		d->view[i] = args->views[args->cones[args->list[list->from + d->at[i]]].first + (d->rank[i] - before)];
	}
}

static void load_lights(drawn *d, const ts_vpl_gather_args *args, ts_v3 p)
{
	for (u32 i = 0; i < d->n; i++) {
		const ts_vpl *light = &args->lights[d->view[i]];
		ts_set_lane3(&d->way, i, ts_sub(p, ts_load3(light->position)));
		ts_set_lane3(&d->from, i, ts_load3(light->normal));
	}
}

/* ts_k_vpl_form by selects, and the texels. */
TS_WIDE(void, weigh_lights, (drawn *restrict d, ts_v3 n, f32 least, u32 px), (d, n, least, px))
{
	for (u32 i = 0; i < LOT; i++) {
		ts_v3 way = ts_lane3(&d->way, i), from = ts_lane3(&d->from, i);
		ts_v3 direction = ts_normalize(way);
		f32 nowhere = ts_max(ts_max(ts_abs(from.x), ts_abs(from.y)), ts_abs(from.z));
		f32 cosine = ts_dot(direction, from);
		f32 leaves = nowhere == 0.0f ? 0.25f : cosine;
		f32 arrives = -ts_dot(direction, n);
		f32 square = ts_max(ts_dot(way, way), least);
		f32 cosines = leaves * arrives;
		f32 projected = cosines * TS_PER_PI;
		f32 form = ts_flush(projected / square);
		form = leaves > 0.0f ? form : 0.0f;
		d->form[i] = arrives > 0.0f ? form : 0.0f;
		d->texel[i] = ts_k_paraboloid_texel(way, px);
	}
}

static void ask_lights(asked *a, const drawn *d)
{
	a->n = 0;
	for (u32 i = 0; i < d->n; i++) {
		a->which[a->n] = i;
		a->n += d->form[i] > 0.0f ? 1u : 0u;
	}
}

static void load_maps(asked *a, const drawn *d, const job *j)
{
	const ts_vpl_gather_args *args = &j->args;
	u64 n_texels = (u64)2 * args->n * args->n;
	for (u32 i = 0; i < a->n; i++) {
		u32 from = a->which[i], view = d->view[from], texel = d->texel[from], leaf = args->leaves[view];
		ts_v3 direction = j->directions != NULL ? j->directions[texel] : ts_k_paraboloid_direction(texel, args->n);
		a->depth[i] = ts_u2f(args->depths[leaf * n_texels + texel]);
		ts_set_lane3(&a->direction, i, direction);
		ts_set_lane3(&a->way, i, ts_lane3(&d->way, from));
		ts_set_lane3(&a->light, i, ts_load3(args->lights[view].position));
		ts_set_lane3(&a->centre, i, ts_load3(args->nodes[leaf].centre));
	}
}

/* Whether a place is within ts_k_vpl_reach; where the map is empty, a farther one may be lit. */
TS_WIDE(void, reach_lights, (asked *restrict a, ts_vpl_gather_args args, ts_v3 n), (a, args, n))
{
	for (u32 i = 0; i < LOT; i++) {
		ts_v3 way = ts_lane3(&a->way, i);
		ts_v3 q = ts_mad(ts_lane3(&a->centre, i), ts_lane3(&a->direction, i), a->depth[i]);
		f32 reach = ts_length(ts_sub(q, ts_lane3(&a->light, i))) + ts_k_vpl_slack(&args, way, n);
		a->reaches[i] = ts_length(way) <= reach ? 1u : 0u;
	}
}

/* ts_k_vpl_reaches for a farther place. */
static bool is_clear(const ts_vpl_gather_args *args, u32 view, u32 texel, const place *at)
{
	u32 shown = (u32)ts_k_vpl_shown(args, view, texel);
	if (shown == TS_NONE) return true;
	const ts_node *node = &args->scene[shown];
	return args->by_plane != 0 && ts_k_node_height(node, at->p, at->n) <= ts_k_vpl_clear(args, node);
}

static ts_v3 add_lights(const asked *a, const drawn *d, const ts_vpl_gather_args *args, const place *at, ts_v3 sum)
{
	for (u32 i = 0; i < a->n; i++) {
		u32 from = a->which[i], view = d->view[from];
		bool lit = args->shadows == 0 || a->reaches[i] != 0 || is_clear(args, view, d->texel[from], at);
		sum = ts_add(sum, ts_scale(ts_load3(args->lights[view].flux), lit ? d->form[from] : 0.0f));
	}
	return sum;
}

/* Draws [first, first + d->n). */
static ts_v3 gather_lot(const job *j, const place *at, drawn *d, asked *a, u32 first, ts_v3 sum)
{
	const ts_vpl_gather_args *args = &j->args;
	if (args->draws != 0) {
		draw_ranks(d, at->index * args->draws + first, args->seed, at->list.views);
	} else {
		for (u32 i = 0; i < LOT; i++) d->rank[i] = first + i;
	}
	find_views(d, args, &at->list);
	load_lights(d, args, at->p);
	weigh_lights(d, at->n, j->near * j->near, args->n);
	ask_lights(a, d);
	if (args->shadows != 0) {
		load_maps(a, d, j);
		reach_lights(a, *args, at->n);
	}
	return add_lights(a, d, args, at, sum);
}

static ts_v3 gather_lights(const job *j, const place *at)
{
	u32 draws = ts_k_list_draws(&j->args, &at->list);
	ts_v3 sum = ts_v3_make(0, 0, 0);
	drawn d;
	asked a;
	if (at->list.views == 0) return sum;
	memset(&d, 0, sizeof d);
	memset(&a, 0, sizeof a);
	for (u32 first = 0; first < draws; first += d.n) {
		d.n = draws - first < LOT ? draws - first : LOT;
		sum = gather_lot(j, at, &d, &a, first, sum);
	}
	return ts_scale(sum, (f32)at->list.views / (f32)draws);
}

static void gather_pixel(const job *j, u64 i)
{
	const ts_gpixel *pixel = &j->args.pixels[i];
	ts_v3 sum = ts_v3_make(0, 0, 0);
	if (pixel->depth != TS_SKY) {
		place at = {.index = (u32)i, .p = ts_load3(pixel->position), .n = ts_load3(pixel->normal)};
		at.list = ts_k_pixel_list(&j->args, at.p);
		if (at.list.from == TS_NONE) ts_add_i64(j->args.n_astray, 1);
		sum = gather_lights(j, &at);
	}
	ts_store3(j->args.irradiance + i * 3, sum);
}

bool ts_c_fast_vpl_gather(const void *of, u64 n, u32 threads)
{
	job j = {.args = *(const ts_vpl_gather_args *)of};
	u32 n_texels = 2 * j.args.n * j.args.n;
	if (j.args.depths == NULL && j.args.shadows != 0) return false;
	j.near = j.args.near * ts_k_leaf_side(&j.args);
	if (j.args.n <= MOST_TEXELS) j.directions = malloc(n_texels * sizeof *j.directions);
	for (u32 i = 0; j.directions != NULL && i < n_texels; i++) j.directions[i] = ts_k_paraboloid_direction(i, j.args.n);
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, PIXELS_A_CHUNK) num_threads(threads)
	for (i64 i = 0; i < (i64)n; i++) {
		if (ts_stopped(stop)) continue;
		gather_pixel(&j, (u64)i);
	}
	free(j.directions);
	return true;
}

#include "backends/selftest.h"
