/* Pictures of stages, and copies of buffers for viewers, by the rules that families have registered. */
#include "study/stage_pictures.h"
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include "study/results/folder.h"

static const ts_stage_picture_rule *const *lists;

void ts_stage_pictures_use(const ts_stage_picture_rule *const *rules) { lists = rules; }

ts_stage_picture *ts_stage_pictures_add(ts_stage_pictures *pictures, const char *name, u32 width, u32 height,
                                        bool masked)
{
	if (pictures->n == TS_MAX_STAGE_PICTURES) {
		ts_fail("picture %s: one more than %d", name, TS_MAX_STAGE_PICTURES);
		return NULL;
	}
	ts_stage_picture *p = &pictures->picture[pictures->n++];
	snprintf(p->name, sizeof p->name, "%s", name);
	p->width = width;
	p->height = height;
	p->zoom = 1;
	p->rgb = ts_alloc_zero((size_t)width * height, 3, "a stage picture");
	p->mask = masked ? ts_alloc_zero((size_t)width, height, "a stage picture") : NULL;
	return p->rgb != NULL && (!masked || p->mask != NULL) ? p : NULL;
}

ts_stage_picture *ts_stage_pictures_find(ts_stage_pictures *pictures, const char *name)
{
	for (u32 i = 0; i < pictures->n; i++) {
		if (strcmp(pictures->picture[i].name, name) == 0) return &pictures->picture[i];
	}
	return NULL;
}

static ts_status take(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	assert(lists != NULL);
	for (const ts_stage_picture_rule *const *list = lists; *list != NULL; list++) {
		for (const ts_stage_picture_rule *rule = *list; rule->take != NULL; rule++) {
			if (rule->buffer == id && rule->take(pictures, run, id) != TS_OK) return TS_ERROR;
		}
	}
	return TS_OK;
}

ts_status ts_stage_pictures_take(ts_stage_pictures *pictures, const ts_run *run, const ts_stage *stage)
{
	ts_status status = TS_OK;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (status == TS_OK && run->frame.buffer[*id].made) status = take(pictures, run, *id);
	}
	return status;
}

void ts_stage_pictures_finish(ts_stage_pictures *pictures, const u8 *srgb)
{
	for (u32 k = 0; k < pictures->n; k++) {
		ts_stage_picture *p = &pictures->picture[k];
		for (u64 i = 0; p->mask != NULL && i < (u64)p->width * p->height; i++) {
			const u8 *pixel = srgb + 3 * (i / p->width / p->zoom * (p->width / p->zoom) + i % p->width / p->zoom);
			if (p->mask[i] == 0) memset(p->rgb + 3 * i, (pixel[0] + 2 * pixel[1] + pixel[2]) / 12, 3);
		}
	}
}

void ts_stage_pictures_free(ts_stage_pictures *pictures)
{
	for (u32 k = 0; k < pictures->n; k++) {
		free(pictures->picture[k].rgb);
		free(pictures->picture[k].mask);
	}
	pictures->n = 0;
}

static const ts_viewer_rule *const *viewers;

void ts_viewer_use(const ts_viewer_rule *const *rules) { viewers = rules; }

const char *ts_viewer_file(const char *folder, const char *name)
{
	char path[96];
	snprintf(path, sizeof path, "%s/%s", folder, name);
	return ts_folder_file(path);
}

ts_status ts_viewer_take(const ts_run *run, const ts_stage *stage, const char *folder)
{
	assert(viewers != NULL);
	for (const ts_viewer_rule *const *list = viewers; *list != NULL; list++) {
		for (const ts_viewer_rule *rule = *list; rule->write != NULL; rule++) {
			if (ts_stage_writes(stage, rule->buffer) && rule->write(run, folder) != TS_OK) return TS_ERROR;
		}
	}
	return TS_OK;
}
