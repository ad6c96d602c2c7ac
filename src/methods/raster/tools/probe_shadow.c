/* The light that reaches a pixel: each sample's comparison with its depth map, repeated. */
#include <stdlib.h>
#include "kernels/raster/shadow_test_margin.h"
#include "methods/raster/tools/probe.h"

ts_status ts_probe_read_rows(ts_probe *p, ts_probe_shadow *q, const ts_offscreen *view, u32 first, u32 n)
{
	free(q->depths);
	q->first_texel = view->offset + (u64)first * view->width;
	q->depths = ts_alloc((size_t)n * view->width, sizeof *q->depths, "a depth map");
	q->args.depths = q->depths;
	return q->depths != NULL ? ts_probe_fetch(p, TS_B_depth_map_depth, q->first_texel, (u64)n * view->width, q->depths)
	                         : TS_ERROR;
}

/* The least measured margin, if there is one. */
static void put_margin(ts_probe *p, json_t *o, const char *key, u64 bits)
{
	if (bits != TS_EMPTY) ts_probe_put(p, o, key, ts_probe_real(ts_u2f((u32)bits)));
}

/* A texel's result, with all inputs. */
static ts_status put_texel(ts_probe *p, json_t *o, ts_probe_shadow *q, const ts_offscreen *offscreen, f32 z,
                           bool *reaches)
{
	ts_camera_k view = ts_k_offscreen(offscreen);
	ts_corner at = ts_k_to_view(&view, q->at.p);
	ts_v2 place = ts_k_project(&view, &at);
	i32 i = ts_floor_i32(place.x), j = ts_floor_i32(place.y);
	i32 row = ts_max_i32(ts_k_into(j, view.height) - 1, 0), n = ts_min_i32(3, view.height - row);
	if (ts_probe_read_rows(p, q, offscreen, (u32)row, (u32)n) != TS_OK) return TS_ERROR;
	u32 held = ts_k_map_texel(&q->args, offscreen, q->first_texel, i, j);
	bool inside = i == ts_k_into(i, view.width) && j == ts_k_into(j, view.height);
	u64 margin[2] = {TS_EMPTY, TS_EMPTY};
	*reaches = ts_k_reaches(&q->args, offscreen, &q->at, q->first_texel);
	ts_k_reach_margin(&q->args, offscreen, &q->at, q->moves, q->first_texel, margin);
	ts_probe_put(p, o, "place", json_pack("[o,o]", ts_probe_real(place.x), ts_probe_real(place.y)));
	if (inside) ts_probe_put(p, o, "texel", ts_probe_pair((u32)i, (u32)j));
	if (held != TS_NONE) {
		f32 bias = ts_k_shadow_bias(&q->args, &view, &q->at, z);
		ts_probe_put(p, o, "map", ts_probe_bits(ts_u2f(held)));
		ts_probe_put(p, o, "bias", ts_probe_bits(bias));
		ts_probe_put(p, o, "free", json_real((double)ts_u2f(held) + (double)bias - (double)z));
	}
	put_margin(p, o, "edge_margin", margin[0]);
	put_margin(p, o, "depth_margin", margin[1]);
	ts_probe_put(p, o, "answer",
	             json_string(held != TS_NONE ? (*reaches ? "reaches" : "in shadow")
	                         : inside        ? "reaches: the texel is empty"
	                                         : "reaches: beside the map"));
	return TS_OK;
}

static ts_status put_sample(ts_probe *p, json_t *list, ts_probe_shadow *q, u32 light, u32 k, bool *reaches)
{
	const ts_offscreen *offscreen = ts_k_asked_view(&q->args, ts_probe_lamp_view(&q->lamps, light, k), &q->at);
	ts_camera_k view = ts_k_offscreen(offscreen);
	f32 z = ts_k_to_view(&view, q->at.p).z;
	ts_status status = TS_OK;
	json_t *o = json_object();
	ts_probe_put(p, o, "view", ts_probe_lamp_view_name(&q->lamps, offscreen, light));
	ts_probe_put(p, o, "depth", ts_probe_bits(z));
	*reaches = true;
	if (z >= view.near) {
		status = put_texel(p, o, q, offscreen, z, reaches);
	} else {
		ts_probe_put(p, o, "answer", json_string("reaches: before the map begins"));
	}
	ts_probe_append(p, list, o);
	return status;
}

ts_status ts_probe_put_samples(ts_probe *p, json_t *o, ts_probe_shadow *q, u32 light)
{
	json_t *samples = json_array();
	ts_status status = TS_OK;
	for (u32 k = 0; k < q->lamps.lamps[light].samples && status == TS_OK; k++) {
		bool reaches = false;
		status = put_sample(p, samples, q, light, k, &reaches);
		q->lit[light] += reaches;
	}
	ts_probe_put(p, o, "by_sample", samples);
	return status;
}

