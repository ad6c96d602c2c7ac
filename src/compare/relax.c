/* Near floats, and lists of names. */
#include "compare/relax.h"
#include <math.h>
#include <stdio.h>
#include "trace/field.h"

bool ts_relax_close(const ts_relaxations *r, u64 ref, u64 cand)
{
	i64 ulps = ts_field_ulps(ref, cand);
	if (ulps == INT64_MAX) return false;
	double x = (double)ts_u2f((u32)ref), apart = fabs(x - (double)ts_u2f((u32)cand));
	if ((u64)(ulps < 0 ? -ulps : ulps) <= r->ulp) return true;
	return isfinite(apart) && ((r->abs > 0 && apart <= r->abs) || (r->rel > 0 && apart <= r->rel * fabs(x)));
}

static const char *next_of(const char *list)
{
	const char *comma = strchr(list, ',');
	return comma != NULL ? comma + 1 : NULL;
}

/* Whether the first n bytes of `text` are `name`. */
static bool is_name(const char *text, size_t n, const char *name)
{
	return strlen(name) == n && strncmp(text, name, n) == 0;
}

bool ts_relax_takes(const ts_relaxations *r, u32 buffer) { return r->only == NULL || r->only[buffer]; }

bool ts_relax_ignores(const ts_relaxations *r, const char *name)
{
	for (const char *at = r->ignore; at != NULL; at = next_of(at)) {
		if (is_name(at, strcspn(at, ","), name)) return true;
	}
	return false;
}

static bool is_known(const char *text, size_t n)
{
	char name[128];
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const char *buffer = ts_buffer_table[id].name;
		ts_fields fields = ts_fields_of((ts_buffer_id)id);
		if (is_name(text, n, buffer)) return true;
		for (u32 f = 0; f < fields.n; f++) {
			if (fields.field[f].name[0] == 0) continue;
			snprintf(name, sizeof name, "%s.%s", buffer, fields.field[f].name);
			if (is_name(text, n, name)) return true;
		}
	}
	return false;
}

ts_status ts_relax_check(const ts_relaxations *r)
{
	for (const char *at = r->ignore; at != NULL; at = next_of(at)) {
		size_t n = strcspn(at, ",");
		if (is_known(at, n)) continue;
		return ts_fail("ignore: no buffer and no field \"%.*s\"; the table of buffers names all",
		               (int)(n < 80 ? n : 80), at);
	}
	return TS_OK;
}
