/* trace.json and the headers of the files that it names. */
#include "trace/read.h"
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "model/input.h"
#include "model/json/read.h"
#include "trace/describe.h"
#include "trace/item.h"
#include "trace/packed.h"

enum { MAX_JSON_BYTES = 1 << 24 };

bool ts_trace_find(ts_buffer_id *id, const char *name)
{
	for (u32 i = 0; i < TS_N_BUFFERS; i++) {
		*id = (ts_buffer_id)i;
		if (strcmp(ts_buffer_table[i].name, name) == 0) return true;
	}
	return false;
}

static const char *text_of(const json_t *root, const char *key)
{
	const char *text = json_string_value(json_object_get(root, key));
	return text != NULL ? text : "";
}

static ts_status add_crop(ts_trace *trace, ts_buffer_id id, const char *path, const json_t *crop)
{
	ts_trace_item *item = &trace->item[id];
	bool pixels = ts_shape_is_image(ts_buffer_shape(id));
	if (crop == NULL) return TS_OK;
	for (u32 i = 0; i < 4; i++) {
		json_int_t n;
		if (json_array_size(crop) != 4 || !ts_json_whole(&n, json_array_get(crop, i), 0, 16384))
			return ts_fail("%s: crop is not 4 numbers of pixels", path);
		item->crop[i] = (u32)n;
	}
	item->cropped = true;
	bool right = item->npy.n_dims >= 2 && item->npy.shape[0] == item->crop[3] && item->npy.shape[1] == item->crop[2];
	if (!pixels) return ts_fail("%s: a crop of a buffer that has no rows and columns", path);
	return right ? TS_OK : ts_fail("%s: its shape is not that of its crop", path);
}

/* A file that is left out. */
static ts_status add_left_out(ts_trace_item *item, const char *path, const json_t *entry)
{
	const char *sha256 = text_of(entry, "sha256");
	const json_t *shape = json_object_get(entry, "shape");
	ts_npy npy = {.n_dims = (u32)json_array_size(shape)};
	bool right = json_array_size(shape) <= TS_MAX_DIMS;
	if (sha256[0] == 0) return TS_OK;
	for (u32 i = 0; i < npy.n_dims && right; i++) {
		json_int_t n = 0;
		right = ts_json_whole(&n, json_array_get(shape, i), 0, INT64_MAX);
		npy.shape[i] = (u64)n;
	}
	right = right && ts_shape_count(&npy.n, npy.n_dims, npy.shape);
	if (!right || strlen(sha256) != TS_DIGEST_BYTES - 1 || strspn(sha256, "0123456789abcdef") != TS_DIGEST_BYTES - 1) {
		return ts_fail("%s: buffer %s: a shape, and 64 hexadecimal digits of sha256, would be right", path,
		               text_of(entry, "name"));
	}
	item->npy = npy;
	memcpy(item->sha256, sha256, TS_DIGEST_BYTES);
	return TS_OK;
}

static ts_status add_buffer(ts_trace *trace, const char *path, const json_t *entry, ts_trust trust,
                            bool listed[TS_N_BUFFERS])
{
	ts_buffer_id id;
	char shown[64];
	const json_t *file = json_object_get(entry, "file");
	const char *name = text_of(entry, "name");
	snprintf(shown, sizeof shown, "%s", name);
	if (!ts_trace_find(&id, name)) {
		return ts_fail("%s: no buffer \"%s\"; the table of buffers names all", path, shown);
	}
	if (listed[id]) return ts_fail("%s: buffer %s is there twice", path, ts_buffer_table[id].name);
	listed[id] = true;
	if (file == NULL || json_is_null(file)) return add_left_out(&trace->item[id], path, entry);
	const char *in = json_is_string(file) ? json_string_value(file) : "";
	if (ts_item_add(trace, id, in, trust) != TS_OK) return TS_ERROR;
	return add_crop(trace, id, path, json_object_get(entry, "crop"));
}

