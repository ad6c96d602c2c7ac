/* Writing a shard's results. */
#include "cli/reports/sharded.h"
#include <stdlib.h>
#include "model/digest.h"
#include "model/input.h"
#include "output/file.h"
#include "output/json/text.h"
#include "study/results/folder.h"

bool ts_sharded_tells(u32 option)
{
	static const bool told[TS_N_GROUPS] = {[TS_GROUP_METHODS] = true,
	                                       [TS_GROUP_EYE] = true,
	                                       [TS_GROUP_SCENE] = true,
	                                       [TS_GROUP_JUDGE] = true,
	                                       [TS_GROUP_GOLDENS] = true};
	return told[ts_option_table[option].group];
}

/* A new reference, or NULL without memory. */
static json_t *typed_of(const ts_cli *cli)
{
	json_t *words = json_array();
	int failed = 0;
	for (u32 i = 0; i < cli->n_typed; i++) {
		const char *name = ts_option_table[cli->typed[i].option].name, *text = cli->typed[i].text;
		if (!ts_sharded_tells(cli->typed[i].option)) continue;
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

char *ts_sharded_read(size_t *bytes, char *hex, const char *dir, const char *name, u64 most)
{
	ts_digest digest;
	char *data = ts_input_read_in(bytes, dir, name, most);
	if (data == NULL) return NULL;
	ts_digest_begin(&digest);
	ts_digest_add(&digest, data, *bytes);
	ts_digest_end(&digest, hex);
	return data;
}

static ts_status put_sum(FILE *out, const char *name)
{
	char hex[TS_DIGEST_BYTES];
	size_t bytes;
	char *data = ts_sharded_read(&bytes, hex, ts_folder_path(), name, TS_INPUT_ANY);
	if (data == NULL) return TS_ERROR;
	free(data);
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
		if (strcmp(name, TS_SHARDED_SUMS) != 0) status = put_sum(text.out, name);
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
