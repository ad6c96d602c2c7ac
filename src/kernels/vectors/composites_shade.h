/* Composites of shading: lights and the BRDF (shade.h), surfaces with their textures (surface.h, texture.h), the bias
 * of depth maps (shadow_map.h). */
#ifndef TS_KERNELS_VECTORS_COMPOSITES_SHADE_H
#define TS_KERNELS_VECTORS_COMPOSITES_SHADE_H
#include "kernels/base/shade.h"
#include "kernels/raster/shadow_map.h"
#include "kernels/vectors/composites_row.h"

TS_VECTOR(light)
{
	ts_v3 l;
	f32 arrives = ts_k_light(ts_row_at_ts_light(in, 0u), ts_row_v3(in, 16u), &l);
	ts_put_v3(out, l);
	ts_put_f32(out, 3u, arrives);
}

TS_FN ts_surface ts_row_surface(TS_GLOBAL const u32 *row)
{
	ts_surface r;
	r.p = ts_row_v3(row, 0u);
	r.n = ts_row_v3(row, 3u);
	r.face = ts_row_v3(row, 6u);
	r.base = ts_row_v3(row, 9u);
	r.emissive = ts_row_v3(row, 12u);
	r.metallic = ts_row_f32(row, 15u);
	r.roughness = ts_row_f32(row, 16u);
	r.occlusion = ts_row_f32(row, 17u);
	r.flags = row[18];
	return r;
}

TS_FN void ts_put_surface(TS_GLOBAL u32 *row, const ts_surface *s)
{
	ts_put_v3(row, s->p);
	ts_put_v3(row + 3, s->n);
	ts_put_v3(row + 6, s->face);
	ts_put_v3(row + 9, s->base);
	ts_put_v3(row + 12, s->emissive);
	ts_put_f32(row, 15u, s->metallic);
	ts_put_f32(row, 16u, s->roughness);
	ts_put_f32(row, 17u, s->occlusion);
	row[18] = s->flags;
}

TS_VECTOR(brdf)
{
	ts_v3 none = ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_surface s;
	/* Set what the BRDF reads; it does not read the rest. */
	s.p = none;
	s.n = none;
	s.face = none;
	s.base = ts_row_v3(in, 10u);
	s.emissive = none;
	s.metallic = ts_row_f32(in, 13u);
	s.roughness = ts_row_f32(in, 14u);
	s.occlusion = 1.0f;
	s.flags = 0u;
	/* Evaluate it for the normal, the viewer and the light of the row. */
	ts_v3 n = ts_row_v3(in, 0u);
	ts_put_v3(out, ts_k_brdf(&s, n, ts_row_v3(in, 3u), ts_row_v3(in, 6u), ts_row_f32(in, 9u)));
}

/* Shades in a scene with one light. */
TS_VECTOR(shade)
{
	ts_surface s = ts_row_surface(in);
	ts_arrays scene;
	scene.lights = ts_row_at_ts_light(in, 23u);
	scene.n_lights = 1u;
	scene.ambient = ts_row_f32(in, 22u);
	ts_put_v3(out, ts_k_shade(&scene, &s, ts_row_v3(in, 19u)));
}

/* The surface in a scene with one triangle and one texture of 2 x 2 texels. */
TS_VECTOR(surface)
{
	ts_arrays scene;
	scene.texels = ts_row_at_u64(in, 0u);
	scene.images = ts_row_at_ts_image(in, 10u);
	scene.slots = ts_row_at_ts_slot(in, 16u);
	scene.materials = ts_row_at_ts_material(in, 28u);
	scene.triangles = ts_row_at_ts_triangle(in, 48u);
	scene.objects = ts_row_at_ts_object(in, 52u);
	scene.vertices = ts_row_at_ts_vertex(in, 64u);
	ts_surface s = ts_k_surface(&scene, 0u, ts_row_v3(in, 124u), ts_row_f32(in, 127u));
	ts_put_surface(out, &s);
}

TS_VECTOR(shadow_bias)
{
	ts_camera_k view = ts_k_view(ts_row_at_ts_view(in, 0u));
	view.orthographic = in[16];
	ts_shadow_test_args args;
	args.bias = ts_row_f32(in, 17u);
	args.slope = ts_row_f32(in, 18u);
	ts_receiver at;
	at.p = ts_row_v3(in, 19u);
	at.n = ts_row_v3(in, 22u);
	at.seen = true;
	ts_put_f32(out, 0u, ts_k_shadow_bias(&args, &view, &at, ts_row_f32(in, 25u)));
}

#endif
