/* What the tests of the probe share: runs whose traces are probed, and figures of answers. */
#ifndef TS_TESTS_PROBE_PROBED_H
#define TS_TESTS_PROBE_PROBED_H
#include <dirent.h>
#include <math.h>
#include <unistd.h>
#include "probe/parts.h"
#include "tests/methods/small.h"
#include "tests/status.h"
#include "trace/load.h"
#include "trace/write.h"

typedef struct {
	char dir[200], path[512];
	ts_scene *scene;
	ts_run run;
	ts_probe *probe;
	ts_trace_writer *writer;
	ts_trace *trace;
} traced;

static u32 n_random;

static inline u32 below(u32 n) { return (u32)(((u64)ts_random(n_random++, 6, 17) * n) >> 32); }

static inline const char *place(void *user, const char *name)
{
	traced *t = user;
	snprintf(t->path, sizeof t->path, "%.199s/%.255s", t->dir, name);
	return t->path;
}

static inline ts_status hook(const ts_run *run, const ts_stage *stage, void *user)
{
	traced *t = user;
	return ts_trace_write_stage(t->writer, run, stage);
}

static inline void make(traced *t, const char *effect, const char *method, const ts_params *params)
{
	const ts_pipeline *pipeline = ts_pipeline_find(effect, method);
	ts_trace_options options = {.margins = true, .place = place, .user = t};
	const char *tmp = getenv("TMPDIR");
	snprintf(t->dir, sizeof t->dir, "%s/touchstone-probe-XXXXXX", tmp != NULL ? tmp : "/tmp");
	assert_non_null(mkdtemp(t->dir));
	t->scene = small_scene(params);
	ts_run_begin(&t->run, t->scene, params, 2);
	t->run.traced = t->run.margins = true;
	require(ts_trace_write_begin(&t->writer, pipeline, &t->run, &options));
	t->run.hook = hook;
	t->run.hook_user = t;
	require(ts_pipeline_run(pipeline, &t->run));
	require(ts_trace_write_end(t->writer, &t->run));
	require(ts_trace_open_folder(&t->trace, t->dir));
	require(ts_probe_open(&t->probe, t->trace));
}

static inline void drop(traced *t)
{
	struct dirent *entry;
	DIR *dir = opendir(t->dir);
	ts_probe_close(t->probe);
	ts_trace_close(t->trace);
	ts_trace_write_free(t->writer);
	ts_run_end(&t->run);
	ts_scene_free(t->scene);
	while (dir != NULL && (entry = readdir(dir)) != NULL) {
		if (entry->d_name[0] != '.') unlink(place(t, entry->d_name));
	}
	if (dir != NULL) closedir(dir);
	rmdir(t->dir);
}

static inline const void *data(const traced *t, ts_buffer_id id) { return ts_frame_data(&t->run.frame, id); }
static inline u64 count(const traced *t, ts_buffer_id id) { return ts_frame_n(&t->run.frame, id); }

/* A probe of a trace of whose buffers one is a copy, in memory. */
typedef struct {
	ts_trace trace;
	ts_probe *probe;
	void *data;
} damaged;

/* Opens it; the copy, which may be changed, is returned. */
static inline void *damage(damaged *d, const traced *t, ts_buffer_id id)
{
	size_t bytes = (size_t)count(t, id) * ts_buffer_table[id].element_bytes;
	d->trace = *t->trace;
	d->data = malloc(bytes + 1);
	assert_non_null(d->data);
	memcpy(d->data, data(t, id), bytes);
	d->trace.item[id].memory = d->data;
	require(ts_probe_open(&d->probe, &d->trace));
	return d->data;
}

static inline void damage_end(damaged *d)
{
	ts_probe_close(d->probe);
	free(d->data);
}

static inline void assert_refused(ts_status status, const char *words)
{
	assert_int_equal(status, TS_ERROR);
	if (strstr(ts_error_message(), words) == NULL) fail_msg("\"%s\" says nothing of \"%s\"", ts_error_message(), words);
}

/* Every "check" and "sum" of an answer agrees. Returns how many there are. */
static inline u32 assert_agrees(const json_t *v)
{
	const char *key;
	json_t *member;
	u32 n = 0;
	size_t i;
	json_object_foreach ((json_t *)v, key, member) {
		n += assert_agrees(member);
		if (strcmp(key, "check") == 0) assert_memory_equal(json_string_value(member), "bits agree with ", 16);
		if (strcmp(key, "sum") == 0)
			assert_string_equal(json_string_value(member), "terms add up to the bits of the total");
		n += strcmp(key, "check") == 0 || strcmp(key, "sum") == 0;
	}
	json_array_foreach ((json_t *)v, i, member) n += assert_agrees(member);
	return n;
}

static inline const json_t *get(const json_t *v, const char *a, const char *b)
{
	const json_t *found = json_object_get(json_object_get(v, a), b);
	if (found == NULL) fail_msg("no %s.%s", a, b);
	return found;
}

static inline u64 figure(const json_t *v, const char *key)
{
	const json_t *found = json_object_get(v, key);
	if (!json_is_integer(found)) fail_msg("no %s", key);
	return (u64)json_integer_value(found);
}

static inline u32 bits_of(const json_t *v) { return (u32)strtoul(json_string_value(v), NULL, 16); }

/* A float that an answer shows with its bits; of a vector component c. */
static inline f32 shown(const json_t *v, const char *key, u32 c)
{
	const json_t *bits = json_object_get(json_object_get(v, key), "bits");
	return ts_u2f(bits_of(json_is_array(bits) ? json_array_get(bits, c) : bits));
}