static ts_status add_params(ts_trace *trace, const char *path, json_t *params)
{
	const char *name;
	json_t *value;
	ts_params_default(&trace->params);
	trace->has_params = params != NULL;
	if (params != NULL && !json_is_object(params)) return ts_fail("%s: params is not an object", path);
	json_object_foreach (params, name, value) {
		if (!json_is_string(value)) return ts_fail("%s: parameter %s is not a string", path, name);
		if (ts_params_set(&trace->params, name, json_string_value(value)) != TS_OK) {
			return ts_fail("%s: %s", path, ts_error_message());
		}
	}
	trace->params = ts_pipeline_params(trace->pipeline, &trace->params);
	return TS_OK;
}

static ts_status check_version(const char *path, const json_t *root, const char *key, int first, int last)
{
	const json_t *value = json_object_get(root, key);
	json_int_t n;
	if (ts_json_whole(&n, value, first, last)) return TS_OK;
	char *text = value != NULL ? json_dumps(value, JSON_ENCODE_ANY) : NULL;
	char right[64];
	snprintf(right, sizeof right, first < last ? "%s %d to %d" : "%s %d", key, first, last);
	ts_fail("%s: %s %.40s; this program reads %s", path, key, text != NULL ? text : "is missing", right);
	free(text);
	return TS_ERROR;
}

/* The effects that have a method of that name: "effect "indirect" or "area-light"". */
static void name_effects(char *text, size_t room, const char *method)
{
	size_t n = 0;
	for (const ts_pipeline *const *p = ts_pipelines(); *p != NULL && n < room; p++) {
		if (strcmp((*p)->name, method) != 0) continue;
		n += (size_t)snprintf(text + n, room - n, "%s\"%s\"", n != 0 ? " or " : "effect ", (*p)->effect->name);
	}
}

static ts_status read_pipeline(ts_trace *trace, const char *path, const json_t *root)
{
	char others[256] = "";
	const json_t *named = json_object_get(root, "effect");
	if (named != NULL && !json_is_string(named)) return ts_fail("%s: effect is not a text", path);
	const char *method = text_of(root, "pipeline"), *effect = text_of(root, "effect");
	bool given = effect[0] != 0;
	if (!given) effect = ts_pipelines()[0]->effect->name;
	trace->pipeline = ts_pipeline_find(effect, method);
	if (trace->pipeline != NULL) return TS_OK;
	name_effects(others, sizeof others, method);
	return ts_fail("%s: no pipeline \"%.40s\" of effect \"%.40s\"%s; %s%s", path, method, effect,
	               given ? "" : ", the default", others[0] != 0 ? others : "the table of methods names all",
	               others[0] != 0 ? " would be right" : "");
}

static ts_status read_root(ts_trace *trace, const char *path, json_t *root)
{
	if (strcmp(text_of(root, "format"), "touchstone-trace") != 0) {
		return ts_fail("%s: format is not \"touchstone-trace\"", path);
	}
	if (check_version(path, root, "version", TS_TRACE_VERSION, TS_TRACE_VERSION_SHARED) != TS_OK) return TS_ERROR;
	if (check_version(path, root, "contract", TS_CONTRACT_VERSION, TS_CONTRACT_VERSION) != TS_OK) return TS_ERROR;
	const char *order = text_of(root, "order");
	trace->arrival = strcmp(order, "arrival") == 0;
	if (!trace->arrival && strcmp(order, "canonical") != 0) {
		return ts_fail("%s: order is \"%.40s\"; \"canonical\" or \"arrival\" would be right", path, order);
	}
	if (read_pipeline(trace, path, root) != TS_OK) return TS_ERROR;
	bool listed[TS_N_BUFFERS] = {false};
	const json_t *producer = json_object_get(root, "producer"), *buffers = json_object_get(root, "buffers");
	snprintf(trace->producer, sizeof trace->producer, "%s %s", text_of(producer, "name"), text_of(producer, "version"));
	ts_line_clean(trace->producer);
	bool plain = json_number_value(json_object_get(root, "version")) == (double)TS_TRACE_VERSION;
	if (!json_is_array(buffers)) return ts_fail("%s: buffers is not an array", path);
	for (size_t i = 0; i < json_array_size(buffers); i++) {
		const json_t *entry = json_array_get(buffers, i);
		if (add_buffer(trace, path, entry, plain ? TS_IN_FOLDER : TS_OF_RUN, listed) != TS_OK) return TS_ERROR;
	}
	return add_params(trace, path, json_object_get(root, "params"));
}

