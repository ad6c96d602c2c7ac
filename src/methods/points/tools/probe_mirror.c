/* What a reflective pixel of EPR shows: its samples, and the bounces behind them. The kernels of look-up and shading
 * compute each entry again in a small world, whose arrays hold what the entry refers to. */
#include "kernels/points/lookup.h"
#include "methods/points/points.h"
#include "methods/points/tools/probe.h"

enum { MOST_POINTS = TS_N_SAMPLES + 1 };

typedef struct {
	u32 bounce, n_samples;
	u64 entry;
	u32 found[TS_N_SAMPLES]; /* indices of points in the trace */
	u32 local[TS_N_SAMPLES]; /* their indices in this world */
	u32 first_next;          /* entries of the next bounce before the first sample */
	u32 offset[TS_N_SAMPLES + 1];
	f32 next[TS_N_SAMPLES * 3];
	u32 n_points;
	ts_point point[MOST_POINTS];
	ts_piece piece[MOST_POINTS];
	ts_align frame[MOST_POINTS];
	u64 key[MOST_POINTS];
	ts_pixel pixel;
	ts_bounce queue;
	u32 reflector;   /* whose cube is read */
	ts_face cube[2]; /* its cube, and the one read before */
	f32 radiance[3];
	u32 used;
	ts_lookup_args args;
} world;

static ts_status hold(ts_probe *p, world *w, u32 point, u32 *local)
{
	u32 i = *local = w->n_points++;
	if (ts_probe_fetch_point(p, point, &w->point[i], &w->piece[i]) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_align_frame, w->point[i].piece, 1, &w->frame[i]) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_points_key, point, 1, &w->key[i]) != TS_OK) return TS_ERROR;
	w->point[i].piece = i;
	return ts_probe_textures(p, w->piece[i].triangle);
}

/* Copies the next bounce's radiance for the samples that queued. */
static ts_status hold_next(ts_probe *p, world *w)
{
	const ts_bounce_buffers *next = &ts_bounce_table[w->bounce + 1];
	u64 first = w->entry * w->n_samples;
	if (ts_probe_fetch(p, next->offset, first, w->n_samples + 1, w->offset) != TS_OK) return TS_ERROR;
	w->first_next = w->offset[0];
	for (u32 k = 0; k < w->n_samples; k++) {
		u32 before = k > 0 ? w->offset[k] : 0, here = w->offset[k + 1] - w->first_next;
		if (here < before || here > before + 1) {
			return ts_fail("%s: element %llu is %u; a sample has one entry at most", p->trace->item[next->offset].path,
			               (unsigned long long)(first + k + 1), (unsigned)w->offset[k + 1]);
		}
		w->offset[k + 1] = here;
	}
	w->offset[0] = 0;
	return ts_probe_fetch(p, next->radiance, (u64)w->first_next * 3, (u64)w->offset[w->n_samples] * 3, w->next);
}

/* Copies the entry, and the cube that it reads; reflectors become places in w->cube. */
static ts_status hold_entry(ts_probe *p, world *w)
{
	ts_buffer_id queue = ts_bounce_table[w->bounce].queue;
	if (w->bounce == 0) {
		if (ts_probe_fetch(p, queue, w->entry, 1, &w->pixel) != TS_OK) return TS_ERROR;
		w->reflector = w->pixel.reflector;
		w->pixel.reflector = 0;
	} else {
		if (ts_probe_fetch(p, queue, w->entry, 1, &w->queue) != TS_OK) return TS_ERROR;
		w->reflector = w->queue.reflector;
		if (ts_probe_fetch(p, TS_B_cube_size_face, w->queue.from, 1, &w->cube[1]) != TS_OK) return TS_ERROR;
		if (hold(p, w, w->queue.point, &w->queue.point) != TS_OK) return TS_ERROR;
		w->queue.reflector = 0;
		w->queue.from = 1;
	}
	return ts_probe_fetch(p, TS_B_cube_size_face, w->reflector, 1, &w->cube[0]);
}

