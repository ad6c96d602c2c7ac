/* A direct-mapped cache of blocks of a file; or memory. */
#include "trace/reader.h"
#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>
#include "model/order.h"

_Static_assert(TS_LITTLE_ENDIAN, "on a big-endian machine make core alone: traces are read as they are");

enum { BLOCK_BYTES = 1 << 16, N_BLOCKS = 64, MOST_HELD = 1 << 16 };

struct ts_reader {
	char *path;
	int file;
	u64 data_at, n;
	size_t element_bytes;
	u64 per_block;
	u64 held[N_BLOCKS]; /* 1 + the block that a place holds; 0: none */
	u8 *blocks;
	const u8 *memory; /* instead of a file */
};

ts_reader *ts_reader_open(int file, const char *path, u64 data_at, u64 n, size_t element_bytes)
{
	ts_reader *r = ts_alloc_zero(1, sizeof *r, "a reader");
	if (r == NULL) {
		close(file);
		return NULL;
	}
	*r = (ts_reader){.path = strdup(path),
	                 .file = file,
	                 .data_at = data_at,
	                 .n = n,
	                 .element_bytes = element_bytes,
	                 .per_block = BLOCK_BYTES / element_bytes};
	u64 blocks = n / r->per_block + 1;
	r->blocks = ts_alloc(blocks < N_BLOCKS ? (size_t)blocks : N_BLOCKS, BLOCK_BYTES, "blocks of a file");
	if (r->path != NULL && r->blocks != NULL) return r;
	if (r->blocks != NULL) ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
	ts_reader_close(r);
	return NULL;
}

ts_reader *ts_reader_memory(const void *data, u64 n, size_t element_bytes)
{
	ts_reader *r = ts_alloc_zero(1, sizeof *r, "a reader");
	if (r != NULL) *r = (ts_reader){.file = -1, .n = n, .element_bytes = element_bytes, .memory = data};
	return r;
}

static bool read_all(const ts_reader *r, u8 *to, size_t bytes, u64 at)
{
	while (bytes > 0) {
		ssize_t n = pread(r->file, to, bytes, (off_t)at);
		if (n < 0 && errno == EINTR) continue;
		if (n <= 0) {
			ts_fail_as(TS_KIND_FILE, "%s: %s", r->path, n == 0 ? "is shorter than it was" : strerror(errno));
			return false;
		}
		to += n;
		bytes -= (size_t)n;
		at += (u64)n;
	}
	return true;
}

const void *ts_reader_at(ts_reader *r, u64 first, u64 *n)
{
	assert(first < r->n);
	if (ts_stopped(ts_stop_here())) {
		ts_go_on();
		return NULL;
	}
	if (r->memory != NULL) {
		*n = r->n - first < MOST_HELD ? r->n - first : MOST_HELD;
		return r->memory + first * r->element_bytes;
	}
	u64 block = first / r->per_block, inside = first % r->per_block;
	u64 begin = block * r->per_block, place = block % N_BLOCKS;
	u64 held = r->n - begin < r->per_block ? r->n - begin : r->per_block;
	u8 *data = r->blocks + place * BLOCK_BYTES;
	if (r->held[place] != block + 1) {
		r->held[place] = 0;
		if (!read_all(r, data, (size_t)held * r->element_bytes, r->data_at + begin * r->element_bytes)) return NULL;
		r->held[place] = block + 1;
	}
	*n = held - inside;
	return data + inside * r->element_bytes;
}

void ts_reader_close(ts_reader *r)
{
	if (r == NULL) return;
	if (r->file >= 0) close(r->file);
	free(r->blocks);
	free(r->path);
	free(r);
}
