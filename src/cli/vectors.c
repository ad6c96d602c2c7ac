/* `vectors -o DIR`: writes inputs and outputs of every primitive. `vectors --check DIR`: judges a port's outputs. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../output/file.h"
#include "../study/folder.h"
#include "../study/table.h"
#include "../output/npy.h"
#include "vectors.h"

static ts_status write_file(const char *name, const char *descr, u32 n_dims, const u64 *shape, const void *data,
                            size_t bytes)
{
	char header[TS_NPY_HEADER];
	size_t header_bytes = ts_npy_header(header, descr, n_dims, shape);
	const char *path = ts_folder_file(name);
	return path != NULL ? ts_npy_write(path, header, header_bytes, data, bytes) : TS_ERROR;
}

/* The dtype of a record is the text of a list of fields, that of a number its name alone. */
static json_t *describe_out(const ts_vector *v, const char *file, const char *descr)
{
	u64 dims[TS_MAX_DIMS];
	u32 n_dims = ts_vector_out_shape(dims, v);
	json_t *shape = json_array();
	for (u32 i = 0; i < n_dims; i++) json_array_append_new(shape, json_integer((json_int_t)dims[i]));
	size_t quote = ts_vector_gives_record(v) ? 0 : 1;
	return json_pack("{ss, ss%, so}", "file", file, "dtype", descr + quote, strlen(descr) - 2 * quote, "shape", shape);
}

static json_t *describe(const ts_vector *v, bool composed, const char *in_file, const char *in_descr,
                        const char *out_file, const char *out_descr)
{
	return json_pack("{ss, ss, ss, sb, s{ss, ss, s[i]}, so}", "name", v->name, "rule", v->rule, "doc", v->doc,
	                 "composed", composed, "in", "file", in_file, "dtype", in_descr, "shape", (int)TS_VECTOR_ITEMS,
	                 "out", describe_out(v, out_file, out_descr));
}

static ts_status write_primitive(const ts_vector *v, bool composed, ts_vector_rows *rows, json_t *list)
{
	char in_file[64], out_file[64], in_descr[TS_VECTOR_DESCR], out_descr[TS_VECTOR_DESCR];
	u64 shape[TS_MAX_DIMS];
	u32 n_dims = ts_vector_out_shape(shape, v);
	snprintf(in_file, sizeof in_file, "%s.in.npy", v->name);
	snprintf(out_file, sizeof out_file, "%s.out.npy", v->name);
	ts_vector_in_descr(in_descr, v);
	ts_vector_out_descr(out_descr, v);
	ts_vector_make(v, rows->in, rows->out);
	size_t word_bytes = TS_VECTOR_ITEMS * sizeof *rows->in;
	ts_status status =
		write_file(in_file, in_descr, 1, (u64[]){TS_VECTOR_ITEMS}, rows->in, ts_vector_in_words(v) * word_bytes);
	if (status == TS_OK) {
		status = write_file(out_file, out_descr, n_dims, shape, rows->out, ts_vector_out_words(v) * word_bytes);
	}
	json_array_append_new(list, describe(v, composed, in_file, in_descr, out_file, out_descr));
	return status;
}

/* "program" and "files" are what a later --force goes by. */
static ts_status write_index(json_t *list)
{
	const char *path = ts_folder_file("vectors.json");
	json_t *files = path != NULL ? ts_results_list() : NULL;
	json_t *root = files != NULL ? json_pack("{ss, ss, si, si, sO, so}", "program", ts_program, "version", TS_VERSION,
	                                         "contract", (int)TS_CONTRACT_VERSION, "items", (int)TS_VECTOR_ITEMS,
	                                         "primitives", list, "files", files)
	                             : NULL;
	if (files == NULL) return TS_ERROR;
	bool whole = root != NULL && json_array_size(list) == ts_vectors_count();
	char *text = whole ? json_dumps(root, JSON_INDENT(1)) : NULL;
	json_decref(root);
	ts_status status = text != NULL ? ts_file_write(path, text, strlen(text)) : ts_fail("%s: out of memory", path);
	free(text);
	return status;
}

static ts_status write_all(void)
{
	const ts_vector *v;
	json_t *list = json_array();
	ts_vector_rows *rows = ts_alloc(1, sizeof *rows, "arithmetic vectors");
	ts_status status = rows != NULL ? TS_OK : TS_ERROR;
	for (u32 i = 0; status == TS_OK && (v = ts_vectors_at(i)) != NULL; i++) {
		status = write_primitive(v, ts_vectors_place(i).composed, rows, list);
		ts_progress("vectors", i + 1, ts_vectors_count());
	}
	if (status == TS_OK) status = write_index(list);
	free(rows);
	json_decref(list);
	return status;
}

static ts_status write_folder(const ts_cli *cli)
{
	ts_report report;
	ts_status status = ts_results_begin(cli->job.output.dir, cli->job.output.force);
	if (status == TS_OK) status = write_all();
	if (status == TS_OK) status = ts_folder_commit();
	if (status != TS_OK) {
		ts_folder_discard();
		return status;
	}
	ts_report_begin(&report, cli->job.output.json);
	report.quiet = cli->job.output.quiet;
	ts_report_value(&report, "folder", json_string(cli->job.output.dir));
	ts_report_value(&report, "contract", json_integer(TS_CONTRACT_VERSION));
	ts_report_value(&report, "primitives", json_integer(ts_vectors_count()));
	ts_report_value(&report, "items", json_integer(TS_VECTOR_ITEMS));
	ts_report_line(&report, "%" PRIu32 " primitives of %d items each in %s; vectors.json tells of them",
	               ts_vectors_count(), TS_VECTOR_ITEMS, cli->job.output.dir);
	return ts_report_end(&report);
}

ts_status ts_vectors_command(ts_cli *cli)
{
	bool check = cli->check != NULL, write = cli->job.output.dir != NULL;
	if (check == write) return ts_fail("vectors: write them with -o DIR, or judge a port's with --check DIR");
	if (check && cli->job.output.force) return ts_fail("vectors: --check writes nothing; leave --force out");
	if (ts_selftest_require() != TS_OK) return TS_ERROR;
	return check ? ts_vectors_check(cli) : write_folder(cli);
}
