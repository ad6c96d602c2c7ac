/* `golden new`: proposes current results beside the goldens, which stay. */
#include <stdio.h>
#include "cli/golden/golden.h"
#include "output/file.h"
#include "output/folder.h"

static ts_status write_preview(const ts_golden *golden)
{
	u32 width, height;
	const u8 *srgb = ts_golden_image(golden, &width, &height);
	if (ts_golden_by.write == NULL || srgb == NULL) return TS_OK;
	const char *path = ts_folder_file(TS_GOLDEN_PREVIEW);
	return path != NULL ? ts_golden_by.write(path, srgb, width, height, 3, NULL) : TS_ERROR;
}

static ts_status write_all(const ts_golden *golden, const ts_case *c)
{
	ts_status status = write_preview(golden);
	if (status == TS_OK) status = ts_case_write_params(c);
	if (status == TS_OK) status = ts_golden_write(golden, c->pipeline, c->small);
	return status == TS_OK ? ts_folder_commit() : status;
}

static ts_status propose(const ts_goldens *goldens, const ts_case *c)
{
	char path[TS_CASE_PATH];
	ts_golden golden;
	ts_case_path(path, goldens, c, ".new");
	if (ts_folder_begin(path, ts_golden_judge) != TS_OK) return TS_ERROR;
	ts_status status = ts_case_compute(&golden, goldens, c, &goldens->cli->job.how);
	if (status == TS_OK) status = write_all(&golden, c);
	if (status != TS_OK) ts_folder_discard();
	ts_golden_free(&golden);
	return status;
}

ts_status ts_golden_new_action(const ts_goldens *goldens)
{
	for (u32 i = 0; i < goldens->n_chosen; i++) {
		const ts_case *c = goldens->chosen[i];
		if (propose(goldens, c) != TS_OK) return TS_ERROR;
		if (!goldens->cli->job.output.quiet) printf("proposed   %s\n", c->name);
		if (ts_file_print("", 0) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}
