/* A built-in scene: its materials, its shapes, and a rug that makes up the exact number of triangles. scenes.def has
 * the list. */
#ifndef TS_SCENE_BUILTIN_BUILTIN_H
#define TS_SCENE_BUILTIN_BUILTIN_H
#include "scene/builtin/mesh.h"
#include "scene/builtin/paint.h"
#include "scene/builtin/parts.h"

enum { TS_MAX_PAINTS = 40 };

typedef struct {
	ts_builtin_info info;
	const ts_paint *paints; /* its materials, in order */
	u32 n_paints;
	/* material: indices of the paints in the build. The count must not fall when `detail` rises. */
	void (*shape)(ts_mesh *mesh, const u32 *material);
	ts_rug rug;              /* made of exactly the triangles that are left; its material is an index into `paints` */
	const f32 (*mirrors)[4]; /* balls: middle and radius */
	u32 n_mirrors;
	void (*beyond)(ts_build *build); /* adds what eye and mirrors do not follow from; NULL: nothing */
	/* For a scene of surfels, instead of the members above: makes at most `count` surfels, of a radius in spacings. */
	void (*surfels)(ts_build *build, u32 count, f32 splat_radius);
	const char *camera; /* the camera if none is named; NULL: the circling eye */
} ts_builtin;

/* Adds a camera that looks along -z, and down by `down` a metre. */
void ts_builtin_camera(ts_build *build, const char *name, ts_v3 eye, f32 down);

#define SCENE(name) extern const ts_builtin ts_builtin_##name;
#include "scene/builtin/scenes.def"
#undef SCENE

#endif
