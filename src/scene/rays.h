/* Ray casts against a scene's triangles at rest, while the scene is built, by a tree of boxes, without Embree. Only the
 * kernels' binary32 arithmetic (CONTRACT rule 4) is used, so every build places things alike. */
#ifndef TS_SCENE_RAYS_H
#define TS_SCENE_RAYS_H
#include "kernels/base/vec.h"
#include "scene/scene.h"

typedef struct ts_rays ts_rays;

/* Farther than anything in a scene: no vertex lies beyond 2^24. */
#define TS_RAYS_FAR 134217728.0f

/* Builds a tree over the triangles of objects with period 0, without those whose corners do not exist or lie beyond
 * 2^24.
 * Returns: the tree, to be released with ts_rays_free; NULL without memory, or cancelled, with the message set.
 * Args:    scene may be under construction; it must outlive the tree and not change. */
ts_rays *ts_rays_new(const ts_scene *scene);
/* NULL is allowed. */
void ts_rays_free(ts_rays *rays);

/* The nearest triangle that the ray sees. Masked triangles, and single-sided ones from behind, let the ray through.
 * Returns: the triangle, or TS_NONE.
 * Args:    way   unit length; most  how far the ray goes.
 * Out:     *distance to the triangle, or most. */
u32 ts_rays_cast(f32 *distance, const ts_rays *rays, ts_v3 from, ts_v3 way, f32 most);

/* The unit normal of a triangle's front, of one that ts_rays_cast returned. */
ts_v3 ts_rays_normal(const ts_rays *rays, u32 triangle);

/* Whether p lies in the matter of a closed body: most rays from p first meet a single-sided triangle from behind. */
bool ts_rays_is_inside(const ts_rays *rays, ts_v3 p);

/* Direction i of n that cover the sphere evenly, from the top down. */
ts_v3 ts_rays_way(u32 i, u32 n);

/* Whether a ray between two points meets nothing; the last 1/256 of the way is left out. */
bool ts_rays_free_between(const ts_rays *rays, ts_v3 from, ts_v3 to);

/* Returns: the distance from p to the nearest triangle, whatever its sides and mask; at most `most`. */
f32 ts_rays_clearance(const ts_rays *rays, ts_v3 p, f32 most);

#endif