static void put_check(ts_probe *p, json_t *o, u32 computed, u32 held)
{
	ts_probe_put(p, o, "check",
	             computed == held ? json_string("bits agree with shadow_test.lit")
	                              : json_sprintf("bits differ from shadow_test.lit, which holds %u", (unsigned)held));
}

static ts_status put_light(ts_probe *p, json_t *list, ts_probe_shadow *q, u32 light, ts_probe_samples *put_samples,
                           const u32 *held)
{
	json_t *o = json_object();
	q->args.cubes = ts_probe_lamp_has_cube(&q->lamps, light);
	ts_probe_put(p, o, "light", ts_probe_int(light));
	ts_status status = put_samples(p, o, q, light);
	ts_probe_put(p, o, "reach", ts_probe_int(q->lit[light]));
	ts_probe_put(p, o, q->lamps.lens == TS_PROBE_TAPS ? "taps" : "samples",
	             ts_probe_int(q->lamps.lamps[light].samples));
	if (held != NULL) put_check(p, o, q->lit[light], held[light]);
	ts_probe_append(p, list, o);
	return status;
}

static ts_status put_lights(ts_probe *p, json_t *list, ts_probe_shadow *q, u32 x, u32 y, ts_probe_samples *put_samples)
{
	bool there;
	u32 n = q->lamps.n_lights, *held = ts_alloc(n, sizeof *held, "lights");
	ts_status status = held != NULL ? ts_probe_fetch_pixel(p, TS_B_shadow_test_lit, x, y, n, held, &there) : TS_ERROR;
	for (u32 i = 0; i < n && status == TS_OK; i++) {
		status = put_light(p, list, q, i, put_samples, there ? held : NULL);
	}
	free(held);
	return status;
}

ts_status ts_probe_put_shadow(ts_probe *p, ts_probe_shadow *q, u32 x, u32 y, const ts_receiver *at,
                              ts_probe_samples *put_samples, json_t *object)
{
	ts_camera_k eye = ts_k_view(&p->view);
	q->at = *at;
	q->args = (ts_shadow_test_args){.scene = p->scene,
	                                .view = &p->view,
	                                .views = q->lamps.views,
	                                .n_lamps = q->lamps.n_lights,
	                                .bias = TS_PARAM(&p->trace->params, depth_map_bias),
	                                .slope = TS_PARAM(&p->trace->params, depth_map_bias_slope)};
	q->moves = ts_k_receiver_step(&eye, &q->at);
	q->lit = ts_alloc_zero(q->lamps.n_lights, sizeof *q->lit, "lights");
	if (q->lit == NULL) return TS_ERROR;
	json_t *lights = json_array();
	ts_status status = put_lights(p, lights, q, x, y, put_samples);
	ts_probe_put(p, object, "shadow", lights);
	return status;
}

void ts_probe_shadow_free(ts_probe_shadow *q)
{
	free(q->depths);
	free(q->lit);
}

ts_status ts_probe_put_shadowed(ts_probe *p, const ts_probe_seen *seen, ts_probe_lens lens,
                                ts_probe_samples *put_samples, json_t *o, ts_v3 *radiance)
{
	ts_receiver at = ts_k_receiver(&p->scene, &seen->view, seen->key, (i32)seen->x, (i32)seen->y);
	ts_probe_shadow q = {.depths = NULL};
	ts_status status = ts_probe_read_lamps(p, lens, &q.lamps);
	if (status == TS_OK) status = ts_probe_put_shadow(p, &q, seen->x, seen->row, &at, put_samples, o);
	if (status == TS_OK) ts_probe_put_shading(p, seen, q.lit, q.lamps.lamps, o, radiance);
	ts_probe_shadow_free(&q);
	return status;
}

static ts_status put_shadowed(ts_probe *p, const ts_probe_seen *at, json_t *o, ts_v3 *radiance)
{
	ts_probe_lens lens = ts_probe_makes(p, TS_B_cube_size_face) ? TS_PROBE_A_CUBE : TS_PROBE_A_VIEW;
	return ts_probe_put_shadowed(p, at, lens, ts_probe_put_samples, o, radiance);
}

ts_status ts_probe_shadow_pixel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	static const ts_buffer_id needed[] = {TS_B_eye_depth_triangle, TS_B_depth_map_depth, TS_N_BUFFERS};
	return ts_probe_eye_pixel(p, q, needed, put_shadowed, o);
}
