/* "Did you mean": the offered name at the least edit distance from the typed one, if it is near. An insertion,
 * deletion, exchange or transposition of letters is one edit, and at most a third of the typed letters may be edited. A
 * word without a point or hyphen is also compared with the parts of the name between these, which counts as one edit
 * more. */
#include <stdio.h>
#include <string.h>
#include "study/words.h"

enum { MAX_NAME = 64 };

static u32 min(u32 a, u32 b) { return a < b ? a : b; }

/* Optimal string alignment: no letter is edited twice. */
static u32 distance(const char *a, const char *b, size_t nb)
{
	u32 rows[3][MAX_NAME + 1];
	size_t na = strnlen(a, MAX_NAME);
	if (nb > MAX_NAME) nb = MAX_NAME;
	for (size_t j = 0; j <= nb; j++) rows[0][j] = (u32)j;
	for (size_t i = 1; i <= na; i++) {
		u32 *row = rows[i % 3];
		const u32 *above = rows[(i - 1) % 3], *before = rows[(i + 1) % 3];
		row[0] = (u32)i;
		for (size_t j = 1; j <= nb; j++) {
			const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
			row[j] = min(min(above[j], row[j - 1]) + 1, above[j - 1] + (a[i - 1] != b[j - 1]));
			if (swapped) row[j] = min(row[j], before[j - 2] + 1);
		}
	}
	return rows[na % 3][nb];
}

ts_nearest ts_nearest_begin(const char *typed)
{
	const ts_nearest nearest = {.typed = typed, .best = "", .mark = "", .distance = UINT32_MAX};
	return nearest;
}

void ts_nearest_offer(ts_nearest *nearest, const char *name)
{
	static const char between[] = ".-";
	u32 d = distance(nearest->typed, name, strlen(name));
	if (strpbrk(nearest->typed, between) == NULL && strpbrk(name, between) != NULL) {
		for (const char *part = name; *part != 0; part += strspn(part, between)) {
			const size_t n = strcspn(part, between);
			d = min(d, distance(nearest->typed, part, n) + 1);
			part += n;
		}
	}
	if (d < nearest->distance) {
		nearest->distance = d;
		nearest->best = name;
	}
}

const char *ts_nearest_hint(ts_nearest *nearest, const char *lists)
{
	char *hint = nearest->hint;
	const bool near = nearest->distance <= ((u32)strnlen(nearest->typed, MAX_NAME) + 1) / 3;
	hint[0] = 0;
	if (near) snprintf(hint, sizeof nearest->hint, "; the nearest is %s%.64s", nearest->mark, nearest->best);
	if (lists == NULL) return hint;
	const size_t used = strlen(hint);
	snprintf(hint + used, sizeof nearest->hint - used, "%s \"%s\" lists all", near ? ", and" : ";", lists);
	return hint;
}
