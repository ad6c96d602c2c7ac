/* Triangles, in parts that a lattice can hold, sampled as for points. Runs twice: to count, and to write at the sums of
 * the counts. */
#include <stdlib.h>
#include "kernels/base/bisect.h"
#include "kernels/raster/lattice.h"
#include "model/core.h"
#include "scene/build_parts.h"
#include "scene/sources.h"

enum { SAFE = TS_SAFE_HALF, CENTRE = 0, MOST_PARTS = 64 }; /* half sizes of a lattice square, in 1/256 */
#define MOST_SURFELS 268435456.0                           /* 2^28 */

typedef struct {
	ts_arrays scene;
	f32 s; /* samples per world unit */
	f32 radius;
	bool backs; /* of two-sided triangles */
} sampler;

/* The interpolated normal, without the texture's; the triangle's own if that is on the other side. */
static ts_v3 smooth_normal(const sampler *from, u32 triangle, ts_v3 weights, ts_v3 face)
{
	const ts_vertex *vertices = from->scene.vertices;
	const u32 *v = from->scene.triangles[triangle].vertex;
	ts_v3 n = ts_normalize(ts_blend(weights, ts_load3(vertices[v[0]].normal), ts_load3(vertices[v[1]].normal),
	                                ts_load3(vertices[v[2]].normal)));
	return ts_dot(n, face) > 0.0f ? n : face;
}

/* A vector of a triangle's plane, turned by the least angle that takes the plane's normal to a surface's, on the same
 * side. */
static ts_v3 turn(ts_v3 a, ts_v3 plane, ts_v3 n)
{
	return ts_mad(a, ts_add(plane, n), -ts_dot(a, n) / (1.0f + ts_dot(plane, n)));
}

/* Writes a surfel, or only counts it where `out` is NULL. */
static void put(const sampler *from, const ts_piece *piece, const ts_align *frame, ts_v3 centre, i32 x, i32 y,
                bool turned, ts_surfel *out)
{
	if (out == NULL) return;
	ts_surface r = ts_k_lattice_surface(&from->scene, frame, piece->triangle, x, y, centre, 1.0f / from->s);
	ts_v3 w = ts_k_lattice_weights(&from->scene, frame, piece->triangle, x, y);
	ts_v3 n = smooth_normal(from, piece->triangle, w, r.face);
	ts_v3 u = ts_scale(turn(ts_load3(frame->u), r.face, n), from->radius);
	ts_v3 v = ts_scale(turn(ts_load3(frame->v), r.face, n), from->radius);
	ts_store3(out->centre, centre);
	ts_store3(out->u, turned ? v : u);
	ts_store3(out->v, turned ? u : v);
	ts_store3(out->colour, ts_scale(r.base, 1.0f - r.metallic));
}

/* A sample in the part, or one for a square of the lattice that no neighbouring sample represents. */
static bool is_wanted(const ts_cover *safe, const ts_cover *centre, i32 x, i32 y)
{
	if (ts_k_touches(centre, x, y)) return true;
	bool beside = ts_k_touches(centre, x - 1, y) || ts_k_touches(centre, x + 1, y) || ts_k_touches(centre, x, y - 1) ||
	              ts_k_touches(centre, x, y + 1);
	return !beside && ts_k_touches(safe, x, y);
}

/* Samples a part; returns the number of surfels. */
static u32 sample_part(const sampler *from, u32 triangle, const ts_part *part, ts_surfel *out)
{
	u32 n = 0, sides = from->backs && ts_k_is_two_sided(&from->scene, triangle) ? 2 : 1;
	ts_align frame;
	ts_piece piece = {.triangle = triangle, .path = part->path};
	ts_store3(piece.a, part->v[0]);
	ts_store3(piece.b, part->v[1]);
	ts_store3(piece.c, part->v[2]);
	ts_k_lattice_align(&piece, from->s, &frame);
	ts_cover safe = ts_k_lattice_cover(&frame, SAFE), centre_of = ts_k_lattice_cover(&frame, CENTRE);
	for (i32 y = safe.touched.y0; y <= safe.touched.y1; y++) {
		for (i32 x = safe.touched.x0; x <= safe.touched.x1; x++) {
			if (!is_wanted(&safe, &centre_of, x, y)) continue;
			if (!ts_k_is_sample(&from->scene, &piece, &frame, &safe, x, y)) continue;
			ts_v3 centre = ts_k_sample_centre(&piece, &frame, true, x, y);
			for (u32 side = 0; side < sides; side++, n++)
				put(from, &piece, &frame, centre, x, y, side == 1, out != NULL ? &out[n] : NULL);
		}
	}
	return n;
}

