/* The plan of a method, for its runs and for replays of its stages; the default plan, and the table of members. */
#include "methods/plan.h"
#include <assert.h>
#include <string.h>
#include "kernels/base/num.h"
#include "methods/pipeline.h"

#define ALONE(member) {"", #member, offsetof(ts_plan, member)},
#define PART(name, members) members
#define MEMBER(part, name) {#part, #name, offsetof(ts_plan, part.name)},
const ts_plan_row ts_plan_table[] = {ALONE(units) ALONE(batch)
#include "model/params.def"
};
static_assert(sizeof ts_plan_table / sizeof *ts_plan_table == TS_PLAN_ROWS, "every member has a row");

u32 ts_plan_value(const ts_plan *plan, const ts_plan_row *row)
{
	u32 value;
	memcpy(&value, (const char *)plan + row->offset, sizeof value);
	return value;
}

ts_counts ts_scene_counts(const ts_scene *scene)
{
	return (ts_counts){scene->info.n_reflectors, scene->n_lights, TS_NONE, TS_NONE, TS_NONE};
}

void ts_plan_begin(ts_plan *plan, const ts_counts *counts)
{
	*plan = (ts_plan){.units = counts->reflectors, .batch = 1};
}

void ts_plan_lights(ts_plan *plan, const ts_params *params)
{
	plan->lights.own = TS_PARAM(params, lamp_source) == TS_LAMP_SCENE;
}

void ts_plan_views(ts_plan *plan, const ts_params *params)
{
	plan->views.field = TS_PARAM(params, view_map_field);
	plan->views.px = TS_PARAM(params, view_map_px);
}

void ts_plan_default(ts_plan *plan, const ts_params *params, const ts_counts *counts)
{
	ts_plan_begin(plan, counts);
	ts_plan_lights(plan, params);
	ts_plan_views(plan, params);
	plan->lights.samples = TS_PARAM(params, lamp_views);
}

ts_params ts_pipeline_params(const ts_pipeline *pipeline, const ts_params *typed)
{
	ts_params params = *typed;
	if (pipeline->sets.param == NULL) return params;
	ts_status known = ts_params_set(&params, pipeline->sets.param, pipeline->sets.value);
	assert(known == TS_OK);
	return params;
}

/* Existing units, as a trace may have others than its parameters imply. */
static void count_units(ts_plan *plan, const ts_pipeline *pipeline, const ts_counts *counts)
{
	bool cubeless = ts_pipeline_maker(pipeline, TS_B_cube_size_face) == NULL;
	if (counts->cubes != TS_NONE) plan->units = counts->cubes;
	if (counts->lamps != TS_NONE && plan->lights.taps != 0) plan->units = counts->lamps;
	if (counts->views != TS_NONE && cubeless) plan->units = counts->views;
}

void ts_plan_make(ts_plan *plan, const ts_pipeline *pipeline, const ts_params *typed, const ts_counts *counts,
                  const ts_request *request)
{
	static const ts_request nothing;
	ts_params params = ts_pipeline_params(pipeline, typed);
	ts_plan_begin(plan, counts);
	if (request == NULL) request = &nothing;
	if (pipeline->plan != NULL) {
		TS_PARAM_READER(pipeline->effect->name, pipeline->name, pipeline->plan(plan, &params, counts, request));
	}
	count_units(plan, pipeline, counts);
}

void ts_pipeline_plan(const ts_pipeline *pipeline, ts_run *run, const ts_counts *counts, const ts_request *request)
{
	const ts_counts fresh = ts_scene_counts(run->scene);
	run->params = ts_pipeline_params(pipeline, &run->params);
	ts_plan_make(&run->plan, pipeline, &run->params, counts != NULL ? counts : &fresh, request);
	run->pipeline = pipeline;
	run->first_unit = 0;
	run->n_units = run->plan.units;
}

ts_expected ts_pipeline_expect(const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *typed)
{
	ts_run run = {.scene = scene, .params = ts_pipeline_params(pipeline, typed)};
	ts_expected expected = {.batches = 1};
	ts_counts counts = ts_scene_counts(scene);
	ts_plan_make(&run.plan, pipeline, typed, &counts, NULL);
	ts_sizes_clear(&expected.sizes);
	ts_sizes_scene(&expected.sizes, scene);
	TS_PARAM_READER(pipeline->effect->name, pipeline->name, pipeline->expect(&expected, scene, &run.params));
	ts_sizes_give(&expected.sizes, &run);
	return expected;
}
