/* Distributes a truth's triangles among geometries of Embree: see parts.h. The order of the triangles, which decides
 * between equal distances, does not depend on the borders of parts. */
#include "truth/parts.h"
#include <stdlib.h>
#include <string.h>

enum { LONG_RUNS = 256 }; /* at most this many runs are long */

static u32 kind_of(const ts_arrays *scene, u32 triangle)
{
	u32 flags = scene->materials[scene->triangles[triangle].material].flags & (TS_DOUBLE_SIDED | TS_MASKED);
	return flags | (ts_k_reflector_of(scene, triangle) != TS_NONE ? TS_OF_REFLECTOR : 0);
}

static ts_truth_facet facet_of(const ts_arrays *scene, u32 triangle)
{
	ts_corners corner = ts_k_corners(scene, triangle);
	ts_truth_facet facet = {.reflector = ts_k_reflector_of(scene, triangle), .kind = kind_of(scene, triangle)};
	memcpy(facet.normal, &corner.n, sizeof facet.normal);
	memcpy(facet.corner, &corner.a, sizeof facet.corner);
	return facet;
}

/* Appends to the n triangles those that no ray passes, or the others; returns their new number. Skips those without an
 * area. */
static u32 append(ts_truth *truth, u32 n, bool solid)
{
	const ts_arrays *scene = &truth->scene;
	for (u32 t = 0; t < scene->n_triangles; t++) {
		bool is_wanted = (kind_of(scene, t) == TS_DOUBLE_SIDED) == solid;
		if (is_wanted && !ts_k_is_degenerate(ts_k_corners(scene, t).n)) truth->triangle[n++] = t;
	}
	return n;
}

static void add_part(ts_truth *truth, u32 first, u32 n, const ts_truth_facet *facet)
{
	if (n == 0) return;
	u32 kind = facet != NULL ? facet[0].kind : TS_DOUBLE_SIDED;
	for (u32 i = 0; i < n && facet != NULL; i++) kind = facet[i].kind == kind ? kind : TS_MIXED;
	truth->parts[truth->n_parts++] =
		(ts_truth_part){.truth = truth, .triangle = truth->triangle + first, .facet = facet, .n = n, .kind = kind};
}

/* Splits off long runs of one kind, and the triangles between them. */
static void split(ts_truth *truth, u32 first, u32 n)
{
	const ts_truth_facet *facet = truth->facet;
	u32 begin = 0, end = 0;
	for (u32 i = 0; i < n; i = end) {
		while (end < n && facet[end].kind == facet[i].kind) end++;
		if (end - i <= n / LONG_RUNS) continue;
		add_part(truth, first + begin, i - begin, facet + begin);
		add_part(truth, first + i, end - i, facet + i);
		begin = end;
	}
	add_part(truth, first + begin, n - begin, facet + begin);
}

ts_status ts_truth_parts_make(ts_truth *truth)
{
	truth->triangle = ts_alloc(truth->scene.n_triangles, sizeof *truth->triangle, "truth's triangles");
	truth->parts = ts_alloc(TS_MOST_PARTS, sizeof *truth->parts, "truth's triangles");
	if (truth->triangle == NULL || truth->parts == NULL) return TS_ERROR;
	u32 open = append(truth, 0, true), n = append(truth, open, false) - open;
	truth->facet = ts_alloc(n, sizeof *truth->facet, "truth's triangles");
	if (truth->facet == NULL) return TS_ERROR;
	for (u32 i = 0; i < n; i++) truth->facet[i] = facet_of(&truth->scene, truth->triangle[open + i]);
	add_part(truth, 0, open, NULL);
	split(truth, open, n);
	return TS_OK;
}

void ts_truth_parts_free(ts_truth *truth)
{
	free(truth->triangle);
	free(truth->facet);
	free(truth->parts);
}
