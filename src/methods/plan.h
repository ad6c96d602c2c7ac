/* A plan: what a method derives from the parameters, from what there is, and from what was asked for beside them. It is
 * made before the first stage (ts_pipeline_plan) and read only from then on; parameters stay what was typed. */
#ifndef TS_STAGES_PLAN_H
#define TS_STAGES_PLAN_H
#include "../model/param.h"
#include "../scene/scene.h"

/* How many there are; TS_NONE: not known yet, because a stage makes them. */
typedef struct {
	u32 reflectors, lights;  /* of the scene */
	u32 cubes, views, lamps; /* made: cubes, off-screen views and area lights */
} ts_counts;

/* What truths ask of a plan beside the parameters; zeros: nothing. */
typedef struct {
	u32 samples; /* of each light, instead of views and lamp.cubes */
} ts_request;

/* Every member is a u32, so that ts_plan_row can read it. A family has parts, PART(name, members), whose members are
 * MEMBER(part, name). */
#define FAMILY(name) FAMILY_FILE(methods, name, plan.def)
#define PART(name, members) \
	struct { \
		members \
	} name;
#define MEMBER(part, name) u32 name;
typedef struct {
	u32 units; /* what batches are made of: cubes, depth maps, or lights */
	u32 batch; /* units a batch */
#include "../families.def"
} ts_plan;
#undef MEMBER
#undef PART
#undef FAMILY

/* A member of the plan as text. */
typedef struct {
	const char *part, *name;
	size_t offset;
} ts_plan_row;
extern const ts_plan_row ts_plan_table[];
enum { TS_PLAN_ROWS = sizeof(ts_plan) / sizeof(u32) };
u32 ts_plan_value(const ts_plan *plan, const ts_plan_row *row);

/* Counts of a scene of which no stage has made anything. */
ts_counts ts_scene_counts(const ts_scene *scene);
/* What every plan starts as: a batch a reflector, points for the eye. */
void ts_plan_begin(ts_plan *plan, const ts_counts *counts);
/* Whose lights they are, and what views of many lights see, as the parameters say. */
void ts_plan_lights(ts_plan *plan, const ts_params *params);
void ts_plan_views(ts_plan *plan, const ts_params *params);
/* The plan of a run without a method: all of these, and the views of soft shadows. */
void ts_plan_default(ts_plan *plan, const ts_params *params, const ts_counts *counts);

#endif
