/* One shard's folder. */
#include <stdlib.h>
#include <string.h>
#include "cli/reports/merge.h"
#include "cli/reports/sharded.h"
#include "model/digest.h"
#include "model/input.h"
#include "model/json/read.h"
#include "output/file.h"
#include "output/folder.h"
#include "study/results/folder.h"

enum { MOST_TEXT_BYTES = 1 << 26, WHY_BYTES = 4096 + 600 };

ts_status ts_part_damaged(const ts_part *part, const char *what)
{
	return ts_fail("%s: damaged: %s; run that shard again", part->dir, what);
}

static ts_status take_line(ts_part *part, char *line)
{
	char *name = line + TS_DIGEST_BYTES - 1 + 2;
	bool good = strlen(line) > TS_DIGEST_BYTES + 1 && strspn(line, "0123456789abcdef") == TS_DIGEST_BYTES - 1;
	if (!good || !ts_ours_is_name(name)) return ts_part_damaged(part, "SHA256SUMS has a line that is none of its");
	json_t *digest = json_stringn(line, TS_DIGEST_BYTES - 1);
	if (json_object_set_new(part->sums, name, digest) == 0) return TS_OK;
	return ts_part_damaged(part, "SHA256SUMS has a name that is no text");
}

static ts_status read_sums(ts_part *part)
{
	size_t bytes;
	char *text = ts_input_read_in(&bytes, part->dir, TS_SHARDED_SUMS, MOST_TEXT_BYTES), *state = NULL;
	if (text == NULL) {
		return ts_fail("%s; name folders that a command with --shard I/N wrote to -o", ts_error_message());
	}
	ts_status status = strlen(text) == bytes ? TS_OK : ts_part_damaged(part, "SHA256SUMS is no text");
	if ((part->sums = json_object()) == NULL) status = ts_fail("the digests of a shard: out of memory");
	for (char *line = strtok_r(text, "\n", &state); line != NULL && status == TS_OK;) {
		status = take_line(part, line);
		line = strtok_r(NULL, "\n", &state);
	}
	free(text);
	return status;
}

char *ts_part_file(size_t *bytes, const ts_part *part, const char *name, u64 most)
{
	char hex[TS_DIGEST_BYTES], why[WHY_BYTES];
	const char *digest = json_string_value(json_object_get(part->sums, name));
	char *data = digest != NULL ? ts_sharded_read(bytes, hex, part->dir, name, most) : NULL;
	if (data != NULL && strcmp(hex, digest) == 0) return data;
	if (digest == NULL)
		snprintf(why, sizeof why, "SHA256SUMS names no %.200s", name);
	else if (data == NULL)
		snprintf(why, sizeof why, "%s", ts_error_message());
	else
		snprintf(why, sizeof why, "%.200s is not what SHA256SUMS says", name);
	free(data);
	ts_part_damaged(part, why);
	return NULL;
}

static json_t *read_json(const ts_part *part, const char *name)
{
	char path[WHY_BYTES];
	size_t bytes;
	snprintf(path, sizeof path, "%s/%s", part->dir, name);
	char *text = ts_part_file(&bytes, part, name, MOST_TEXT_BYTES);
	if (text == NULL) return NULL;
	json_t *root = ts_json_read(text, bytes, false, path);
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
	json_int_t index = 0, of = 0, status = 0;
	bool good = ts_json_whole(&of, json_object_get(shard, "of"), 1, TS_MOST_SHARDS);
	good = good && ts_json_whole(&index, json_object_get(shard, "index"), 1, of);
	good = good && ts_json_whole(&status, json_object_get(shard, "status"), TS_OK, TS_SKIPPED);
	good &= status <= TS_ERROR || status == TS_SKIPPED;
	for (u32 i = 0; i < 3; i++) good &= json_is_string(json_object_get(shard, texts[i]));
	for (u32 i = 0; i < 2; i++) good &= are_strings(json_object_get(shard, lists[i]));
	part->index = (u32)index;
	part->of = (u32)of;
	return good ? TS_OK : ts_part_damaged(part, "report.json says of no shard what it is");
}

/* Also the files that merge does not copy. */
static ts_status confirm_all(const ts_part *part)
{
	const json_t *files = json_object_get(part->report, "files");
	for (size_t i = 0; i < json_array_size(files); i++) {
		const char *name = json_string_value(json_array_get(files, i));
		size_t bytes;
		if (name != NULL && strcmp(name, TS_SHARDED_SUMS) == 0) continue;
		char *data = ts_part_file(&bytes, part, name != NULL ? name : "", TS_INPUT_ANY);
		if (data == NULL) return TS_ERROR;
		free(data);
	}
	return TS_OK;
}

ts_status ts_part_read(ts_part *part, const char *dir)
{
	*part = (ts_part){.dir = dir};
	if (read_sums(part) != TS_OK) return TS_ERROR;
	part->report = read_json(part, "report.json");
	part->times = part->report != NULL ? read_json(part, "times.json") : NULL;
	if (part->times == NULL || take_shard(part) != TS_OK) return TS_ERROR;
	return confirm_all(part);
}

void ts_part_end(ts_part *part)
{
	json_decref(part->sums);
	json_decref(part->report);
	json_decref(part->times);
}

ts_status ts_part_copy(const ts_part *part, const char *name)
{
	size_t bytes;
	char *data = ts_part_file(&bytes, part, name, TS_INPUT_ANY);
	const char *to = data != NULL ? ts_folder_file(name) : NULL;
	ts_status status = to != NULL ? ts_file_write(to, data, bytes) : TS_ERROR;
	free(data);
	return status;
}