/* Bisects a triangle until its parts fit in a lattice (METHODS 2), and samples them in order. */
static u32 sample_triangle(const sampler *from, u32 triangle, ts_surfel *out)
{
	ts_corners t = ts_k_corners(&from->scene, triangle);
	ts_part stack[MOST_PARTS] = {{{t.a, t.b, t.c}, 1}};
	u32 n_parts = ts_k_is_degenerate(t.n) ? 0 : 1, n = 0;
	while (n_parts > 0) {
		ts_part part = stack[--n_parts];
		f32 length, area = ts_k_area(part.v[0], part.v[1], part.v[2]);
		u32 edge = ts_k_longest_edge(part.v[0], part.v[1], part.v[2], &length);
		bool large = area * from->s * from->s > TS_SPLIT_SAMPLES || length * from->s > TS_MOST_WIDTH;
		if (large && n_parts + 2 <= MOST_PARTS) {
			stack[n_parts++] = ts_k_child(&part, edge, 1);
			stack[n_parts++] = ts_k_child(&part, edge, 0);
		} else {
			n += sample_part(from, triangle, &part, out != NULL ? out + n : NULL);
		}
	}
	return n;
}

static double area_of(const sampler *from, u32 n)
{
	double area = 0.0;
	for (u32 i = 0; i < n; i++) {
		ts_corners t = ts_k_corners(&from->scene, i);
		if (!ts_k_is_degenerate(t.n)) area += (double)ts_k_area(t.a, t.b, t.c);
	}
	return area;
}

/* About the most cells that the lattice can touch: those inside, and a row along the border. */
static double cells_of(const sampler *from, u32 n)
{
	double cells = 0.0, s = (double)from->s;
	for (u32 i = 0; i < n; i++) {
		f32 length;
		ts_corners t = ts_k_corners(&from->scene, i);
		ts_k_longest_edge(t.a, t.b, t.c, &length);
		cells += (double)ts_k_area(t.a, t.b, t.c) * s * s + 6.0 * (double)length * s + 4.0;
	}
	return cells;
}

/* Writes at the sums of the counts; `first` has one place more than there are triangles. */
static void sample_all(ts_build *build, const sampler *from, u64 *first)
{
	ts_scene *scene = build->scene;
	u32 n = scene->n_triangles, old = scene->n_surfels;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for num_threads((int)ts_threads_all()) schedule(dynamic, 256)
	for (u32 i = 0; i < n; i++) first[i + 1] = ts_stopped(stop) ? 0 : sample_triangle(from, i, NULL);
	if (ts_build_failed(build)) return;
	first[0] = old;
	for (u32 i = 0; i < n; i++) first[i + 1] += first[i];
	scene->surfels = ts_build_room(build, scene->surfels, old, first[n] - old, &build->capacity.surfels,
	                               sizeof *scene->surfels, "surfels");
	if (build->failed) return;
#pragma omp parallel for num_threads((int)ts_threads_all()) schedule(dynamic, 256)
	for (u32 i = 0; i < n; i++) {
		if (!ts_stopped(stop)) sample_triangle(from, i, scene->surfels + first[i]);
	}
	if (!ts_build_failed(build)) scene->n_surfels = (u32)first[n];
}

static sampler sampler_of(const ts_scene *scene, const ts_params *params)
{
	sampler r = {.scene = {.vertices = scene->vertices,
	                       .triangles = scene->triangles,
	                       .materials = scene->materials,
	                       .slots = scene->slots,
	                       .images = scene->images,
	                       .texels = scene->texels,
	                       .objects = scene->objects,
	                       .n_triangles = scene->n_triangles}};
	double area = area_of(&r, scene->n_triangles);
	r.s = area > 0.0 ? ts_sqrt((f32)((double)TS_PARAM(params, surfels_from_mesh) / area)) : 0.0f;
	r.radius = r.s > 0.0f ? TS_PARAM(params, surfels_radius) / r.s : 0.0f;
	r.backs = TS_PARAM(params, surfels_sides) == TS_SIDES_MATERIAL;
	return r;
}

void ts_sample_add(ts_build *build, const ts_params *params)
{
	const ts_scene *scene = build->scene;
	if (TS_PARAM(params, surfels_from_mesh) == 0) return;
	sampler from = sampler_of(scene, params);
	if (!(from.s > 0.0f) || !(from.radius > 0.0f) || from.s > FLT_MAX || from.radius > FLT_MAX) {
		ts_build_fail(build,
		              "%s: surfels.from_mesh: its triangles have no area, or too much, to sample %u surfels from",
		              scene->name, TS_PARAM(params, surfels_from_mesh));
		return;
	}
	double cells = cells_of(&from, scene->n_triangles);
	if (cells > MOST_SURFELS || cells * sizeof(ts_surfel) > (double)ts_memory_total() / 3.0) {
		ts_build_fail(
			build, "%s: surfels.from_mesh: %u surfels would take up to %.3g; its triangles are many or long and thin",
			scene->name, TS_PARAM(params, surfels_from_mesh), cells);
		return;
	}
	u64 *first = ts_alloc(scene->n_triangles + 1, sizeof *first, "counts of surfels");
	if (first != NULL)
		sample_all(build, &from, first);
	else
		ts_build_adopt(build);
	free(first);
}
