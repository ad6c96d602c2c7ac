/* The rows of records.def. */
#include "model/table.h"
#include <assert.h>
#include <pthread.h>

#define BUFFER(id, name, element, shape, order, key, doc) {name, #element, sizeof(element), shape, #order, key, doc},
const ts_buffer_info ts_buffer_table[TS_N_BUFFERS] = {
#include <touchstone/records.def>
};

/* A row without a field opens a record. */
#define RECORD(name, doc) {#name, NULL, NULL, 0, NULL},
#define FIELD(type, name, count, doc) {NULL, #type, #name, count, doc},
static const ts_field_info lines[] = {
#include <touchstone/records.def>
};

#define SUM(buffer, size, what) {TS_B_##buffer, TS_DIM_##size, what},
static const ts_sum_info sums[] = {
#include <touchstone/records.def>
};

#define INDEX(buffer, field, size, none) {TS_B_##buffer, field, size, none, {0}},
static ts_index_info indices[] = {
#include <touchstone/records.def>
};

enum {
	N_LINES = sizeof lines / sizeof *lines,
	N_SUMS = sizeof sums / sizeof *sums,
	N_INDICES = sizeof indices / sizeof *indices,
};

static ts_field_info fields[N_LINES];
static size_t n_fields;
static ts_shape shapes[TS_N_BUFFERS];

static void fill_fields(void)
{
	const char *record = NULL;
	for (size_t i = 0; i < N_LINES; i++) {
		if (lines[i].record) {
			record = lines[i].record;
		} else {
			fields[n_fields] = lines[i];
			fields[n_fields++].record = record;
		}
	}
}

static void parse(ts_shape *shape, const char *text)
{
	bool good = ts_shape_parse(shape, text);
	assert(good);
}

static void fill(void)
{
	ts_shape size;
	fill_fields();
	for (u32 id = 0; id < TS_N_BUFFERS; id++) parse(&shapes[id], ts_buffer_table[id].shape);
	for (size_t i = 0; i < N_INDICES; i++) {
		parse(&size, indices[i].size);
		indices[i].of = size.axis[0];
	}
}

static void require(void)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, fill);
}

const ts_field_info *ts_field_table(size_t *n)
{
	require();
	*n = n_fields;
	return fields;
}

size_t ts_type_bytes(const char *type) { return strcmp(type, "u64") == 0 ? 8 : strcmp(type, "u8") == 0 ? 1 : 4; }

const ts_shape *ts_buffer_shape(ts_buffer_id id)
{
	require();
	return &shapes[id];
}

ts_dim ts_buffer_counts(ts_buffer_id id) { return ts_axis_counts(&ts_buffer_shape(id)->axis[0]); }

ts_dim ts_buffer_gives(ts_buffer_id id)
{
	ts_dim dim = ts_buffer_counts(id);
	if (dim == TS_DIM_none || ts_buffer_shape(id)->axis[0].more != 0) return TS_DIM_none;
	return ts_dim_table[dim].how != TS_IS_given && ts_dim_table[dim].how != TS_IS_found ? dim : TS_DIM_none;
}

const ts_sum_info *ts_sum_table(size_t *n)
{
	*n = N_SUMS;
	return sums;
}

const ts_sum_info *ts_sum_of(ts_buffer_id id)
{
	for (size_t i = 0; i < N_SUMS; i++) {
		if (sums[i].buffer == id) return &sums[i];
	}
	return NULL;
}

const ts_index_info *ts_index_table(size_t *n)
{
	require();
	*n = N_INDICES;
	return indices;
}
