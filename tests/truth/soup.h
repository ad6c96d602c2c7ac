/* A scene of random triangles with reflectors among them: nothing is regular, so nothing hides. */
#ifndef TS_TESTS_TRUTH_SOUP_H
#define TS_TESTS_TRUTH_SOUP_H
#include <stddef.h>
#include "kernels/base/scene.h"
#include "scene/sources.h"

enum { SOUP_MATERIALS = 8, SOUP_STREAM = 6, SOUP_SEED = 21 };

/* Uniform in [-1, 1); *id counts on. */
static inline f32 soup_random(u32 *id) { return ts_uniform(ts_random((*id)++, SOUP_STREAM, SOUP_SEED)) * 2.0f - 1.0f; }

static inline u32 soup_corner(ts_build *build, u32 *id, ts_v3 middle, f32 size)
{
	ts_vertex v = {.colour = {1, 1, 1, 1}};
	f32 x = soup_random(id), y = soup_random(id);
	ts_store3(v.position, ts_mad(middle, ts_v3_make(x, y, soup_random(id)), size));
	return ts_build_vertex(build, &v);
}

/* Coloured materials, every other one two-sided. */
static inline void soup_materials(ts_build *build, u32 *id)
{
	for (u32 i = 0; i < SOUP_MATERIALS; i++) {
		ts_material m = ts_material_default();
		for (u32 k = 0; k < 3; k++) m.base[k] = soup_random(id) * 0.5f + 0.5f;
		m.flags = i % 2 ? TS_DOUBLE_SIDED : 0;
		ts_build_material(build, &m);
	}
}

/* n triangles in a box of 20 x 10 x 20, most of them small, and the added reflectors. NULL: see the message. */
static inline ts_scene *soup_open(const ts_params *params, u32 n)
{
	ts_build *build = ts_build_new("soup");
	ts_scene *scene = NULL;
	u32 id = 0;
	if (build == NULL) return NULL;
	soup_materials(build, &id);
	for (u32 i = 0; i < n; i++) {
		f32 x = soup_random(&id) * 10, y = soup_random(&id) * 5;
		ts_v3 middle = ts_v3_make(x, y, soup_random(&id) * 10);
		f32 size = i % 16 == 0 ? 2.0f : i % 2 ? 0.3f : 0.05f;
		u32 a = soup_corner(build, &id, middle, size), b = soup_corner(build, &id, middle, size);
		ts_build_triangle(build, a, b, soup_corner(build, &id, middle, size), i % SOUP_MATERIALS);
	}
	ts_reflectors_add(build, params, NULL, NULL);
	return ts_build_finish(build, params, NULL, &scene) == TS_OK ? scene : NULL;
}

#endif
