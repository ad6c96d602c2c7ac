/* What tests of drawing share: a soup of triangles, views of it, and what a view sees by rays in double precision. */
#ifndef TS_TESTS_KERNELS_RASTER_SIGHT_H
#define TS_TESTS_KERNELS_RASTER_SIGHT_H
#include "kernels/raster/raster.h"
#include "tests/kernels/small.h"

/* The ray through a place of an image; its parameter is axial depth. */
typedef struct {
	double3 from, way;
} sight_ray;

static inline sight_ray ray_through(const ts_camera_k *view, double x, double y)
{
	double right = (x - view->width * 0.5) / (double)view->focal, up = (view->height * 0.5 - y) / (double)view->focal;
	double3 aside = d3_mad(d3_scale(d3_of(view->right), right), d3_of(view->up), up);
	double3 eye = d3_of(view->eye), ahead = d3_scale(d3_of(view->back), -1);
	if (view->orthographic != 0) return (sight_ray){d3_add(eye, aside), ahead};
	return (sight_ray){eye, d3_add(aside, ahead)};
}

/* What a ray meets first. */
typedef struct {
	double z, next; /* axial depth, and that of what stands behind it */
	u32 triangle;
	double3 p, w; /* place, and weights of the triangle's corners */
} hit;

static inline double3 corner_of(const small_scene *scene, u32 t, u32 k)
{
	return d3_of(ts_load3(scene->vertices[3 * t + k].position));
}

static inline double3 normal_of(const small_scene *scene, u32 t)
{
	double3 a = corner_of(scene, t, 0);
	return d3_cross(d3_sub(corner_of(scene, t, 1), a), d3_sub(corner_of(scene, t, 2), a));
}

static inline const ts_material *material_of(const small_scene *scene, u32 t)
{
	return &scene->materials[scene->triangles[t].material];
}

static inline double colour_at(const small_scene *scene, const hit *h, u32 channel)
{
	const ts_vertex *v = &scene->vertices[3 * h->triangle];
	double3 colour = {v[0].colour[channel], v[1].colour[channel], v[2].colour[channel]};
	return (double)material_of(scene, h->triangle)->base[channel] * d3_dot(h->w, colour);
}

/* Where the ray meets triangle t, if it does: a one-sided one from its front, a masked one where it is not cut. */
static inline bool meets(const small_scene *scene, const sight_ray *ray, u32 t, hit *h)
{
	double3 n = normal_of(scene, t), a = corner_of(scene, t, 0), b = corner_of(scene, t, 1), c = corner_of(scene, t, 2);
	const ts_material *m = material_of(scene, t);
	if ((m->flags & TS_DOUBLE_SIDED) == 0 && d3_dot(n, ray->way) >= 0) return false;
	h->triangle = t;
	h->z = d3_dot(n, d3_sub(a, ray->from)) / d3_dot(n, ray->way);
	h->p = d3_mad(ray->from, ray->way, h->z);
	h->w = d3_scale((double3){d3_dot(d3_cross(d3_sub(c, b), d3_sub(h->p, b)), n),
	                          d3_dot(d3_cross(d3_sub(a, c), d3_sub(h->p, c)), n),
	                          d3_dot(d3_cross(d3_sub(b, a), d3_sub(h->p, a)), n)},
	                1 / d3_dot(n, n));
	bool inside = h->w.x >= 0 && h->w.y >= 0 && h->w.z >= 0;
	return inside && ((m->flags & TS_MASKED) == 0 || colour_at(scene, h, 3) >= (double)m->alpha_cutoff);
}

/* The nearest triangle beyond the near plane, leaving out those of an object. */
static inline hit cast(const small_scene *scene, const ts_camera_k *view, u32 object, double x, double y)
{
	hit h = {.z = INFINITY, .next = INFINITY, .triangle = TS_NONE};
	sight_ray ray = ray_through(view, x, y);
	for (u32 t = 0; t < scene->n_triangles; t++) {
		hit met;
		if (scene->vertices[3 * t].object == object || !meets(scene, &ray, t, &met)) continue;
		if (met.z < (double)view->near) continue;
		double next = fmin(h.next, fmax(met.z, h.z));
		if (met.z < h.z) h = met;
		h.next = next;
	}
	return h;
}

