/* Goldens on disk. */
#include <stdio.h>
#include <stdlib.h>
#include "golden.h"

enum { HEX = TS_DIGEST_BYTES - 1, MOST_SUMS_BYTES = 64 << 10 };
static const char sums_name[] = "SHA256SUMS", small_name[] = "small";

/* The buffer whose file in a trace of this pipeline has that name; TS_N_BUFFERS: none. */
static ts_buffer_id find(const ts_pipeline *pipeline, const char *name)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		char known[TS_EMIT_NAME];
		bool scene = strncmp(ts_buffer_table[id].name, "scene.", 6) == 0;
		ts_emit_name(known, pipeline, (ts_buffer_id)id);
		bool made = scene || ts_emit_number(pipeline, (ts_buffer_id)id) != 0;
		if (made && strcmp(known, name) == 0) return (ts_buffer_id)id;
	}
	return TS_N_BUFFERS;
}

static ts_status read_line(ts_golden *golden, const ts_pipeline *pipeline, const char *line)
{
	if (strspn(line, "0123456789abcdef") != HEX || strncmp(line + HEX, "  ", 2) != 0) {
		return ts_fail("\"%.90s\" is not a digest, two blanks and a name", line);
	}
	ts_buffer_id id = find(pipeline, line + HEX + 2);
	if (id == TS_N_BUFFERS) return ts_fail("%s writes no file \"%.90s\"", pipeline->name, line + HEX + 2);
	if (golden->sums.hex[id][0] != 0) return ts_fail("\"%s\" stands there twice", line + HEX + 2);
	memcpy(golden->sums.hex[id], line, HEX);
	golden->sums.hex[id][HEX] = 0;
	return TS_OK;
}

static ts_status read_sums(ts_golden *golden, const ts_golden_dir *dir, const ts_pipeline *pipeline, const char *name)
{
	char *text;
	size_t bytes;
	if (ts_golden_read_file(&text, &bytes, dir, name, MOST_SUMS_BYTES) != TS_OK) return TS_ERROR;
	ts_status status = TS_OK;
	if (bytes == 0 || strlen(text) != bytes || text[bytes - 1] != '\n') status = ts_fail("not lines of text");
	char *end;
	for (char *line = text; status == TS_OK && (end = strchr(line, '\n')) != NULL; line = end + 1) {
		*end = 0;
		status = read_line(golden, pipeline, line);
	}
	free(text);
	return status == TS_OK ? TS_OK : ts_fail("%s/%s: %s", dir->path, name, ts_error_message());
}

static ts_status digest_of(char hex[TS_DIGEST_BYTES], const void *data, size_t bytes)
{
	ts_digest d;
	if (ts_digest_begin(&d) != TS_OK) return TS_ERROR;
	ts_digest_add(&d, data, bytes);
	ts_digest_end(&d, hex);
	return TS_OK;
}

typedef struct {
	ts_golden *golden;
	const ts_pipeline *pipeline;
	const ts_golden_dir *dir; /* small/ */
} small_reader;

static ts_status read_small(void *user, const char *name)
{
	const small_reader *r = user;
	ts_buffer_id id = find(r->pipeline, name);
	char path[TS_GOLDEN_PATH + TS_EMIT_NAME], descr[TS_NPY_DESCR];
	if (id == TS_N_BUFFERS || r->golden->sums.hex[id][0] == 0) {
		return ts_fail("%s: \"%.90s\" is not a file that SHA256SUMS names", r->dir->path, name);
	}
	ts_golden_file *file = &r->golden->file[id];
	if (ts_golden_read_file(&file->data, &file->bytes, r->dir, name, TS_GOLDEN_SMALL_BYTES) != TS_OK) return TS_ERROR;
	file->taken = file->bytes;
	snprintf(path, sizeof path, "%s/%s", r->dir->path, name);
	ts_npy_descr(descr, id);
	ts_status status =
		ts_npy_parse(&file->npy, path, file->data, file->bytes, file->bytes, descr, ts_buffer_table[id].element_bytes);
	return status == TS_OK ? digest_of(file->hex, file->data, file->bytes) : status;
}

ts_status ts_golden_read(ts_golden *golden, const ts_golden_dir *dir, const ts_pipeline *pipeline, const char *suffix)
{
	char name[64];
	memset(golden, 0, sizeof *golden);
	golden->infinite = TS_N_BUFFERS;
	snprintf(name, sizeof name, "%s%s", sums_name, suffix);
	if (read_sums(golden, dir, pipeline, name) != TS_OK) return TS_ERROR;
	snprintf(name, sizeof name, "%s%s", small_name, suffix);
	if (!ts_golden_has(dir, name)) return TS_OK;
	ts_golden_dir small;
	small_reader reader = {golden, pipeline, &small};
	if (ts_golden_dir_open(&small, dir, name) != TS_OK) return TS_ERROR;
	ts_status status = ts_golden_names(&small, read_small, &reader);
	ts_golden_dir_close(&small);
	return status;
}

static ts_status propose_small(const ts_golden *golden, const ts_golden_dir *dir, const ts_pipeline *pipeline)
{
	ts_golden_dir small;
	ts_status status = ts_golden_dir_make(&small, dir, "small.new");
	for (u32 id = 0; id < TS_N_BUFFERS && status == TS_OK; id++) {
		const ts_golden_file *file = &golden->file[id];
		char name[TS_EMIT_NAME];
		if (!ts_golden_is_small(golden, (ts_buffer_id)id)) continue;
		ts_emit_name(name, pipeline, (ts_buffer_id)id);
		status = ts_golden_write_file(&small, name, file->data, file->bytes);
	}
	ts_golden_dir_close(&small);
	return status;
}

ts_status ts_golden_propose(const ts_golden *golden, const ts_golden_dir *dir, const ts_pipeline *pipeline, bool small)
{
	char *text = NULL;
	size_t bytes = 0;
	ts_status status = ts_golden_remove_dir(dir, "small.new");
	if (status == TS_OK && small) status = propose_small(golden, dir, pipeline);
	if (status != TS_OK) return status;
	FILE *out = open_memstream(&text, &bytes);
	if (out == NULL) return ts_fail("no memory for a list of digests");
	ts_sums_print(&golden->sums, pipeline, out);
	status = fclose(out) == 0 ? ts_golden_write_file(dir, "SHA256SUMS.new", text, bytes)
	                          : ts_fail("no memory for a list of digests");
	free(text);
	return status;
}

static ts_status promote(const ts_golden_dir *dir, const char *name)
{
	char from[64];
	snprintf(from, sizeof from, "%s.new", name);
	return ts_golden_has(dir, from) ? ts_golden_rename(dir, from, name) : TS_OK;
}

ts_status ts_golden_promote(const ts_golden_dir *dir, const char *const *files)
{
	ts_status status = ts_golden_remove_dir(dir, small_name);
	if (status == TS_OK) status = promote(dir, small_name);
	for (; *files != NULL && status == TS_OK; files++) status = promote(dir, *files);
	return status == TS_OK ? promote(dir, sums_name) : status;
}
