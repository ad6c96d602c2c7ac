/* libFuzzer on trace.json: `make fuzz`. Each input is the trace.json of a folder that has a file of keys, plain and
 * compressed, and one of bytes, and beside it a folder of shared files; what is taken is compared with itself. */
#include "compare/compare.h"
#include "tests/fuzz/folder.h"
#include "trace/packed.h"

static const char *folder, *json;

static void pack(const char *path, const char *from)
{
	char data[1024];
	FILE *plain = fopen(from, "rb");
	ts_file file;
	if (plain == NULL) abort();
	size_t n = fread(data, 1, sizeof data, plain);
	ts_packer *packer = ts_packer_begin(n, path);
	if (packer == NULL || ts_file_begin(&file, path) != TS_OK) abort();
	if (ts_packer_put(packer, &file, data, n, true) != TS_OK || ts_file_end(&file) != TS_OK) abort();
	ts_packer_free(packer);
	fclose(plain);
}

static void begin(void)
{
	static const u64 keys[4] = {1, 2, 3, 4};
	static const u8 bytes[24];
	fuzz_begin();
	folder = fuzz_name("trace");
	const char *scene = fuzz_name("scene"), *plain = fuzz_name("trace/k.npy");
	if (mkdir(folder, 0777) != 0 || mkdir(scene, 0777) != 0) abort();
	json = fuzz_name("trace/trace.json");
	fuzz_npy(plain, TS_B_points_key, 4, 0, keys);
	pack(fuzz_name("trace/k.npy.zst"), plain);
	fuzz_npy(fuzz_name("scene/k.npy"), TS_B_points_key, 4, 0, keys);
	fuzz_npy(fuzz_name("trace/t.npy"), TS_B_splat_tie, 24, 0, bytes);
	fuzz_npy(fuzz_name("trace/l.npy"), TS_B_lookup_point, 2, 2, keys);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	static ts_comparison c;
	ts_trace *trace;
	if (json == NULL) begin();
	fuzz_write(json, data, n);
	if (ts_trace_open_folder(&trace, folder) == TS_OK) {
		const ts_relaxations exact = {.ulp = 0};
		ts_status status = ts_compare_traces(&c, trace, trace, &exact);
		assert(status == TS_OK || status == TS_ERROR);
		assert(strchr(trace->producer, '\n') == NULL);
		ts_trace_close(trace);
	} else {
		assert(trace == NULL);
		fuzz_refused();
	}
	return 0;
}