/* All of a small file, ended by 0; to be released by free(). */
static char *read_text(const char *path, size_t *n)
{
	u64 bytes;
	int file = ts_item_open(path, TS_IN_FOLDER, &bytes);
	if (file < 0) return NULL;
	char *text = bytes <= MAX_JSON_BYTES ? ts_alloc((size_t)bytes + 1, 1, path) : NULL;
	if (bytes > MAX_JSON_BYTES)
		ts_fail("%s: %" PRIu64 " bytes; a trace.json has at most %d", path, bytes, MAX_JSON_BYTES);
	ssize_t got = text != NULL ? read(file, text, (size_t)bytes) : -1;
	close(file);
	if (text != NULL && got < 0) {
		ts_fail_as(TS_KIND_FILE, "%s: %s", path, strerror(errno));
		free(text);
		return NULL;
	}
	*n = got > 0 ? (size_t)got : 0;
	return text;
}

static ts_status read_json(ts_trace *trace)
{
	char path[TS_PATH];
	size_t n;
	if (ts_item_path(path, trace->dir, "trace.json", TS_IN_FOLDER) != TS_OK) return TS_ERROR;
	char *text = read_text(path, &n);
	if (text == NULL) return TS_ERROR;
	size_t mark = ts_text_mark(text, n);
	json_t *root = ts_json_read(text + mark, n - mark, false, path);
	free(text);
	if (root == NULL) return TS_ERROR;
	if (!json_is_object(root)) {
		json_decref(root);
		return ts_fail("%s: line 1: not an object", path);
	}
	ts_status status = read_root(trace, path, root);
	json_decref(root);
	return status;
}

ts_trace *ts_trace_new(const char *dir)
{
	ts_trace *trace = ts_alloc_zero(1, sizeof *trace, "a trace");
	if (trace == NULL) return NULL;
	ts_params_default(&trace->params);
	trace->dir = strdup(dir);
	if (trace->dir != NULL) return trace;
	ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", dir);
	free(trace);
	return NULL;
}

ts_status ts_trace_open_folder(ts_trace **trace, const char *dir)
{
	*trace = NULL;
	ts_trace *made = ts_trace_new(dir);
	if (made == NULL) return TS_ERROR;
	if (ts_blame(read_json(made), TS_KIND_FORMAT) != TS_OK) {
		ts_trace_close(made);
		return TS_ERROR;
	}
	*trace = made;
	return TS_OK;
}

/* "NAME=FILE". */
static ts_status add_layout(ts_trace *trace, char *text, const ts_trace *like)
{
	ts_buffer_id id;
	char *file = strchr(text, '=');
	if (file == NULL) return ts_fail("\"%s\" is not NAME=FILE", text);
	*file++ = 0;
	if (!ts_trace_find(&id, text)) return ts_fail("no buffer \"%s\"; the table of buffers names all", text);
	size_t n = strlen(file);
	if (n > 4 && strcmp(file + n - 4, ".npy") == 0) return ts_item_add(trace, id, file, TS_IN_FOLDER);
	if (ts_packed_is(file)) return ts_fail("%s: compressed; \"zstd -d\" makes the .npy of it", file);
	if (like->item[id].path == NULL) return ts_fail("%s: the reference lacks it", text);
	return ts_item_add_raw(trace, id, file, &like->item[id].npy);
}

ts_status ts_trace_open_layout(ts_trace **trace, const char *dir, const char *layout, bool arrival,
                               const ts_trace *like)
{
	*trace = NULL;
	ts_trace *made = ts_trace_new(dir);
	char *list = made != NULL ? strdup(layout) : NULL, *rest = NULL;
	if (list == NULL) {
		ts_trace_close(made);
		return ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", dir);
	}
	made->pipeline = like->pipeline;
	made->arrival = arrival;
	snprintf(made->producer, sizeof made->producer, "raw files");
	ts_status status = TS_OK;
	for (char *item = strtok_r(list, ",", &rest); item != NULL && status == TS_OK; item = strtok_r(NULL, ",", &rest)) {
		status = add_layout(made, item, like);
	}
	free(list);
	if (status == TS_OK) {
		*trace = made;
	} else {
		ts_trace_close(made);
	}
	return status;
}

