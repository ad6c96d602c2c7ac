/* A pixel of `direct`: the brightest triangles of light and lamps without extent; and the triangles of light that a
 * trace gathers from, texels of reflective shadow maps or lamps. */
#include <inttypes.h>
#include <stdlib.h>
#include "kernels/hulls/polygon.h"
#include "methods/hulls/gloss.h"
#include "methods/hulls/tools/probe.h"
#include "methods/raster/tools/probe.h"

const ts_buffer_id *ts_probe_source_needed(const ts_probe *p)
{
	static const ts_buffer_id texels[] = {TS_B_eye_depth_triangle, TS_B_rsm_patch, TS_N_BUFFERS};
	static const ts_buffer_id lamps[] = {TS_B_eye_depth_triangle, TS_B_lamp_light, TS_B_lamp_shape, TS_B_polygon_patch,
	                                     TS_N_BUFFERS};
	return ts_probe_makes(p, TS_B_rsm_patch) ? texels : lamps;
}

static ts_status read_lamps(ts_probe *p, ts_direct_args *source)
{
	u64 n = ts_probe_n(p, TS_B_lamp_light), n_shapes = ts_probe_n(p, TS_B_lamp_shape);
	source->lamps = ts_probe_whole(p, TS_B_lamp_light);
	source->shapes = source->lamps != NULL ? ts_probe_whole(p, TS_B_lamp_shape) : NULL;
	if (source->shapes == NULL) return TS_ERROR;
	if (n >= TS_NONE || n_shapes != n || source->n_patches != n * TS_LAMP_TRIANGLES) {
		return ts_fail("%s: %" PRIu64 " lamps, %" PRIu64 " shapes and %" PRIu64 " triangles of light; of each lamp one "
		               "shape and %u triangles would be right",
		               p->trace->dir, n, n_shapes, source->n_patches, TS_LAMP_TRIANGLES);
	}
	source->n_lamps = (u32)n;
	return TS_OK;
}

ts_status ts_probe_read_source(ts_probe *p, ts_direct_args *source)
{
	bool of_texels = ts_probe_makes(p, TS_B_rsm_patch);
	ts_buffer_id id = of_texels ? TS_B_rsm_patch : TS_B_polygon_patch;
	*source = (ts_direct_args){.patches = ts_probe_whole(p, id), .n_patches = ts_probe_n(p, id)};
	if (source->patches == NULL) return TS_ERROR;
	return of_texels ? TS_OK : read_lamps(p, source);
}

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

/* Light of a triangle by index; the indices after those of triangles are lamps without extent. */
static ts_v3 light_of(const ts_direct_args *from, const ts_gpixel *pixel, u32 index)
{
	ts_v3 at = ts_load3(pixel->position), n = ts_load3(pixel->normal), none = {0, 0, 0};
	if (index < from->n_patches) return ts_k_direct(&from->patches[index], at, n);
	u32 lamp = index - (u32)from->n_patches;
	return from->shapes[lamp].radius > 0.0f ? none : ts_k_direct_point(&from->lamps[lamp], at, n);
}

static ts_status put_triangle(ts_probe *p, json_t *o, const ts_direct_args *from, const ts_probe_lamps *lamps,
                              u32 index, const ts_gpixel *pixel)
{
	ts_status status = TS_OK;
	const ts_patch *patch = &from->patches[index];
	ts_v3 at = ts_load3(pixel->position), a = ts_load3(patch->a), b = ts_load3(patch->b), c = ts_load3(patch->c);
	if (from->n_lamps == 0) {
		status = ts_probe_put_patch(p, o, lamps, index, patch);
	} else {
		ts_probe_put(p, o, "patch", ts_probe_int(index));
		ts_probe_put(p, o, "light", ts_probe_int(index / TS_LAMP_TRIANGLES));
		ts_probe_put_shining(p, o, patch);
	}
	ts_probe_put(p, o, "form_factor", ts_probe_bits(ts_k_form_factor(at, ts_load3(pixel->normal), a, b, c)));
	return status;
}

static ts_status put_terms(ts_probe *p, json_t *o, const ts_gpixel *pixel, const ts_direct_args *from,
                           const term *terms, u32 n)
{
	ts_probe_lamps lamps = {.lens = TS_PROBE_A_VIEW};
	json_t *list = json_array();
	ts_status status = from->n_lamps == 0 ? ts_probe_read_lamps(p, TS_PROBE_A_VIEW, &lamps) : TS_OK;
	for (u32 i = 0; i < n && status == TS_OK; i++) {
		json_t *entry = json_object();
		if (terms[i].patch < from->n_patches) {
			status = put_triangle(p, entry, from, &lamps, terms[i].patch, pixel);
		} else {
			ts_probe_put(p, entry, "light", ts_probe_int(terms[i].patch - from->n_patches));
		}
		ts_probe_put(p, entry, "irradiance", ts_probe_v3_bits(terms[i].light));
		ts_probe_append(p, list, entry);
	}
	ts_probe_put(p, o, "brightest", list);
	return status;
}

