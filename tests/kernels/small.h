/* A small scene that tests fill by hand. */
#ifndef TS_TESTS_KERNELS_SMALL_H
#define TS_TESTS_KERNELS_SMALL_H
#include "kernels/base/scene.h"
#include "tests/kernels/seeded.h"

enum { MAX_TRIANGLES = 1024, MAX_TEXELS = 4096 };

typedef struct {
	ts_vertex vertices[3 * MAX_TRIANGLES];
	ts_triangle triangles[MAX_TRIANGLES];
	ts_material materials[4];
	ts_slot slots[5];
	ts_image images[5];
	u64 texels[MAX_TEXELS];
	ts_light lights[4];
	ts_object objects[4];
	u32 n_triangles, n_images, n_texels, n_lights;
	f32 ambient;
} small_scene;

/* White, rough, single-sided materials without textures, and four static objects that reflect nothing. */
static inline void small_clear(small_scene *s)
{
	memset(s, 0, sizeof *s);
	for (u32 i = 0; i < 4; i++) {
		ts_material *m = &s->materials[i];
		for (u32 k = 0; k < 4; k++) m->base[k] = 1;
		for (u32 k = 0; k < 5; k++) m->slot[k] = TS_NONE;
		m->roughness = m->normal_scale = m->occlusion = 1;
		m->alpha_cutoff = 0.5f;
		s->objects[i].reflector = TS_NONE;
	}
}

/* Objects 1 and 2 are reflectors 0 and 1; materials are seen from both sides, in colours. */
static inline void small_mirrors(small_scene *s)
{
	small_clear(s);
	s->objects[1].reflector = 0;
	s->objects[2].reflector = 1;
	for (u32 m = 0; m < 4; m++) {
		s->materials[m].flags = TS_DOUBLE_SIDED;
		ts_store3(s->materials[m].base, uniform3(0, 1));
	}
}

/* Returns its index. Normals are zero, colours white, texture coordinates those of the standard corner. */
static inline u32 small_add(small_scene *s, ts_v3 a, ts_v3 b, ts_v3 c, u32 material, u32 object)
{
	u32 t = s->n_triangles++;
	ts_v3 p[3] = {a, b, c};
	assert_true(t < MAX_TRIANGLES);
	s->triangles[t].material = material;
	for (u32 k = 0; k < 3; k++) {
		ts_vertex *v = &s->vertices[3 * t + k];
		memset(v, 0, sizeof *v);
		ts_store3(v->position, p[k]);
		v->object = object;
		v->uv[0] = k == 1;
		v->uv[1] = k == 2;
		for (u32 i = 0; i < 4; i++) v->colour[i] = 1;
		s->triangles[t].vertex[k] = 3 * t + k;
	}
	return t;
}

static inline u64 texel(u32 r, u32 g, u32 b, u32 a) { return (u64)a << 48 | (u64)b << 32 | (u64)g << 16 | r; }

/* An image of one colour, all its levels, read by slot `slot`, repeated. */
static inline void small_colour(small_scene *s, u32 slot, u32 size, u64 colour)
{
	ts_image *image = &s->images[s->n_images];
	*image = (ts_image){.width = size, .height = size, .first_texel = s->n_texels};
	s->slots[slot] = (ts_slot){.image = s->n_images++, .transform = {1, 0, 0, 0, 1, 0}};
	for (u32 n = size; n > 0; n >>= 1) {
		image->n_levels++;
		assert_true(s->n_texels + n * n <= MAX_TEXELS);
		for (u32 k = 0; k < n * n; k++) s->texels[s->n_texels++] = colour;
	}
}

static inline ts_arrays small_arrays(const small_scene *s)
{
	return (ts_arrays){
		.vertices = s->vertices,
		.triangles = s->triangles,
		.materials = s->materials,
		.slots = s->slots,
		.images = s->images,
		.texels = s->texels,
		.lights = s->lights,
		.objects = s->objects,
		.n_triangles = s->n_triangles,
		.n_lights = s->n_lights,
		.ambient = s->ambient,
	};
}

#endif
