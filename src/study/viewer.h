/* Copies of a run's buffers in formats for people and viewers; never hashed, never compared. */
#ifndef TS_STUDY_VIEWER_H
#define TS_STUDY_VIEWER_H
#include "methods/stage.h"

/* A buffer, and the function that writes its copy into a folder of the output. */
typedef struct {
	ts_buffer_id buffer;
	ts_status (*write)(const ts_run *run, const char *folder);
} ts_viewer_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `write`. They must stay. */
void ts_viewer_use(const ts_viewer_rule *const *rules);
/* For rules: the path of a file in that folder, valid until the next call but one; NULL: failed. */
const char *ts_viewer_file(const char *folder, const char *name);

/* Writes the copies of the buffers that a stage has just made. */
ts_status ts_viewer_take(const ts_run *run, const ts_stage *stage, const char *folder);

#endif
