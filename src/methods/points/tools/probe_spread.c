/* Which points took which texels from a triangle. */
#include <stdlib.h>
#include "methods/points/tools/probe.h"

enum { MOST_RIVALS = 8 };

static ts_status lose(ts_spread *s, u32 triangle, u64 ours, u64 theirs)
{
	f32 gap = ts_u2f((u32)(ours >> 32)) - ts_u2f((u32)(theirs >> 32));
	bool tie = ours >> 32 == theirs >> 32;
	size_t i = s->last < s->n_rivals && s->rival[s->last].triangle == triangle ? s->last : 0;
	while (i < s->n_rivals && s->rival[i].triangle != triangle) i++;
	s->last = i;
	if (i == s->n_rivals) {
		void *array = s->rival;
		if (ts_grow(&array, &s->capacity, i + 1, sizeof *s->rival, "rivals") != TS_OK) return TS_ERROR;
		s->rival = array;
		s->rival[s->n_rivals++] = (ts_rival){.triangle = triangle, .least = gap, .least_ulps = INT64_MAX};
	}
	ts_rival *r = &s->rival[i];
	i64 ulps = ts_field_ulps(theirs >> 32, ours >> 32);
	r->texels++;
	r->ties += tie;
	r->least = gap < r->least ? gap : r->least;
	r->least_ulps = ulps < r->least_ulps ? ulps : r->least_ulps;
	s->lost++;
	s->ties += tie;
	return TS_OK;
}

size_t ts_probe_place(const u32 *index, size_t n, u32 point)
{
	size_t low = 0, high = n;
	while (low < high) {
		size_t middle = (low + high) / 2;
		if (index[middle] < point) {
			low = middle + 1;
		} else {
			high = middle;
		}
	}
	return low < n && index[low] == point ? low : n;
}

static ts_status lose_to_point(ts_probe *p, ts_spread *s, u32 triangle, u64 ours, u64 theirs)
{
	ts_point record;
	ts_piece piece;
	if (ts_probe_fetch_point(p, (u32)theirs, &record, &piece) != TS_OK) return TS_ERROR;
	s->lost_to_own += piece.triangle == triangle;
	return lose(s, piece.triangle, ours, theirs);
}

ts_status ts_probe_spread_add(ts_probe *p, ts_spread *s, const u64 *alone, u64 n, ts_buffer_id id, u64 first,
                              u32 triangle, const u32 *index, size_t n_index, u64 *won)
{
	for (u64 i = 0; i < n; i++) {
		u64 held;
		if (alone[i] == TS_EMPTY) continue;
		if (ts_probe_fetch(p, id, first + i, 1, &held) != TS_OK) return TS_ERROR;
		s->offered++;
		size_t place = index != NULL ? ts_probe_place(index, n_index, (u32)held) : 0;
		bool ours = held != TS_EMPTY && (index != NULL ? place < n_index : (u32)held == triangle);
		s->won += ours;
		if (ours && won != NULL) won[place]++;
		if (ours) continue;
		if (held == TS_EMPTY || held >> 32 > alone[i] >> 32) {
			s->odd++;
			continue;
		}
		ts_status status =
			index != NULL ? lose_to_point(p, s, triangle, alone[i], held) : lose(s, (u32)held, alone[i], held);
		if (status != TS_OK) return status;
	}
	return TS_OK;
}

static int by_texels(const void *a, const void *b)
{
	const ts_rival *x = a, *y = b;
	if (x->texels != y->texels) return x->texels < y->texels ? 1 : -1;
	return (x->triangle > y->triangle) - (x->triangle < y->triangle);
}

void ts_probe_put_spread(ts_probe *p, json_t *o, const ts_spread *s)
{
	json_t *list = json_array();
	if (s->n_rivals > 1) qsort(s->rival, s->n_rivals, sizeof *s->rival, by_texels);
	ts_probe_put(p, o, "texels_offered", ts_probe_int(s->offered));
	ts_probe_put(p, o, "texels_won", ts_probe_int(s->won));
	ts_probe_put(p, o, "texels_lost", ts_probe_int(s->lost));
	ts_probe_put(p, o, "lost_by_ties", ts_probe_int(s->ties));
	if (s->odd > 0) ts_probe_put(p, o, "texels_that_hold_what_is_farther", ts_probe_int(s->odd));
	for (size_t i = 0; i < s->n_rivals && i < MOST_RIVALS; i++) {
		const ts_rival *r = &s->rival[i];
		ts_probe_append(p, list,
		                json_pack("{s:I,s:I,s:I,s:o,s:I}", "triangle", (json_int_t)r->triangle, "texels",
		                          (json_int_t)r->texels, "ties", (json_int_t)r->ties, "least_margin",
		                          ts_probe_real(r->least), "least_margin_ulps", (json_int_t)r->least_ulps));
	}
	if (s->n_rivals > MOST_RIVALS) ts_probe_put(p, o, "rivals", ts_probe_int(s->n_rivals));
	ts_probe_put(p, o, "lost_to", list);
}

void ts_probe_spread_free(ts_spread *s)
{
	free(s->rival);
	*s = (ts_spread){.rival = NULL};
}
