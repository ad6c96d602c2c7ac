/* Surfaces side by side, and light on them, equal ts_k_surface and ts_k_shade_lit bit for bit: materials with any of
 * the five textures, of any size, levels, wraps, transforms and sets; corners with and without normals and tangents,
 * with degenerate texture coordinates; flat and unlit materials, mirrors; lights of every kind, within range and
 * beyond, in part shadowed; footprints from none to huge; viewers on either side, or on the surface, and lights too. */
#include "backends/c/raster/surface_batch.h"
#include "backends/c/raster/surface_bins.h"
#include "tests/kernels/small.h"

enum { N = 1500, TRIANGLES = 24, SAMPLES = 200, LAMPS = 4, MOST = 8, MATERIALS = 2 * TS_SURFACE_BINS };

static void random_image(small_scene *s, u32 slot)
{
	ts_image *image = &s->images[slot];
	*image = (ts_image){.width = 1 + below(MOST), .height = 1 + below(MOST), .first_texel = s->n_texels};
	u32 width = image->width, height = image->height;
	u32 longest = width > height ? width : height;
	image->n_levels = 1 + below(32 - (u32)__builtin_clz(longest));
	for (u32 l = 0; l < image->n_levels; l++) {
		for (u32 i = 0; i < width * height; i++) s->texels[s->n_texels++] = (u64)bits() << 32 | bits();
		width = width > 1 ? width / 2 : 1;
		height = height > 1 ? height / 2 : 1;
	}
	s->slots[slot] = (ts_slot){.image = slot, .uv_set = below(2), .wrap = {below(3), below(3)}};
	for (u32 k = 0; k < 6; k++) s->slots[slot].transform[k] = below(8) == 0 ? 0 : uniform(-2, 2);
}

static void random_material(ts_material *m)
{
	for (u32 k = 0; k < 4; k++) m->base[k] = uniform(0, 1);
	for (u32 k = 0; k < 3; k++) m->emissive[k] = below(2) == 0 ? 0 : uniform(0, 2);
	for (u32 k = 0; k < 5; k++) m->slot[k] = below(3) == 0 ? TS_NONE : below(5);
	m->metallic = below(3) == 0 ? 0 : uniform(0, 1);
	m->roughness = below(3) == 0 ? 0 : uniform(0, 1);
	m->normal_scale = uniform(-1, 2);
	m->occlusion = uniform(0, 1);
	m->flags = (below(2) == 0 ? TS_DOUBLE_SIDED : 0) | (below(8) == 0 ? TS_UNLIT : 0);
}

static void random_light(ts_light *l)
{
	*l = (ts_light){.kind = below(3), .range = below(2) == 0 ? 0 : uniform(0.5f, 8)};
	l->spot_scale = uniform(1, 8);
	l->spot_offset = -l->spot_scale * uniform(-1, 0.9f);
	ts_store3(l->position, below(4) == 0 ? ts_scale(uniform3(-1, 1), 0x1p-54f) : uniform3(-4, 4));
	ts_store3(l->direction, direction());
	ts_store3(l->intensity, uniform3(0, 20));
}

static void random_vertex(ts_vertex *v)
{
	if (below(4) != 0) ts_store3(v->normal, below(8) == 0 ? uniform3(-1, 1) : direction());
	if (below(2) == 0) ts_store3(v->tangent, direction());
	v->tangent[3] = below(2) == 0 ? 1 : -1;
	for (u32 k = 0; k < 4; k++) {
		v->uv[k] = below(4) == 0 ? (f32)below(3) : uniform(-3, 3);
		v->colour[k] = uniform(0, 1);
	}
}

static void random_triangle(small_scene *s)
{
	f32 side = exp2f(uniform(-6, 3));
	ts_v3 a = below(4) == 0 ? ts_v3_make(0, 0, 0) : uniform3(-2, 2), b = ts_add(a, uniform3(-side, side));
	u32 t = small_add(s, a, b, below(8) == 0 ? b : ts_add(a, uniform3(-side, side)), 0, below(4));
	s->triangles[t].material = below(4) + (below(4) == 0 ? TS_SURFACE_BINS : 0);
	for (u32 k = 0; k < 3; k++) random_vertex(&s->vertices[3 * t + k]);
}

