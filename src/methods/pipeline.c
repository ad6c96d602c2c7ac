/* The steps of pipelines: flattened once, with runs of steps in place and margins after their stages; and run, in
 * batches, freeing buffers after their last reader. */
#include "methods/pipeline.h"
#include <assert.h>
#include <pthread.h>
#include <stdio.h>

enum { MOST_PIPELINES = 32, MOST_STEPS = 64 };
static ts_step flat[MOST_PIPELINES][MOST_STEPS];

static void append(ts_step *to, u32 *n, const ts_step *step)
{
	assert(*n + 1 < MOST_STEPS); /* the last has no stage */
	to[(*n)++] = *step;
}

static void append_margin(ts_step *to, u32 *n, const ts_step *step)
{
	const ts_stage *stage = ts_stage_find(step->stage);
	assert(stage != NULL);
	const ts_stage *margin = ts_stage_margin(stage);
	if (margin == NULL) return;
	ts_step of = *step;
	of.stage = margin->name;
	of.only_margins = true;
	append(to, n, &of);
}

static void flatten(ts_step *to, u32 *n, const ts_step *step)
{
	for (; step->stage != NULL || step->run != NULL; step++) {
		if (step->run != NULL) {
			flatten(to, n, step->run);
		} else {
			append(to, n, step);
			append_margin(to, n, step);
		}
	}
}

static void flatten_all(void)
{
	for (u32 i = 0; ts_pipelines()[i] != NULL; i++) {
		u32 n = 0;
		assert(i < MOST_PIPELINES);
		flatten(flat[i], &n, ts_pipelines()[i]->steps);
	}
}

const ts_step *ts_pipeline_steps(const ts_pipeline *pipeline)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, flatten_all);
	for (u32 i = 0; ts_pipelines()[i] != NULL; i++) {
		if (pipeline == ts_pipelines()[i]) return flat[i];
	}
	return pipeline->steps;
}

static bool stores(const ts_step *step, const ts_params *params)
{
	if (step->stored == TS_STORED_BY_DEFAULT) return TS_PARAM(params, points_buffered) != TS_BUFFERED_OFF;
	return step->stored == TS_STORED_ANYHOW || TS_PARAM(params, points_buffered) == TS_BUFFERED_ON;
}

bool ts_pipeline_takes(const ts_step *step, const ts_params *params, bool traced)
{
	if (step->only_if != NULL && !step->only_if(params)) return false;
	if (step->least_bounces > 0 && TS_PARAM(params, lookup_bounces) < step->least_bounces) return false;
	return stores(step, params) && (traced || !(step->only_traced || step->only_margins));
}

bool ts_pipeline_needs(const ts_step *step, const ts_params *params, ts_buffer_id id)
{
	bool spares = step->spares != NULL && step->spared == id && step->spares(params);
	return !spares && ts_pipeline_takes(step, params, true) && ts_stage_reads(ts_stage_find(step->stage), id);
}

/* True if a step from `step` on reads the buffer. */
static bool is_read_from(const ts_step *step, const ts_params *params, ts_buffer_id id)
{
	while (step->stage != NULL && !ts_pipeline_needs(step, params, id)) step++;
	return step->stage != NULL;
}

bool ts_pipeline_reads(const ts_pipeline *pipeline, ts_buffer_id id)
{
	const ts_step *step = ts_pipeline_steps(pipeline);
	while (step->stage != NULL && !ts_stage_reads(ts_stage_find(step->stage), id)) step++;
	return step->stage != NULL;
}

/* True if some step reads the buffer, and none from `next` on; buffers that no stage reads stay. */
static bool is_over(const ts_pipeline *pipeline, const ts_step *next, const ts_params *params, ts_buffer_id id)
{
	return is_read_from(ts_pipeline_steps(pipeline), params, id) && !is_read_from(next, params, id);
}

static void forget(const ts_pipeline *pipeline, const ts_step *next, ts_run *run)
{
	for (u32 id = 0; run->lean && id < TS_N_BUFFERS; id++) {
		const ts_buffer *buffer = &run->frame.buffer[id];
		bool own = buffer->made && !buffer->borrowed && !run->keep[id];
		if (own && is_over(pipeline, next, &run->params, (ts_buffer_id)id)) {
			ts_frame_drop(&run->frame, (ts_buffer_id)id);
		}
	}
}

/* Reports progress up to a step, plus thousandths of the step. */
static void show(const ts_run *run, const ts_step *step, u64 thousandths)
{
	char label[64];
	const ts_step *first = ts_pipeline_steps(run->pipeline), *end = step;
	while (end->stage != NULL) end++;
	snprintf(label, sizeof label, "%s%s%s", run->pipeline->name, step > first ? ", after " : "",
	         step > first ? step[-1].stage : "");
	ts_progress(label, (u64)(step - first) * 1000 + thousandths, (u64)(end - first) * 1000);
}

