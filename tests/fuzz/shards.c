/* libFuzzer on the folders of shards: `make fuzz`. The first byte says which file of a second shard the rest is: of a
 * comparison or of a series of renders the report or the times, which SHA256SUMS then confirms, or SHA256SUMS itself.
 * Whatever merge makes of it, nothing but its output is written. */
#include <fcntl.h>
#include "cli/reports/sharded.h"
#include "model/digest.h"
#include "model/input.h"
#include "output/folder.h"
#include "tests/fuzz/folder.h"

static const struct {
	const char *shard, *file;
} kinds[] = {
	{"c", "report.json"}, {"c", "times.json"}, {"c", TS_SHARDED_SUMS}, {"p", "report.json"}, {"p", "times.json"}};
static const char *precious;
static const char held[] = "precious";

static ts_status run(const char *format, ...) __attribute__((format(printf, 1, 2)));
static ts_status run(const char *format, ...)
{
	static ts_cli cli;
	char line[1024], *words[64], *state = NULL;
	int n = 0;
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(line, sizeof line, format, arguments);
	va_end(arguments);
	for (char *word = strtok_r(line, " ", &state); word != NULL; word = strtok_r(NULL, " ", &state)) words[n++] = word;
	words[n] = NULL;
	const ts_command *command = ts_cli_require(words[0]);
	ts_status status = ts_cli_parse(&cli, command, n, words);
	return status == TS_OK ? command->run(&cli) : status;
}

static const char *below(const char *shard, u32 index, const char *file)
{
	static char path[128];
	snprintf(path, sizeof path, "%s/%s-%u%s%s", fuzz_root, shard, index, file[0] != 0 ? "/" : "", file);
	return path;
}

static void end(void)
{
	static const char *const all[] = {"r", "c-1", "c-2", "p-1", "p-2", "out"};
	for (u32 i = 0; i < sizeof all / sizeof *all; i++) {
		char path[64];
		snprintf(path, sizeof path, "%s/%s", fuzz_root, all[i]);
		if (access(path, F_OK) == 0) ts_folder_remove(path);
	}
}

/* Before the first input, whose time is limited. */
int LLVMFuzzerInitialize(int *argc, char ***argv)
{
	(void)argc;
	(void)argv;
	static const char of[] =
		"render reflections scenes/triangle.gltf --camera camera --reflectors 0 --size 16x16 --set "
		"cube.px=16 --method epr";
	fuzz_begin();
	atexit(end);
	precious = fuzz_name("precious");
	fuzz_write(precious, held, sizeof held);
	assert(freopen("/dev/null", "w", stdout) != NULL);
	bool good = run("%s --trace --no-images -o %s/r", of, fuzz_root) == TS_OK;
	for (u32 i = 1; i <= 2; i++) {
		good &= run("compare %s/r/trace-epr %s/r/trace-epr --shard %u/2 -o %s", fuzz_root, fuzz_root, i,
		            below("c", i, "")) == TS_OK;
		good &= run("%s --set seed=1,2 --shard %u/2 -o %s", of, i, below("p", i, "")) == TS_OK;
	}
	assert(good);
	return 0;
}

/* SHA256SUMS of the shard, by its own names, or by those of `listed`. */
static void confirm(const char *shard, const char *listed)
{
	char sums[1 << 14] = "", dir[64];
	size_t used = 0, bytes;
	const char *name = listed;
	snprintf(dir, sizeof dir, "%s", below(shard, 2, ""));
	while ((name = strstr(name, "  ")) != NULL) {
		char hex[TS_DIGEST_BYTES];
		size_t n = strcspn(name += 2, "\n");
		char *file = strndup(name, n), *data = ts_sharded_read(&bytes, hex, dir, file, TS_INPUT_ANY);
		assert(data != NULL);
		used += (size_t)snprintf(sums + used, sizeof sums - used, "%s  %s\n", hex, file);
		free(data);
		free(file);
	}
	fuzz_write(below(shard, 2, TS_SHARDED_SUMS), sums, used);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	size_t bytes, kept_bytes;
	if (n == 0 || data[0] >= sizeof kinds / sizeof *kinds) return 0;
	const char *shard = kinds[data[0]].shard, *file = kinds[data[0]].file;
	char *sums = ts_text_read(&bytes, below(shard, 2, TS_SHARDED_SUMS), TS_INPUT_ANY);
	char *kept = ts_input_read(&kept_bytes, below(shard, 2, file), TS_INPUT_ANY);
	assert(sums != NULL && kept != NULL);
	fuzz_write(below(shard, 2, file), data + 1, n - 1);
	if (strcmp(file, TS_SHARDED_SUMS) != 0) confirm(shard, sums);
	ts_status status = run("merge %s/%s-1 %s/%s-2 -o %s/out --force", fuzz_root, shard, fuzz_root, shard, fuzz_root);
	if (status == TS_ERROR) fuzz_refused();
	fuzz_write(below(shard, 2, file), kept, kept_bytes);
	fuzz_write(below(shard, 2, TS_SHARDED_SUMS), sums, bytes);
	free(kept);
	free(sums);
	char *same = ts_input_read(&bytes, precious, TS_INPUT_ANY);
	assert(same != NULL && bytes == sizeof held && memcmp(same, held, bytes) == 0);
	free(same);
	return 0;
}
