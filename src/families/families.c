/* The families' tables, in the order of families. */
#include "families/families.h"
#include <pthread.h>
#include "methods/registry.h"
#include "vectors/vectors.h"

#define VECTORS(name) extern const ts_vector_set ts_##name##_vectors;
#include "families.def"

#define VECTORS(name) &ts_##name##_vectors,
static const ts_vector_set *const vectors[] = {
#include "families.def"
	NULL,
};

#define STAGE(name) extern const ts_stage ts_stage_##name;
#include "families.def"

#define STAGE(name) &ts_stage_##name,
static const ts_stage *const stages[] = {
#include "families.def"
	NULL,
};

#define PIPELINE(name) extern const ts_pipeline ts_pipeline_##name;
#include "families.def"

#define PIPELINE(name) &ts_pipeline_##name,
static const ts_pipeline *const pipelines[] = {
#include "families.def"
	NULL,
};

/* Sizes that are computed: ts_size_<name>. */
#define SIZE_fixed(id, computed)
#define SIZE_counted(id, computed)
#define SIZE_given(id, computed) computed(id)
#define SIZE_found(id, computed) computed(id)
#define SIZE_batched(id, computed) computed(id)
#define DECLARED(id) ts_size_answer ts_size_##id;
#define DIM(id, noun, how, bits, doc) SIZE_##how(id, DECLARED)
#include <touchstone/records.def>

#define ROW(id) [TS_DIM_##id] = ts_size_##id,
#define DIM(id, noun, how, bits, doc) SIZE_##how(id, ROW)
static ts_size_answer *const sizes[TS_N_DIMS] = {
#include <touchstone/records.def>
};

/* The same, grouped by effect. */
static const ts_pipeline *by_effect[sizeof pipelines / sizeof *pipelines];

static void group(void)
{
	u32 n = 0;
	for (u32 i = 0; pipelines[i] != NULL; i++) {
		bool seen = false;
		for (u32 k = 0; k < n; k++) seen = seen || by_effect[k]->effect == pipelines[i]->effect;
		for (u32 k = i; !seen && pipelines[k] != NULL; k++) {
			if (pipelines[k]->effect == pipelines[i]->effect) by_effect[n++] = pipelines[k];
		}
	}
}

void ts_families_begin(void)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	static const ts_registry methods = {stages, by_effect, sizes};
	pthread_once(&once, group);
	ts_registry_use(&methods);
	ts_vectors_use(vectors);
}
