/* What light reaches a pixel: the question of each sample to its depth map, asked again. */
#include <inttypes.h>
#include <stdlib.h>
#include "../../../kernels/points/pcss.h"
#include "../../../kernels/raster/resolve_margin.h"
#include "../../stages.h"
#include "../../../probe/parts.h"

static u32 views_a_sample(const ts_probe *p) { return p->n_cubes > 0 ? 6 : 1; }

/* Of surfels, whose lights have a view or six each. */
static const ts_light *lights_of(const ts_probe *p) { return ts_probe_loaded(p, TS_B_lamp_light); }

static bool has_cube(const ts_probe *p, u32 light)
{
	return p->surfels ? ts_k_has_cube(&lights_of(p)[light]) : p->n_cubes > 0;
}

/* The view of a light's sample, or the first of its cube. */
static u32 view_of(const ts_probe *p, u32 light, u32 k)
{
	u32 first = 0;
	if (!p->surfels) return (p->lamps[light].first + k) * views_a_sample(p);
	for (u32 i = 0; i < light; i++) first += ts_light_views(&lights_of(p)[i]);
	return first;
}

static ts_status check_views(const ts_probe *p)
{
	u64 offset = 0;
	const char *path = p->trace->item[TS_B_offscreen_view].path;
	for (u32 v = 0; v < p->n_views; v++) {
		const ts_offscreen *view = &p->views[v];
		bool fits = view->width >= 1 && view->height >= 1 && view->width <= TS_PROBE_SIDE && view->height <= TS_PROBE_SIDE;
		if (!fits || view->offset != offset || view->light >= p->scene.n_lights) {
			return ts_fail("%s: element %u: %u x %u of light %u at texel %" PRIu64 "; of %u lights, at %" PRIu64
			               " would be right", path, (unsigned)v, (unsigned)view->width, (unsigned)view->height,
			               (unsigned)view->light, view->offset, (unsigned)p->scene.n_lights, offset);
		}
		offset += (u64)view->width * view->height;
	}
	return TS_OK;
}

/* Each has its samples among the views. */
static ts_status check_lamps(const ts_probe *p, u64 n_lamps)
{
	const char *path = p->trace->item[TS_B_lamp_shape].path;
	if (n_lamps != p->scene.n_lights) return ts_fail("%s: as many as lamp.light would be right", path);
	for (u32 i = 0; i < n_lamps; i++) {
		u64 first = p->lamps[i].first, n = p->has_taps ? 1 : p->lamps[i].samples;
		if (p->lamps[i].samples > 0 && (first + n) * views_a_sample(p) <= p->n_views) continue;
		return ts_fail("%s: element %u: %u samples from %" PRIu64 " on; there are %u views", path, (unsigned)i,
		               (unsigned)p->lamps[i].samples, first, (unsigned)p->n_views);
	}
	return TS_OK;
}

ts_status ts_probe_lamps(ts_probe *p)
{
	u64 n_views = 0, n_lamps = 0;
	p->views = ts_probe_load(p, TS_B_offscreen_view, &n_views);
	p->lamps = p->views != NULL ? ts_probe_load(p, TS_B_lamp_shape, &n_lamps) : NULL;
	p->lit = p->lamps != NULL ? ts_alloc_zero((size_t)n_lamps, sizeof *p->lit, "lights") : NULL;
	if (p->lit == NULL) return TS_ERROR;
	if (n_views >= 1u << 20) return ts_fail("%s: too large", p->trace->dir);
	p->n_views = (u32)n_views;
	p->n_words = (p->n_views + 63) / 64;
	if (n_views % views_a_sample(p) != 0) return ts_fail("%s: six views a cube would be right", p->trace->dir);
	return check_views(p) == TS_OK ? check_lamps(p, n_lamps) : TS_ERROR;
}

/* A pixel's point before the maps, of which some rows of one are there. */
typedef struct { ts_resolve_args args; ts_receiver at; f32 moves; u32 *depths; u64 first_texel; } question;

static ts_status read_rows(ts_probe *p, question *q, const ts_offscreen *view, u32 first, u32 n)
{
	free(q->depths);
	q->first_texel = view->offset + (u64)first * view->width;
	q->depths = ts_alloc((size_t)n * view->width, sizeof *q->depths, "a depth map");
	q->args.depths = q->depths;
	return q->depths != NULL ? ts_probe_fetch(p, TS_B_scatter_depth, q->first_texel, (u64)n * view->width, q->depths)
	                         : TS_ERROR;
}

/* Of surfels a cube is named by its light. */
static json_t *view_name(const ts_probe *p, const ts_offscreen *view, u32 light)
{
	u32 v = (u32)(view - p->views);
	if (!has_cube(p, light)) return ts_probe_int(v);
	return p->surfels ? ts_probe_face_name(light, v - view_of(p, light, 0)) : ts_probe_face_name(v / 6, v % 6);
}

/* The least of what the kernel measured, if it measured. */
static void put_margin(ts_probe *p, json_t *o, const char *key, u64 bits)
{
	if (bits != TS_EMPTY) ts_probe_put(p, o, key, ts_probe_real(ts_u2f((u32)bits)));
}

/* A texel's answer, with all that went into it. */
static ts_status put_texel(ts_probe *p, json_t *o, question *q, const ts_offscreen *offscreen, f32 z, bool *reaches)
{
	ts_camera_k view = ts_k_offscreen(offscreen);
	ts_corner at = ts_k_to_view(&view, q->at.p);
	ts_v2 place = ts_k_project(&view, &at);
	i32 i = ts_floor_i32(place.x), j = ts_floor_i32(place.y);
	i32 row = ts_max_i32(ts_k_into(j, view.height) - 1, 0), n = ts_min_i32(3, view.height - row);
	if (read_rows(p, q, offscreen, (u32)row, (u32)n) != TS_OK) return TS_ERROR;
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
	ts_probe_put(p, o, "answer", json_string(held != TS_NONE ? (*reaches ? "reaches" : "in shadow")
	                                         : inside        ? "reaches: the texel is empty"
	                                                         : "reaches: beside the map"));
	return TS_OK;
}

