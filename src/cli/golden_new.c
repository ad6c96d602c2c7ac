/* `golden new`: what is computed now, beside the goldens, which it does not touch. */
#include <stdio.h>
#include "golden.h"

static ts_status write_preview(const ts_golden *golden, const ts_golden_dir *dir)
{
	char path[TS_GOLDEN_PATH + 32];
	u32 width, height;
	const u8 *srgb = ts_golden_image(golden, &width, &height);
	if (ts_golden_preview == NULL || srgb == NULL) return TS_OK;
	snprintf(path, sizeof path, "%s/preview.new.png", dir->path);
	ts_status status = ts_golden_preview(path, srgb, width, height, 3);
	return status == TS_OK ? ts_golden_rename(dir, "preview.new.png", "preview.png.new") : status;
}

static ts_status propose(const ts_goldens *goldens, const ts_case *c)
{
	ts_golden_dir dir;
	ts_golden golden;
	if (ts_golden_dir_make(&dir, &goldens->dir, c->name) != TS_OK) return TS_ERROR;
	ts_status status = ts_case_compute(&golden, c, &goldens->job->how);
	if (status == TS_OK) status = write_preview(&golden, &dir);
	if (status == TS_OK) status = ts_case_write_params(c, &dir, "params.txt.new");
	if (status == TS_OK) status = ts_golden_propose(&golden, &dir, c->pipeline, c->small);
	ts_golden_free(&golden);
	ts_golden_dir_close(&dir);
	return status;
}

ts_status ts_golden_new_action(const ts_goldens *goldens, const ts_case *only)
{
	for (u32 i = 0; i < goldens->n_cases; i++) {
		const ts_case *c = &goldens->cases[i];
		if (only != NULL && c != only) continue;
		if (propose(goldens, c) != TS_OK) return TS_ERROR;
		printf("proposed   %s\n", c->name);
		fflush(stdout);
	}
	return TS_OK;
}
