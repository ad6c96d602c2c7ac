/* Fast path of the shade kernel, with the same bits: neighbouring samples see the same points, so each thread remembers
 * what it shaded. The data for the points of some entries is prefetched, and points of one material are shaded
 * together. Shading operations are counted as the method prescribes, remembered or not. */
#include <omp.h>
#include <stdlib.h>
#include "backends/c/points/point_batch.h"
#include "backends/c/raster/surface_batch.h"
#include "backends/fast.h"
#include "kernels/points/lookup.h"
#include "model/core.h"

enum { SLOTS = 16384, ENTRIES = 256, CHUNK = 4 /* parts */, MOST = ENTRIES * TS_N_SAMPLES };

/* A point's radiance towards a cube's centre, and its place among a part's colours; TS_NONE: not there. */
typedef struct {
	u32 point, cube, place;
	ts_v3 radiance;
} seen;

/* A sample whose colour is not known. */
typedef struct {
	u64 sample;
	u32 cube, place;
	seen *slot; /* NULL: it is not remembered */
} wanted;

/* Where the light of points goes. */
typedef struct {
	const ts_arrays *scene;
	ts_v3 *colour;
} sink;

/* Some entries. */
typedef struct {
	u64 first;
	u32 n, n_colours, n_wanted;
	u32 place[MOST]; /* of each sample among the colours */
	ts_v3 colour[MOST];
	seen *used[MOST]; /* slots, by colour */
	wanted wanted[MOST];
	ts_point_batch points;
	ts_surface_bins bins;
	sink sink;
	seen memory[SLOTS];
} part;

static void forget(part *p)
{
	for (u32 i = 0; i < SLOTS; i++) p->memory[i].point = p->memory[i].place = TS_NONE;
}

static u32 add_colour(part *p, seen *slot)
{
	p->used[p->n_colours] = slot;
	if (slot != NULL) slot->place = p->n_colours;
	return p->n_colours++;
}

static u32 want(part *p, u64 sample, u32 cube, seen *slot)
{
	u32 place = add_colour(p, slot);
	p->wanted[p->n_wanted++] = (wanted){sample, cube, place, slot};
	return place;
}

/* The place of the sample's colour, now or later. */
static u32 recall(part *p, const ts_lookup_args *args, u64 sample, u32 cube)
{
	u32 point = args->found[sample];
	if (point == TS_NONE || ts_k_is_followed(args, sample)) return want(p, sample, cube, NULL);
	seen *slot = &p->memory[(point ^ (cube << 7)) % SLOTS];
	if (slot->point != point || slot->cube != cube) {
		*slot = (seen){.point = point, .cube = cube};
		return want(p, sample, cube, slot);
	}
	if (slot->place != TS_NONE) return slot->place;
	u32 place = add_colour(p, slot);
	p->colour[place] = slot->radiance;
	return place;
}

static void recall_all(part *p, const ts_lookup_args *args)
{
	p->n_colours = p->n_wanted = 0;
	for (u32 i = 0; i < p->n * args->n_samples; i++) {
		u64 entry = p->first + i / args->n_samples;
		p->place[i] = recall(p, args, p->first * args->n_samples + i, ts_k_cube_read(args, entry));
	}
}

static void fetch(const void *from, size_t bytes)
{
	__builtin_prefetch(from);
	__builtin_prefetch((const char *)from + bytes - 1);
}

static void fetch_point(const ts_points_args *from, u32 point)
{
	fetch(&from->points[point], sizeof *from->points);
	fetch(&from->keys[point], sizeof *from->keys);
}

static void fetch_piece(const ts_points_args *from, u32 point)
{
	u32 piece = from->points[point].piece;
	fetch(&from->pieces[piece].triangle, sizeof from->pieces->triangle);
	fetch(&from->frames[piece], sizeof *from->frames);
}

static const ts_triangle *triangle_of(const ts_points_args *from, u32 point)
{
	return &from->scene.triangles[from->pieces[from->points[point].piece].triangle];
}

static void fetch_triangle(const ts_points_args *from, u32 point)
{
	fetch(triangle_of(from, point), sizeof *from->scene.triangles);
}

static void fetch_vertices(const ts_points_args *from, u32 point)
{
	const ts_triangle *t = triangle_of(from, point);
	for (u32 k = 0; k < 3; k++) fetch(&from->scene.vertices[t->vertex[k]], sizeof *from->scene.vertices);
}

