/* Reading words that were typed. */
#include "words.h"
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
