/* Files of buffers that are there. */
#include "output/file.h"
#include "output/json/text.h"
#include "trace/describe.h"
#include "trace/write.h"

/* Writes the elements, as many at once as the reader holds. */
static ts_status put_elements(ts_file *file, ts_digest *digest, const ts_trace_item *item, ts_buffer_id id)
{
	const size_t bytes = ts_buffer_table[id].element_bytes;
	ts_reader *reader = ts_trace_read(item, id);
	ts_status status = reader != NULL ? TS_OK : TS_ERROR;
	for (u64 i = 0, held = 0; i < item->npy.n && status == TS_OK; i += held) {
		const void *data = ts_reader_at(reader, i, &held);
		status = data != NULL ? ts_file_put(file, data, (size_t)held * bytes) : TS_ERROR;
		if (status == TS_OK) ts_digest_add(digest, data, (size_t)held * bytes);
	}
	ts_reader_close(reader);
	return status;
}

static ts_status save_buffer(const ts_trace_item *item, ts_buffer_id id, const char *path, char sha256[TS_DIGEST_BYTES])
{
	char header[TS_NPY_HEADER], descr[TS_NPY_DESCR];
	ts_digest digest;
	ts_file file;
	ts_npy_descr(descr, id);
	const size_t header_bytes = ts_npy_header(header, descr, item->npy.n_dims, item->npy.shape);
	if (ts_file_begin(&file, path) != TS_OK) return TS_ERROR;
	ts_digest_begin(&digest);
	ts_digest_add(&digest, header, header_bytes);
	ts_status status = ts_file_put(&file, header, header_bytes);
	if (status == TS_OK) status = put_elements(&file, &digest, item, id);
	ts_digest_end(&digest, sha256);
	if (status == TS_OK) return ts_file_end(&file);
	ts_file_drop(&file);
	return TS_ERROR;
}

static ts_status add_buffer(json_t *list, const ts_trace *trace, ts_buffer_id id, ts_trace_place *place, void *user)
{
	char name[TS_EMIT_NAME], sha256[TS_DIGEST_BYTES];
	const ts_trace_item *item = &trace->item[id];
	ts_emit_name(name, trace->pipeline, id);
	const char *path = place(user, name);
	if (path == NULL || save_buffer(item, id, path, sha256) != TS_OK) return TS_ERROR;
	json_t *shape = json_array();
	int failed = 0;
	for (u32 i = 0; i < item->npy.n_dims; i++)
		failed |= json_array_append_new(shape, json_integer((json_int_t)item->npy.shape[i]));
	json_t *entry = json_pack("{s:s, s:s, s:s, s:o, s:s}", "name", ts_buffer_table[id].name, "file", name, "element",
	                          ts_buffer_table[id].element, "shape", shape, "sha256", sha256);
	const u32 *c = item->crop;
	if (item->cropped) {
		json_t *crop = json_pack("[i,i,i,i]", (int)c[0], (int)c[1], (int)c[2], (int)c[3]);
		failed |= json_object_set_new(entry, "crop", crop);
	}
	failed |= json_array_append_new(list, entry);
	return failed == 0 ? TS_OK : ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
}

/* The members of trace.json; takes the list over. NULL without memory. */
static json_t *describe(const ts_trace *trace, const char *producer, json_t *list)
{
	ts_run run = {.backend = NULL}; /* gives the description of a backend in C */
	const ts_pipeline *p = trace->pipeline;
	ts_c_begin(&run.c, 1);
	json_t *who = producer == NULL ? ts_producer(&run) : json_pack("{s:o}", "name", ts_text_json(producer));
	json_t *root =
		json_pack("{s:s, s:i, s:i, s:s, s:s, s:s, s:o, s:o}", "format", "touchstone-trace", "version", TS_TRACE_VERSION,
	              "contract", TS_CONTRACT_VERSION, "order", trace->arrival ? "arrival" : "canonical", "pipeline",
	              p->name, "effect", p->effect->name, "producer", who, "buffers", list);
	int failed = root == NULL;
	if (producer == NULL) failed |= json_object_set_new(root, "arithmetic", ts_arithmetic(&run));
	if (trace->replayed != NULL) failed |= json_object_set_new(root, "replayed", json_string(trace->replayed->name));
	if (trace->has_params) failed |= json_object_set_new(root, "params", ts_trace_params(&trace->params));
	if (failed == 0) return root;
	json_decref(root);
	return NULL;
}

ts_status ts_trace_save_files(const ts_trace *trace, const char *producer, ts_trace_place *place, void *user)
{
	ts_buffer_id ids[TS_N_BUFFERS];
	json_t *list = json_array();
	ts_status status = list != NULL ? TS_OK : ts_fail_as(TS_KIND_MEMORY, "trace.json: out of memory");
	ts_emit_order(ids, trace->pipeline);
	for (u32 i = 0; i < TS_N_BUFFERS && status == TS_OK; i++) {
		if (trace->item[ids[i]].path != NULL) status = add_buffer(list, trace, ids[i], place, user);
	}
	const char *path = status == TS_OK ? place(user, "trace.json") : NULL;
	if (path == NULL) {
		json_decref(list);
		return TS_ERROR;
	}
	json_t *root = describe(trace, producer, list);
	return root != NULL ? ts_trace_write_json(path, root) : ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
}
