/* A line of text word by word. */
#include "study/tables/cursor.h"
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "model/decimal.h"

void ts_cursor_wrong(ts_cursor *line, const char *at, const char *format, ...)
{
	char text[512];
	va_list arguments;
	if (line->status != TS_OK) return;
	va_start(arguments, format);
	vsnprintf(text, sizeof text, format, arguments);
	va_end(arguments);
	line->status = ts_fail("%s:%u:%u: %s", line->path, (unsigned)line->number, (unsigned)(at - line->begin) + 1, text);
	line->at += strlen(line->at);
}

bool ts_cursor_ended(ts_cursor *line)
{
	line->at += strspn(line->at, " \t");
	return *line->at == 0;
}

char *ts_cursor_more(ts_cursor *line)
{
	if (ts_cursor_ended(line)) return line->at;
	bool quoted = *line->at == '"';
	char *word = line->at + quoted;
	line->at = word + strcspn(word, quoted ? "\"" : " \t");
	if (*line->at != 0) {
		*line->at++ = 0;
	} else if (quoted) {
		ts_cursor_wrong(line, word - 1, "a text without its second '\"'");
	}
	return line->status == TS_OK ? word : line->at;
}

char *ts_cursor_word(ts_cursor *line, const char *what)
{
	if (ts_cursor_ended(line)) ts_cursor_wrong(line, line->at, "%s is expected", what);
	return ts_cursor_more(line);
}

enum { NAME_CHARS = 40 };

/* Whether all of the word's characters are letters, digits or of `others`. */
static bool is_of(const char *word, const char *others)
{
	while (*word != 0 && (isalnum((unsigned char)*word) || strchr(others, *word) != NULL)) word++;
	return *word == 0;
}

char *ts_cursor_name(ts_cursor *line, const char *what)
{
	char *word = ts_cursor_word(line, what);
	if (line->status != TS_OK || (*word != 0 && *word != '.' && is_of(word, "_-.") && strlen(word) <= NAME_CHARS))
		return word;
	ts_cursor_wrong(line, word, "\"%s\": %s has at most %d letters, digits, _, - and .", word, what, NAME_CHARS);
	return line->at;
}

char *ts_cursor_key(ts_cursor *line, const char *what)
{
	char *word = ts_cursor_name(line, what);
	bool reserved = strcmp(word, "growth") == 0 || strcmp(word, "truth") == 0;
	if (line->status != TS_OK || (isalpha((unsigned char)*word) && is_of(word, "_") && !reserved)) return word;
	ts_cursor_wrong(line, word, "\"%s\": %s is a letter, then letters, digits and _; not growth or truth", word, what);
	return line->at;
}

char *ts_cursor_rest(ts_cursor *line, const char *what)
{
	if (ts_cursor_ended(line) && what != NULL) ts_cursor_wrong(line, line->at, "%s is expected", what);
	char *rest = line->at;
	line->at += strlen(line->at);
	return rest;
}

double ts_cursor_number(ts_cursor *line)
{
	char *word = ts_cursor_word(line, "a number"), *end = word;
	double value = *word != 0 ? ts_strtod(word, &end) : 0;
	if (*word != 0 && *end == 0 && isfinite(value)) return value;
	ts_cursor_wrong(line, word, "\"%s\" is no number", word);
	return 0;
}

u32 ts_cursor_count(ts_cursor *line, u32 most)
{
	const char *at = line->at + strspn(line->at, " \t");
	double value = ts_cursor_number(line);
	if (value >= 0 && value <= most && value == floor(value)) return (u32)value;
	ts_cursor_wrong(line, at, "a whole number up to %u is expected", (unsigned)most);
	return 0;
}

void ts_cursor_expect(ts_cursor *line, const char *right)
{
	const char *word = ts_cursor_more(line);
	if (strcmp(word, right) != 0) ts_cursor_wrong(line, word, "\"%s\" is expected", right);
}

void ts_cursor_end(ts_cursor *line)
{
	if (!ts_cursor_ended(line)) ts_cursor_wrong(line, line->at, "nothing more is expected");
}
