/* Off-screen views of a mesh: random ones, their projection in double precision, and what points leave in them. */
#ifndef TS_TESTS_KERNELS_POINTS_VIEWS_H
#define TS_TESTS_KERNELS_POINTS_VIEWS_H
#include "kernels/points/scatter.h"
#include "kernels/points/split.h"
#include "tests/kernels/points/mesh.h"

/* Of the rates, the one that no kernel asks for by name. */
enum { RATE_IS_EXACT = TS_RATE_WATERTIGHT + 1 };

static inline ts_v3 unit3(void)
{
	for (;;) {
		ts_v3 d = uniform3(-1, 1);
		f32 l = ts_length(d);
		if (l > 0.1f && l <= 1) return ts_scale(d, 1 / l);
	}
}

/* A view without an offset that looks along -back, rolled at random: `reach` is the tangent of half the field of view,
 * of orthographic ones half the extent. */
static inline ts_offscreen view_from(ts_v3 eye, ts_v3 back, f32 reach, u32 n, f32 near, u32 orthographic)
{
	ts_offscreen r = {.width = n,
	                  .height = n,
	                  .near = near,
	                  .reach = {reach, reach},
	                  .focal = (f32)n / (2 * reach),
	                  .orthographic = orthographic,
	                  .object = TS_NONE,
	                  .light = TS_NONE};
	ts_v3 right = ts_normalize(ts_cross(unit3(), back));
	ts_store3(r.eye, eye);
	ts_store3(r.right, right);
	ts_store3(r.up, ts_cross(back, right));
	ts_store3(r.back, back);
	return r;
}

/* Where a point appears: pixels, and axial depth. */
typedef struct {
	double x, y, z;
} d3_place;

static inline d3_place view_place(const ts_offscreen *view, d3 p)
{
	d3 d = d3_sub(p, d3_load(view->eye));
	double z = -d3_dot(d3_load(view->back), d), over = view->orthographic != 0 ? 1 : z;
	return (d3_place){view->width * 0.5 + view->focal * d3_dot(d3_load(view->right), d) / over,
	                  view->height * 0.5 - view->focal * d3_dot(d3_load(view->up), d) / over, z};
}

/* The ray through a place of the image. */
typedef struct {
	d3 from, way;
} d3_ray;

static inline d3_ray view_ray(const ts_offscreen *view, double x, double y)
{
	double right = (x - view->width * 0.5) / view->focal, up = (view->height * 0.5 - y) / view->focal;
	d3 eye = d3_load(view->eye), aside = d3_add(d3_scale(d3_load(view->right), right), d3_scale(d3_load(view->up), up));
	d3 ahead = d3_scale(d3_load(view->back), -1);
	if (view->orthographic != 0) return (d3_ray){d3_add(eye, aside), ahead};
	return (d3_ray){eye, d3_add(aside, ahead)};
}

/* How far along the ray the plane of a triangle is, in axial depth; what the corners weigh there. */
static inline double ray_meets(const d3_ray *ray, d3 a, d3 b, d3 c, double weight[3])
{
	d3 n = d3_cross(d3_sub(b, a), d3_sub(c, a));
	double t = d3_dot(n, d3_sub(a, ray->from)) / d3_dot(n, ray->way), area = d3_dot(n, n);
	d3 p = d3_mad(ray->from, ray->way, t);
	weight[0] = d3_dot(d3_cross(d3_sub(c, b), d3_sub(p, b)), n) / area;
	weight[1] = d3_dot(d3_cross(d3_sub(a, c), d3_sub(p, c)), n) / area;
	weight[2] = 1 - weight[0] - weight[1];
	return t;
}

static inline ts_density_args views_density(const mesh *m, const ts_offscreen *views, u32 n_views, u32 rate,
                                            i64 *n_capped)
{
	return (ts_density_args){.scene = mesh_arrays(m),
	                         .bits = m->bits,
	                         .n_capped = n_capped,
	                         .n_words = 2,
	                         .split = 1,
	                         .views = views,
	                         .n_views = n_views,
	                         .rate = rate};
}

/* The arguments of scattering all pieces of a mesh, or its points, to its views; tally: points, scatters, writes. */
static inline ts_scatter_args views_scatter(const mesh *m, const ts_offscreen *views, u32 n_views, ts_points_args how,
                                            i64 tally[3])
{
	how.scene = mesh_arrays(m);
	how.pieces = m->pieces;
	how.frames = m->frames;
	how.keys = m->keys;
	how.points = m->points;
	return (ts_scatter_args){.from = how,
	                         .views = views,
	                         .bits = m->bits,
	                         .n_points = &tally[0],
	                         .n_scatters = &tally[1],
	                         .n_writes = &tally[2],
	                         .n_views = n_views,
	                         .n_words = 2,
	                         .exposure = 1};
}

#endif
