/* Shapes of which the built-in scenes are made. The same code counts and builds: with `build` NULL a shape only adds
 * its triangles to `n`. Lengths in metres, angles in turns; y is up; texture coordinates are metres on the surface.
 * Numbers of segments are proportional to `detail`, so numbers of triangles are proportional to its square. */
#ifndef TS_SCENE_BUILTIN_MESH_H
#define TS_SCENE_BUILTIN_MESH_H
#include "kernels/base/vec.h"
#include "scene/build.h"

/* Part to world: o + p.x x + p.y y + p.z z. The axes are orthogonal, right-handed and equally long. */
typedef struct {
	ts_v3 o, x, y, z;
} ts_place;

typedef struct {
	ts_build *build; /* NULL: count only */
	u32 seed;
	u32 material; /* of the triangles made from now on */
	f32 detail;
	u64 n;          /* triangles made or counted */
	ts_place place; /* of the shapes made from now on */
	ts_v2 shift;    /* of their texture coordinates, metres */
} ts_mesh;

/* One vertex of a surface, in the part's coordinates. A zero normal is made from the neighbours. */
typedef struct {
	ts_v3 p, n;
	ts_v2 uv;
} ts_corner;
/* Sets *corner to the surface point at (s, t) of the unit square. The front is on the side to which ds x dt points. */
typedef void ts_mesh_surface(ts_corner *corner, const void *shape, f32 s, f32 t);
/* Flags of a grid: closed along s; the first, or last, row is one point; a normal for each cell. */
enum { TS_GRID_WRAP_S = 1, TS_GRID_POLE_T0 = 2, TS_GRID_POLE_T1 = 4, TS_GRID_FLAT = 8 };

/* A rectangle cut out of a wall, in metres from its corner. */
typedef struct {
	f32 lo[2], hi[2];
} ts_hole;

/* `base` segments at detail 1, never fewer than `least`. */
u32 ts_mesh_segments(const ts_mesh *mesh, f32 base, u32 least);
/* Whether mesh->detail is at least `detail`, below which a part is left out. */
bool ts_mesh_shows(const ts_mesh *mesh, f32 detail);
/* Uniform in [0,1), by the scene's seed. */
f32 ts_mesh_random(const ts_mesh *mesh, u32 id);

/* The world's own origin and axes. */
ts_place ts_place_world(void);
/* The part's origin at p, turned about y. */
ts_place ts_place_at(f32 x, f32 y, f32 z, f32 turns);
/* `inner` as seen from `outer`. */
ts_place ts_place_in(const ts_place *outer, ts_place inner);
/* The part's y along `up` (any length), its size unchanged. */
ts_place ts_place_along(ts_v3 origin, ts_v3 up);

/* ns by nt cells of two triangles; at a pole (all of a row in one point) one triangle a cell. FLAT: normals are
 * computed for each cell by itself. */
void ts_mesh_grid(ts_mesh *mesh, u32 ns, u32 nt, u32 flags, ts_mesh_surface *surface, const void *shape);
/* A surface of exactly n triangles, n at least 8; `aspect` is its length along s over that along t. */
void ts_mesh_fill(ts_mesh *mesh, u32 n, f32 aspect, ts_mesh_surface *surface, const void *shape);
/* A plane: from o along es and et (both in metres), front es x et. */
void ts_mesh_plane(ts_mesh *mesh, ts_v3 o, ts_v3 es, ts_v3 et, u32 ns, u32 nt);
/* The same with rectangular holes (in metres from o) and cells of about `step`. At most 7 holes. */
void ts_mesh_wall(ts_mesh *mesh, ts_v3 o, ts_v3 es, ts_v3 et, f32 step, const ts_hole *holes, u32 n_holes);
/* A box of these half sizes, its edges rounded with radius r in k steps; k = 0: sharp, 12 triangles. */
void ts_mesh_block(ts_mesh *mesh, ts_v3 centre, ts_v3 half, f32 r, u32 k);
/* A profile of (radius, y) points turned about y, smooth through the points; a point given twice makes an edge. From
 * the bottom up the outside is the front. na segments around, `between` segments (at detail 1) from point to point. */
void ts_mesh_lathe(ts_mesh *mesh, const f32 (*profile)[2], u32 n_points, u32 na, f32 between);
/* A tube through the points; `side` is a direction the path never follows. */
void ts_mesh_tube(ts_mesh *mesh, const ts_v3 *points, u32 n_points, f32 radius, ts_v3 side, u32 na, u32 nl);
/* A straight round bar from a to b. */
void ts_mesh_rod(ts_mesh *mesh, ts_v3 a, ts_v3 b, f32 radius, u32 na);
/* A moulding around a rectangle of half sizes hx, hy in the plane z = 0, facing +z: the profile gives (distance
 * outwards, z) from the outer edge to the inner. `relief` metres of carving, n_along segments a side. */
void ts_mesh_frame(ts_mesh *mesh, f32 hx, f32 hy, const f32 (*profile)[2], u32 n_points, f32 relief, u32 n_along);

/* A smooth curve through n values, `stride` floats apart, that stays between neighbouring values; `at` is 0 to n -
 * 1. */
f32 ts_mesh_spline(const f32 *values, u32 stride, u32 n, f32 at);

#endif
