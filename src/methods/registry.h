/* The stages, the pipelines and the sizes that there are: families/families.c hands them in. */
#ifndef TS_METHODS_REGISTRY_H
#define TS_METHODS_REGISTRY_H
#include "pipeline.h"

/* What is asked for a size of records.def that is computed. known: what is known already. whole: of all units, not of
 * the batch. */
typedef struct {
	const ts_run *run;
	const ts_sizes *known;
	bool whole;
} ts_size_question;

/* TS_UNKNOWN where what it follows from is not there. */
typedef u64 ts_size_answer(const ts_size_question *question);

/* A stage has made the buffer. */
bool ts_is_made(const ts_size_question *question, ts_buffer_id id);

typedef struct {
	const ts_stage *const *stages;       /* in the order of pipelines, ended by NULL */
	const ts_pipeline *const *pipelines; /* those of an effect beside each other, ended by NULL */
	ts_size_answer *const *sizes;        /* by ts_dim; NULL: not computed */
} ts_registry;

/* Before anything is asked of them; it must outlive all that. */
void ts_registry_use(const ts_registry *registry);
const ts_registry *ts_registered(void);

#endif
