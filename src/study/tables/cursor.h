/* Reads a line of text word by word. The message of the first mistake has file, line and column. After a mistake all
 * words are empty and all numbers 0, so a reader looks at the status once a line. */
#ifndef TS_STUDY_TABLES_CURSOR_H
#define TS_STUDY_TABLES_CURSOR_H
#include "kernels/base/compat.h"
#include "model/core.h"

typedef struct {
	const char *path;
	u32 number;
	char *begin, *at; /* words are ended in place */
	ts_status status;
} ts_cursor;

/* The first message stands. `at`: where in the line. */
void ts_cursor_wrong(ts_cursor *line, const char *at, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* The next word, or a text in quotes; "" at the end of the line. */
char *ts_cursor_more(ts_cursor *line);
/* The same, and there must be one; `what` names it in the message. */
char *ts_cursor_word(ts_cursor *line, const char *what);
/* A word that may be a part of a file's name: at most 40 letters, digits, `_`, `-` and `.`, but no `.` first. */
char *ts_cursor_name(ts_cursor *line, const char *what);
/* A name that expressions may have: a letter, then letters, digits and `_`; neither "growth" nor "truth". */
char *ts_cursor_key(ts_cursor *line, const char *what);
/* All that is left of the line; unless `what` is NULL it must be something. */
char *ts_cursor_rest(ts_cursor *line, const char *what);
double ts_cursor_number(ts_cursor *line);
u32 ts_cursor_count(ts_cursor *line, u32 most);
/* The next word must be this one. */
void ts_cursor_expect(ts_cursor *line, const char *word);
/* Whether the line has no more words. */
bool ts_cursor_ended(ts_cursor *line);
/* It must not have. */
void ts_cursor_end(ts_cursor *line);

#endif
