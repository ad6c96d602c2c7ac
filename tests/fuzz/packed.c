/* libFuzzer on compressed files: `make fuzz`. Each input is such a file. What its head says is what reading gives: the
 * first bytes are the same, and one byte more or less is refused. */
#include <fcntl.h>
#include "tests/fuzz/folder.h"
#include "trace/packed.h"

enum { HEAD = 4096, MOST = 1 << 22 };

static ts_status read_of(char *data, size_t bytes, const char *path)
{
	int file = open(path, O_RDONLY);
	ts_status status = ts_packed_read(data, 0, bytes, file, path);
	close(file);
	return status;
}

static void read_whole(const char *path, const char *head, size_t n, size_t held)
{
	char *data = malloc(held + 1);
	if (data == NULL) abort();
	if (read_of(data, held, path) == TS_OK) {
		assert(memcmp(data, head, n) == 0);
		assert(read_of(data, held + 1, path) == TS_ERROR);
		assert(held == 0 || read_of(data, held - 1, path) == TS_ERROR);
	}
	free(data);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t bytes)
{
	static const char *path;
	char head[HEAD];
	size_t n = sizeof head;
	u64 held;
	if (path == NULL) {
		fuzz_begin();
		path = fuzz_name("k.npy.zst");
	}
	fuzz_write(path, data, bytes);
	int file = open(path, O_RDONLY);
	if (ts_packed_head(head, &n, &held, file, path) == TS_OK) {
		assert(n <= sizeof head && (n == sizeof head || n <= held));
		if (held <= MOST) read_whole(path, head, n, (size_t)held);
	} else {
		fuzz_refused();
	}
	close(file);
	return 0;
}