static ts_status put_sample(ts_probe *p, json_t *list, question *q, u32 light, u32 k, bool *reaches)
{
	const ts_offscreen *offscreen = ts_k_asked_view(&q->args, view_of(p, light, k), &q->at);
	ts_camera_k view = ts_k_offscreen(offscreen);
	f32 z = ts_k_to_view(&view, q->at.p).z;
	ts_status status = TS_OK;
	json_t *o = json_object();
	ts_probe_put(p, o, "view", view_name(p, offscreen, light));
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

static ts_status put_samples(ts_probe *p, json_t *o, question *q, u32 light)
{
	json_t *samples = json_array();
	ts_status status = TS_OK;
	for (u32 k = 0; k < p->lamps[light].samples && status == TS_OK; k++) {
		bool reaches = false;
		status = put_sample(p, samples, q, light, k, &reaches);
		p->lit[light] += reaches;
	}
	ts_probe_put(p, o, "by_sample", samples);
	return status;
}

/* PCSS: one view, whose blockers say how wide its taps are spread. */
static ts_status put_taps(ts_probe *p, json_t *o, question *q, u32 light)
{
	const ts_offscreen *view = &p->views[p->lamps[light].first];
	ts_pcss_args args = {.lamps = p->lamps, .near = TS_PARAM(&p->trace->params, pcss_near)};
	if (read_rows(p, q, view, 0, view->height) != TS_OK) return TS_ERROR;
	args.of = q->args;
	args.of.first_view = p->lamps[light].first;
	ts_shaded r = ts_k_shaded(&args.of, view, &q->at);
	p->lit[light] = ts_k_pcss(&args, view, &q->at);
	ts_probe_put(p, o, "view", view_name(p, view, light));
	ts_probe_put(p, o, "depth", ts_probe_bits(r.z));
	ts_probe_put(p, o, "place", json_pack("[o,o]", ts_probe_real(r.place.x), ts_probe_real(r.place.y)));
	ts_probe_put(p, o, "bias", ts_probe_bits(r.bias));
	if (!(r.z >= r.view.near)) return TS_OK;
	f32 radius = ts_k_search_radius(&r, p->lamps[light].radius, args.near * r.z), depth = ts_k_blocker_depth(&r, radius);
	ts_probe_put(p, o, "search_radius", ts_probe_real(radius));
	if (!(depth > 0.0f)) return TS_OK;
	ts_probe_put(p, o, "blocker_depth", ts_probe_bits(depth));
	ts_probe_put(p, o, "filter_radius", ts_probe_real(ts_k_filter_radius(&r, p->lamps[light].radius, depth)));
	return TS_OK;
}

static void put_check(ts_probe *p, json_t *o, u32 computed, u32 held)
{
	ts_probe_put(p, o, "check", computed == held
	                                ? json_string("bits agree with resolve.lit")
	                                : json_sprintf("bits differ from resolve.lit, which holds %u", (unsigned)held));
}

static ts_status put_light(ts_probe *p, json_t *list, question *q, u32 light, const u32 *held)
{
	json_t *o = json_object();
	p->lit[light] = 0;
	q->args.cubes = has_cube(p, light);
	ts_probe_put(p, o, "light", ts_probe_int(light));
	ts_status status = p->has_taps ? put_taps(p, o, q, light) : put_samples(p, o, q, light);
	ts_probe_put(p, o, "reach", ts_probe_int(p->lit[light]));
	ts_probe_put(p, o, p->has_taps ? "taps" : "samples", ts_probe_int(p->lamps[light].samples));
	if (held != NULL) put_check(p, o, p->lit[light], held[light]);
	ts_probe_append(p, list, o);
	return status;
}

static ts_status put_lights(ts_probe *p, json_t *list, question *q, u32 x, u32 y)
{
	bool there;
	u32 *held = ts_alloc(p->scene.n_lights, sizeof *held, "lights");
	ts_status status =
		held != NULL ? ts_probe_fetch_pixel(p, TS_B_resolve_lit, x, y, p->scene.n_lights, held, &there) : TS_ERROR;
	for (u32 i = 0; i < p->scene.n_lights && status == TS_OK; i++) {
		status = put_light(p, list, q, i, there ? held : NULL);
	}
	free(held);
	return status;
}

ts_status ts_probe_shadow(ts_probe *p, u32 x, u32 y, const ts_receiver *at, json_t *object)
{
	ts_camera_k eye = ts_k_view(&p->view);
	question q = {.at = *at};
	q.args = (ts_resolve_args){.scene = p->scene, .view = &p->view, .views = p->views, .n_lamps = p->scene.n_lights,
	                           .bias = TS_PARAM(&p->trace->params, bias),
	                           .slope = TS_PARAM(&p->trace->params, bias_slope)};
	q.moves = ts_k_receiver_step(&eye, &q.at);
	json_t *lights = json_array();
	ts_status status = put_lights(p, lights, &q, x, y);
	ts_probe_put(p, object, "shadow", lights);
	free(q.depths);
	return status;
}

ts_status ts_probe_of_reflections(const ts_probe *p)
{
	if (p->mirrors) return TS_OK;
	return ts_fail("%s: a trace of %s, of which probe explains the eye's pixels; --pixel X,Y would be right", p->trace->dir,
	               p->trace->pipeline->effect->name);
}
