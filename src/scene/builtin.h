/* What a built-in scene is made of: it paints its materials, puts its shapes together, and fills up to an exact count.
 * builtin.c knows them by name. */
#ifndef TS_SCENE_BUILTIN_H
#define TS_SCENE_BUILTIN_H
#include "builtin_mesh.h"
#include "builtin_paint.h"

enum { TS_MAX_PAINTS = 40 };

typedef struct {
	const ts_paint *paints; /* its materials, in order */
	u32 n_paints;
	/* material: indices of the paints in the build. The count must not fall when `detail` rises. */
	void (*shape)(ts_mesh *mesh, const u32 *material);
	/* One more part, of exactly n triangles. */
	void (*fill)(ts_mesh *mesh, const u32 *material, u32 n);
	ts_light lights[4];
	u32 n_lights;
} ts_builtin;

extern const ts_builtin ts_builtin_atrium, ts_builtin_gallery, ts_builtin_dining;

#endif
