/* The default plan of methods, and the table of members. */
#include "methods/plan.h"
#include <assert.h>
#include <string.h>
#include "kernels/base/num.h"

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
