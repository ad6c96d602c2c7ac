/* A pixel of `direct`: the triangles of light that give it most. */
#include <stdlib.h>
#include "../../../kernels/hulls/direct.h"
#include "../../raster/tools/probe.h"
#include "probe.h"

enum { MOST_LISTED = 16 };

typedef struct {
	u32 patch;
	ts_v3 light;
} term;

static int by_light(const void *a, const void *b)
{
	const term *s = a, *t = b;
	f32 x = s->light.x + s->light.y + s->light.z, y = t->light.x + t->light.y + t->light.z;
	return x != y ? (x < y) - (x > y) : (s->patch > t->patch) - (s->patch < t->patch);
}

static ts_status put_terms(ts_probe *p, json_t *o, const ts_gpixel *pixel, const ts_patch *patches, const term *terms,
                           u32 n)
{
	ts_probe_lamps lamps;
	json_t *list = json_array();
	ts_status status = ts_probe_read_lamps(p, TS_PROBE_A_VIEW, &lamps);
	for (u32 i = 0; i < n && status == TS_OK; i++) {
		json_t *entry = json_object();
		const ts_patch *patch = &patches[terms[i].patch];
		ts_v3 at = ts_load3(pixel->position), a = ts_load3(patch->a), b = ts_load3(patch->b), c = ts_load3(patch->c);
		status = ts_probe_put_patch(p, entry, &lamps, terms[i].patch, patch);
		ts_probe_put(p, entry, "form_factor", ts_probe_bits(ts_k_form_factor(at, ts_load3(pixel->normal), a, b, c)));
		ts_probe_put(p, entry, "irradiance", ts_probe_v3_bits(terms[i].light));
		ts_probe_append(p, list, entry);
	}
	ts_probe_put(p, o, "brightest", list);
	return status;
}

static ts_status put_all(ts_probe *p, json_t *o, const ts_gpixel *pixel, const ts_patch *patches, u32 n,
                         f32 irradiance[3])
{
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	u32 n_giving = 0;
	term *terms = ts_alloc(n + (size_t)1, sizeof *terms, "triangles of light");
	if (terms == NULL) return TS_ERROR;
	for (u32 k = 0; k < n; k++) {
		ts_v3 light = ts_k_direct(&patches[k], ts_load3(pixel->position), ts_load3(pixel->normal));
		sum = ts_add(sum, light);
		if (light.x + light.y + light.z > 0.0f) terms[n_giving++] = (term){k, light};
	}
	qsort(terms, n_giving, sizeof *terms, by_light);
	ts_probe_put(p, o, "triangles_of_light", ts_probe_int(n));
	ts_probe_put(p, o, "that_give", ts_probe_int(n_giving));
	ts_status status = put_terms(p, o, pixel, patches, terms, n_giving < MOST_LISTED ? n_giving : MOST_LISTED);
	free(terms);
	ts_direct_args args = {.pixels = pixel, .patches = patches, .irradiance = irradiance, .n_patches = n};
	ts_k_direct_item(&args, 0);
	ts_probe_put_sum(p, o, sum, ts_load3(irradiance));
	return status;
}

static ts_status put_direct(ts_probe *p, const ts_probe_seen *at, const ts_gpixel *pixel, json_t *object,
                            f32 irradiance[3])
{
	json_t *o = json_object();
	const ts_patch *patches = ts_probe_whole(p, TS_B_rsm_patch);
	u64 n = ts_probe_n(p, TS_B_rsm_patch);
	(void)at;
	ts_status status = patches != NULL ? put_all(p, o, pixel, patches, (u32)n, irradiance) : TS_ERROR;
	ts_probe_put(p, object, "direct", o);
	return status;
}

static ts_status put_light(ts_probe *p, const ts_probe_seen *at, json_t *o, ts_v3 *radiance)
{
	return ts_probe_put_indirect(p, at, put_direct, o, radiance);
}

ts_status ts_probe_direct_pixel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	static const ts_buffer_id needed[] = {TS_B_eye_depth_triangle, TS_B_rsm_patch, TS_N_BUFFERS};
	return ts_probe_eye_pixel(p, q, needed, put_light, o);
}
