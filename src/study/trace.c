/* The options of traces, and whether there is room for them. */
#include "study/trace.h"
#include <stdio.h>
#include <sys/statvfs.h>
#include "study/asked/words.h"
#include "study/results/folder.h"

static const char *place(void *user, const char *name)
{
	const ts_tracing *tracing = user;
	const size_t up = sizeof "../" - 1;
	if (strncmp(name, "../", up) == 0) return ts_folder_file(name + up);
	char path[sizeof tracing->folder + TS_EMIT_NAME];
	snprintf(path, sizeof path, "%s/%s", tracing->folder, name);
	return ts_folder_file(path);
}

static bool is_of(const char *buffer, const char *stage)
{
	size_t n = strlen(stage);
	return strncmp(buffer, stage, n) == 0 && buffer[n] == '.';
}

/* Keeps the buffers of stages of the method, and of "scene". */
static ts_status keep_only(ts_trace_options *options, const ts_pipeline *method, const char *stages)
{
	char name[32];
	for (u32 id = 0; id < TS_N_BUFFERS; id++) options->without[id] = true;
	while (ts_words_item(&stages, name, sizeof name)) {
		const ts_stage *stage = ts_stage_find(name);
		bool scene = strcmp(name, "scene") == 0, known = scene;
		for (const ts_step *s = ts_pipeline_steps(method); s->stage != NULL; s++) known |= strcmp(s->stage, name) == 0;
		if (!known) {
			return ts_fail("--trace-only: \"%s\" is no stage of %s; see: touchstone list stages", name, method->name);
		}
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			bool wanted = scene ? is_of(ts_buffer_table[id].name, "scene") : ts_stage_writes(stage, (ts_buffer_id)id);
			if (wanted) options->without[id] = false;
		}
	}
	return TS_OK;
}

/* With several samples the eye's buffers hold several pictures. */
static ts_status read_crop(u32 crop[4], const ts_params *params, const char *text)
{
	const char *list = text;
	char item[16];
	u32 n = 0;
	for (; n < 4 && ts_words_item(&list, item, sizeof item); n++) {
		if (ts_words_count(&crop[n], item, 0, 16384, "--crop") != TS_OK) return TS_ERROR;
	}
	if (TS_PARAM(params, eye_samples) != TS_EYE_SAMPLES_1)
		return ts_fail("--crop %s: with eye.samples=4 traces hold whole pictures; eye.samples=1 would be right", text);
	if (n == 4 && list == NULL && crop[2] > 0 && crop[3] > 0 && crop[0] + crop[2] <= TS_PARAM(params, width) &&
	    crop[1] + crop[3] <= TS_PARAM(params, height))
		return TS_OK;
	return ts_fail("--crop %s: not X,Y,WIDTH,HEIGHT of a part of the %u x %u image", text,
	               (unsigned)TS_PARAM(params, width), (unsigned)TS_PARAM(params, height));
}

ts_status ts_tracing_make(ts_tracing *tracing, const ts_job *job, const ts_pipeline *method)
{
	*tracing = (ts_tracing){.options = {.place = place, .user = tracing}};
	snprintf(tracing->folder, sizeof tracing->folder, "trace-%s", method->name);
	snprintf(tracing->viewer, sizeof tracing->viewer, "view-%s", method->name);
	ts_trace_options *options = &tracing->options;
	options->margins = job->output.margins;
	options->compress = job->output.compress;
	const ts_output *output = &job->output;
	if (output->trace_only != NULL && keep_only(options, method, output->trace_only) != TS_OK) return TS_ERROR;
	return output->crop != NULL ? read_crop(options->crop, &job->params, output->crop) : TS_OK;
}

/* Free bytes at `dir`, or at the nearest folder above it that exists. */
static u64 room_at(const char *dir)
{
	char path[4096];
	struct statvfs disk;
	snprintf(path, sizeof path, "%s", dir);
	while (statvfs(path, &disk) != 0) {
		char *slash = strrchr(path, '/');
		if (slash == NULL || slash == path) {
			snprintf(path, sizeof path, "%s", slash == NULL ? "." : "/");
			return statvfs(path, &disk) == 0 ? (u64)disk.f_bavail * disk.f_frsize : UINT64_MAX;
		}
		*slash = 0;
	}
	return (u64)disk.f_bavail * disk.f_frsize;
}

ts_status ts_tracing_check(const ts_tracing *tracings, const ts_pipeline *const *methods, u32 n, const ts_scene *scene,
                           const ts_params *params, const char *dir)
{
	u64 need = 0, room = room_at(dir);
	for (u32 i = 0; i < n; i++) {
		ts_trace_options options = tracings[i].options;
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			options.without[id] |= i > 0 && options.shared != NULL && ts_emit_is_scene((ts_buffer_id)id);
		}
		/* Sizes of compressed files are only known by writing; a disk that fills leaves nothing behind. */
		if (!options.compress) need += ts_trace_estimate(methods[i], scene, params, &options);
	}
	if (need <= room) return TS_OK;
	return ts_fail(
		"%s: the traces need about %.1f MB, and the disk has %.1f MB; choose fewer stages, a crop, or a smaller "
		"image",
		dir, (double)need / 1e6, (double)room / 1e6);
}
