/* Goldens on disk. */
#include <stdio.h>
#include <stdlib.h>
#include "golden/golden.h"
#include "output/file.h"
#include "output/folder.h"

enum { HEX = TS_DIGEST_BYTES - 1, MOST_SUMS_BYTES = 64 << 10 };
static const char small_name[] = "small";
static const char *const file_names[] = {TS_GOLDEN_SUMS, TS_GOLDEN_PARAMS, TS_GOLDEN_PREVIEW, TS_GOLDEN_CHANGES};
enum { N_FILES = sizeof file_names / sizeof *file_names };

/* The buffer whose file in a trace of this pipeline has that name; TS_N_BUFFERS: none. */
static ts_buffer_id find(const ts_pipeline *pipeline, const char *name)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		char known[TS_EMIT_NAME];
		if (strstr(name, ts_buffer_table[id].name) == NULL) continue;
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

static ts_status read_sums(ts_golden *golden, const ts_golden_dir *dir, const ts_pipeline *pipeline)
{
	char *text;
	size_t bytes;
	if (ts_golden_read_file(&text, &bytes, dir, TS_GOLDEN_SUMS, MOST_SUMS_BYTES) != TS_OK) return TS_ERROR;
	ts_status status = TS_OK;
	if (bytes == 0 || strlen(text) != bytes || text[bytes - 1] != '\n') status = ts_fail("not lines of text");
	char *end;
	for (char *line = text; status == TS_OK && (end = strchr(line, '\n')) != NULL; line = end + 1) {
		*end = 0;
		status = read_line(golden, pipeline, line);
	}
	free(text);
	return status == TS_OK ? TS_OK : ts_fail("%s/%s: %s", dir->path, TS_GOLDEN_SUMS, ts_error_message());
}

static void digest_of(char hex[TS_DIGEST_BYTES], const void *data, size_t bytes)
{
	ts_digest d;
	ts_digest_begin(&d);
	ts_digest_add(&d, data, bytes);
	ts_digest_end(&d, hex);
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
	if (status == TS_OK) digest_of(file->hex, file->data, file->bytes);
	return status;
}

ts_status ts_golden_read(ts_golden *golden, const ts_golden_dir *dir, const ts_pipeline *pipeline)
{
	memset(golden, 0, sizeof *golden);
	golden->stray = TS_N_BUFFERS;
	if (read_sums(golden, dir, pipeline) != TS_OK) return TS_ERROR;
	if (!ts_golden_has(dir, small_name)) return TS_OK;
	ts_golden_dir small;
	small_reader reader = {golden, pipeline, &small};
	if (ts_golden_dir_open(&small, dir, small_name) != TS_OK) return TS_ERROR;
	ts_status status = ts_golden_names(&small, read_small, &reader);
	ts_golden_dir_close(&small);
	return status;
}

static ts_status write_small(const ts_golden *golden, const ts_pipeline *pipeline)
{
	ts_status status = TS_OK;
	for (u32 id = 0; id < TS_N_BUFFERS && status == TS_OK; id++) {
		const ts_golden_file *file = &golden->file[id];
		char name[TS_EMIT_NAME], inner[sizeof small_name + TS_EMIT_NAME];
		if (!ts_golden_is_small(golden, (ts_buffer_id)id)) continue;
		ts_emit_name(name, pipeline, (ts_buffer_id)id);
		snprintf(inner, sizeof inner, "%s/%s", small_name, name);
		const char *path = ts_folder_file(inner);
		status = path != NULL ? ts_file_write(path, file->data, file->bytes) : TS_ERROR;
	}
	return status;
}

ts_status ts_golden_write(const ts_golden *golden, const ts_pipeline *pipeline, bool small)
{
	ts_file_text text;
	if (small && write_small(golden, pipeline) != TS_OK) return TS_ERROR;
	const char *path = ts_folder_file(TS_GOLDEN_SUMS);
	if (path == NULL || ts_file_text_begin(&text, TS_GOLDEN_SUMS) != TS_OK) return TS_ERROR;
	ts_sums_print(&golden->sums, pipeline, text.out);
	return ts_file_text_write(&text, path);
}

static ts_status copy_file(const ts_golden_dir *from, const char *name, const char *to)
{
	char *data;
	size_t bytes;
	if (ts_golden_read_file(&data, &bytes, from, name, TS_GOLDEN_FILE_BYTES) != TS_OK) return TS_ERROR;
	const char *path = ts_folder_file(to);
	ts_status status = path != NULL ? ts_file_write(path, data, bytes) : TS_ERROR;
	free(data);
	return status;
}

static ts_status copy_small(void *user, const char *name)
{
	char to[sizeof small_name + TS_EMIT_NAME];
	snprintf(to, sizeof to, "%s/%s", small_name, name);
	return copy_file(user, name, to);
}

ts_status ts_golden_copy(const ts_golden_dir *from)
{
	ts_golden_dir small;
	for (size_t i = 0; i < N_FILES; i++) {
		bool copied = strcmp(file_names[i], TS_GOLDEN_CHANGES) != 0;
		if (copied && copy_file(from, file_names[i], file_names[i]) != TS_OK) return TS_ERROR;
	}
	if (!ts_golden_has(from, small_name)) return TS_OK;
	ts_status status = ts_golden_dir_open(&small, from, small_name);
	if (status == TS_OK) status = ts_golden_names(&small, copy_small, &small);
	ts_golden_dir_close(&small);
	return status;
}

static ts_status judge_name(void *user, const char *name)
{
	const char *dir = user;
	bool known = strcmp(name, small_name) == 0;
	for (size_t i = 0; i < N_FILES; i++) known |= strcmp(name, file_names[i]) == 0;
	return known ? TS_OK : ts_fail("%s: holds %.90s, which is no part of a golden; move it away", dir, name);
}

ts_status ts_golden_judge(const char *path)
{
	ts_golden_dir dir;
	ts_status status = ts_golden_dir_open(&dir, NULL, path);
	if (status == TS_OK) status = ts_golden_names(&dir, judge_name, dir.path);
	ts_golden_dir_close(&dir);
	return status;
}
