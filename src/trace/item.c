/* Files of traces, which are untrusted. */
#include "trace/item.h"
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>
#include "trace/describe.h"
#include "trace/field.h"
#include "trace/packed.h"

static bool is_plain(const char *name) { return name[0] != 0 && name[0] != '.' && strchr(name, '/') == NULL; }

/* The folder that traces of one run share must not be a link, which could lead elsewhere. */
static ts_status check_scene(const char *dir)
{
	char path[TS_PATH];
	struct stat info;
	snprintf(path, sizeof path, "%s/" TS_TRACE_SCENE, dir);
	path[strlen(path) - 1] = 0;
	if (lstat(path, &info) == 0)
		return S_ISDIR(info.st_mode) ? TS_OK : ts_fail_as(TS_KIND_FILE, "%s: not a folder", path);
	if (errno != ENOENT) return ts_fail_as(TS_KIND_FILE, "%s: %s", path, strerror(errno));
	return ts_fail_as(TS_KIND_FILE,
	                  "%s: no such folder; traces of one run share it, so they are moved together, or written each "
	                  "with a scene of its own",
	                  path);
}

ts_status ts_item_path(char path[TS_PATH], const char *dir, const char *name, ts_trust trust)
{
	size_t scene = trust == TS_OF_RUN && strncmp(name, TS_TRACE_SCENE, sizeof TS_TRACE_SCENE - 1) == 0
	                   ? sizeof TS_TRACE_SCENE - 1
	                   : 0;
	if (!is_plain(name + scene)) return ts_fail("%s: file \"%s\": not the name of a file in that folder", dir, name);
	int n = snprintf(path, TS_PATH, "%s/%s", dir, name);
	if (n >= TS_PATH) return ts_fail("%.200s: a path of %d bytes in it; at most %d would do", dir, n, TS_PATH - 1);
	return scene > 0 ? check_scene(dir) : TS_OK;
}

int ts_item_open(const char *path, ts_trust trust, u64 *bytes)
{
	struct stat info;
	int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | (trust != TS_TYPED ? O_NOFOLLOW : 0));
	if (file < 0) {
		bool link = errno == ELOOP && trust != TS_TYPED;
		ts_fail_as(TS_KIND_FILE, "%s: %s", path,
		           link ? "is a link, which could lead out of the folder; the file itself would be right"
		                : strerror(errno));
		return -1;
	}
	if (fstat(file, &info) != 0 || !S_ISREG(info.st_mode)) {
		close(file);
		ts_fail_as(TS_KIND_FILE, "%s: not a regular file", path);
		return -1;
	}
	*bytes = (u64)info.st_size;
	return file;
}

int ts_item_reopen(const ts_trace_item *item)
{
	u64 bytes;
	return ts_item_open(item->path, item->typed ? TS_TYPED : TS_IN_FOLDER, &bytes);
}

/* Whether a file's name marks it as compressed: names of version 1 do not. */
static bool is_packed(const char *path, ts_trust trust) { return trust != TS_IN_FOLDER && ts_packed_is(path); }

static ts_status read_header(ts_npy *npy, const char *path, ts_buffer_id id, ts_trust trust)
{
	char head[TS_NPY_HEADER], descr[TS_NPY_DESCR];
	u64 bytes;
	size_t n = sizeof head;
	ts_status status = TS_OK;
	int file = ts_item_open(path, trust, &bytes);
	if (file < 0) return TS_ERROR;
	if (is_packed(path, trust)) {
		status = ts_packed_head(head, &n, &bytes, file, path);
	} else {
		ssize_t got = pread(file, head, sizeof head, 0);
		if (got < 0) status = ts_fail_as(TS_KIND_FILE, "%s: %s", path, strerror(errno));
		n = got > 0 ? (size_t)got : 0;
	}
	close(file);
	ts_npy_descr(descr, id);
	if (status != TS_OK) return status;
	return ts_npy_parse(npy, path, head, n, bytes, descr, ts_buffer_table[id].element_bytes);
}

