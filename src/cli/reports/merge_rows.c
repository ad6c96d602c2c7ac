/* Shards of a command that judges: rows of their reports return to the order of the cases. */
#include <string.h>
#include "cli/reports/merge.h"
#include "cli/reports/outcomes.h"
#include "output/file.h"
#include "study/results/folder.h"

enum { MOST_KEYS = 4 };

/* The members of a command's report that depend on cases; the others are the same in each shard. */
typedef struct {
	const char *command;
	const char *key;              /* of a case's name in a row */
	bool all;                     /* each case has a row */
	const char *rows[MOST_KEYS];  /* arrays; the first has one row per judged case */
	const char *sums[MOST_KEYS];  /* counts */
	const char *first[MOST_KEYS]; /* from the first case that has them; the last is an object that names the case */
} mergeable;

static const mergeable known[] = {
	{"golden check", "case", true, {"cases"}, {"passed", "failed", "known", "skipped"}, {NULL}},
	{"compare", "stage", false, {"stages", "buffers", "differences"}, {"judged"}, {"first_divergence", "divergence"}},
};

typedef struct {
	const ts_parts *parts;
	const mergeable *is;
	json_t *root, *seconds;
	ts_outcomes outcomes;
} merged;

static bool is_one_of(const char *key, const char *const keys[MOST_KEYS])
{
	u32 i = 0;
	while (i < MOST_KEYS && keys[i] != NULL && strcmp(keys[i], key) != 0) i++;
	return i < MOST_KEYS && keys[i] != NULL;
}

static bool is_of_case(const json_t *row, const char *key, const json_t *name)
{
	return row != NULL && json_equal(json_object_get(row, key), name);
}

/* The rows of each case from its shard; `seconds` receives how long each took. */
static json_t *interleave(const merged *m, const char *rows, json_t *seconds)
{
	const ts_parts *p = m->parts;
	size_t at[TS_MOST_SHARDS] = {0}, k;
	json_t *name, *all = json_array();
	int failed = all == NULL;
	json_array_foreach (p->cases, k, name) {
		u32 owner = (u32)(k % p->n);
		const json_t *array = json_object_get(p->part[owner].report, rows);
		for (; is_of_case(json_array_get(array, at[owner]), m->is->key, name); at[owner]++) {
			json_t *time = json_array_get(json_object_get(p->part[owner].times, "seconds"), at[owner]);
			failed |= json_array_append(all, json_array_get(array, at[owner])) != 0;
			if (seconds != NULL) failed |= json_array_append(seconds, time) != 0;
		}
	}
	ts_status status = failed == 0 ? TS_OK : ts_part_damaged(&p->part[0], "cases without times");
	for (u32 i = 0; i < p->n && status == TS_OK; i++) {
		const json_t *array = json_object_get(p->part[i].report, rows);
		if (json_is_array(array) && at[i] == json_array_size(array)) continue;
		status = ts_part_damaged(&p->part[i], "its cases are not as touchstone writes them");
	}
	if (status == TS_OK && m->is->all && json_array_size(all) != json_array_size(p->cases)) {
		status = ts_part_damaged(&p->part[0], "a case is in no shard");
	}
	if (status == TS_OK) return all;
	json_decref(all);
	return NULL;
}

/* The shard with the first case's value; NULL: none has one. */
static const ts_part *first_of(const merged *m)
{
	const ts_part *found = NULL;
	size_t least = SIZE_MAX, k;
	json_t *name;
	u32 last = 0;
	while (last + 1 < MOST_KEYS && m->is->first[last + 1] != NULL) last++;
	for (u32 i = 0; i < m->parts->n && m->is->first[0] != NULL; i++) {
		const json_t *value = json_object_get(m->parts->part[i].report, m->is->first[last]);
		json_array_foreach (m->parts->cases, k, name) {
			if (k >= least || !is_of_case(value, m->is->key, name)) continue;
			least = k;
			found = &m->parts->part[i];
		}
	}
	return found;
}

static json_t *sum_of(const merged *m, const char *key)
{
	json_int_t sum = 0;
	for (u32 i = 0; i < m->parts->n; i++) sum += json_integer_value(json_object_get(m->parts->part[i].report, key));
	return json_integer(sum);
}

static json_t *verdict_of(const merged *m)
{
	static const char *const order[] = {"skipped", "same", "error", "different"};
	u32 worst = 0;
	for (u32 i = 0; i < m->parts->n; i++) {
		const char *own = json_string_value(json_object_get(m->parts->part[i].report, "verdict"));
		if (own == NULL) {
			ts_part_damaged(&m->parts->part[i], "it has no verdict");
			return NULL;
		}
		for (u32 k = worst + 1; k < 4; k++) {
			if (strcmp(own, order[k]) == 0) worst = k;
		}
	}
	return json_string(order[worst]);
}

/* The value that all shards share; a new reference. */
static json_t *common_of(const merged *m, const char *key, const json_t *value)
{
	for (u32 i = 0; i < m->parts->n; i++) {
		const ts_part *part = &m->parts->part[i];
		if (json_equal(json_object_get(part->report, key), value)) continue;
		ts_fail("%s: says something else of \"%s\" than the other shards: name shards of one run", part->dir, key);
		return NULL;
	}
	return json_deep_copy(value);
}

