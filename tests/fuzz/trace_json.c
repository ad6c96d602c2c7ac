/* libFuzzer on trace.json: `make fuzz`. Each input is the trace.json of a folder that has a file of keys and one of
 * bytes; what is taken is compared with itself. */
#include "folder.h"
#include "../../src/compare/compare.h"

static const char *json;

static void begin(void)
{
	static const u64 keys[4] = {1, 2, 3, 4};
	static const u8 bytes[24];
	fuzz_begin();
	json = fuzz_name("trace.json");
	fuzz_npy(fuzz_name("k.npy"), TS_B_points_key, 4, 0, keys);
	fuzz_npy(fuzz_name("t.npy"), TS_B_splat_tie, 24, 0, bytes);
	fuzz_npy(fuzz_name("l.npy"), TS_B_lookup_point, 2, 2, keys);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	static ts_comparison c;
	ts_trace *trace;
	if (json == NULL) begin();
	fuzz_write(json, data, n);
	if (ts_trace_open_folder(&trace, fuzz_root) == TS_OK) {
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
