/* libFuzzer on .npy headers: `make fuzz`. The first byte chooses the buffer, the rest is the file. What is taken must
 * agree with the size of the file, and writing it again must say the same. */
#include "tests/fuzz/folder.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	ts_npy npy, again;
	char descr[TS_NPY_DESCR], head[TS_NPY_HEADER];
	if (n == 0) return 0;
	ts_buffer_id id = (ts_buffer_id)(data[0] % TS_N_BUFFERS);
	size_t element = ts_buffer_table[id].element_bytes, bytes = n - 1;
	ts_npy_descr(descr, id);
	size_t held = bytes < TS_NPY_HEADER ? bytes : TS_NPY_HEADER;
	char *copy = malloc(held + 1);
	if (copy == NULL) abort();
	memcpy(copy, data + 1, held);
	copy = realloc(copy, held != 0 ? held : 1);
	if (ts_npy_parse(&npy, "fuzz", copy, held, bytes, descr, element) == TS_OK) {
		assert(npy.data_at + npy.n * element == bytes && npy.n_dims >= 1 && npy.n_dims <= TS_MAX_DIMS);
		size_t header = ts_npy_header(head, descr, npy.n_dims, npy.shape);
		assert(ts_npy_parse(&again, "fuzz", head, header, header + npy.n * element, descr, element) == TS_OK);
		assert(again.n == npy.n && memcmp(again.shape, npy.shape, npy.n_dims * sizeof(u64)) == 0);
	} else {
		fuzz_refused();
	}
	free(copy);
	return 0;
}