static json_t *value_of(merged *m, const ts_part *first, const char *key, const json_t *value)
{
	if (is_one_of(key, m->is->rows)) return interleave(m, key, strcmp(key, m->is->rows[0]) == 0 ? m->seconds : NULL);
	if (is_one_of(key, m->is->first)) {
		if (first != NULL) return json_deep_copy(json_object_get(first->report, key));
		ts_part_damaged(&m->parts->part[0], "it has a first difference in no case");
		return NULL;
	}
	if (is_one_of(key, m->is->sums)) return sum_of(m, key);
	return strcmp(key, "verdict") == 0 ? verdict_of(m) : common_of(m, key, value);
}

/* A shard whose rows are worse than its exit code says otherwise than it ran. */
static ts_status check_rows(const merged *m, const ts_part *part)
{
	ts_outcomes rows;
	const json_int_t code = json_integer_value(json_object_get(part->shard, "status"));
	ts_status status =
		ts_outcomes_read(&rows, m->is->key, m->parts->class_name, json_object_get(part->report, m->is->rows[0]),
	                     json_object_get(part->times, "seconds"));
	if (status != TS_OK) {
		ts_part_damaged(part, ts_error_message());
	} else {
		const bool broken = ts_outcomes_count(&rows, TS_BROKEN) > 0, failed = ts_outcomes_count(&rows, TS_FAILED) > 0;
		const bool right = code == TS_ERROR || (!broken && (code == TS_DIFFERENT || !failed));
		if (!right) status = ts_part_damaged(part, "its rows are worse than its exit code");
	}
	ts_outcomes_end(&rows);
	return status;
}

/* In the order of keys of the report with the first difference, which has all keys. */
static ts_status merge_reports(merged *m)
{
	static const char *const own[MOST_KEYS] = {"shard", "files", "program"};
	const ts_part *first = first_of(m);
	const char *key;
	json_t *value;
	for (u32 i = 0; i < m->parts->n; i++) {
		if (check_rows(m, &m->parts->part[i]) != TS_OK) return TS_ERROR;
	}
	json_object_foreach ((first != NULL ? first : &m->parts->part[0])->report, key, value) {
		if (is_one_of(key, own)) continue;
		json_t *whole = value_of(m, first, key, value);
		if (whole == NULL) return TS_ERROR;
		if (json_object_set_new(m->root, key, whole) != 0) return ts_fail("the report: out of memory");
	}
	return ts_outcomes_read(&m->outcomes, m->is->key, m->parts->class_name, json_object_get(m->root, m->is->rows[0]),
	                        m->seconds);
}

static void report_merged(ts_report *report, const void *user)
{
	const merged *m = user;
	const char *key;
	json_t *value;
	json_object_foreach (m->root, key, value) ts_report_value(report, key, json_incref(value));
	ts_outcomes_lines(report, &m->outcomes);
	u32 passed = ts_outcomes_count(&m->outcomes, TS_PASSED), skipped = ts_outcomes_count(&m->outcomes, TS_LEFT_OUT);
	u32 known_ones = ts_outcomes_count(&m->outcomes, TS_KNOWN), all = (u32)json_array_size(m->outcomes.rows);
	ts_report_line(report, "%u passed, %u failed, %u skipped", (unsigned)(passed + known_ones),
	               (unsigned)(all - passed - skipped - known_ones), (unsigned)skipped);
}

/* Copies the pictures of differences, whose names begin with the buffer's. */
static ts_status copy_pictures(const void *user)
{
	const merged *m = user;
	size_t at[TS_MOST_SHARDS] = {0}, i;
	json_t *row;
	ts_status status = TS_OK;
	json_array_foreach (json_object_get(m->root, "differences"), i, row) {
		const char *buffer = json_string_value(json_object_get(row, "buffer"));
		size_t n = buffer != NULL ? strlen(buffer) : 0;
		for (u32 k = 0; k < m->parts->n && status == TS_OK; k++) {
			const ts_part *part = &m->parts->part[k];
			const json_t *files = json_object_get(part->report, "files");
			const char *name;
			while (status == TS_OK && (name = json_string_value(json_array_get(files, at[k]))) != NULL &&
			       strncmp(name, buffer, n) == 0 && (name[n] == '.' || name[n] == '-')) {
				status = ts_part_copy(part, name);
				at[k]++;
			}
		}
	}
	return status;
}

ts_status ts_merge_rows(ts_cli *cli, const ts_parts *parts)
{
	merged m = {.parts = parts, .is = known, .root = json_object(), .seconds = json_array()};
	const mergeable *end = known + sizeof known / sizeof *known;
	while (m.is < end && strcmp(m.is->command, parts->command) != 0) m.is++;
	ts_status status = m.root != NULL && m.seconds != NULL ? TS_OK : ts_fail("the report: out of memory");
	if (m.is == end) status = ts_part_damaged(&parts->part[0], "a command that has no shards");
	if (cli->job.output.report != NULL) status = ts_fail("--report: of shards of render; these judge: leave it out");
	if (status == TS_OK) status = merge_reports(&m);
	if (status == TS_OK) {
		const char *relaxed = json_string_value(json_object_get(m.root, "relaxations"));
		const ts_outcomes_output output = {parts->command,
		                                   &m.outcomes,
		                                   relaxed != NULL ? relaxed : "",
		                                   NULL,
		                                   parts->status,
		                                   report_merged,
		                                   true,
		                                   copy_pictures,
		                                   NULL,
		                                   &m};
		status = ts_outcomes_report(cli, &output, true);
	}
	ts_outcomes_end(&m.outcomes);
	json_decref(m.root);
	json_decref(m.seconds);
	return status;
}