static ts_status hold_found(ts_probe *p, world *w)
{
	ts_buffer_id id = ts_bounce_table[w->bounce].found;
	if (ts_probe_fetch(p, id, w->entry * w->n_samples, w->n_samples, w->found) != TS_OK) return TS_ERROR;
	for (u32 k = 0; k < w->n_samples; k++) {
		w->local[k] = TS_NONE;
		if (w->found[k] != TS_NONE && hold(p, w, w->found[k], &w->local[k]) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static ts_status make(ts_probe *p, world *w, u32 bounce, u64 entry)
{
	const ts_params *params = &p->trace->params;
	*w = (world){.bounce = bounce, .entry = entry, .n_samples = bounce == 0 ? TS_N_SAMPLES : TS_N_BOUNCE_SAMPLES};
	bool follow = bounce + 1 < TS_MAX_BOUNCES && bounce + 1 < TS_PARAM(params, lookup_bounces);
	if (hold_entry(p, w) != TS_OK || hold_found(p, w) != TS_OK) return TS_ERROR;
	if (follow && hold_next(p, w) != TS_OK) return TS_ERROR;
	w->args = (ts_lookup_args){
		.from = {.scene = p->scene, .pieces = w->piece, .frames = w->frame, .keys = w->key, .points = w->point},
		.view = &p->view,
		.cubes = w->cube,
		.pixels = &w->pixel,
		.queue = &w->queue,
		.found = w->local,
		.offset = w->offset,
		.next_radiance = w->next,
		.radiance = w->radiance,
		.used = &w->used,
		.n_samples = w->n_samples,
		.first = bounce == 0,
		.follow = follow,
		.adaptive = bounce == 0 && TS_PARAM(params, lookup_samples) == TS_SAMPLES_ADAPTIVE,
	};
	ts_k_shade_item(&w->args, 0);
	return TS_OK;
}

/* Like ts_k_bounce_item. */
static ts_v3 direction_of(const ts_probe *p, const world *w, u32 k)
{
	if (w->bounce == 0) return ts_k_sample_ray(&w->pixel, ts_load3(p->view.eye), k).direction;
	const ts_point *point = &w->point[w->queue.point];
	const ts_align *frame = &w->frame[w->queue.point];
	ts_surface surface = ts_k_point_surface(&w->args, w->queue.point);
	ts_v3 from = ts_load3(w->cube[1].centre);
	ts_v3 n = ts_k_facing_normal(&surface, ts_sub(from, surface.p));
	f32 radius = w->cube[0].radius, spread = radius > 0.0f ? point->length / radius : 0.0f;
	return ts_k_bounce_direction(surface.p, n, ts_load3(frame->u), ts_load3(frame->v), from, spread, k);
}

static ts_status put_place(ts_probe *p, json_t *o, const world *w, u32 k)
{
	u64 key;
	u32 n = w->cube[0].n;
	ts_v3 direction = direction_of(p, w, k);
	ts_probe_put(p, o, "direction", ts_probe_v3(direction));
	if (n == 0) return TS_OK;
	ts_cube_place place = ts_k_cube_place(direction);
	u64 inside = ts_k_cube_index(place, n);
	ts_probe_put(p, o, "face", ts_probe_face_name(w->reflector, place.face));
	ts_probe_put(p, o, "texel", ts_probe_pair((u32)(inside % n), (u32)(inside / n % n)));
	if (!ts_probe_has(p, TS_B_splat_depth_index)) return TS_OK;
	if (ts_probe_fetch(p, TS_B_splat_depth_index, w->cube[0].offset + inside, 1, &key) != TS_OK) return TS_ERROR;
	if ((u32)key != w->found[k]) {
		ts_probe_put(p, o, "check", json_sprintf("splat.depth_index holds point %u here", (unsigned)key));
	}
	if (key != TS_EMPTY) ts_probe_put(p, o, "distance", ts_probe_bits(ts_u2f((u32)(key >> 32))));
	return TS_OK;
}

static ts_status put_entry(ts_probe *p, u32 bounce, u64 entry, json_t *o, ts_v3 *total);

static ts_status put_sample(ts_probe *p, const world *w, u32 k, json_t *list)
{
	json_t *o = json_object();
	ts_status status = TS_OK;
	u32 local = w->local[k];
	ts_v3 centre = ts_load3(w->cube[0].centre);
	ts_probe_put(p, o, "k", ts_probe_int(k));
	status = put_place(p, o, w, k);
	if (local == TS_NONE) {
		ts_probe_put(p, o, "point", json_string("none: background"));
	} else {
		ts_probe_put(p, o, "point", ts_probe_int(w->found[k]));
		ts_probe_put(p, o, "key", ts_probe_key(w->key[local]));
		ts_probe_put(p, o, "piece", ts_probe_int(w->key[local] >> 32));
		ts_probe_put_triangle(p, o, w->piece[local].triangle);
	}
	if (k >= w->used && w->bounce == 0) ts_probe_put(p, o, "used", json_false());
	ts_probe_put(p, o, "radiance", ts_probe_v3_bits(ts_k_sample_radiance(&w->args, k, centre)));
	if (status == TS_OK && w->args.follow && w->offset[k + 1] != w->offset[k]) {
		json_t *next = json_object();
		ts_v3 ignored;
		status = put_entry(p, w->bounce + 1, (u64)w->first_next + w->offset[k], next, &ignored);
		ts_probe_put(p, o, "bounce", next);
	}
	ts_probe_append(p, list, o);
	return status;
}

static void put_result(ts_probe *p, const world *w, json_t *o, const f32 *held)
{
	u32 used;
	ts_v3 tint = ts_v3_make(w->pixel.tint_r, w->pixel.tint_g, w->pixel.tint_b);
	if (w->bounce > 0) tint = ts_k_point_surface(&w->args, w->queue.point).base;
	ts_v3 mean = ts_k_mean_radiance(&w->args, 0, ts_load3(w->cube[0].centre), &used);
	if (w->bounce == 0) ts_probe_put(p, o, "samples_used", ts_probe_int(used));
	ts_probe_put(p, o, "mean", ts_probe_v3_bits(mean));
	ts_probe_put(p, o, "tint", ts_probe_v3_bits(tint));
	ts_probe_put(p, o, "total", ts_probe_v3_bits(ts_load3(w->radiance)));
	if (held != NULL) ts_probe_put_check(p, o, ts_bounce_table[w->bounce].radiance, w->radiance, held, 3);
}

static ts_status put_entry(ts_probe *p, u32 bounce, u64 entry, json_t *o, ts_v3 *total)
{
	world w;
	f32 held[3];
	ts_buffer_id radiance = ts_bounce_table[bounce].radiance;
	if (make(p, &w, bounce, entry) != TS_OK) return TS_ERROR;
	bool has = ts_probe_has(p, radiance);
	if (has && ts_probe_fetch(p, radiance, entry * 3, 3, held) != TS_OK) return TS_ERROR;
	json_t *list = json_array();
	ts_status status = TS_OK;
	ts_probe_put(p, o, "reflector", ts_probe_int(w.reflector));
	ts_probe_put(p, o, "cube_size", ts_probe_int(w.cube[0].n));
	ts_probe_put(p, o, "cube_centre", ts_probe_v3(ts_load3(w.cube[0].centre)));
	for (u32 k = 0; k < w.n_samples && status == TS_OK; k++) status = put_sample(p, &w, k, list);
	ts_probe_put(p, o, "samples", list);
	put_result(p, &w, o, has ? held : NULL);
	*total = ts_load3(w.radiance);
	return status;
}

ts_status ts_probe_mirror(ts_probe *p, u64 entry, json_t *o, ts_v3 *total)
{
	static const ts_buffer_id needed[TS_MAX_BOUNCES][9] = {
		{TS_B_lookup_point, TS_B_points_record, TS_B_points_key, TS_B_split_piece, TS_B_align_frame, TS_N_BUFFERS},
		{TS_B_lookup_second_offset, TS_B_lookup_second_parent, TS_B_lookup_second_point, TS_B_shade_second_radiance,
	     TS_N_BUFFERS},
		{TS_B_lookup_third_offset, TS_B_lookup_third_parent, TS_B_lookup_third_point, TS_B_shade_third_radiance,
	     TS_N_BUFFERS},
	};
	for (u32 b = 0; b < TS_MAX_BOUNCES && b < TS_PARAM(&p->trace->params, lookup_bounces); b++) {
		if (ts_probe_require(p, needed[b]) != TS_OK) return TS_ERROR;
	}
	return put_entry(p, 0, entry, o, total);
}