/* Whether the file has as many dimensions as the shape in records.def, and its numbers where that has some. */
static bool fits(ts_buffer_id id, const ts_npy *npy)
{
	const ts_shape *shape = ts_buffer_shape(id);
	for (u32 i = 0; i < shape->n && i < npy->n_dims; i++) {
		if (shape->axis[i].n_factors == 0 && npy->shape[i] != shape->axis[i].number) return false;
	}
	return npy->n_dims == shape->n;
}

ts_status ts_item_add(ts_trace *trace, ts_buffer_id id, const char *name, ts_trust trust)
{
	char path[TS_PATH];
	ts_trace_item *item = &trace->item[id];
	const ts_buffer_info *info = &ts_buffer_table[id];
	if (item->path != NULL) return ts_fail("%s: buffer %s is there twice", trace->dir, info->name);
	if (ts_item_path(path, trace->dir, name, trust) != TS_OK ||
	    ts_blame(read_header(&item->npy, path, id, trust), TS_KIND_FORMAT) != TS_OK)
		return TS_ERROR;
	if (!fits(id, &item->npy)) {
		return ts_fail_as(TS_KIND_FORMAT, "%s: its shape is none of %s, which is %s", path, info->name, info->shape);
	}
	if (is_packed(path, trust)) {
		item->unpacked = ts_alloc_zero(1, sizeof *item->unpacked, path);
		if (item->unpacked == NULL) return TS_ERROR;
	}
	item->typed = trust == TS_TYPED;
	item->path = strdup(path);
	return item->path != NULL ? TS_OK : ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
}

ts_status ts_item_add_raw(ts_trace *trace, ts_buffer_id id, const char *name, const ts_npy *like)
{
	char path[TS_PATH];
	u64 bytes, row = ts_buffer_table[id].element_bytes;
	ts_trace_item *item = &trace->item[id];
	if (item->path != NULL) return ts_fail("%s: buffer %s is there twice", trace->dir, ts_buffer_table[id].name);
	if (ts_item_path(path, trace->dir, name, TS_IN_FOLDER) != TS_OK) return TS_ERROR;
	int file = ts_item_open(path, TS_IN_FOLDER, &bytes);
	if (file < 0) return TS_ERROR;
	close(file);
	item->npy = *like;
	for (u32 i = 1; i < like->n_dims; i++) row *= like->shape[i];
	if (row == 0 || bytes % row != 0) {
		return ts_fail_as(TS_KIND_FORMAT, "%s: %" PRIu64 " bytes are no whole number of rows of %" PRIu64, path, bytes,
		                  row);
	}
	item->npy.data_at = 0;
	item->npy.shape[0] = bytes / row;
	item->npy.n = bytes / ts_buffer_table[id].element_bytes;
	item->path = strdup(path);
	return item->path != NULL ? TS_OK : ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
}

static void *unpack(const ts_trace_item *item, ts_buffer_id id)
{
	size_t bytes = (size_t)item->npy.n * ts_buffer_table[id].element_bytes;
	if (bytes > ts_memory_limit()) {
		ts_fail_as(TS_KIND_MEMORY, "%s: unpacked it has %.1f GB; a run may use %.1f GB", item->path,
		           (double)bytes / 1e9, (double)ts_memory_limit() / 1e9);
		return NULL;
	}
	int file = ts_item_reopen(item);
	if (file < 0) return NULL;
	void *data = ts_alloc(bytes, 1, item->path);
	ts_status status =
		data != NULL ? ts_packed_read(data, (size_t)item->npy.data_at, bytes, file, item->path) : TS_ERROR;
	close(file);
	if (ts_blame(status, TS_KIND_FORMAT) == TS_OK) return data;
	free(data);
	return NULL;
}

const void *ts_item_unpack(const ts_trace_item *item, ts_buffer_id id)
{
	static pthread_mutex_t one = PTHREAD_MUTEX_INITIALIZER; /* threads may share a trace */
	pthread_mutex_lock(&one);
	void *data = item->unpacked->data;
	pthread_mutex_unlock(&one);
	if (data != NULL) return data;
	void *made = unpack(item, id); /* without the lock, for a host is asked meanwhile whether it cancels */
	pthread_mutex_lock(&one);
	if (item->unpacked->data == NULL) {
		item->unpacked->data = made;
		made = NULL;
	}
	data = item->unpacked->data;
	pthread_mutex_unlock(&one);
	free(made);
	return data;
}

