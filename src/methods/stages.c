/* Stages by name, with the buffers that each reads and writes. */
#include <assert.h>
#include <pthread.h>
#include "methods/stage.h"

enum { MOST_STAGES = 128, LIST = 40 };

static struct {
	ts_buffer_id inputs[LIST], outputs[LIST];
} lists[MOST_STAGES];

const ts_stage *ts_stage_find(const char *name)
{
	for (const ts_stage *const *stage = ts_stages(); *stage != NULL; stage++) {
		if (strcmp((*stage)->name, name) == 0) return *stage;
	}
	return NULL;
}

const ts_stage *ts_stage_margin(const ts_stage *stage)
{
	for (const ts_stage *const *margin = ts_stages(); *margin != NULL; margin++) {
		if ((*margin)->margin_of != NULL && strcmp((*margin)->margin_of, stage->name) == 0) return *margin;
	}
	return NULL;
}

/* Appends a buffer that is not yet in the list. */
static void put(ts_buffer_id ids[LIST], ts_buffer_id id)
{
	u32 n = 0;
	while (ids[n] != TS_N_BUFFERS && ids[n] != id) n++;
	if (ids[n] == id) return;
	assert(n + 1 < LIST);
	ids[n] = id;
	ids[n + 1] = TS_N_BUFFERS;
}

static void put_all(ts_buffer_id ids[LIST], const ts_buffer_id *more)
{
	for (; more != NULL && *more != TS_N_BUFFERS; more++) put(ids, *more);
}

static void put_launch(ts_buffer_id reads[LIST], ts_buffer_id writes[LIST], const ts_launch *launch)
{
	const ts_pointers *p = ts_kernel_pointers(launch->kernel);
	for (u32 i = 0; i < p->n; i++) {
		const ts_bound bound = ts_launch_bound(launch, &p->pointer[i]);
		if (bound.bound && bound.role <= TS_ROLE_SUM) put(bound.role == TS_ROLE_IN ? reads : writes, bound.to);
	}
}

static bool is_in(const ts_buffer_id *ids, ts_buffer_id id)
{
	while (*ids != TS_N_BUFFERS && *ids != id) ids++;
	return *ids == id;
}

/* Buffers read and not made, in the order of records.def; buffers made, in that of the launches. */
static void fill(void)
{
	for (u32 i = 0; ts_stages()[i] != NULL; i++) {
		const ts_stage *stage = ts_stages()[i];
		assert(i < MOST_STAGES);
		ts_buffer_id reads[LIST] = {TS_N_BUFFERS}, *inputs = lists[i].inputs, *outputs = lists[i].outputs;
		inputs[0] = outputs[0] = TS_N_BUFFERS;
		put_all(reads, stage->looks_at);
		for (u32 k = 0; stage->launches != NULL && stage->launches[k] != NULL; k++) {
			put_launch(reads, outputs, stage->launches[k]);
		}
		put_all(outputs, stage->makes);
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			if (is_in(reads, (ts_buffer_id)id) && !is_in(outputs, (ts_buffer_id)id)) put(inputs, (ts_buffer_id)id);
		}
	}
}

static u32 place_of(const ts_stage *stage)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	u32 i = 0;
	pthread_once(&once, fill);
	while (ts_stages()[i] != stage) i++;
	return i;
}

const ts_buffer_id *ts_stage_inputs(const ts_stage *stage) { return lists[place_of(stage)].inputs; }
const ts_buffer_id *ts_stage_outputs(const ts_stage *stage) { return lists[place_of(stage)].outputs; }

bool ts_stage_reads(const ts_stage *stage, ts_buffer_id id) { return is_in(ts_stage_inputs(stage), id); }
bool ts_stage_writes(const ts_stage *stage, ts_buffer_id id) { return is_in(ts_stage_outputs(stage), id); }
