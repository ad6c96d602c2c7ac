/* Files of one stage's outputs. */
#include "outputs.h"
#include "../output/file.h"
#include "../trace/describe.h"
#include "../trace/producer.h"

static ts_status write_buffer(const ts_buffer *buffer, ts_buffer_id id, const char *path, char sha256[TS_DIGEST_BYTES])
{
	char header[TS_NPY_HEADER], descr[TS_NPY_DESCR];
	ts_digest digest;
	ts_npy_descr(descr, id);
	size_t header_bytes = ts_npy_header(header, descr, buffer->n_dims, buffer->shape);
	size_t bytes = (size_t)buffer->n * ts_buffer_table[id].element_bytes;
	ts_digest_begin(&digest);
	ts_digest_add(&digest, header, header_bytes);
	ts_digest_add(&digest, buffer->data, bytes);
	ts_digest_end(&digest, sha256);
	return ts_npy_write(path, header, header_bytes, buffer->data, bytes);
}

static ts_status add_buffer(json_t *list, const ts_load *load, ts_buffer_id id, ts_trace_place *place, void *user)
{
	char name[TS_EMIT_NAME], sha256[TS_DIGEST_BYTES];
	const ts_buffer *buffer = &load->run.frame.buffer[id];
	ts_emit_name(name, load->pipeline, id);
	const char *path = place(user, name);
	if (path == NULL || write_buffer(buffer, id, path, sha256) != TS_OK) return TS_ERROR;
	json_t *shape = json_array();
	for (u32 i = 0; i < buffer->n_dims; i++) json_array_append_new(shape, json_integer((json_int_t)buffer->shape[i]));
	json_t *entry = json_pack("{s:s, s:s, s:s, s:o, s:s}", "name", ts_buffer_table[id].name, "file", name, "element",
	                          ts_buffer_table[id].element, "shape", shape, "sha256", sha256);
	return json_array_append_new(list, entry) == 0 ? TS_OK : ts_fail("%s: out of memory", path);
}

ts_status ts_outputs_write(const ts_load *load, const ts_stage *stage, ts_trace_place *place, void *user)
{
	json_t *list = json_array();
	ts_status status = list != NULL ? TS_OK : ts_fail("trace.json: out of memory");
	for (u32 i = 0; ts_stage_outputs(stage)[i] != TS_N_BUFFERS && status == TS_OK; i++) {
		status = add_buffer(list, load, ts_stage_outputs(stage)[i], place, user);
	}
	const char *path = status == TS_OK ? place(user, "trace.json") : NULL;
	if (path == NULL) {
		json_decref(list);
		return TS_ERROR;
	}
	const ts_pipeline *p = load->pipeline;
	json_t *root =
		json_pack("{s:s, s:i, s:i, s:s, s:s, s:s, s:s, s:o, s:o, s:o, s:o}", "format", "touchstone-trace", "version",
	              TS_TRACE_VERSION, "contract", TS_CONTRACT_VERSION, "order", "canonical", "pipeline", p->name,
	              "effect", p->effect->name, "replayed", stage->name, "producer", ts_producer(&load->run), "arithmetic",
	              ts_arithmetic(&load->run), "params", ts_trace_params(&load->run.params), "buffers", list);
	if (root == NULL) return ts_fail("%s: out of memory", path);
	return ts_trace_write_json(path, root);
}
