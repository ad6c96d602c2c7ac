/* One shard's folder. */
#include <stdlib.h>
#include <string.h>
#include "cli/reports/merge.h"
#include "cli/reports/sharded.h"
#include "model/digest.h"
#include "model/json.h"
#include "output/file.h"
#include "output/folder.h"
#include "study/results/folder.h"

enum { PATH_BYTES = 4096 + 300 };

ts_status ts_part_damaged(const ts_part *part, const char *what)
{
	return ts_fail("%s: damaged: %s; run that shard again", part->dir, what);
}

static ts_status check_line(const ts_part *part, const char *line)
{
	char path[PATH_BYTES], hex[TS_DIGEST_BYTES], text[PATH_BYTES];
	const char *name = line + TS_DIGEST_BYTES - 1 + 2;
	bool good = strlen(line) > TS_DIGEST_BYTES + 1 && strspn(line, "0123456789abcdef") == TS_DIGEST_BYTES - 1;
	if (!good || !ts_ours_is_name(name)) return ts_part_damaged(part, "SHA256SUMS has a line that is none of its");
	snprintf(path, sizeof path, "%s/%s", part->dir, name);
	if (!ts_sharded_digest(hex, path)) {
		snprintf(text, sizeof text, "%s", ts_error_message());
		return ts_part_damaged(part, text);
	}
	if (strncmp(hex, line, TS_DIGEST_BYTES - 1) == 0) return TS_OK;
	snprintf(text, sizeof text, "%.200s is not what SHA256SUMS says", name);
	return ts_part_damaged(part, text);
}

/* *listed: it names report.json. */
static ts_status check_sums(const ts_part *part, bool *listed)
{
	char path[PATH_BYTES];
	size_t bytes;
	snprintf(path, sizeof path, "%s/" TS_SHARDED_SUMS, part->dir);
	char *text = ts_text_read(&bytes, path), *state = NULL;
	if (text == NULL) {
		return ts_fail("%s: no " TS_SHARDED_SUMS " there; name folders that a command with --shard I/N wrote to -o",
		               part->dir);
	}
	ts_status status = strlen(text) == bytes ? TS_OK : ts_part_damaged(part, "SHA256SUMS is no text");
	*listed = false;
	for (char *line = strtok_r(text, "\n", &state); line != NULL && status == TS_OK;) {
		status = check_line(part, line);
		*listed |= status == TS_OK && strcmp(line + TS_DIGEST_BYTES + 1, "report.json") == 0;
		line = strtok_r(NULL, "\n", &state);
	}
	free(text);
	return status;
}

static json_t *read_json(const ts_part *part, const char *name)
{
	char path[PATH_BYTES], why[TS_JSON_WHY];
	size_t bytes;
	json_error_t error;
	snprintf(path, sizeof path, "%s/%s", part->dir, name);
	char *text = ts_text_read(&bytes, path);
	if (text == NULL) return NULL;
	errno = 0;
	json_t *root = json_loadb(text, bytes, JSON_REJECT_DUPLICATES, &error);
	if (root == NULL) ts_fail("%s: %s", path, ts_json_why(why, &error));
	free(text);
	if (root == NULL || json_is_object(root)) return root;
	json_decref(root);
	ts_part_damaged(part, "a report that is no object");
	return NULL;
}

static bool are_strings(const json_t *array)
{
	bool all = json_is_array(array);
	for (size_t i = 0; i < json_array_size(array); i++) all &= json_is_string(json_array_get(array, i));
	return all;
}

static ts_status take_shard(ts_part *part)
{
	static const char *const texts[] = {"commit", "command", "class"}, *const lists[] = {"typed", "cases"};
	json_t *shard = part->shard = json_object_get(part->report, "shard");
	json_int_t index = json_integer_value(json_object_get(shard, "index"));
	json_int_t of = json_integer_value(json_object_get(shard, "of"));
	json_int_t status = json_integer_value(json_object_get(shard, "status"));
	bool good = of >= 1 && of <= TS_MOST_SHARDS && index >= 1 && index <= of && status >= TS_OK;
	good &= status <= TS_ERROR || status == TS_SKIPPED;
	for (u32 i = 0; i < 3; i++) good &= json_is_string(json_object_get(shard, texts[i]));
	for (u32 i = 0; i < 2; i++) good &= are_strings(json_object_get(shard, lists[i]));
	part->index = (u32)index;
	part->of = (u32)of;
	return good ? TS_OK : ts_part_damaged(part, "report.json says of no shard what it is");
}

ts_status ts_part_read(ts_part *part, const char *dir)
{
	bool listed;
	*part = (ts_part){.dir = dir};
	if (check_sums(part, &listed) != TS_OK) return TS_ERROR;
	if (!listed) return ts_part_damaged(part, "SHA256SUMS names no report.json");
	part->report = read_json(part, "report.json");
	part->times = part->report != NULL ? read_json(part, "times.json") : NULL;
	return part->times != NULL ? take_shard(part) : TS_ERROR;
}

void ts_part_end(ts_part *part)
{
	json_decref(part->report);
	json_decref(part->times);
}

ts_status ts_part_copy(const ts_part *part, const char *name)
{
	char from[PATH_BYTES];
	size_t bytes;
	if (!ts_ours_is_name(name)) return ts_part_damaged(part, "a file's name leads out of it");
	snprintf(from, sizeof from, "%s/%s", part->dir, name);
	const char *to = ts_folder_file(name);
	char *data = to != NULL ? ts_input_read(&bytes, from) : NULL;
	ts_status status = data != NULL ? ts_file_write(to, data, bytes) : TS_ERROR;
	free(data);
	return status;
}
