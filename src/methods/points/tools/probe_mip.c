/* What a reflective pixel of MVR shows: its look-ups in the mip chain of one cube. */
#include <stdlib.h>
#include "kernels/points/mirror.h"
#include "methods/points/tools/probe.h"

/* One texel of level 0: its triangle and its value. */
static ts_status put_texel(ts_probe *p, json_t *o, u32 r, const ts_mip_cube *cube, ts_v3 direction)
{
	u64 key;
	u32 n = cube->n;
	ts_cube_place place = ts_k_cube_place(direction);
	u64 inside = ts_k_cube_index(place, n);
	ts_probe_put(p, o, "direction", ts_probe_v3(direction));
	ts_probe_put(p, o, "face", ts_probe_face_name(r, place.face));
	ts_probe_put(p, o, "texel", ts_probe_pair((u32)(inside % n), (u32)(inside / n % n)));
	if (ts_probe_has(p, TS_B_cube_face_depth_triangle)) {
		u64 at = ts_probe_cubes(p)[r].offset + inside;
		if (ts_probe_fetch(p, TS_B_cube_face_depth_triangle, at, 1, &key) != TS_OK) return TS_ERROR;
		if (key == TS_EMPTY) {
			ts_probe_put(p, o, "triangle", json_string("none: background"));
		} else {
			ts_probe_put(p, o, "depth", ts_probe_bits(ts_u2f((u32)(key >> 32))));
			ts_probe_put_triangle(p, o, (u32)key);
		}
	}
	ts_probe_put(p, o, "radiance", ts_probe_v3_bits(ts_k_mip_texel(cube, 0, inside)));
	return TS_OK;
}

static ts_status put_samples(ts_probe *p, json_t *o, u32 r, const ts_mip_cube *cube, const ts_pixel *pixel)
{
	json_t *list = json_array();
	ts_status status = TS_OK;
	for (u32 k = 0; k < TS_N_SAMPLES && status == TS_OK; k++) {
		json_t *sample = json_object();
		ts_probe_put(p, sample, "k", ts_probe_int(k));
		status = put_texel(p, sample, r, cube, ts_k_sample_ray(pixel, ts_load3(p->view.eye), k).direction);
		ts_probe_append(p, list, sample);
	}
	ts_probe_put(p, o, "samples", list);
	return status;
}

/* Level and place; a level that is not a number would lead the kernel out of the chain. */
static ts_status put_trilinear(ts_probe *p, json_t *o, u32 r, const ts_mip_cube *cube, const ts_pixel *pixel)
{
	ts_v3 eye = ts_load3(p->view.eye);
	f32 level = ts_k_mirror_level(pixel, eye, cube->n);
	if (!(level >= 0.0f && level <= (f32)(ts_k_mip_levels(cube->n) - 1))) {
		return ts_fail("%s: level %g of a cube of %u texels", p->trace->dir, (double)level, (unsigned)cube->n);
	}
	json_t *texel = json_object();
	ts_probe_put(p, o, "level", ts_probe_bits(level));
	ts_cube_place place = ts_k_cube_place(ts_k_mirror_direction(pixel, eye, 0.0f, 0.0f));
	ts_probe_put(p, o, "sharp", ts_probe_v3_bits(ts_k_mip_bilinear(cube, (u32)ts_floor_i32(level), place)));
	ts_status status = put_texel(p, texel, r, cube, ts_k_mirror_direction(pixel, eye, 0.0f, 0.0f));
	ts_probe_put(p, o, "nearest_texel", texel);
	return status;
}

static ts_status put_cube(ts_probe *p, json_t *o, const ts_pixel *pixel, const f32 *texels, f32 radiance[3])
{
	u32 r = pixel->reflector;
	bool many = TS_PARAM(&p->trace->params, mvr_filter) == TS_MVR_SUPERSAMPLE;
	ts_face cube = ts_probe_cubes(p)[r];
	ts_mip_cube mip = {.texels = texels, .n = cube.n};
	ts_pixel alone = *pixel;
	ts_status status = TS_OK;
	alone.reflector = 0;
	if (cube.n != 0) status = many ? put_samples(p, o, r, &mip, pixel) : put_trilinear(p, o, r, &mip, pixel);
	if (status != TS_OK) return status;
	ts_mirror_args args = {.view = &p->view,
	                       .cubes = &cube,
	                       .pixels = &alone,
	                       .mip = texels,
	                       .radiance = radiance,
	                       .n_cubes = 1,
	                       .supersample = many};
	ts_k_mirror_item(&args, 0);
	return TS_OK;
}

ts_status ts_probe_mip(ts_probe *p, u64 entry, json_t *o, ts_v3 *total)
{
	static const ts_buffer_id needed[] = {TS_B_cube_face_mip, TS_N_BUFFERS};
	ts_pixel pixel;
	f32 radiance[3], held[3];
	if (ts_probe_require(p, needed) != TS_OK || ts_probe_fetch(p, TS_B_mirror_pixel_record, entry, 1, &pixel) != TS_OK)
		return TS_ERROR;
	const ts_face *cubes = ts_probe_cubes(p);
	u32 n = cubes[pixel.reflector].n;
	u64 n_texels = ts_k_mip_texels(n, TS_NONE), first = ts_k_mip_first(cubes, 0, pixel.reflector);
	f32 *texels = ts_alloc((size_t)n_texels, 4 * sizeof *texels, "a mip chain");
	ts_status status =
		texels != NULL ? ts_probe_fetch(p, TS_B_cube_face_mip, first * 4, n_texels * 4, texels) : TS_ERROR;
	ts_probe_put(p, o, "reflector", ts_probe_int(pixel.reflector));
	ts_probe_put(p, o, "cube_size", ts_probe_int(n));
	if (status == TS_OK) status = put_cube(p, o, &pixel, texels, radiance);
	free(texels);
	if (status != TS_OK) return status;
	*total = ts_load3(radiance);
	ts_probe_put(p, o, "tint", ts_probe_v3_bits(ts_v3_make(pixel.tint_r, pixel.tint_g, pixel.tint_b)));
	ts_probe_put(p, o, "total", ts_probe_v3_bits(*total));
	if (!ts_probe_has(p, TS_B_shade_radiance)) return TS_OK;
	if (ts_probe_fetch(p, TS_B_shade_radiance, entry * 3, 3, held) != TS_OK) return TS_ERROR;
	ts_probe_put_check(p, o, TS_B_shade_radiance, radiance, held, 3);
	return TS_OK;
}