/* A pipeline that makes the buffer, otherwise any. */
static const ts_pipeline *pipeline_of(ts_buffer_id id)
{
	const ts_pipeline *const *p = ts_pipelines();
	while (*p != NULL && ts_pipeline_maker(*p, id) == NULL) p++;
	return *p != NULL ? *p : ts_pipelines()[0];
}

ts_status ts_trace_open_file(ts_trace **trace, const char *path, ts_buffer_id *id)
{
	const char *slash = strrchr(path, '/'), *file = slash != NULL ? slash + 1 : path;
	char name[64];
	*trace = NULL;
	const char *stem = file + strspn(file, "0123456789");
	stem = stem > file && *stem == '-' ? stem + 1 : file;
	size_t n = strlen(stem) - (ts_packed_is(stem) ? sizeof TS_PACKED_SUFFIX - 1 : 0);
	snprintf(name, sizeof name, "%.*s", n > 4 && n < sizeof name ? (int)n - 4 : 0, stem);
	if (n < 5 || strncmp(stem + n - 4, ".npy", 4) != 0 || !ts_trace_find(id, name)) {
		return ts_fail("%s: its name does not say which buffer it holds; one as image.srgb.npy would", path);
	}
	char dir[TS_PATH];
	snprintf(dir, sizeof dir, "%.*s", slash != NULL ? (int)(slash - path) : 1, slash != NULL ? path : ".");
	ts_trace *made = ts_trace_new(dir[0] != 0 ? dir : "/");
	if (made == NULL) return TS_ERROR;
	made->pipeline = pipeline_of(*id);
	if (ts_item_add(made, *id, file, TS_TYPED) != TS_OK) {
		ts_trace_close(made);
		return TS_ERROR;
	}
	*trace = made;
	return TS_OK;
}

ts_reader *ts_trace_read(const ts_trace_item *item, ts_buffer_id id)
{
	size_t bytes = ts_buffer_table[id].element_bytes;
	bool packed = item->memory == NULL && item->unpacked != NULL;
	const void *memory = packed ? ts_item_unpack(item, id) : item->memory;
	if (memory != NULL) return ts_reader_memory(memory, item->npy.n, bytes);
	int file = packed ? -1 : ts_item_reopen(item);
	return file >= 0 ? ts_reader_open(file, item->path, item->npy.data_at, item->npy.n, bytes) : NULL;
}

ts_status ts_trace_copy(void *to, const ts_trace_item *item, ts_buffer_id id)
{
	size_t element_bytes = ts_buffer_table[id].element_bytes;
	ts_reader *reader = ts_trace_read(item, id);
	const void *data = reader;
	for (u64 first = 0, n; first < item->npy.n && reader != NULL; first += n) {
		data = ts_reader_at(reader, first, &n);
		if (data == NULL) break;
		memcpy((u8 *)to + first * element_bytes, data, (size_t)n * element_bytes);
	}
	ts_reader_close(reader);
	return data != NULL ? TS_OK : TS_ERROR;
}

ts_status ts_trace_sha256(char hex[TS_DIGEST_BYTES], const ts_trace_item *item, ts_buffer_id id)
{
	char header[TS_NPY_HEADER], descr[TS_NPY_DESCR];
	ts_digest digest;
	if (item->path == NULL) {
		memcpy(hex, item->sha256, TS_DIGEST_BYTES);
		return TS_OK;
	}
	ts_reader *reader = ts_trace_read(item, id);
	const void *data = reader;
	ts_npy_descr(descr, id);
	ts_digest_begin(&digest);
	ts_digest_add(&digest, header, ts_npy_header(header, descr, item->npy.n_dims, item->npy.shape));
	for (u64 first = 0, n; first < item->npy.n && data != NULL; first += n) {
		data = ts_reader_at(reader, first, &n);
		if (data != NULL) ts_digest_add(&digest, data, (size_t)n * ts_buffer_table[id].element_bytes);
	}
	ts_digest_end(&digest, hex);
	ts_reader_close(reader);
	return data != NULL ? TS_OK : TS_ERROR;
}

void ts_trace_close(ts_trace *trace)
{
	if (trace == NULL) return;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) ts_item_clear(&trace->item[id]);
	free(trace->dir);
	free(trace);
}
