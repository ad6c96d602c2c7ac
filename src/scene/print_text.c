/* Text from files, on its way out: names may hold any bytes, JSON holds UTF-8 only, and terminals obey some of them. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../core/core.h"
#include "print.h"

enum { ESCAPE_BYTES = 4 };

json_t *ts_text_json(const char *text)
{
	json_t *string = json_string(text);
	char *escaped = string == NULL ? ts_alloc(strlen(text) + 1, ESCAPE_BYTES, "a text") : NULL;
	if (escaped == NULL) {
		return string;
	}
	char *to = escaped;
	for (const unsigned char *c = (const unsigned char *)text; *c != 0; c++) {
		to += snprintf(to, ESCAPE_BYTES + 1, *c > 127 ? "\\x%02x" : "%c", (unsigned)*c);
	}
	*to = 0;
	string = json_string(escaped);
	free(escaped);
	return string;
}

void ts_text_clean(char *text)
{
	for (unsigned char *c = (unsigned char *)text; *c != 0; c++) {
		bool c1 = c[0] == 0xc2 && c[1] >= 0x80 && c[1] <= 0x9f;
		if (c1) {
			c[0] = c[1] = '?';
		} else if (*c < 0x20 || *c == 0x7f) {
			*c = '?';
		}
	}
}
