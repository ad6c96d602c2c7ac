/* libFuzzer on what a port computed of arithmetic vectors: `make fuzz`. The first byte says which file of the folder
 * the rest is: vectors.json, or the outputs of a primitive, which are judged where they are taken. */
#include "folder.h"
#include "../../src/cli/vectors.h"

static const char *index_file;

static ts_status read_outputs(u32 primitive, const uint8_t *data, size_t n)
{
	static ts_vector_rows rows;
	char path[128], name[64], descr[TS_VECTOR_DESCR];
	u64 shape[TS_MAX_DIMS];
	bool there;
	const ts_vector *v = ts_vectors_at(primitive);
	snprintf(name, sizeof name, "%s.out.npy", v->name);
	snprintf(path, sizeof path, "%s/%s", fuzz_root, name);
	fuzz_write(path, data, n);
	ts_vector_out_descr(descr, v);
	u32 n_dims = ts_vector_out_shape(shape, v);
	ts_status status = ts_vectors_check_names(fuzz_root);
	assert(status == TS_OK);
	status = ts_vectors_read(rows.found, &there, fuzz_root, name, descr, ts_vector_out_bytes(v), n_dims, shape);
	assert(there && ts_vectors_read_contract(fuzz_root) == TS_OK);
	unlink(path);
	if (status != TS_OK) return status;
	ts_vector_make(v, rows.in, rows.out);
	ts_vector_verdict verdict = ts_vector_judge(v, rows.in, rows.out, rows.found);
	size_t bytes = TS_VECTOR_ITEMS * ts_vector_out_words(v) * sizeof(u32);
	assert((verdict.n_wrong == 0) == (memcmp(rows.out, rows.found, bytes) == 0));
	return TS_OK;
}

static ts_status read_index(const uint8_t *data, size_t n)
{
	fuzz_write(index_file, data, n);
	ts_status status = ts_vectors_read_contract(fuzz_root);
	unlink(index_file);
	return status;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	if (index_file == NULL) {
		fuzz_begin();
		index_file = fuzz_name("vectors.json");
	}
	if (n == 0) return 0;
	ts_status status =
		data[0] < ts_vectors_count() ? read_outputs(data[0], data + 1, n - 1) : read_index(data + 1, n - 1);
	if (status != TS_OK) fuzz_refused();
	return 0;
}
