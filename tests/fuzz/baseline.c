/* libFuzzer on lists of what is known and of what is skipped: `make fuzz`. An accepted list has a name, and a reason
 * that is one line, in each entry, and no entry twice. */
#include "cli/golden/baseline.h"
#include "tests/fuzz/folder.h"

static const char *path;

static ts_status find(const void *user, const char *name, const char **effect, const char **method)
{
	(void)user;
	*effect = ts_pipelines()[0]->effect->name;
	*method = ts_pipelines()[0]->name;
	return name[0] != 'n' ? TS_OK : ts_fail("no case \"%.60s\"", name);
}

static ts_status check_name(const void *user, const char *name)
{
	(void)user;
	return name[0] != 'n' ? TS_OK : ts_fail("no buffer \"%.60s\"", name);
}

static void check(const ts_baseline *b, ts_status status)
{
	if (status != TS_OK) fuzz_refused();
	for (size_t i = 0; i < b->n && status == TS_OK; i++) {
		const ts_entry *e = &b->entry[i];
		assert(e->name[0] != 0 && e->reason[0] != 0 && strpbrk(e->reason, "\n\r") == NULL);
		assert(ts_baseline_find(b, e->name, e->buffer) == e);
	}
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	ts_baseline b;
	if (path == NULL) {
		fuzz_begin();
		path = fuzz_name("known.txt");
	}
	fuzz_write(path, data, n);
	check(&b, ts_baseline_read(&b, path, find, NULL));
	ts_baseline_free(&b);
	check(&b, ts_baseline_skips(&b, path, check_name, NULL));
	ts_baseline_free(&b);
	return 0;
}
