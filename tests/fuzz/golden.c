/* libFuzzer on files of goldens: `make fuzz`. The first byte says which of them the rest is: cases.txt, or of a case
 * its params.txt, its SHA256SUMS or a file of small/. An accepted file is compared. */
#include "cli/golden/golden.h"
#include "tests/fuzz/folder.h"

static const char *cases, *params, *sums, *keys;
static ts_goldens goldens;
static ts_case one;
static ts_golden whole; /* of that case */

static void begin(void)
{
	static const char line[] = "a: epr atrium:triangles=10000 --size 64x36 --small\n";
	static const u64 key[3] = {1, 2, 3};
	char name[TS_EMIT_NAME], small[TS_EMIT_NAME + 8], text[TS_EMIT_NAME + 80];
	fuzz_begin();
	cases = fuzz_name("cases.txt");
	params = fuzz_name("params.txt");
	sums = fuzz_name("SHA256SUMS");
	if (mkdir(fuzz_name("small"), 0700) != 0) abort();
	fuzz_write(cases, line, sizeof line - 1);
	ts_status status = ts_golden_dir_open(&goldens.dir, NULL, fuzz_root);
	if (status == TS_OK) status = ts_cases_read(&goldens);
	assert(status == TS_OK);
	one = goldens.cases[0];
	ts_emit_name(name, one.pipeline, TS_B_points_key);
	snprintf(small, sizeof small, "small/%s", name);
	snprintf(text, sizeof text, "%064d  %s\n", 0, name);
	keys = fuzz_name(small);
	fuzz_npy(keys, TS_B_points_key, 3, 0, key);
	fuzz_write(sums, text, strlen(text));
	status = ts_golden_read(&whole, &goldens.dir, one.pipeline);
	assert(status == TS_OK);
}

static ts_status read_cases(void)
{
	ts_status status = ts_cases_read(&goldens);
	for (u32 i = 0; i < goldens.n_cases && status == TS_OK; i++) {
		const ts_case *c = &goldens.cases[i];
		assert(ts_case_name(c->name) && ts_cases_find(&goldens, c->name) == c);
		assert(ts_params_check(&c->settings.params) == TS_OK);
	}
	return status;
}

static ts_status read_params(void)
{
	char text[512] = "";
	ts_status status = ts_case_check_params(text, sizeof text, &one, &goldens.dir);
	assert((status == TS_DIFFERENT) == (text[0] != 0) && strchr(text, '\n') == NULL);
	return status;
}

static ts_status read_digests(void)
{
	ts_golden golden;
	char text[512];
	ts_status status = ts_golden_read(&golden, &goldens.dir, one.pipeline);
	if (status == TS_OK) {
		ts_status same = ts_golden_compare(text, sizeof text, &golden, &whole, one.pipeline, false);
		assert((same == TS_DIFFERENT) == (text[0] != 0) && strchr(text, '\n') == NULL);
	}
	ts_golden_free(&golden);
	return status;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	if (cases == NULL) begin();
	const struct {
		const char *path;
		ts_status (*read)(void);
	} kinds[] = {{cases, read_cases}, {params, read_params}, {sums, read_digests}, {keys, read_digests}};
	if (n == 0 || data[0] >= sizeof kinds / sizeof *kinds) return 0;
	fuzz_write(kinds[data[0]].path, data + 1, n - 1);
	if (kinds[data[0]].read() == TS_ERROR) fuzz_refused();
	return 0;
}
