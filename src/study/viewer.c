/* Copies of buffers for viewers, by the rules that families have registered. */
#include "study/viewer.h"
#include <assert.h>
#include <stdio.h>
#include "study/folder.h"

static const ts_viewer_rule *const *lists;

void ts_viewer_use(const ts_viewer_rule *const *rules) { lists = rules; }

const char *ts_viewer_file(const char *folder, const char *name)
{
	char path[96];
	snprintf(path, sizeof path, "%s/%s", folder, name);
	return ts_folder_file(path);
}

ts_status ts_viewer_take(const ts_run *run, const ts_stage *stage, const char *folder)
{
	assert(lists != NULL);
	for (const ts_viewer_rule *const *list = lists; *list != NULL; list++) {
		for (const ts_viewer_rule *rule = *list; rule->write != NULL; rule++) {
			if (ts_stage_writes(stage, rule->buffer) && rule->write(run, folder) != TS_OK) return TS_ERROR;
		}
	}
	return TS_OK;
}
