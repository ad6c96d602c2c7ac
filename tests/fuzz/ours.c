/* libFuzzer on the list of an earlier output: `make fuzz`. Each input is the report.json of a folder that --force would
 * replace. It may be replaced only if the list, read here again, names every file in it and none out of it. */
#include <jansson.h>
#include "study/results/folder.h"
#include "tests/fuzz/folder.h"

static const char *const files[] = {"epr.png", "sub/a.npy", "sub/b.npy"};
static const char *report;

static void begin(void)
{
	fuzz_begin();
	report = fuzz_name("report.json");
	if (mkdir(fuzz_name("sub"), 0700) != 0) abort();
	for (size_t i = 0; i < sizeof files / sizeof *files; i++) fuzz_write(fuzz_name(files[i]), "", 0);
}

static bool has(const json_t *list, const char *name)
{
	bool found = false;
	for (size_t i = 0; i < json_array_size(list); i++)
		found |= strcmp(json_string_value(json_array_get(list, i)), name) == 0;
	return found;
}

static void check(const json_t *root)
{
	const json_t *list = json_object_get(root, "files");
	assert(strcmp(json_string_value(json_object_get(root, "program")), "touchstone") == 0);
	for (size_t i = 0; i < json_array_size(list); i++) {
		const char *name = json_string_value(json_array_get(list, i)), *slash = strchr(name, '/');
		assert(name[0] != 0 && name[0] != '.' && name[0] != '/');
		assert(slash == NULL || (slash[1] != 0 && slash[1] != '.' && strchr(slash + 1, '/') == NULL));
	}
	for (size_t i = 0; i < sizeof files / sizeof *files; i++) assert(has(list, files[i]));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	if (report == NULL) begin();
	fuzz_write(report, data, n);
	if (ts_ours_judge(fuzz_root) == TS_OK) {
		json_t *root = json_loadb((const char *)data, n, 0, NULL);
		check(root);
		json_decref(root);
	} else {
		fuzz_refused();
	}
	return 0;
}
