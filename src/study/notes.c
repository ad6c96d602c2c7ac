/* Notes of the families on a run. */
#include "study/notes.h"
#include <assert.h>

static const ts_note_rule *const *lists;

void ts_notes_use(const ts_note_rule *const *rules) { lists = rules; }

static ts_status take(char note[TS_NOTE_CHARS], const ts_run *run, ts_buffer_id id)
{
	assert(lists != NULL);
	for (const ts_note_rule *const *list = lists; *list != NULL; list++) {
		for (const ts_note_rule *rule = *list; rule->take != NULL; rule++) {
			if (rule->buffer == id && rule->take(note, run) != TS_OK) return TS_ERROR;
		}
	}
	return TS_OK;
}

ts_status ts_notes_take(char note[TS_NOTE_CHARS], const ts_run *run, const ts_stage *stage)
{
	ts_status status = TS_OK;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (status == TS_OK && run->frame.buffer[*id].made) status = take(note, run, *id);
	}
	return status;
}
