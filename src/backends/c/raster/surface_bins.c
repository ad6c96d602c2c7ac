/* Bins of surfaces: see surface_bins.h. */
#include "backends/c/raster/surface_bins.h"
#include <stddef.h>

void ts_surface_bins_begin(ts_surface_bins *bins, const ts_arrays *scene, ts_surface_done *done, const void *user)
{
	bins->scene = *scene;
	bins->done = done;
	bins->user = user;
	for (u32 b = 0; b < TS_SURFACE_BINS; b++) bins->bin[b].n = 0;
}

static void find(ts_surface_bins *bins, ts_surface_batch *bin)
{
	ts_surfaces found;
	ts_repeat_last(bin->triangle, offsetof(ts_surface_batch, lit) - offsetof(ts_surface_batch, triangle), bin->n);
	ts_surfaces_find(&found, &bins->scene, bin);
	bins->done(bins->user, bin, &found);
	bin->n = 0;
}

void ts_surface_bins_add(ts_surface_bins *bins, const ts_surface_ask *ask)
{
	u32 material = bins->scene.triangles[ask->triangle].material;
	ts_surface_batch *bin = &bins->bin[material % TS_SURFACE_BINS];
	if (bin->n == TS_ABREAST || (bin->n > 0 && bin->material != material)) find(bins, bin);
	u32 i = bin->n++;
	bin->material = material;
	bin->triangle[i] = ask->triangle;
	ts_set_lane3(&bin->w, i, ask->w);
	ts_set_lane3(&bin->normal, i, ask->normal);
	ts_set_lane3(&bin->p, i, ask->p);
	ts_set_lane3(&bin->viewer, i, ask->viewer);
	bin->footprint[i] = ask->footprint;
	bin->lit[i] = ask->lit;
	bin->place[i] = ask->place;
}

void ts_surface_bins_flush(ts_surface_bins *bins)
{
	for (u32 b = 0; b < TS_SURFACE_BINS; b++)
		if (bins->bin[b].n > 0) find(bins, &bins->bin[b]);
}

#include "backends/selftest.h"
