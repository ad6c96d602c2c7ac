/* The table of stages, pipelines and sizes, which families/families.c hands in. */
#ifndef TS_METHODS_REGISTRY_H
#define TS_METHODS_REGISTRY_H
#include "methods/pipeline.h"

/* The input for a computed size of records.def. known: the sizes that are known already. whole: of all units, not of
 * the batch. */
typedef struct {
	const ts_run *run;
	const ts_sizes *known;
	bool whole;
} ts_size_question;

/* Computes a size; TS_UNKNOWN if its inputs are not there. */
typedef u64 ts_size_answer(const ts_size_question *question);

/* Whether a stage has made the buffer. */
bool ts_is_made(const ts_size_question *question, ts_buffer_id id);

typedef struct {
	const ts_stage *const *stages;       /* in the order of pipelines, ended by NULL */
	const ts_pipeline *const *pipelines; /* grouped by effect, ended by NULL */
	ts_size_answer *const *sizes;        /* by ts_dim; NULL: not computed */
} ts_registry;

/* Sets the table, before any use. It must stay. */
void ts_registry_use(const ts_registry *registry);
const ts_registry *ts_registered(void);

#endif