static ts_status put_all(ts_probe *p, json_t *o, const ts_gpixel *pixel, const ts_direct_args *from, f32 irradiance[3])
{
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	u32 n = (u32)from->n_patches + from->n_lamps, n_giving = 0;
	term *terms = ts_alloc(n + (size_t)1, sizeof *terms, "triangles of light");
	if (terms == NULL) return TS_ERROR;
	for (u32 k = 0; k < n; k++) {
		ts_v3 light = light_of(from, pixel, k);
		sum = ts_add(sum, light);
		if (light.x + light.y + light.z > 0.0f) terms[n_giving++] = (term){k, light};
	}
	qsort(terms, n_giving, sizeof *terms, by_light);
	ts_probe_put(p, o, "triangles_of_light", ts_probe_int(from->n_patches));
	ts_probe_put(p, o, "that_give", ts_probe_int(n_giving));
	ts_status status = put_terms(p, o, pixel, from, terms, n_giving < MOST_LISTED ? n_giving : MOST_LISTED);
	free(terms);
	ts_direct_args args = *from;
	args.pixels = pixel;
	args.irradiance = irradiance;
	ts_k_direct_item(&args, 0);
	ts_probe_put_sum(p, o, sum, ts_load3(irradiance));
	return status;
}

/* Specular light of a triangle by index; the indices after those of triangles are lamps without extent. */
static ts_v3 reflected_of(const ts_direct_args *from, const ts_glossy *glossy, ts_v3 p, u32 index, u32 vmf)
{
	ts_v3 none = {0, 0, 0};
	if (index < from->n_patches) return ts_k_gloss_direct(glossy, &from->patches[index], p, vmf);
	u32 lamp = index - (u32)from->n_patches;
	return from->shapes[lamp].radius > 0.0f ? none : ts_k_gloss_direct_point(glossy, &from->lamps[lamp], p, vmf);
}

static void put_reflections(ts_probe *p, json_t *o, const ts_direct_args *from, const term *terms, u32 n)
{
	json_t *list = json_array();
	for (u32 i = 0; i < n; i++) {
		json_t *entry = json_object();
		u32 index = terms[i].patch, n_patches = (u32)from->n_patches;
		ts_probe_put(p, entry, index < n_patches ? "patch" : "light", ts_probe_int(index % n_patches));
		ts_probe_put(p, entry, "radiance", ts_probe_v3_bits(terms[i].light));
		ts_probe_append(p, list, entry);
	}
	ts_probe_put(p, o, "brightest", list);
}

static ts_status put_specular(ts_probe *p, const ts_probe_seen *at, json_t *object, const ts_direct_args *from,
                              const ts_gpixel *pixel, f32 specular[3])
{
	ts_glossy glossy;
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f), place = ts_load3(pixel->position);
	u32 n = (u32)from->n_patches + from->n_lamps, vmf = TS_PARAM(&p->trace->params, hull_sharpness) == TS_SHARPNESS_VMF;
	term *terms = ts_alloc(n + (size_t)1, sizeof *terms, "triangles of light");
	if (terms == NULL) return TS_ERROR;
	json_t *o = json_object();
	ts_status status = ts_probe_put_gloss(p, at, pixel, o, &glossy);
	for (u32 k = 0; k < n; k++) {
		terms[k] = (term){k, reflected_of(from, &glossy, place, k, vmf)};
		sum = ts_add(sum, terms[k].light);
	}
	ts_store3(specular, sum);
	qsort(terms, n, sizeof *terms, by_light);
	put_reflections(p, o, from, terms, n < MOST_LISTED ? n : MOST_LISTED);
	free(terms);
	ts_probe_put(p, object, "gloss", o);
	return status;
}

static ts_status put_direct(ts_probe *p, const ts_probe_seen *at, const ts_gpixel *pixel, json_t *object,
                            ts_probe_gathered *gathered)
{
	json_t *o = json_object();
	ts_direct_args from;
	gathered->reflects = ts_gloss_is_asked(&p->trace->params);
	ts_status status = ts_probe_read_source(p, &from);
	if (status == TS_OK) status = put_all(p, o, pixel, &from, gathered->irradiance);
	ts_probe_put(p, object, "direct", o);
	if (status != TS_OK || !gathered->reflects) return status;
	return put_specular(p, at, object, &from, pixel, gathered->specular);
}

static ts_status put_light(ts_probe *p, const ts_probe_seen *at, json_t *o, ts_v3 *radiance)
{
	return ts_probe_put_indirect(p, at, put_direct, o, radiance);
}

ts_status ts_probe_direct_pixel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	return ts_probe_eye_pixel(p, q, ts_probe_source_needed(p), put_light, o);
}