/* Triangles about the origin of random materials: one-sided, two-sided, masked or unlit; object 1 is a mirror. */
static inline void small_soup(small_scene *scene, u32 n)
{
	small_clear(scene);
	scene->objects[1].reflector = 0;
	for (u32 m = 0; m < 4; m++) {
		const u32 flags[4] = {0, TS_DOUBLE_SIDED, TS_DOUBLE_SIDED | TS_MASKED, TS_DOUBLE_SIDED | TS_UNLIT};
		scene->materials[m].flags = flags[m];
		scene->materials[m].metallic = 0.25f * (f32)m;
		for (u32 k = 0; k < 3; k++) scene->materials[m].base[k] = uniform(0.5f, 1);
	}
	for (u32 i = 0; i < n; i++) {
		ts_v3 a = uniform3(-2, 2), b = uniform3(-2, 2), c = uniform3(-2, 2);
		u32 t = small_add(scene, a, b, c, below(4), below(2));
		for (u32 k = 0; k < 12; k++) scene->vertices[3 * t + k / 4].colour[k % 4] = uniform(0, 1);
	}
}

/* A view of the soup from any side, rolled at random. */
static inline ts_offscreen random_view(u32 size, u32 orthographic)
{
	f32 reach = orthographic != 0 ? 2 : uniform(0.3f, 1);
	ts_v3 back = direction(), right = ts_normalize(ts_cross(direction(), back));
	ts_offscreen r = {.focal = (f32)size / (2 * reach),
	                  .width = size,
	                  .height = size * 3 / 4,
	                  .near = 0.25f,
	                  .reach = {reach, reach * 0.75f},
	                  .orthographic = orthographic,
	                  .object = TS_NONE,
	                  .light = TS_NONE};
	ts_store3(r.eye, ts_mad(uniform3(-0.5f, 0.5f), back, 2));
	ts_store3(r.right, right);
	ts_store3(r.up, ts_cross(back, right));
	ts_store3(r.back, back);
	return r;
}

/* Diffuse reflectance: a mirror's is that of a surface without metal, unlit ones have none. */
static inline double albedo_at(const small_scene *scene, const hit *h, u32 channel)
{
	const ts_material *m = material_of(scene, h->triangle);
	bool mirror = scene->objects[scene->vertices[3 * h->triangle].object].reflector != TS_NONE;
	if ((m->flags & TS_UNLIT) != 0) return 0;
	return colour_at(scene, h, channel) * (mirror ? 1 : 1 - (double)m->metallic);
}

/* What the middle of a pixel sees, and what is seen a hundredth of a pixel aside of it, at four corners. */
typedef struct {
	hit at, around[4];
} sight;

/* Fills *s. True if all five rays see the same triangle, or none, by a clear margin. */
static inline bool is_decided(const small_scene *scene, const ts_camera_k *view, u32 object, u32 pixel, sight *s)
{
	double x = (i32)pixel % view->width + 0.5, y = (i32)pixel / view->width + 0.5, near = view->near;
	s->at = cast(scene, view, object, x, y);
	bool same = s->at.triangle == TS_NONE || (s->at.next - s->at.z > 0.01 * s->at.z && s->at.z > near * 1.01);
	for (u32 k = 0; k < 4 && same; k++) {
		s->around[k] = cast(scene, view, object, x + (k & 1 ? 0.01 : -0.01), y + (k & 2 ? 0.01 : -0.01));
		same = s->around[k].triangle == s->at.triangle;
	}
	return same;
}

/* The value lies between those around the middle. Depths, places and colours do: they are ratios of linear functions of
 * the image, and snapping moves what is seen by less than a hundredth of a pixel. */
static inline void assert_among(double value, const double around[4], double slack)
{
	double least = fmin(fmin(around[0], around[1]), fmin(around[2], around[3]));
	double most = fmax(fmax(around[0], around[1]), fmax(around[2], around[3]));
	if (!(value >= least - slack && value <= most + slack)) print_error("%g is not in %g to %g\n", value, least, most);
	assert_true(value >= least - slack && value <= most + slack);
}

static inline void assert_depth(f32 z, const sight *s)
{
	double around[4];
	for (u32 k = 0; k < 4; k++) around[k] = s->around[k].z;
	assert_among((double)z, around, 1e-5 * s->at.z);
}

/* (b - a) x (c - a) / 2 */
static inline double3 area_of(double3 a, double3 b, double3 c)
{
	return d3_scale(d3_cross(d3_sub(b, a), d3_sub(c, a)), 0.5);
}

/* Area that a rectangle of the image sees of the plane through p: what its four corners' rays cut out. */
static inline double seen_area(const ts_camera_k *view, const double low[2], const double high[2], double3 p, double3 n)
{
	double3 q[4];
	for (u32 k = 0; k < 4; k++) {
		sight_ray ray = ray_through(view, (k + 1) / 2 % 2 ? high[0] : low[0], k / 2 ? high[1] : low[1]);
		q[k] = d3_mad(ray.from, ray.way, d3_dot(n, d3_sub(p, ray.from)) / d3_dot(n, ray.way));
	}
	return d3_length(area_of(q[0], q[1], q[2])) + d3_length(area_of(q[0], q[2], q[3]));
}

#endif
