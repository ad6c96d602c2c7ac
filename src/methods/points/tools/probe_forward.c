/* What a reflective pixel of forward-shaded points shows: the colours that its samples looked up, and their mean. */
#include "kernels/points/lookup.h"
#include "methods/points/points.h"
#include "methods/points/tools/probe.h"

typedef struct {
	ts_pixel pixel;
	u32 reflector;
	ts_face cube;
	u32 found[TS_N_SAMPLES];
	u32 used;
	f32 radiance[3];
} world;

static ts_status hold(ts_probe *p, world *w, u64 entry)
{
	if (ts_probe_fetch(p, TS_B_mirror_pixel_record, entry, 1, &w->pixel) != TS_OK) return TS_ERROR;
	w->reflector = w->pixel.reflector;
	w->pixel.reflector = 0;
	if (ts_probe_fetch(p, TS_B_cube_size_face, w->reflector, 1, &w->cube) != TS_OK) return TS_ERROR;
	return ts_probe_fetch(p, TS_B_lookup_colour, entry * TS_N_SAMPLES, TS_N_SAMPLES, w->found);
}

static void shade(const ts_probe *p, world *w)
{
	ts_lookup_args args = {.cubes = &w->cube,
	                       .pixels = &w->pixel,
	                       .found = w->found,
	                       .radiance = w->radiance,
	                       .used = &w->used,
	                       .coloured = 1,
	                       .n_samples = TS_N_SAMPLES,
	                       .first = 1,
	                       .adaptive = TS_PARAM(&p->trace->params, lookup_samples) == TS_SAMPLES_ADAPTIVE};
	ts_k_shade_item(&args, 0);
}

static ts_status put_place(ts_probe *p, json_t *o, const world *w, u32 k)
{
	u64 key;
	u32 n = w->cube.n;
	ts_v3 direction = ts_k_sample_ray(&w->pixel, ts_load3(p->view.eye), k).direction;
	ts_probe_put(p, o, "direction", ts_probe_v3(direction));
	if (n == 0) return TS_OK;
	ts_cube_place place = ts_k_cube_place(direction);
	u64 inside = ts_k_cube_index(place, n);
	ts_probe_put(p, o, "face", ts_probe_face_name(w->reflector, place.face));
	ts_probe_put(p, o, "texel", ts_probe_pair((u32)(inside % n), (u32)(inside / n % n)));
	if (!ts_probe_has(p, TS_B_splat_depth_colour)) return TS_OK;
	if (ts_probe_fetch(p, TS_B_splat_depth_colour, w->cube.offset + inside, 1, &key) != TS_OK) return TS_ERROR;
	if ((u32)key != w->found[k]) {
		ts_probe_put(p, o, "check", json_sprintf("splat.depth_colour holds colour %08x here", (unsigned)key));
	}
	if (key != TS_EMPTY) ts_probe_put(p, o, "distance", ts_probe_bits(ts_u2f((u32)(key >> 32))));
	return TS_OK;
}

static ts_status put_sample(ts_probe *p, const world *w, u32 k, json_t *list)
{
	json_t *o = json_object();
	bool empty = w->found[k] == TS_NONE;
	ts_probe_put(p, o, "k", ts_probe_int(k));
	ts_status status = put_place(p, o, w, k);
	ts_probe_put(p, o, "colour", empty ? json_string("none: background") : json_sprintf("%08x", (unsigned)w->found[k]));
	if (k >= w->used) ts_probe_put(p, o, "used", json_false());
	ts_probe_put(p, o, "radiance", ts_probe_v3_bits(empty ? ts_k_background() : ts_k_shared_radiance(w->found[k])));
	ts_probe_append(p, list, o);
	return status;
}

ts_status ts_probe_colours(ts_probe *p, u64 entry, json_t *o, ts_v3 *total)
{
	static const ts_buffer_id needed[] = {TS_B_lookup_colour, TS_N_BUFFERS};
	world w;
	f32 held[3];
	if (ts_probe_require(p, needed) != TS_OK || hold(p, &w, entry) != TS_OK) return TS_ERROR;
	bool has = ts_probe_has(p, TS_B_shade_radiance);
	if (has && ts_probe_fetch(p, TS_B_shade_radiance, entry * 3, 3, held) != TS_OK) return TS_ERROR;
	shade(p, &w);
	json_t *list = json_array();
	ts_status status = TS_OK;
	for (u32 k = 0; k < TS_N_SAMPLES && status == TS_OK; k++) status = put_sample(p, &w, k, list);
	ts_probe_put(p, o, "reflector", ts_probe_int(w.reflector));
	ts_probe_put(p, o, "cube_size", ts_probe_int(w.cube.n));
	ts_probe_put(p, o, "samples", list);
	ts_probe_put(p, o, "samples_used", ts_probe_int(w.used));
	ts_probe_put(p, o, "tint", ts_probe_v3_bits(ts_v3_make(w.pixel.tint_r, w.pixel.tint_g, w.pixel.tint_b)));
	*total = ts_load3(w.radiance);
	ts_probe_put(p, o, "total", ts_probe_v3_bits(*total));
	if (has) ts_probe_put_check(p, o, TS_B_shade_radiance, w.radiance, held, 3);
	return status;
}
