/* Things that more than one built-in scene has. Each is placed at mesh->place, which it leaves unchanged;
 * mesh->material is changed and not restored. */
#ifndef TS_SCENE_BUILTIN_PARTS_H
#define TS_SCENE_BUILTIN_PARTS_H
#include "scene/builtin/mesh.h"

/* A pot of this radius with a plant in it. kind 0: a bush of broad leaves; 1: long arching blades. */
typedef struct {
	u32 pot, soil, stem, leaf;
} ts_plant_materials;
void ts_part_plant(ts_mesh *mesh, const ts_plant_materials *material, f32 radius, f32 height, u32 kind, u32 id);

/* Cloth in the plane z = 0, from (-width/2, 0) down to -height, in `folds` folds of this depth, gathered at its foot to
 * `gather` of its width. */
void ts_part_curtain(ts_mesh *mesh, f32 width, f32 height, f32 folds, f32 depth, f32 gather, u32 id);

/* A string hanging between two points, `sag` below the straight line in its middle. */
void ts_part_rope(ts_mesh *mesh, ts_v3 a, ts_v3 b, f32 sag, f32 radius, u32 na, u32 nl);

/* A chain of n links from a straight down, each of this length. */
void ts_part_chain(ts_mesh *mesh, ts_v3 a, u32 n, f32 link, f32 radius);

/* A picture of half sizes hx, hy in a carved frame, facing +z. */
void ts_part_picture(ts_mesh *mesh, u32 frame, u32 picture, f32 hx, f32 hy, f32 width);

/* A ring (torus) around the y axis; na around the tube, nl along. */
void ts_part_ring(ts_mesh *mesh, f32 ring, f32 tube, u32 na, u32 nl);

/* A straight wall strip of profile (z out, y up), from (-half, 0, 0) to (half, 0, 0), facing +z. */
void ts_part_moulding(ts_mesh *mesh, f32 half, const f32 (*profile)[2], u32 n_points, u32 n_along);

/* A rug along x about (0, 0, z), lying unevenly `height` or a little more above the floor. */
typedef struct {
	u32 material;
	f32 half_x, half_z, z, height; /* metres */
	f32 repeats;                   /* of its picture, along x */
	f32 waves[4];                  /* turns over half its length and width: of the long swell, of the short one */
} ts_rug;
/* Of exactly n triangles, n at least 8, of mesh->material. */
void ts_part_rug(ts_mesh *mesh, const ts_rug *rug, u32 n);

/* A bicycle standing at y = 0, riding along x; 1.7 m long. */
typedef struct {
	u32 rubber, steel, paint, leather;
} ts_bicycle_materials;
void ts_part_bicycle(ts_mesh *mesh, const ts_bicycle_materials *material);

#endif
