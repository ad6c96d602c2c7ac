/* "Did you mean": the offered name at the least edit distance (Levenshtein) from what was typed. A word without a point
 * is also compared with what stands behind the point, which counts as one edit more. */
#include <stdlib.h>
#include <string.h>
#include "words.h"

enum { MAX_NAME = 64 };

static u32 least(u32 a, u32 b, u32 c)
{
	u32 m = a < b ? a : b;
	return m < c ? m : c;
}

static u32 distance(const char *a, const char *b)
{
	u32 row[MAX_NAME + 1];
	size_t na = strnlen(a, MAX_NAME), nb = strnlen(b, MAX_NAME);
	for (size_t j = 0; j <= nb; j++) row[j] = (u32)j;
	for (size_t i = 1; i <= na; i++) {
		u32 diagonal = row[0];
		row[0] = (u32)i;
		for (size_t j = 1; j <= nb; j++) {
			u32 cost = least(row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1]));
			diagonal = row[j];
			row[j] = cost;
		}
	}
	return row[nb];
}

ts_nearest ts_nearest_begin(const char *typed)
{
	ts_nearest nearest = {typed, "", UINT32_MAX};
	return nearest;
}

void ts_nearest_offer(ts_nearest *nearest, const char *name)
{
	const char *point = strchr(nearest->typed, '.') == NULL ? strchr(name, '.') : NULL;
	u32 d = distance(nearest->typed, name),
		behind = point != NULL ? distance(nearest->typed, point + 1) + 1 : UINT32_MAX;
	if (behind < d) d = behind;
	if (d < nearest->distance) {
		nearest->distance = d;
		nearest->best = name;
	}
}
