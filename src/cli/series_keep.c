/* Pictures that later combinations of a sweep need again. */
#include <stdlib.h>
#include "cli/series.h"
#include "study/asked/reads.h"

struct ts_kept {
	ts_kept *next;
	u32 shown, combination, frame; /* what it is a picture of; unread parameters have their first value */
	ts_measure measure;            /* of a method, like the stages */
	ts_stage_pictures stages;
	ts_picture picture; /* without pixels while a render has it */
};

static bool truth_reads(const ts_render *render, const ts_truth_kind *kind, const char *param)
{
	const ts_pipeline *method = kind->needs != NULL ? ts_render_truth_method(render, kind) : NULL;
	return ts_reads("truth", kind->name, param) || (kind->image != NULL && ts_reads("stage", kind->image, param)) ||
	       (method != NULL && ts_reads_making(method, kind->needs, param));
}

/* Whether the shown picture depends on the parameter: a method's reads with any parameters count. */
static bool depends(const ts_render *render, u32 shown, const char *param)
{
	if (ts_render_scene_reads(render->job, param)) return true;
	if (render->job->truths != 0 && strcmp(param, "truth.rays") == 0) return true; /* texels besides rays */
	return shown < TS_MAX_METHODS ? ts_reads_method(render->methods[shown], NULL, param)
	                              : truth_reads(render, ts_truths()[shown - TS_MAX_METHODS], param);
}

/* The combination with the first value of each parameter that the picture does not depend on. */
static u32 combination_of(const ts_series *series, u32 shown)
{
	const ts_sweep *sweep = &series->job->sweep;
	u32 rest = series->combination, combination = 0, weight = 1;
	for (u32 k = sweep->n; k-- > 0;) {
		const ts_swept *swept = &sweep->swept[k];
		if (depends(series->render, shown, swept->name)) combination += rest % swept->n * weight;
		rest /= swept->n;
		weight *= swept->n;
	}
	return combination;
}

static ts_kept *find(const ts_series *series, u32 shown)
{
	u32 combination = combination_of(series, shown), frame = TS_PARAM(&series->job->params, frame);
	ts_kept *kept = series->keep.list;
	while (kept != NULL && (kept->shown != shown || kept->combination != combination || kept->frame != frame))
		kept = kept->next;
	return kept;
}

/* Moves a picture to the render, if `give`, or from it. */
static void move(ts_render *render, ts_kept *kept, bool give)
{
	ts_picture *picture = ts_render_picture(render, kept->shown);
	*(give ? picture : &kept->picture) = give ? kept->picture : *picture;
	*(give ? &kept->picture : picture) = (ts_picture){.radiance = NULL};
	if (kept->shown >= TS_MAX_METHODS) return;
	ts_measure *measure = &render->measures[kept->shown];
	ts_stage_pictures *stages = &render->stages[kept->shown];
	*(give ? measure : &kept->measure) = give ? kept->measure : *measure;
	*(give ? stages : &kept->stages) = give ? kept->stages : *stages;
	*(give ? &kept->stages : stages) = (ts_stage_pictures){.n = 0};
}

void ts_keep_give(ts_series *series)
{
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) {
		bool meant =
			i < TS_MAX_METHODS ? i < series->render->n_methods : (series->job->truths >> (i - TS_MAX_METHODS) & 1) != 0;
		ts_kept *kept = meant ? find(series, i) : NULL;
		if (kept != NULL) move(series->render, kept, true);
	}
}

/* Bytes of its pictures: three bytes and three floats per pixel, and marks; twice for a partial truth. */
static u64 bytes_of(const ts_series *series, u32 shown)
{
	u64 bytes = (u64)TS_PARAM(&series->job->params, width) * TS_PARAM(&series->job->params, height) * 20;
	if (ts_render_shown(series->render, shown) != NULL && ts_render_shown(series->render, shown)->chosen != NULL)
		bytes *= 2;
	const ts_stage_pictures *stages = shown < TS_MAX_METHODS ? &series->render->stages[shown] : NULL;
	for (u32 k = 0; stages != NULL && k < stages->n; k++)
		bytes += (u64)stages->picture[k].width * stages->picture[k].height * 4;
	return bytes + sizeof(ts_kept);
}

static ts_kept *add(ts_series *series, u32 shown)
{
	ts_kept *kept = ts_alloc_zero(1, sizeof *kept, "a picture to keep");
	if (kept == NULL) return NULL;
	kept->shown = shown;
	kept->combination = combination_of(series, shown);
	kept->frame = TS_PARAM(&series->job->params, frame);
	kept->next = series->keep.list;
	series->keep.list = kept;
	return kept;
}

ts_status ts_keep_take(ts_series *series)
{
	ts_keep *keep = &series->keep;
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) {
		if (ts_render_shown(series->render, i) == NULL) continue;
		ts_kept *kept = find(series, i);
		u64 bytes = bytes_of(series, i);
		if (kept == NULL && keep->bytes + bytes > ts_memory_limit() / 8) continue;
		if (kept == NULL) {
			kept = add(series, i);
			keep->bytes += bytes;
		}
		if (kept == NULL) return TS_ERROR;
		move(series->render, kept, false);
	}
	return TS_OK;
}

void ts_keep_free(ts_keep *keep)
{
	while (keep->list != NULL) {
		ts_kept *next = keep->list->next;
		ts_picture_free(&keep->list->picture);
		ts_stage_pictures_free(&keep->list->stages);
		free(keep->list);
		keep->list = next;
	}
}
