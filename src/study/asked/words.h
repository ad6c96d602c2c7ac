/* Reads typed words. */
#ifndef TS_STUDY_ASKED_WORDS_H
#define TS_STUDY_ASKED_WORDS_H
#include "kernels/base/compat.h"
#include "model/core.h"
#include "study/asked/job.h"

/* Reads a decimal count in [min, max]; `what` names it in the message. */
ts_status ts_words_count(u32 *value, const char *text, u32 min, u32 max, const char *what);
/* Reads "WxH" into width and height; `what` names it in the message. */
ts_status ts_words_size(ts_params *params, const char *text, const char *what);
/* Reads "A..B" or "A..B:STEP" of the option --frames. */
ts_status ts_words_frames(ts_frames *frames, const char *text);
/* Copies the next item of a comma-separated list to `item` and moves *list behind it: false at the end. An item that is
 * too long is cut, and so matches no name. */
bool ts_words_item(const char **list, char *item, size_t item_bytes);

/* Whether `item` is an item of a comma-separated list. */
bool ts_words_listed(const char *list, const char *item);

/* Whether `word` is one of the words of a text, which blanks separate. */
bool ts_words_have(const char *text, const char *word);

/* The nearest of the names offered so far to what was typed, for "did you mean". */
typedef struct {
	const char *typed, *best, *mark; /* mark: text before the name in the message, "" at first */
	u32 distance;                    /* edits; 0: it is the name */
	char hint[160];
} ts_nearest;
ts_nearest ts_nearest_begin(const char *typed);
void ts_nearest_offer(ts_nearest *nearest, const char *name);
/* The end of a message, from its semicolon on: the nearest name, if it is near, and the command that lists all; NULL:
 * there is none. The text lives in *nearest. */
const char *ts_nearest_hint(ts_nearest *nearest, const char *lists);

#endif
