/* Faults in a copy of one buffer of a trace, and what a replay from it says. */
#ifndef TS_TESTS_REPLAY_FAULTS_H
#define TS_TESTS_REPLAY_FAULTS_H
#include "tests/lcg.h"
#include "tests/replay/spot.h"
#include "tests/replay/traces.h"

static u32 random_state;

static inline u32 random_below(u32 n) { return lcg_below(&random_state, n); }

static inline void put(const ts_buffer *buffer, ts_buffer_id id, u64 element, const char *name, u32 component,
                       u64 value)
{
	spot place = spot_of(buffer->data, buffer->n, id, element, name, component);
	memcpy(place.at, &value, place.bytes);
}

static inline ts_status replay_with(u32 m, const ts_stage *stage, ts_buffer_id id, const ts_buffer *buffer)
{
	ts_trace *candidate = traces_plant(m, &(planted){id, buffer}, 1, "canonical", "");
	ts_load *load;
	ts_status status = ts_replay_run(&load, stage, traces[m], candidate, 1);
	assert_true((status == TS_OK) == (load != NULL));
	ts_load_end(load);
	traces_drop(candidate);
	return status;
}

/* The stage refuses the value, and names the file and the place, in one line. */
static inline void refuses(u32 m, const ts_stage *stage, ts_buffer_id id, u64 element, const char *field, u32 component,
                           u64 value)
{
	ts_buffer buffer;
	void *data = traces_read(&buffer, traces[m], id);
	put(&buffer, id, element, field, component, value);
	ts_status status = replay_with(m, stage, id, &buffer);
	char file[MAX_TEXT], place[MAX_TEXT];
	snprintf(file, sizeof file, "%s.npy: ", ts_buffer_table[id].name);
	snprintf(place, sizeof place, "element %u", (unsigned)element);
	const char *message = ts_error_message();
	bool told = strstr(message, file) != NULL && strstr(message, place) != NULL && strstr(message, field) != NULL &&
	            strstr(message, "would be right") != NULL && strchr(message, '\n') == NULL;
	if (status != TS_ERROR || !told) {
		fail_msg("%s, %s of %s: value %llx: status %d: %s", stage->name, field, file, (unsigned long long)value,
		         (int)status, message);
	}
	free(data);
}

static inline void accepts(u32 m, const ts_stage *stage, ts_buffer_id id, u64 element, const char *field, u32 component,
                           u64 value)
{
	ts_buffer buffer;
	void *data = traces_read(&buffer, traces[m], id);
	put(&buffer, id, element, field, component, value);
	if (replay_with(m, stage, id, &buffer) != TS_OK) fail_msg("%s", ts_error_message());
	free(data);
}

#endif
