/* The frame that tables of backends measure. */
#include <string.h>
#include "output/json/text.h"
#include "study/asked/methods.h"
#include "study/asked/words.h"
#include "study/bench.h"

const char *ts_bench_frame_spec(const ts_job *job) { return job->scenes != NULL ? job->scenes : "atrium"; }

ts_status ts_bench_frame_params(ts_params *params, const ts_job *job)
{
	u32 objects;
	*params = job->params;
	if (strchr(ts_bench_frame_spec(job), ',') != NULL) {
		return ts_fail("--scene %s: this table takes one scene", job->scenes);
	}
	const char *typed = job->objects != NULL ? job->objects : "10";
	if (ts_words_count(&objects, typed, 1, TS_BENCH_OBJECTS, "--objects") != TS_OK) return TS_ERROR;
	TS_PARAM_SET(params, reflectors_count, objects);
	return TS_OK;
}

ts_status ts_bench_frame_open(ts_bench_frame *frame, const ts_job *job)
{
	const ts_pipeline *methods[TS_MAX_METHODS];
	ts_params params;
	u32 n;
	ts_estimate estimate;
	const ts_pipeline *first = ts_pipelines()[0];
	const char *typed = job->method != NULL ? job->method : first->name;
	if (ts_bench_frame_params(&params, job) != TS_OK) return TS_ERROR;
	if (ts_methods_find(methods, &n, first->effect->name, typed) != TS_OK) return TS_ERROR;
	if (n != 1) return ts_fail("--method %s: this table takes one method", job->method);
	*frame = (ts_bench_frame){.method = methods[0], .params = params};
	ts_status status = ts_scene_load(&frame->scene, ts_bench_frame_spec(job), &frame->params, &job->scene.options);
	return status == TS_OK ? ts_measure_estimate(&estimate, methods, 1, 0, frame->scene, &frame->params, NULL) : status;
}

ts_status ts_bench_frame_run(const ts_bench_frame *frame, const ts_how *how, ts_measure *measure)
{
	*measure = (ts_measure){.whole = true};
	return ts_measure_run(measure, frame->method, frame->scene, &frame->params, how, NULL, NULL);
}

void ts_bench_frame_close(ts_bench_frame *frame) { ts_scene_free(frame->scene); }

void ts_bench_frame_report(const ts_bench_frame *frame, ts_report *report)
{
	const ts_info *info = &frame->scene->info;
	ts_report_line(report, "%s: %u triangles, %u mirrors, by %s", frame->scene->name,
	               (unsigned)frame->scene->n_triangles, (unsigned)info->n_reflectors, frame->method->name);
	ts_report_value(report, "scene", ts_text_json(frame->scene->name));
	ts_report_value(report, "triangles", json_integer(frame->scene->n_triangles));
	ts_report_value(report, "mirrors", json_integer(info->n_reflectors));
	ts_report_value(report, "method", json_string(frame->method->name));
}
