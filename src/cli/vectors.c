/* `vectors -o DIR`: writes inputs and outputs of every primitive, or of the named ones. `vectors --check DIR`: judges a
 * port's outputs. */
#include "cli/vectors.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "output/file.h"
#include "output/npy.h"
#include "study/results/folder.h"
#include "study/results/table.h"

u32 ts_vectors_total(void)
{
	u32 n = 0;
	while (ts_vector_at(n) != NULL) n++;
	return n;
}

ts_status ts_vectors_rows(ts_vector_rows *rows)
{
	const ts_vector_info *v;
	size_t most = 0;
	for (size_t i = 0; (v = ts_vector_at(i)) != NULL; i++) {
		size_t words = v->in_words > v->out_words ? v->in_words : v->out_words;
		most = v->items * words > most ? v->items * words : most;
	}
	if (most == 0) return TS_ERROR; /* no memory for the table of primitives */
	rows->in = ts_alloc(3 * most, sizeof *rows->in, "arithmetic vectors");
	if (rows->in == NULL) return TS_ERROR;
	rows->out = rows->in + most;
	rows->found = rows->out + most;
	return TS_OK;
}

static ts_status write_file(const char *name, const char *descr, u32 n_dims, const u64 *shape, const void *data,
                            size_t bytes)
{
	char header[TS_NPY_HEADER];
	size_t header_bytes = ts_npy_header(header, descr, n_dims, shape);
	const char *path = ts_folder_file(name);
	return path != NULL ? ts_npy_write(path, header, header_bytes, data, bytes) : TS_ERROR;
}

/* The dtype of a record is a list of fields as text, that of a number its name alone. */
static json_t *describe_out(const ts_vector_info *v, const char *file)
{
	json_t *shape = json_array();
	for (u32 i = 0; i < v->n_dims; i++) json_array_append_new(shape, json_integer((json_int_t)v->shape[i]));
	const size_t quote = v->record ? 0 : 1, n = strlen(v->out_dtype) - 2 * quote;
	return json_pack("{ss, ss%, so}", "file", file, "dtype", v->out_dtype + quote, n, "shape", shape);
}

static json_t *describe(const ts_vector_info *v, const char *in_file, const char *out_file)
{
	return json_pack("{ss, ss, ss, sb, s{ss, ss, s[i]}, so}", "name", v->name, "rule", v->rule, "doc", v->doc,
	                 "composed", v->composed, "in", "file", in_file, "dtype", v->in_dtype, "shape", (int)v->items,
	                 "out", describe_out(v, out_file));
}

static ts_status write_primitive(ts_context *context, const ts_vector_info *v, ts_vector_rows *rows, json_t *list)
{
	char in_file[64], out_file[64];
	const size_t word_bytes = v->items * sizeof *rows->in;
	const u64 items = v->items;
	snprintf(in_file, sizeof in_file, "%s.in.npy", v->name);
	snprintf(out_file, sizeof out_file, "%s.out.npy", v->name);
	ts_status status = ts_vector_words(context, rows->in, rows->out, v->name);
	if (status == TS_OK) status = write_file(in_file, v->in_dtype, 1, &items, rows->in, v->in_words * word_bytes);
	if (status == TS_OK) {
		status = write_file(out_file, v->out_dtype, v->n_dims, v->shape, rows->out, v->out_words * word_bytes);
	}
	json_array_append_new(list, describe(v, in_file, out_file));
	return status;
}

/* Items of each primitive. */
static u32 n_items(void)
{
	const ts_vector_info *first = ts_vector_at(0);
	return first != NULL ? first->items : 0;
}

static bool is_wanted(const ts_cli *cli, const ts_vector_info *v)
{
	for (u32 i = 0; i < cli->n_arguments; i++) {
		if (strcmp(cli->arguments[i], v->name) == 0) return true;
	}
	return cli->n_arguments == 0;
}