static ts_status run_steps(const ts_step *step, const ts_step *end, ts_run *run)
{
	for (; step < end; step++) {
		const ts_stage *stage = ts_stage_find(step->stage);
		assert(stage != NULL);
		bool takes = ts_pipeline_takes(step, &run->params, run->traced) && (run->margins || !step->only_margins) &&
		             !(run->arrival && step->only_ordered);
		if (takes && ts_run_stage(run, stage) != TS_OK) return TS_ERROR;
		if (run->n_units == run->plan.units) show(run, step + 1, 0);
	}
	return TS_OK;
}

/* Runs batch after batch; a scene without reflectors is one empty batch. */
static ts_status run_batches(const ts_step *step, const ts_step *end, ts_run *run)
{
	u32 n = run->plan.units;
	for (u32 first = 0; first == 0 || first < n; first += run->plan.batch) {
		run->first_unit = first;
		run->n_units = n - first < run->plan.batch ? n - first : run->plan.batch;
		if (first > 0) show(run, step, (u64)(end - step) * 1000 * first / n);
		if (run_steps(step, end, run) != TS_OK) return TS_ERROR;
	}
	run->first_unit = 0;
	run->n_units = n;
	show(run, end, 0);
	return TS_OK;
}

/* The step behind this one, or behind the last of its batch. */
static const ts_step *step_after(const ts_step *step)
{
	const ts_step *end = step + 1;
	while (step->each_batch && end->each_batch) end++;
	return end;
}

static ts_status check_scene(const ts_pipeline *pipeline, const ts_run *run)
{
	const ts_scene *scene = run->scene;
	bool draws_surfels = ts_pipeline_reads(pipeline, TS_B_scene_surfel);
	if (draws_surfels && TS_PARAM(&run->params, eye_samples) != TS_EYE_SAMPLES_1)
		return ts_fail("eye.samples=4: surfels have a filter of their own, and 1 would be right");
	if (draws_surfels && scene->n_surfels == 0)
		return ts_fail("%s: has no surfels; surfels.from_mesh=COUNT samples some from its triangles", scene->name);
	if (!draws_surfels && scene->n_surfels > 0 && scene->n_triangles == 0)
		return ts_fail("%s: has surfels only; %s by %s draws triangles", scene->name, pipeline->effect->name,
		               pipeline->name);
	return TS_OK;
}

static ts_status run_method(const ts_pipeline *pipeline, ts_run *run)
{
	if (check_scene(pipeline, run) != TS_OK) return TS_ERROR;
	ts_pipeline_plan(pipeline, run, NULL, NULL);
	const ts_step *end;
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL; step = end) {
		end = step_after(step);
		ts_status status = step->each_batch ? run_batches(step, end, run) : run_steps(step, end, run);
		if (status != TS_OK) return status;
		forget(pipeline, end, run);
	}
	return ts_frame_fetch(&run->frame);
}

ts_status ts_pipeline_run(const ts_pipeline *pipeline, ts_run *run)
{
	ts_status status;
	TS_PARAM_READER(pipeline->effect->name, pipeline->name, status = run_method(pipeline, run));
	return status;
}

const ts_step *ts_pipeline_maker(const ts_pipeline *pipeline, ts_buffer_id id)
{
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL; step++) {
		if (ts_stage_writes(ts_stage_find(step->stage), id)) return step;
	}
	return NULL;
}

u64 ts_pipeline_bytes(ts_buffer_id id, const ts_sizes *sizes)
{
	u64 dims[TS_MAX_DIMS], n, bytes, most = 1ull << 63;
	const ts_shape *shape = ts_buffer_shape(id);
	bool known = ts_shape_dims(shape, sizes, dims) && ts_shape_count(&n, shape->n, dims) &&
	             ts_shape_count(&bytes, 2, (u64[]){n, ts_buffer_table[id].element_bytes});
	return known && bytes < most ? bytes : most;
}

static u64 add(u64 a, u64 b) { return a > UINT64_MAX - b ? UINT64_MAX : a + b; }

/* Bytes of live buffers while `step` runs. */
static u64 bytes_at(const ts_pipeline *pipeline, const ts_step *step, const ts_params *params, const ts_sizes *sizes,
                    bool lean)
{
	u64 bytes = 0;
	bool made[TS_N_BUFFERS] = {false};
	for (const ts_step *s = ts_pipeline_steps(pipeline); s <= step; s++) {
		if (!ts_pipeline_takes(s, params, false)) continue;
		for (const ts_buffer_id *id = ts_stage_outputs(ts_stage_find(s->stage)); *id != TS_N_BUFFERS; id++)
			made[*id] = true;
	}
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool alive = made[id] && !(lean && is_over(pipeline, step, params, (ts_buffer_id)id));
		bytes = add(bytes, alive ? ts_pipeline_bytes((ts_buffer_id)id, sizes) : 0);
	}
	return bytes;
}

u64 ts_pipeline_estimate(const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *typed, bool lean)
{
	const ts_params params = ts_pipeline_params(pipeline, typed);
	const ts_expected expected = ts_pipeline_expect(pipeline, scene, &params);
	u64 peak = 0;
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL; step++) {
		u64 bytes = bytes_at(pipeline, step, &params, &expected.sizes, lean);
		peak = bytes > peak ? bytes : peak;
	}
	return add(peak, expected.work);
}
