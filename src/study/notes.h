/* Notes of a family to the user of a successful run, about a setting that does harm. */
#ifndef TS_STUDY_NOTES_H
#define TS_STUDY_NOTES_H
#include "methods/stage.h"

enum { TS_NOTE_CHARS = 256 };

/* A buffer, and the function that is called when its stage has run. */
typedef struct {
	ts_buffer_id buffer;
	ts_status (*take)(char note[TS_NOTE_CHARS], const ts_run *run); /* leaves `note` as it is if there is none */
} ts_note_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `take`. They must stay. */
void ts_notes_use(const ts_note_rule *const *rules);
/* Writes the note on the buffers that `stage` has just made; a later note replaces an earlier one. */
ts_status ts_notes_take(char note[TS_NOTE_CHARS], const ts_run *run, const ts_stage *stage);

#endif