/* Kernels read numbers in place. */
static bool is_aligned(const void *data, ts_buffer_id id)
{
	const ts_fields fields = ts_fields_of(id);
	u32 bytes = 1;
	for (u32 f = 0; f < fields.n; f++) bytes = fields.field[f].bytes > bytes ? fields.field[f].bytes : bytes;
	return (uintptr_t)data % bytes == 0;
}

ts_status ts_item_put(ts_trace *trace, ts_buffer_id id, const ts_npy *shape, const void *data)
{
	static const u64 nothing;
	ts_trace_item *item = &trace->item[id];
	const ts_buffer_info *info = &ts_buffer_table[id];
	if (!fits(id, shape)) return ts_fail("%s: its shape is none of %s", info->name, info->shape);
	if (!is_aligned(data, id)) {
		return ts_fail("%s: the array is not aligned as its %s elements must be", info->name, info->element);
	}
	char *path = strdup(info->name);
	if (path == NULL) return ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", info->name);
	ts_item_clear(item);
	*item = (ts_trace_item){.path = path, .memory = shape->n > 0 ? data : &nothing, .npy = *shape};
	return TS_OK;
}

ts_status ts_item_keep(ts_trace *trace, ts_buffer_id id, const ts_npy *shape, const void *data)
{
	size_t bytes = ts_buffer_table[id].element_bytes;
	void *memory = ts_alloc((size_t)shape->n, bytes, ts_buffer_table[id].name);
	if (memory == NULL) return TS_ERROR;
	if (ts_item_put(trace, id, shape, memory) != TS_OK) {
		free(memory);
		return TS_ERROR;
	}
	trace->item[id].owned = memory;
	if (data != NULL) memcpy(memory, data, (size_t)shape->n * bytes);
	return TS_OK;
}

void ts_item_clear(ts_trace_item *item)
{
	free(item->path);
	free(item->owned);
	if (item->unpacked != NULL) free(item->unpacked->data);
	free(item->unpacked);
	*item = (ts_trace_item){.path = NULL};
}

/* Whether the first dimension is a result, and does not follow from the scene and the parameters. */
static bool is_computed(ts_buffer_id id)
{
	bool computed = false;
	const ts_axis *axis = &ts_buffer_shape(id)->axis[0];
	for (u32 k = 0; k < axis->n_factors; k++) {
		ts_how_known how = ts_dim_table[axis->factor[k]].how;
		computed |= how == TS_IS_counted || how == TS_IS_found || how == TS_IS_batched;
	}
	return computed;
}

ts_status ts_item_match(ts_buffer_id id, const ts_trace_item *ref, const ts_trace_item *cand)
{
	const u32 *a = ref->crop, *b = cand->crop;
	if (memcmp(a, b, sizeof ref->crop) != 0) {
		return ts_fail("%s: crop %u,%u,%u,%u; the reference's is %u,%u,%u,%u, of width 0 where it is whole", cand->path,
		               (unsigned)b[0], (unsigned)b[1], (unsigned)b[2], (unsigned)b[3], (unsigned)a[0], (unsigned)a[1],
		               (unsigned)a[2], (unsigned)a[3]);
	}
	bool same = true;
	for (u32 i = is_computed(id) ? 1 : 0; i < ref->npy.n_dims; i++) same &= ref->npy.shape[i] == cand->npy.shape[i];
	if (same) return TS_OK;
	char text[2][128];
	for (u32 t = 0; t < 2; t++) {
		const ts_npy *npy = t == 0 ? &ref->npy : &cand->npy;
		size_t used = 0;
		for (u32 i = 0; i < npy->n_dims; i++) {
			used +=
				(size_t)snprintf(text[t] + used, sizeof text[t] - used, "%s%" PRIu64, i ? " x " : "", npy->shape[i]);
		}
	}
	return ts_fail("%s: shape %s; the reference's is %s", cand->path, text[1], text[0]);
}
