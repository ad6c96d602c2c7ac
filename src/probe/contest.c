/* Which triangles competed for one pixel, and how far the nearest was ahead. */
#include <stdlib.h>
#include "kernels/raster/draw.h"
#include "probe/parts.h"

enum { MOST_LISTED = 64 };

ts_status ts_probe_offers_add(ts_offers *offers, ts_offer offer)
{
	void *array = offers->offer;
	if (ts_grow(&array, &offers->capacity, offers->n + 1, sizeof offer, "who competed") != TS_OK) return TS_ERROR;
	offers->offer = array;
	offers->offer[offers->n++] = offer;
	return TS_OK;
}

static int by_key(const void *a, const void *b)
{
	u64 x = ((const ts_offer *)a)->key, y = ((const ts_offer *)b)->key;
	return (x > y) - (x < y);
}

void ts_probe_offers_sort(ts_offers *offers)
{
	if (offers->n > 1) qsort(offers->offer, offers->n, sizeof *offers->offer, by_key);
}

/* Like ts_k_draw. */
static ts_status visit(ts_probe *p, const ts_camera_k *view, u32 triangle, u32 x, u32 y, ts_offers *offers)
{
	ts_corners t = ts_k_corners(&p->scene, triangle);
	if (ts_k_is_degenerate(t.n) || !ts_k_is_facing(&p->scene, triangle, &t, view->eye)) return TS_OK;
	ts_polygon polygon = ts_k_polygon(view, t.a, t.b, t.c);
	if (ts_k_is_outside(view, &polygon)) return TS_OK;
	ts_fragment f = ts_k_fragment_at(view, &t, (i32)x, (i32)y);
	if (!(f.z > 0.0f)) return TS_OK;
	if (ts_probe_textures(p, triangle) != TS_OK) return TS_ERROR;
	bool cut = ts_k_is_cut(&p->scene, triangle, f.w, t.n, ts_k_fragment_footprint(view, &t, &f));
	return ts_probe_offers_add(offers,
	                           (ts_offer){.key = (u64)ts_f2u(f.z) << 32 | triangle, .triangle = triangle, .cut = cut});
}

ts_status ts_probe_contest(ts_probe *p, const ts_camera_k *view, u32 own, u32 x, u32 y, ts_offers *offers)
{
	ts_status status = TS_OK;
	for (u32 t = 0; t < p->scene.n_triangles && status == TS_OK; t++) {
		if (own != TS_NONE && ts_k_reflector_of(&p->scene, t) == own) continue;
		status = visit(p, view, t, x, y, offers);
	}
	ts_probe_offers_sort(offers);
	return status;
}

static ts_status put_offer(ts_probe *p, json_t *list, const ts_offer *offer, const ts_offer *winner,
                           ts_probe_put_index *put_index)
{
	json_t *o = json_object();
	ts_status status = TS_OK;
	f32 depth = ts_u2f((u32)(offer->key >> 32));
	ts_probe_put(p, o, put_index != NULL ? "distance" : "depth", ts_probe_bits(depth));
	if (put_index != NULL) status = put_index(p, o, (u32)offer->key);
	ts_probe_put_triangle(p, o, offer->triangle);
	if (offer->cut) ts_probe_put(p, o, "cut", json_string("by the alpha of its material"));
	if (winner != NULL && winner != offer && !offer->cut) {
		f32 least = ts_u2f((u32)(winner->key >> 32));
		ts_probe_put_margin(p, o, least, depth);
		if (offer->key >> 32 == winner->key >> 32)
			ts_probe_put(p, o, "tie", json_string("lost by its index, or its colour, alone"));
	}
	ts_probe_append(p, list, o);
	return status;
}

void ts_probe_put_key_check(ts_probe *p, json_t *o, ts_buffer_id id, u64 found, u64 held)
{
	char buffer[64];
	snprintf(buffer, sizeof buffer, "%s", ts_buffer_table[id].name);
	json_t *text = held == found      ? json_sprintf("bits agree with %s", buffer)
	               : held == TS_EMPTY ? json_sprintf("bits differ from %s, which is empty", buffer)
	                                  : json_sprintf("bits differ from %s, which holds %08x_%08x: depth %.9g, index %u",
	                                                 buffer, (unsigned)(held >> 32), (unsigned)held,
	                                                 (double)ts_u2f((u32)(held >> 32)), (unsigned)held);
	ts_probe_put(p, o, "check", text);
}

/* The winner's distance to the second. */
static void put_lead(ts_probe *p, json_t *o, const ts_offer *winner, const ts_offer *second)
{
	if (winner == NULL || second == NULL) return;
	u64 near = winner->key >> 32, far = second->key >> 32;
	ts_probe_put(p, o, "won_by", json_real((double)ts_u2f((u32)far) - (double)ts_u2f((u32)near)));
	ts_probe_put(p, o, "won_by_ulps", json_integer((json_int_t)ts_field_ulps(near, far)));
	if (near == far) ts_probe_put(p, o, "tie", json_string("equal depths go to the lower index"));
}

ts_status ts_probe_put_offers(ts_probe *p, json_t *o, const ts_offers *offers, ts_buffer_id id, u64 held,
                              ts_probe_put_index *put_index)
{
	const ts_offer *winner = NULL, *second = NULL;
	json_t *list = json_array();
	ts_status status = TS_OK;
	for (size_t i = 0; i < offers->n; i++) {
		const ts_offer *offer = &offers->offer[i];
		if (winner != NULL && second == NULL && !offer->cut) second = offer;
		if (winner == NULL && !offer->cut) winner = offer;
		if (i < MOST_LISTED && status == TS_OK) status = put_offer(p, list, offer, winner, put_index);
	}
	ts_probe_put(p, o, "competitors", ts_probe_int(offers->n));
	put_lead(p, o, winner, second);
	if (offers->n > MOST_LISTED) ts_probe_put(p, o, "listed", ts_probe_int(MOST_LISTED));
	ts_probe_put(p, o, "by_depth", list);
	ts_probe_put_key_check(p, o, id, winner != NULL ? winner->key : TS_EMPTY, held);
	return status;
}
