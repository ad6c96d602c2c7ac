/* Checking goldens. */
#include <stdio.h>
#include <string.h>
#include <touchstone/golden.h>
#include <touchstone/image.h>
#include "api/api.h"
#include "golden/beside.h"
#include "golden/params.h"
#include "scene/sources.h"
#include "trace/emitted/emit.h"

/* The file is untrusted. */
static ts_status find_method(const ts_pipeline **pipeline, const ts_golden_settings *settings, const ts_golden_dir *dir)
{
	*pipeline = ts_pipeline_find(settings->effect, settings->method);
	if (*pipeline == NULL)
		return ts_fail("%s: %s by %s: no such method", dir->path, settings->effect, settings->method);
	if (ts_golden_bound(settings) == TS_OK) return TS_OK;
	return ts_fail("%s: %s", dir->path, ts_error_message());
}

static void name_difference(ts_golden_judged *judged, const char *text, const ts_pipeline *pipeline)
{
	const ts_buffer_id id = ts_golden_named(text, pipeline);
	snprintf(judged->text, sizeof judged->text, "%s", text);
	if (id == TS_N_BUFFERS) return;
	snprintf(judged->stage, sizeof judged->stage, "%s", ts_emit_maker(pipeline, id));
	snprintf(judged->buffer, sizeof judged->buffer, "%s", ts_buffer_table[id].name);
}

static ts_status compare(char text[TS_GOLDEN_TEXT], const ts_golden_dir *dir, const ts_golden *stored,
                         const ts_golden *computed, const ts_pipeline *pipeline)
{
	const bool small = ts_golden_has(dir, "small");
	ts_status status = ts_golden_compare(text, TS_GOLDEN_TEXT, stored, computed, pipeline, small);
	return status == TS_OK ? ts_golden_check_preview(text, dir, computed, ts_image_decode) : status;
}

static ts_status check(ts_golden_judged *judged, const ts_golden_dir *dir, const ts_how *how)
{
	const ts_pipeline *pipeline;
	ts_golden_settings settings;
	ts_golden stored, computed;
	char text[TS_GOLDEN_TEXT] = "", above[TS_GOLDEN_PATH + 4];
	if (ts_golden_read_params(&settings, dir) != TS_OK || find_method(&pipeline, &settings, dir) != TS_OK)
		return TS_ERROR;
	memcpy(judged->effect, settings.effect, sizeof judged->effect);
	memcpy(judged->method, settings.method, sizeof judged->method);
	memcpy(judged->scene, settings.scene, sizeof judged->scene);
	ts_status status = ts_golden_read(&stored, dir, pipeline);
	if (status == TS_OK) status = ts_golden_check_changes(dir);
	if (status == TS_OK) {
		snprintf(above, sizeof above, "%s/..", dir->path);
		status = ts_golden_make(&computed, dir->path, pipeline, &settings, above, ts_scene_load, how);
		if (status == TS_OK) status = compare(text, dir, &stored, &computed, pipeline);
		ts_golden_free(&computed);
	}
	ts_golden_free(&stored);
	if (status != TS_ERROR) name_difference(judged, text, pipeline);
	return status;
}

ts_status ts_golden_check(ts_context *context, ts_golden_judged *judged, const char *folder)
{
	ts_golden_dir dir;
	if (TS_LACKS(context) || TS_LACKS(judged) || TS_LACKS(folder)) return TS_ERROR;
	ts_golden_judged result = {.bytes = judged->bytes};
	if (ts_api_room(judged->bytes, sizeof result, sizeof result, "ts_golden_judged") != TS_OK) return TS_ERROR;
	*judged = result;
	if (ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = ts_golden_dir_open(&dir, NULL, folder);
	if (status == TS_OK) {
		status = ts_blame(check(&result, &dir, &context->how), TS_KIND_FORMAT);
		ts_golden_dir_close(&dir);
	}
	ts_api_leave();
	if (status != TS_ERROR) *judged = result;
	return status;
}
