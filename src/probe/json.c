/* Parts of answers. */
#include <inttypes.h>
#include <stdio.h>
#include "probe/parts.h"
#include "trace/where.h"

void ts_probe_put(ts_probe *p, json_t *object, const char *key, json_t *value)
{
	if (json_object_set_new(object, key, value) != 0) p->failed = true;
}

void ts_probe_append(ts_probe *p, json_t *array, json_t *value)
{
	if (json_array_append_new(array, value) != 0) p->failed = true;
}

json_t *ts_probe_int(u64 value) { return json_integer((json_int_t)value); }
json_t *ts_probe_pair(u32 x, u32 y) { return json_pack("[I,I]", (json_int_t)x, (json_int_t)y); }

/* JSON has no infinity and no NaN. */
json_t *ts_probe_real(f32 value)
{
	bool finite = (ts_f2u(value) & 0x7f800000u) != 0x7f800000u;
	return finite ? json_real((double)value) : json_string("not a finite number");
}

json_t *ts_probe_v3(ts_v3 v)
{
	return json_pack("[o,o,o]", ts_probe_real(v.x), ts_probe_real(v.y), ts_probe_real(v.z));
}

static json_t *bits_of(f32 value) { return json_sprintf("%08x", (unsigned)ts_f2u(value)); }

json_t *ts_probe_bits(f32 value)
{
	return json_pack("{s:o,s:o}", "value", ts_probe_real(value), "bits", bits_of(value));
}

json_t *ts_probe_v3_bits(ts_v3 v)
{
	return json_pack("{s:o,s:[o,o,o]}", "value", ts_probe_v3(v), "bits", bits_of(v.x), bits_of(v.y), bits_of(v.z));
}

json_t *ts_probe_face_name(u32 reflector, u32 face)
{
	return json_sprintf("%u.%s", (unsigned)reflector, ts_where_face(face));
}

void ts_probe_put_method(ts_probe *p, json_t *object)
{
	ts_probe_put(p, object, "method", json_string(p->trace->pipeline->name));
}

void ts_probe_put_margin(ts_probe *p, json_t *object, f32 winner, f32 depth)
{
	ts_probe_put(p, object, "behind", json_real((double)depth - (double)winner));
	ts_probe_put(p, object, "behind_ulps", json_integer((json_int_t)ts_field_ulps(ts_f2u(winner), ts_f2u(depth))));
}

void ts_probe_put_check(ts_probe *p, json_t *object, ts_buffer_id id, const f32 *computed, const f32 *held, u32 n)
{
	char text[160], bits[40] = "";
	size_t used = 0;
	bool same = memcmp(computed, held, n * sizeof(f32)) == 0;
	for (u32 i = 0; i < n && !same && i < 4; i++) {
		used += (size_t)snprintf(bits + used, sizeof bits - used, " %08x", (unsigned)ts_f2u(held[i]));
	}
	snprintf(text, sizeof text, "bits %s %s%s%s", same ? "agree with" : "differ from", ts_buffer_table[id].name,
	         same ? "" : ", which holds", bits);
	ts_probe_put(p, object, "check", json_string(text));
}

void ts_probe_put_record_check(ts_probe *p, json_t *object, ts_buffer_id id, const void *computed, const void *held)
{
	char name[64], value[TS_VALUE_TEXT];
	const char *buffer = ts_buffer_table[id].name;
	json_t *text = NULL;
	for (u32 f = 0; f < p->fields[id].n; f++) {
		const ts_field *field = &p->fields[id].field[f];
		for (u32 k = 0; k < field->count && text == NULL; k++) {
			u64 bits = ts_field_bits(field, held, k);
			if (ts_field_bits(field, computed, k) == bits) continue;
			ts_field_name(name, field, k);
			ts_field_show(value, field, bits);
			text = json_sprintf("bits differ from %s, which holds%s%s %s", buffer, name[0] != 0 ? " in " : "", name,
			                    value);
		}
	}
	ts_probe_put(p, object, "check", text != NULL ? text : json_sprintf("bits agree with %s", buffer));
}

void ts_probe_put_sum(ts_probe *p, json_t *object, ts_v3 sum, ts_v3 total)
{
	f32 a[3], b[3];
	ts_store3(a, sum);
	ts_store3(b, total);
	ts_probe_put(p, object, "sum",
	             json_string(memcmp(a, b, sizeof a) == 0 ? "terms add up to the bits of the total"
	                                                     : "terms do not add up to the total"));
}