/* Some materials share a bin. */
static ts_arrays random_scene(small_scene *s)
{
	static ts_material materials[MATERIALS];
	small_mirrors(s);
	for (u32 k = 0; k < 5; k++) random_image(s, k);
	for (u32 k = 0; k < MATERIALS; k++) random_material(&materials[k]);
	s->n_lights = below(LAMPS + 1);
	for (u32 k = 0; k < s->n_lights; k++) random_light(&s->lights[k]);
	s->ambient = uniform(0, 1);
	while (s->n_triangles < TRIANGLES) random_triangle(s);
	ts_arrays scene = small_arrays(s);
	scene.materials = materials;
	return scene;
}

typedef struct {
	ts_arrays scene;
	const ts_lamp *lamps;
	ts_surface_ask asks[SAMPLES];
	u32 start;
} check;

static u32 n_done;

static ts_surface_ask random_ask(const ts_arrays *scene, const u32 *lit)
{
	ts_surface_ask a = {.triangle = below(TRIANGLES), .w = random_weights(), .lit = lit};
	ts_corners t = ts_k_corners(scene, a.triangle);
	if (below(4) == 0) a.w = ts_v3_make(below(2) == 0, 0, 0);
	a.normal = t.n;
	a.p = ts_blend(a.w, t.a, t.b, t.c);
	a.viewer = below(16) == 0 ? a.p : uniform3(-4, 4);
	a.footprint = below(8) == 0 ? 0 : exp2f(uniform(-16, 8));
	return a;
}

static bool equal(const ts_surface *s, const ts_surfaces *found, u32 i)
{
	return same_bits3(s->n, ts_lane3(&found->n, i)) && same_bits3(s->face, ts_lane3(&found->face, i)) &&
	       same_bits3(s->base, ts_lane3(&found->base, i)) && same_bits3(s->emissive, ts_lane3(&found->emissive, i)) &&
	       same_bits(s->metallic, found->metallic[i]) && same_bits(s->roughness, found->roughness[i]) &&
	       same_bits(s->occlusion, found->occlusion[i]);
}

static void compare(const void *user, const ts_surface_batch *of, const ts_surfaces *found)
{
	const check *c = user;
	ts_lanes3 radiance;
	ts_light_batch(&radiance, &c->scene, c->lamps, of, found);
	for (u32 i = 0; i < of->n; i++, n_done++) {
		const ts_surface_ask *a = &c->asks[of->place[i]];
		ts_surface s = ts_k_surface(&c->scene, a->triangle, a->w, a->footprint);
		s.p = a->p;
		ts_v3 v = ts_normalize(ts_sub(a->viewer, s.p));
		ts_v3 lit = ts_k_shade_lit(&c->scene, &s, v, a->lit, c->lamps);
		bool good = equal(&s, found, i) && same_bits3(lit, ts_lane3(&radiance, i));
		if (!good) fail_msg("random %u: material %u, flags %u, sample %u", c->start, of->material, s.flags, i);
	}
}

static void surfaces_abreast_equal_the_kernel(void **state)
{
	(void)state;
	static small_scene s;
	static check c;
	static ts_surface_bins bins;
	ts_lamp lamps[LAMPS];
	u32 lit[SAMPLES][LAMPS];
	for (u32 i = 0; i < N; i++) {
		c.start = n_random;
		c.scene = random_scene(&s);
		c.lamps = below(2) == 0 ? lamps : NULL;
		n_done = 0;
		for (u32 k = 0; k < LAMPS; k++) lamps[k] = (ts_lamp){.samples = 1 + below(16)};
		ts_surface_bins_begin(&bins, &c.scene, compare, &c);
		u32 n = 1 + below(SAMPLES);
		for (u32 k = 0; k < n; k++) {
			for (u32 l = 0; l < LAMPS; l++) lit[k][l] = below(lamps[l].samples + 1);
			c.asks[k] = random_ask(&c.scene, c.lamps != NULL ? lit[k] : NULL);
			c.asks[k].place = k;
			ts_surface_bins_add(&bins, &c.asks[k]);
		}
		ts_surface_bins_flush(&bins);
		assert_int_equal(n_done, n);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(surfaces_abreast_equal_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