/* Each step reads what the step before has prefetched for all points. */
static void fetch_all(const part *p, const ts_lookup_args *args)
{
	static void (*const steps[])(const ts_points_args *, u32) = {fetch_point, fetch_piece, fetch_triangle,
	                                                             fetch_vertices};
	for (u32 step = 0; step < sizeof steps / sizeof *steps; step++) {
		for (u32 i = 0; i < p->n_wanted; i++) {
			if (p->wanted[i].slot != NULL) steps[step](&args->from, args->found[p->wanted[i].sample]);
		}
	}
}

static void put_lit(const void *user, const ts_surface_batch *of, const ts_surfaces *found)
{
	const sink *to = user;
	ts_lanes3 radiance;
	ts_light_batch(&radiance, to->scene, NULL, of, found);
	for (u32 i = 0; i < of->n; i++) to->colour[of->place[i]] = ts_lane3(&radiance, i);
}

/* Like ts_k_sample_radiance. */
static void shade_wanted(part *p, const ts_lookup_args *args)
{
	for (u32 i = 0; i < p->n_wanted; i++) {
		const wanted *w = &p->wanted[i];
		ts_v3 centre = ts_load3(args->cubes[w->cube].centre);
		if (w->slot == NULL || args->coloured != 0) {
			p->colour[w->place] = ts_k_sample_radiance(args, w->sample, centre);
			continue;
		}
		ts_flight point = ts_k_flight_at(&args->from, args->n_pieces, args->found[w->sample]);
		const ts_point_ask ask = {.frame = &args->from.frames[point.piece],
		                          .triangle = args->from.pieces[point.piece].triangle,
		                          .x = point.x,
		                          .y = point.y,
		                          .centre = point.centre,
		                          .viewer = centre,
		                          .length = point.length,
		                          .place = w->place};
		ts_points_add(&p->points, &p->bins, &args->from.scene, &ask);
	}
	ts_points_flush(&p->points, &p->bins);
	ts_surface_bins_flush(&p->bins);
}

/* A slot that another point has taken since keeps that point's place. */
static void remember(part *p)
{
	for (u32 place = 0; place < p->n_colours; place++) {
		seen *slot = p->used[place];
		if (slot == NULL || slot->place != place) continue;
		slot->radiance = p->colour[place];
		slot->place = TS_NONE;
	}
}

static void put(const part *p, const ts_lookup_args *args)
{
	f32 count = (f32)args->n_samples;
	for (u32 entry = 0; entry < p->n; entry++) {
		ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
		const u32 *place = p->place + entry * args->n_samples;
		for (u32 k = 0; k < args->n_samples; k++) sum = ts_add(sum, p->colour[place[k]]);
		ts_v3 mean = ts_v3_make(sum.x / count, sum.y / count, sum.z / count);
		ts_k_shade_put(args, p->first + entry, mean, args->n_samples);
	}
}

static void shade_part(part *p, const ts_lookup_args *args)
{
	recall_all(p, args);
	if (args->n_pieces == 0 && args->coloured == 0) fetch_all(p, args);
	shade_wanted(p, args);
	remember(p);
	put(p, args);
}

bool ts_c_fast_shade(const void *of, u64 n, u32 threads)
{
	const ts_lookup_args *args = of;
	part *parts =
		args->adaptive == 0 && args->n_samples <= TS_N_SAMPLES ? ts_alloc(threads, sizeof *parts, "points seen") : NULL;
	if (parts == NULL) return false;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel num_threads(threads)
	{
		part *p = &parts[omp_get_thread_num()];
		forget(p);
		p->points.n = 0;
		p->sink = (sink){&args->from.scene, p->colour};
		ts_surface_bins_begin(&p->bins, &args->from.scene, put_lit, &p->sink);
#pragma omp for schedule(dynamic, CHUNK)
		for (i64 i = 0; i < (i64)n; i += ENTRIES) {
			if (ts_stopped(stop)) continue;
			p->first = (u64)i;
			p->n = (i64)n - i < ENTRIES ? (u32)((i64)n - i) : ENTRIES;
			shade_part(p, args);
		}
	}
	free(parts);
	return true;
}

#include "backends/selftest.h"
