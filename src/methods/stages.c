/* Stages by name, and what each reads and writes. */
#include "stage.h"
#include <assert.h>
#include <pthread.h>

enum { MOST_STAGES = 128, LIST = 40 };

static struct { ts_buffer_id inputs[LIST], outputs[LIST]; } lists[MOST_STAGES];

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

static void mark(bool *set, const ts_buffer_id *ids)
{
	for (; ids != NULL && *ids != TS_N_BUFFERS; ids++) set[*ids] = true;
}

static void mark_launch(bool *reads, bool *writes, const ts_launch *launch)
{
	const ts_pointers *p = ts_kernel_pointers(launch->kernel);
	for (u32 i = 0; i < p->n; i++) {
		const ts_bound bound = ts_launch_bound(launch, &p->pointer[i]);
		if (!bound.bound || bound.role > TS_ROLE_SUM) continue;
		*(bound.role == TS_ROLE_IN ? &reads[bound.to] : &writes[bound.to]) = true;
	}
}

static void list(ts_buffer_id ids[LIST], const bool *set, const bool *without)
{
	u32 n = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		assert(n + 1 < LIST);
		if (set[id] && !without[id]) ids[n++] = (ts_buffer_id)id;
	}
	ids[n] = TS_N_BUFFERS;
}

static void fill(void)
{
	static const bool none[TS_N_BUFFERS];
	for (u32 i = 0; ts_stages()[i] != NULL; i++) {
		const ts_stage *stage = ts_stages()[i];
		bool reads[TS_N_BUFFERS] = {false}, writes[TS_N_BUFFERS] = {false};
		mark(reads, stage->looks_at);
		mark(writes, stage->makes);
		for (u32 k = 0; stage->launches != NULL && stage->launches[k] != NULL; k++) {
			mark_launch(reads, writes, stage->launches[k]);
		}
		assert(i < MOST_STAGES);
		list(lists[i].inputs, reads, writes);
		list(lists[i].outputs, writes, none);
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

static bool is_in(const ts_buffer_id *ids, ts_buffer_id id)
{
	for (; *ids != TS_N_BUFFERS; ids++) {
		if (*ids == id) return true;
	}
	return false;
}

bool ts_stage_reads(const ts_stage *stage, ts_buffer_id id) { return is_in(ts_stage_inputs(stage), id); }
bool ts_stage_writes(const ts_stage *stage, ts_buffer_id id) { return is_in(ts_stage_outputs(stage), id); }