static ts_status require_names(const ts_cli *cli)
{
	if (ts_vector_at(0) == NULL) return TS_ERROR; /* no memory for the table of primitives */
	for (u32 i = 0; i < cli->n_arguments; i++) {
		const ts_vector_info *v;
		ts_nearest nearest = ts_nearest_begin(cli->arguments[i]);
		for (size_t k = 0; (v = ts_vector_at(k)) != NULL; k++) ts_nearest_offer(&nearest, v->name);
		if (nearest.distance == 0) continue;
		return ts_fail("no primitive \"%.60s\"%s", cli->arguments[i],
		               ts_nearest_hint(&nearest, "touchstone list vectors"));
	}
	return TS_OK;
}

/* A later --force checks "program" and "files". */
static ts_status write_index(json_t *list, u32 n)
{
	const char *path = ts_folder_file("vectors.json");
	json_t *files = path != NULL ? ts_results_list() : NULL;
	if (files == NULL) return TS_ERROR;
	json_t *root = json_pack("{ss, ss, si, si, sO, so}", "program", ts_program, "version", TS_VERSION, "contract",
	                         (int)TS_CONTRACT_VERSION, "items", (int)n_items(), "primitives", list, "files", files);
	bool whole = root != NULL && json_array_size(list) == n;
	char *text = whole ? json_dumps(root, JSON_INDENT(1)) : NULL;
	json_decref(root);
	ts_status status = text != NULL ? ts_file_write(path, text, strlen(text)) : ts_fail("%s: out of memory", path);
	free(text);
	return status;
}

/* *n: the number of primitives that are written. */
static ts_status write_all(u32 *n, const ts_cli *cli, ts_context *context)
{
	const ts_vector_info *v;
	json_t *list = json_array();
	ts_vector_rows rows = {NULL, NULL, NULL};
	ts_status status = ts_vectors_rows(&rows);
	for (u32 i = 0; status == TS_OK && (v = ts_vector_at(i)) != NULL; i++) {
		ts_progress("vectors", i + 1, ts_vectors_total());
		if (!is_wanted(cli, v)) continue;
		status = write_primitive(context, v, &rows, list);
		*n += 1;
	}
	if (status == TS_OK) status = write_index(list, *n);
	free(rows.in);
	json_decref(list);
	return status;
}

static ts_status write_folder(const ts_cli *cli, ts_context *context)
{
	ts_report report;
	const u32 items = n_items();
	u32 n = 0;
	ts_status status = ts_results_begin(cli->job.output.dir, cli->job.output.force);
	if (status == TS_OK) status = write_all(&n, cli, context);
	if (status == TS_OK) status = ts_folder_commit();
	if (status != TS_OK) {
		ts_folder_discard();
		return status;
	}
	ts_report_begin(&report, cli->job.output.json);
	report.quiet = cli->job.output.quiet;
	ts_report_value(&report, "folder", json_string(cli->job.output.dir));
	ts_report_value(&report, "contract", json_integer(TS_CONTRACT_VERSION));
	ts_report_value(&report, "primitives", json_integer(n));
	ts_report_value(&report, "items", json_integer(items));
	ts_report_line(&report, "%" PRIu32 " primitives of %" PRIu32 " items each in %s; vectors.json tells of them", n,
	               items, cli->job.output.dir);
	return ts_report_end(&report);
}

ts_status ts_vectors_command(ts_cli *cli)
{
	ts_context *context;
	bool check = cli->check != NULL, write = cli->job.output.dir != NULL;
	if (check == write) return ts_fail("vectors: write them with -o DIR, or judge a port's with --check DIR");
	if (check && cli->job.output.force) return ts_fail("vectors: --check writes nothing; leave --force out");
	if (check && cli->n_arguments > 0)
		return ts_fail("vectors: --check judges all that are there; leave \"%s\" out", cli->arguments[0]);
	if (require_names(cli) != TS_OK) return TS_ERROR;
	ts_status status = ts_client_open(&context, cli);
	if (status == TS_OK) status = check ? ts_vectors_check(cli, context) : write_folder(cli, context);
	ts_context_close(context);
	return status;
}
