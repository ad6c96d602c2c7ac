/* Reading typed words; and "did you mean", the offered name at the least edit distance from the typed one. */
#include "study/asked/words.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DIGITS "0123456789"

ts_status ts_words_count(u32 *value, const char *text, u32 min, u32 max, const char *what)
{
	char *end;
	errno = 0;
	unsigned long n = strtoul(text, &end, 10);
	if (text[0] < '0' || text[0] > '9' || *end != 0 || errno != 0 || n < min || n > max) {
		return ts_fail("%s: \"%s\" is not a whole number from %u to %u", what, text, (unsigned)min, (unsigned)max);
	}
	*value = (u32)n;
	return TS_OK;
}

bool ts_words_item(const char **list, char *item, size_t item_bytes)
{
	if (*list == NULL) return false;
	const char *comma = strchr(*list, ',');
	size_t n = comma != NULL ? (size_t)(comma - *list) : strlen(*list);
	snprintf(item, item_bytes, "%.*s", (int)(n < item_bytes ? n : item_bytes - 1), *list);
	*list = comma != NULL ? comma + 1 : NULL;
	return true;
}

ts_status ts_words_size(ts_params *params, const char *text, const char *what)
{
	char width[32];
	const char *x = strpbrk(text, "xX");
	if (x == NULL || x - text >= (ptrdiff_t)sizeof width || strspn(text, DIGITS) != (size_t)(x - text) || x == text ||
	    x[1] == 0 || x[1 + strspn(x + 1, DIGITS)] != 0) {
		return ts_fail("%s %s: not a size; write WIDTHxHEIGHT, for instance 1920x1080", what, text);
	}
	snprintf(width, sizeof width, "%.*s", (int)(x - text), text);
	ts_status status = ts_params_set(params, "width", width);
	return status != TS_OK ? status : ts_params_set(params, "height", x + 1);
}

/* A whole number up to the greatest value of the parameter `frame`; *text moves behind it. */
static bool take_frame(u32 *frame, const char **text)
{
	char *end;
	bool begins = (*text)[0] >= '0' && (*text)[0] <= '9';
	unsigned long n = begins ? strtoul(*text, &end, 10) : 0;
	*frame = (u32)n;
	if (!begins || n > TS_LAST_FRAME) return false;
	*text = end;
	return true;
}

ts_status ts_words_frames(ts_frames *frames, const char *text)
{
	const char *at = text;
	*frames = (ts_frames){.step = 1};
	bool good = take_frame(&frames->first, &at) && strncmp(at, "..", 2) == 0;
	at += good ? 2 : 0;
	good = good && take_frame(&frames->last, &at) && frames->first <= frames->last;
	if (good && *at == ':') {
		at++;
		good = take_frame(&frames->step, &at) && frames->step > 0;
	}
	if (good && *at == 0) return TS_OK;
	return ts_fail("--frames %s: not A..B or A..B:STEP, with A not above B, B not above %d and a STEP of at least 1; "
	               "for instance 0..99",
	               text, TS_LAST_FRAME);
}

bool ts_words_listed(const char *list, const char *item)
{
	char own[64];
	bool listed = false;
	while (!listed && ts_words_item(&list, own, sizeof own)) listed = strcmp(own, item) == 0;
	return listed;
}

bool ts_words_have(const char *text, const char *word)
{
	size_t n = strlen(word);
	while (strcspn(text, " ") != n || strncmp(text, word, n) != 0) {
		text += strcspn(text, " ");
		if (text[0] == 0) return false;
		text++;
	}
	return true;
}

/* The offered name at the least edit distance from the typed one, if it is near. An insertion, deletion, exchange or
 * transposition of letters is one edit, and at most a third of the typed letters may be edited. A word without a point
 * or hyphen is also compared with the parts of the name between these, which counts as one edit more. */

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
