/* A pixel of a deferred shader: its lights one by one with their shadows, and whether the surface ends there. */
#include "methods/stages.h"
#include "methods/surfels/surfel.h"
#include "methods/surfels/tools/probe.h"

/* The neighbours and their effect. Returns whether one of them makes an outline. */
static bool put_outline(ts_probe *p, json_t *object, const ts_deferred_args *args, u64 pixel)
{
	json_t *o = json_object(), *list = json_array();
	bool outline = ts_k_is_outline(args, pixel);
	for (u32 k = 0; k < 4; k++) {
		ts_border next = ts_k_border(args, pixel, k);
		json_t *entry = json_object();
		if (!next.is) {
			json_decref(entry);
			continue;
		}
		ts_probe_put(p, entry, "neighbour", ts_probe_pair((u32)next.x, (u32)next.y));
		ts_probe_put(p, entry, "farther", ts_probe_real(next.farther));
		ts_probe_put(p, entry, "than", ts_probe_real(next.step));
		if (!next.sky) {
			ts_probe_put(p, entry, "below", ts_probe_real(next.below));
			ts_probe_put(p, entry, "more_than", ts_probe_real(next.drop));
		}
		const char *end = next.sky ? "ends before the sky" : "ends";
		ts_probe_put(p, entry, "answer", json_string(ts_k_ends(&next) ? end : "goes on"));
		ts_probe_append(p, list, entry);
	}
	ts_probe_put(p, o, "by_neighbour", list);
	ts_probe_put(p, o, "answer", json_string(outline ? "black: the surface ends" : "none"));
	ts_probe_put(p, object, "outline", o);
	return outline;
}

/* Like ts_k_deferred_light. */
static ts_v3 put_light(ts_probe *p, json_t *list, const ts_deferred_args *args, u64 pixel, u32 k)
{
	ts_v3 l;
	json_t *o = json_object();
	const ts_gpixel *at = &args->pixels[pixel];
	ts_v3 position = ts_load3(at->position), n = ts_load3(at->normal);
	ts_v3 v = ts_normalize(ts_sub(ts_load3(args->view->eye), position));
	const u32 *lit = args->lit != NULL ? args->lit + pixel * args->n_lights : NULL;
	f32 arrives = ts_k_light(&args->lights[k], position, &l), cosine = ts_flush(ts_dot(n, l));
	ts_v3 light = ts_k_deferred_light(args, pixel, k, position, n, v, ts_load3(at->albedo));
	ts_probe_put(p, o, "light", ts_probe_int(k));
	ts_probe_put(p, o, "arrives", ts_probe_bits(arrives));
	ts_probe_put(p, o, "reach", ts_probe_real(ts_k_share(lit, args->lamps, k)));
	ts_probe_put(p, o, "cosine", ts_probe_bits(cosine));
	if (cosine > 0.0f && args->npr != 0) ts_probe_put(p, o, "tone", ts_probe_bits(ts_k_tone(cosine)));
	if (cosine > 0.0f && args->npr == 0) {
		ts_probe_put(p, o, "highlight", ts_probe_bits(ts_k_highlight(n, v, l)));
	}
	ts_probe_put(p, o, "radiance", ts_probe_v3_bits(light));
	ts_probe_append(p, list, o);
	return light;
}

static void put_shading(ts_probe *p, json_t *object, const ts_deferred_args *args, u64 pixel, ts_v3 *total)
{
	json_t *o = json_object(), *list = json_array();
	bool npr = args->npr != 0;
	ts_v3 sum = ts_scale(ts_load3(args->pixels[pixel].albedo), args->ambient);
	ts_probe_put(p, o, "shader", json_string(npr ? "npr" : "phong"));
	ts_probe_put(p, o, "ambient", ts_probe_v3_bits(sum));
	for (u32 k = 0; k < args->n_lights; k++) sum = ts_add(sum, put_light(p, list, args, pixel, k));
	ts_probe_put(p, o, "lights", list);
	bool outline = npr && put_outline(p, o, args, pixel);
	ts_probe_put_sum(p, o, outline ? ts_v3_make(0.0f, 0.0f, 0.0f) : sum, *total);
	ts_probe_put(p, object, "shading", o);
}

static ts_status put_shadow(ts_probe *p, const ts_probe_lamps *lamps, u32 x, u32 y, const ts_receiver *at,
                            json_t *object)
{
	ts_probe_shadow shadow = {.lamps = *lamps};
	ts_status status = ts_probe_put_shadow(p, &shadow, x, y, at, ts_probe_put_samples, object);
	ts_probe_shadow_free(&shadow);
	return status;
}

ts_status ts_probe_put_deferred(ts_probe *p, const ts_probe_lamps *lamps, u32 x, u32 y, json_t *object, ts_v3 *total)
{
	ts_deferred_args args;
	if (ts_deferred_ask(&p->load->run, &args) != TS_OK) return TS_ERROR;
	u64 pixel = (u64)y * p->view.width + x;
	const ts_gpixel *at = &args.pixels[pixel];
	ts_receiver receiver = ts_k_deferred_receiver(at);
	*total = ts_k_deferred(&args, pixel);
	if (at->depth == TS_SKY) {
		ts_probe_put(p, object, "shading", json_string("nothing is here: background"));
		return TS_OK;
	}
	if (lamps != NULL && put_shadow(p, lamps, x, y, &receiver, object) != TS_OK) return TS_ERROR;
	put_shading(p, object, &args, pixel, total);
	return TS_OK;
}
