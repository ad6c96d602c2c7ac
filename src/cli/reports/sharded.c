/* Writing a shard's results. */
#include "cli/reports/sharded.h"
#include <stdlib.h>
#include "model/digest.h"
#include "output/file.h"
#include "output/json/text.h"
#include "study/results/folder.h"

/* Whether an option only affects where and how results are written. */
static bool says_where(u32 option)
{
	static const bool where[TS_N_OPTIONS] = {
		[TS_OPTION_SHARD] = true, [TS_OPTION_OUTPUT] = true,  [TS_OPTION_FORCE] = true,
		[TS_OPTION_JSON] = true,  [TS_OPTION_JUNIT] = true,   [TS_OPTION_MARKDOWN] = true,
		[TS_OPTION_TAP] = true,   [TS_OPTION_THREADS] = true, [TS_OPTION_TIMEOUT] = true,
		[TS_OPTION_QUIET] = true, [TS_OPTION_MEMORY] = true,  [TS_OPTION_NO_WORKER] = true,
	};
	return where[option];
}

/* The typed options that change results: not those about speed, shards, or output. A new reference, or NULL without
 * memory. */
static json_t *typed_of(const ts_cli *cli)
{
	json_t *words = json_array();
	int failed = 0;
	for (u32 i = 0; i < cli->n_typed; i++) {
		const char *name = ts_option_table[cli->typed[i].option].name, *text = cli->typed[i].text;
		if (says_where(cli->typed[i].option)) continue;
		json_t *value = ts_text_json(text != NULL ? text : "");
		failed |= json_array_append_new(words, json_sprintf("--%s%s%s", name, text != NULL ? "=" : "",
		                                                    value != NULL ? json_string_value(value) : "")) != 0;
		failed |= value == NULL;
		json_decref(value);
	}
	for (u32 i = 0; i < cli->n_arguments; i++) {
		failed |= json_array_append_new(words, ts_text_json(cli->arguments[i])) != 0;
	}
	if (failed == 0) return words;
	json_decref(words);
	return NULL;
}

static json_t *describe(const ts_cli *cli, const ts_sharded *s)
{
	json_t *object = json_pack("{s:i, s:i, s:s, s:s, s:o, s:s, s:O, s:i}", "index", (int)cli->job.shard.index, "of",
	                           (int)cli->job.shard.of, "commit", ts_commit(), "command", s->command, "typed",
	                           typed_of(cli), "class", s->class_name, "cases", s->cases, "status", (int)s->status);
	if (object != NULL && s->renders != NULL) json_object_set(object, "renders", s->renders);
	return object;
}

bool ts_sharded_digest(char *hex, const char *path)
{
	ts_digest digest;
	size_t bytes;
	char *data = ts_input_read(&bytes, path);
	if (data == NULL) return false;
	ts_digest_begin(&digest);
	ts_digest_add(&digest, data, bytes);
	ts_digest_end(&digest, hex);
	free(data);
	return true;
}

static ts_status put_sum(FILE *out, const char *name)
{
	char path[TS_FOLDER_PATH + 256], hex[TS_DIGEST_BYTES];
	snprintf(path, sizeof path, "%s/%s", ts_folder_path(), name);
	if (!ts_sharded_digest(hex, path)) return TS_ERROR;
	fprintf(out, "%s  %s\n", hex, name);
	return TS_OK;
}

/* The report lists this file, too. */
static ts_status write_sums(const char *path)
{
	ts_file_text text;
	const char *name;
	ts_status status = ts_file_text_begin(&text, path);
	if (status != TS_OK) return status;
	for (size_t i = 0; status == TS_OK && (name = ts_folder_name(i)) != NULL; i++) {
		bool times = strcmp(name, "times.json") == 0; /* only this file differs between equal runs */
		if (!times && strcmp(name, TS_SHARDED_SUMS) != 0) status = put_sum(text.out, name);
	}
	if (status == TS_OK) return ts_file_text_write(&text, path);
	ts_file_text_drop(&text);
	return status;
}

ts_status ts_sharded_write(ts_report *report, const ts_cli *cli, const ts_sharded *sharded)
{
	const char *path = ts_folder_file(TS_SHARDED_SUMS);
	if (path == NULL) return TS_ERROR;
	ts_report_value(report, "shard", describe(cli, sharded));
	ts_status status = ts_results_report(report);
	return status == TS_OK ? write_sums(path) : status;
}