static inline ts_status ask_pixel(const traced *t, u32 x, u32 y, json_t **answer)
{
	ts_probe_question question = {.subject = TS_PROBE_PIXEL, .x = x, .y = y};
	return ts_probe_ask(t->probe, &question, answer);
}

static inline ts_status ask_texel(const traced *t, const char *view, u32 x, u32 y, json_t **answer)
{
	ts_probe_question question = {.subject = TS_PROBE_TEXEL, .x = x, .y = y, .view = view};
	return ts_probe_ask(t->probe, &question, answer);
}

static inline ts_status ask_triangle(const traced *t, u64 triangle, json_t **answer)
{
	ts_probe_question question = {.subject = TS_PROBE_TRIANGLE, .index = triangle};
	return ts_probe_ask(t->probe, &question, answer);
}

static inline ts_status ask_point(const traced *t, u64 point, json_t **answer)
{
	ts_probe_question question = {.subject = TS_PROBE_POINT, .index = point};
	return ts_probe_ask(t->probe, &question, answer);
}

/* By its key. */
static inline ts_status ask_key(const traced *t, u64 key, json_t **answer)
{
	i64 numbers[3] = {(i64)(key >> 32), (i64)(key & 0xffff) - 32768, (i64)(key >> 16 & 0xffff) - 32768};
	ts_probe_question question = {.subject = TS_PROBE_POINT, .key = numbers};
	return ts_probe_ask(t->probe, &question, answer);
}

/* Every term of the pixel adds up to the bits of the picture. */
static inline void try_pixel(const traced *t, u32 pixel)
{
	json_t *answer;
	const f32 *radiance = data(t, TS_B_image_radiance);
	u32 width = t->run.params.width;
	require(ask_pixel(t, pixel % width, pixel / width, &answer));
	assert_true(assert_agrees(answer) >= 2);
	const json_t *bits = json_object_get(get(answer, "image", "radiance"), "bits");
	for (u32 c = 0; c < 3; c++) assert_int_equal(bits_of(json_array_get(bits, c)), ts_f2u(radiance[pixel * 3 + c]));
	json_decref(answer);
}

static inline bool is_part(const json_t *part, const json_t *whole)
{
	const char *key;
	json_t *member;
	size_t i;
	if (json_is_object(part)) {
		json_object_foreach ((json_t *)part, key, member) {
			if (!is_part(member, json_object_get(whole, key))) return false;
		}
		return true;
	}
	if (!json_is_array(part)) return json_equal(part, whole);
	json_array_foreach ((json_t *)part, i, member) {
		if (!is_part(member, json_array_get(whole, i))) return false;
	}
	return json_array_size(part) == json_array_size(whole);
}

/* Asks a probe of a trace with other items. No answer is given after a failure, whose message names the buffer. */
static inline ts_status ask_other(const ts_trace *other, const ts_probe_question *q, ts_buffer_id id, json_t **answer)
{
	ts_probe *probe = NULL;
	*answer = NULL;
	(void)ts_fail("nothing failed");
	ts_status status = ts_probe_open(&probe, other);
	if (status == TS_OK) status = ts_probe_ask(probe, q, answer);
	ts_probe_close(probe);
	assert_int_equal(status == TS_OK, *answer != NULL);
	assert_int_equal(status == TS_OK, strcmp(ts_error_message(), "nothing failed") == 0);
	if (status != TS_OK) assert_refused(status, ts_buffer_table[id].name);
	return status;
}

static inline bool was_read(const ts_probe *p, u32 id)
{
	return p->reader[id] != NULL || p->whole[id] != NULL || (p->load != NULL && p->load->item[id] != NULL);
}

/* A trace whose file of a buffer is not there, or is empty since the trace was opened. */
static inline ts_trace without(const traced *t, u32 id, bool emptied, char path[512])
{
	ts_trace other = *t->trace;
	other.item[id].path = NULL;
	if (!emptied) return other;
	snprintf(path, 512, "%.199s/%s.empty", t->dir, ts_buffer_table[id].name);
	FILE *file = fopen(path, "w");
	assert_true(file != NULL && fclose(file) == 0);
	other.item[id].path = path;
	return other;
}

/* Without one of the buffers that it reads an answer has nothing else than it has with it; of these every `step`-th is
 * left out. Returns how many buffers were needed. */
static inline u32 try_without(const traced *t, const ts_probe_question *q, u32 step)
{
	json_t *whole, *answer;
	ts_probe *probe;
	u32 n = 0, n_read = below(step);
	char path[512];
	require(ts_probe_open(&probe, t->trace));
	require(ts_probe_ask(probe, q, &whole));
	for (u32 k = 0; k < 2 * TS_N_BUFFERS; k++) {
		u32 id = k / 2;
		bool is_file = t->trace->item[id].path != NULL;
		if (!is_file || !was_read(probe, id) || n_read++ % step != 0) continue;
		ts_trace other = without(t, id, k % 2 == 1, path);
		n += ask_other(&other, q, (ts_buffer_id)id, &answer) != TS_OK;
		if (answer != NULL && !is_part(answer, whole)) {
			fail_msg("without %s: %s\n%s", ts_buffer_table[id].name, json_dumps(answer, 0), json_dumps(whole, 0));
		}
		json_decref(answer);
	}
	ts_probe_close(probe);
	json_decref(whole);
	return n;
}

static inline void assert_bits(f32 found, f32 right) { assert_int_equal(ts_f2u(found), ts_f2u(right)); }

#endif
