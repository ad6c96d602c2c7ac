/* A plan: values that a method derives from parameters, counts and a request. A plan is made before the first stage
 * (ts_pipeline_plan) and only read from then on. */
#ifndef TS_METHODS_PLAN_H
#define TS_METHODS_PLAN_H
#include "model/param.h"
#include "scene/scene.h"

/* Numbers of things; TS_NONE: not known yet, because a stage makes the things. */
typedef struct {
	u32 reflectors, lights;  /* of the scene */
	u32 cubes, views, lamps; /* cubes, off-screen views and area lights that stages make */
} ts_counts;

/* Requests of truths to a plan; zeros: none. */
typedef struct {
	u32 samples; /* of each light, instead of views and lamp.cubes */
} ts_request;

/* Every member is a u32, so that ts_plan_row can read it. A family has parts, PART(name, members), whose members are
 * MEMBER(part, name). */
#define PART(name, members) \
	struct { \
		members \
	} name;
#define MEMBER(part, name) u32 name;
typedef struct {
	u32 units; /* number of the things in batches: cubes, depth maps, or lights */
	u32 batch; /* units per batch */
#include "model/params.def"
} ts_plan;
#undef MEMBER

/* A member of the plan as text. */
typedef struct {
	const char *part, *name;
	size_t offset;
} ts_plan_row;
extern const ts_plan_row ts_plan_table[];
enum { TS_PLAN_ROWS = sizeof(ts_plan) / sizeof(u32) };
u32 ts_plan_value(const ts_plan *plan, const ts_plan_row *row);

/* Counts of a scene before any stage. */
ts_counts ts_scene_counts(const ts_scene *scene);
/* The beginning of every plan: one batch per reflector, points for the eye. */
void ts_plan_begin(ts_plan *plan, const ts_counts *counts);
/* Sets, by the parameters, the origin of lights, and the directions that views of many lights see. */
void ts_plan_lights(ts_plan *plan, const ts_params *params);
void ts_plan_views(ts_plan *plan, const ts_params *params);
/* The plan of a run without a method: all of the above, and the views of soft shadows. */
void ts_plan_default(ts_plan *plan, const ts_params *params, const ts_counts *counts);

#endif
