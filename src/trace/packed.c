/* Frames of zstd, one block of the file at a time. */
#include "trace/packed.h"
#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>
#include <zstd_errors.h>

enum { LEVEL = 3, WINDOW_LOG = 23, BLOCK = 1 << 16 };

/* Most bytes that a block of a frame unpacks to, and fewest that it takes in the file. */
enum { MOST_OF_BLOCK = 1 << 17, LEAST_BLOCK = 4 };

bool ts_packed_is(const char *name)
{
	size_t n = strlen(name), suffix = sizeof TS_PACKED_SUFFIX - 1;
	return n > suffix && strcmp(name + n - suffix, TS_PACKED_SUFFIX) == 0;
}

static ts_status fail(const char *path, size_t code)
{
	if (ZSTD_getErrorCode(code) == ZSTD_error_memory_allocation)
		return ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
	return ts_fail("%s: zstd: %s", path, ZSTD_getErrorName(code));
}

ts_packer *ts_packer_begin(u64 bytes, const char *path)
{
	ts_packer *packer = ZSTD_createCCtx();
	if (packer == NULL) {
		ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
		return NULL;
	}
	size_t code = ZSTD_CCtx_setParameter(packer, ZSTD_c_compressionLevel, LEVEL);
	if (!ZSTD_isError(code)) code = ZSTD_CCtx_setParameter(packer, ZSTD_c_checksumFlag, 1);
	if (!ZSTD_isError(code)) code = ZSTD_CCtx_setPledgedSrcSize(packer, bytes);
	if (!ZSTD_isError(code)) return packer;
	fail(path, code);
	ts_packer_free(packer);
	return NULL;
}

ts_status ts_packer_put(ts_packer *packer, ts_file *file, const void *data, size_t bytes, bool last)
{
	u8 block[BLOCK];
	size_t left = 1;
	ZSTD_inBuffer in = {data, bytes, 0};
	ts_stop *stop = ts_stop_here();
	while (in.pos < in.size || (last && left > 0)) {
		if (ts_stopped(stop)) return ts_go_on();
		ZSTD_outBuffer out = {block, sizeof block, 0};
		left = ZSTD_compressStream2(packer, &out, &in, last ? ZSTD_e_end : ZSTD_e_continue);
		if (ZSTD_isError(left)) return fail(file->path, left);
		if (ts_file_put(file, block, out.pos) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

void ts_packer_free(ts_packer *packer) { ZSTD_freeCCtx(packer); }

/* A frame that is read from the start. */
typedef struct {
	const char *path;
	int file;
	ZSTD_DCtx *context;
	ZSTD_inBuffer in;
	bool ended;
	u8 block[BLOCK];
} unpacker;

/* The next block of the file; empty at its end. */
static ts_status refill(unpacker *u)
{
	ssize_t n;
	if (ts_stopped(ts_stop_here())) return ts_go_on();
	do n = read(u->file, u->block, sizeof u->block);
	while (n < 0 && errno == EINTR);
	if (n < 0) return ts_fail_as(TS_KIND_FILE, "%s: %s", u->path, strerror(errno));
	u->in = (ZSTD_inBuffer){u->block, (size_t)n, 0};
	return TS_OK;
}

/* NULL with the message set; otherwise to be released by end(). */
static unpacker *begin(int file, const char *path)
{
	unpacker *u = ts_alloc_zero(1, sizeof *u, path);
	if (u == NULL) return NULL;
	*u = (unpacker){.path = path, .file = file, .context = ZSTD_createDCtx()};
	bool limited =
		u->context != NULL && !ZSTD_isError(ZSTD_DCtx_setParameter(u->context, ZSTD_d_windowLogMax, WINDOW_LOG));
	if (!limited) ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
	if (limited && refill(u) == TS_OK) return u;
	ZSTD_freeDCtx(u->context);
	free(u);
	return NULL;
}

static void end(unpacker *u)
{
	ZSTD_freeDCtx(u->context);
	free(u);
}

/* The next bytes, *got of them: fewer than requested where the frame ends. */
static ts_status unpack(unpacker *u, void *to, size_t bytes, size_t *got)
{
	ZSTD_outBuffer out = {to, bytes, 0};
	while (out.pos < out.size && !u->ended) {
		size_t before = out.pos, left = ZSTD_decompressStream(u->context, &out, &u->in);
		if (ZSTD_isError(left)) return fail(u->path, left);
		u->ended = left == 0;
		if (u->ended || out.pos > before || u->in.pos < u->in.size) continue;
		if (refill(u) != TS_OK) return TS_ERROR;
		if (u->in.size == 0) return ts_fail("%s: ends within its frame of zstd", u->path);
	}
	*got = out.pos;
	return TS_OK;
}

/* The frame's stated number of bytes. */
static ts_status find_held(const unpacker *u, u64 *held)
{
	struct stat info;
	unsigned long long n = ZSTD_getFrameContentSize(u->in.src, u->in.size);
	if (n == ZSTD_CONTENTSIZE_ERROR) return ts_fail("%s: not a file of zstd", u->path);
	if (n == ZSTD_CONTENTSIZE_UNKNOWN) {
		return ts_fail("%s: its frame of zstd does not say its size; what \"zstd FILE\" writes would", u->path);
	}
	if (fstat(u->file, &info) != 0) return ts_fail_as(TS_KIND_FILE, "%s: %s", u->path, strerror(errno));
	u64 blocks = (u64)info.st_size / LEAST_BLOCK;
	*held = n;
	if (n / MOST_OF_BLOCK <= blocks) return TS_OK;
	return ts_fail("%s: says that it holds %llu bytes, more than %" PRIu64 " bytes of zstd can", u->path, n,
	               (u64)info.st_size);
}

ts_status ts_packed_head(char *head, size_t *head_bytes, u64 *held, int descriptor, const char *path)
{
	unpacker *u = begin(descriptor, path);
	if (u == NULL) return TS_ERROR;
	ts_status status = find_held(u, held);
	if (status == TS_OK) status = unpack(u, head, *head_bytes, head_bytes);
	end(u);
	return status;
}

static ts_status unpack_all(unpacker *u, u8 *to, size_t skip, size_t bytes)
{
	u8 passed[BLOCK];
	size_t got, all = skip + bytes;
	assert(skip <= sizeof passed);
	if (unpack(u, passed, skip, &got) != TS_OK) return TS_ERROR;
	if (got < skip) return ts_fail("%s: holds %zu bytes; %zu would be right", u->path, got, all);
	if (unpack(u, to, bytes, &got) != TS_OK) return TS_ERROR;
	if (got < bytes) return ts_fail("%s: holds %zu bytes; %zu would be right", u->path, skip + got, all);
	if (unpack(u, passed, 1, &got) != TS_OK) return TS_ERROR;
	if (got > 0) return ts_fail("%s: holds more than %zu bytes", u->path, all);
	if (u->in.pos == u->in.size && refill(u) != TS_OK) return TS_ERROR;
	return u->in.pos == u->in.size ? TS_OK : ts_fail("%s: has more behind its frame of zstd", u->path);
}

ts_status ts_packed_read(void *to, size_t skip, size_t bytes, int descriptor, const char *path)
{
	unpacker *u = begin(descriptor, path);
	ts_status status = u != NULL ? unpack_all(u, to, skip, bytes) : TS_ERROR;
	if (u != NULL) end(u);
	return status;
}
