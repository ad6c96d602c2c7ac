/* libFuzzer on what a port computed of arithmetic vectors: `make fuzz`. The first byte says which file of the folder
 * the rest is: vectors.json, or the outputs of a primitive, which are judged where they are taken. */
#include "cli/vectors.h"
#include "tests/fuzz/folder.h"

static const char *index_file;
static ts_context *context;
static ts_vector_rows rows;

static ts_status read_outputs(const ts_vector_info *v, const uint8_t *data, size_t n)
{
	char path[128], name[64];
	bool there;
	const size_t words = (size_t)v->items * v->out_words, elements = v->n_dims > 1 ? v->shape[1] : 1;
	snprintf(name, sizeof name, "%s.out.npy", v->name);
	snprintf(path, sizeof path, "%s/%s", fuzz_root, name);
	fuzz_write(path, data, n);
	ts_status status = ts_vectors_check_names(fuzz_root);
	assert(status == TS_OK);
	status = ts_vectors_read(rows.found, &there, fuzz_root, name, v->out_dtype, v->out_words * sizeof(u32) / elements,
	                         v->n_dims, v->shape);
	assert(there && ts_vectors_read_contract(fuzz_root) == TS_OK);
	unlink(path);
	if (status != TS_OK) return status;
	ts_vector_judged judged = {.bytes = sizeof judged};
	if (ts_vector_words(context, NULL, rows.out, v->name) != TS_OK) abort();
	status = ts_vector_check(context, &judged, v->name, rows.found);
	assert((status == TS_OK) == (memcmp(rows.out, rows.found, words * sizeof(u32)) == 0));
	assert((status == TS_DIFFERENT) == (judged.n_wrong > 0));
	return TS_OK;
}

static ts_status read_index(const uint8_t *data, size_t n)
{
	fuzz_write(index_file, data, n);
	ts_status status = ts_vectors_read_contract(fuzz_root);
	unlink(index_file);
	return status;
}

static void end(void)
{
	free(rows.in);
	ts_context_close(context);
}

static void begin(void)
{
	fuzz_begin();
	index_file = fuzz_name("vectors.json");
	const ts_context_options options = {.bytes = sizeof options, .threads = 1};
	if (ts_context_open(&context, &options) != TS_OK || ts_vectors_rows(&rows) != TS_OK) abort();
	atexit(end);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	if (context == NULL) begin();
	if (n == 0) return 0;
	const ts_vector_info *v = ts_vector_at(data[0]);
	ts_status status = v != NULL ? read_outputs(v, data + 1, n - 1) : read_index(data + 1, n - 1);
	if (status != TS_OK) fuzz_refused();
	return 0;
}
