/* Compressed files: what is written is read again, and what is damaged, or holds other than it says, is refused. */
#include <fcntl.h>
#include <zstd.h>
#include "model/core.h"
#include "tests/lcg.h"
#include "tests/trace/folder.h"
#include "trace/packed.h"

static u32 seed = 29;

/* Half of the bytes are noise. */
static u8 *make(size_t n)
{
	u8 *data = malloc(n + 1);
	assert_non_null(data);
	for (size_t i = 0; i < n; i++) {
		u32 noise = lcg_next(&seed) >> 24;
		data[i] = (u8)(i / 4096 % 2 ? noise : i / 64);
	}
	return data;
}

/* Writes the data in parts of a size that is no block's. */
static void pack(const char *path, const u8 *data, size_t n, size_t part)
{
	ts_file file;
	ts_packer *packer = ts_packer_begin(n, path);
	assert_non_null(packer);
	assert_int_equal(ts_file_begin(&file, path), TS_OK);
	for (size_t at = 0; at < n || at == 0; at += part) {
		size_t bytes = n - at < part ? n - at : part;
		assert_int_equal(ts_packer_put(packer, &file, data + at, bytes, at + bytes == n), TS_OK);
	}
	assert_int_equal(ts_file_end(&file), TS_OK);
	ts_packer_free(packer);
}

static ts_status head_of(const char *path, char *head, size_t *n, u64 *held)
{
	int file = open(path, O_RDONLY);
	assert_true(file >= 0);
	ts_status status = ts_packed_head(head, n, held, file, path);
	close(file);
	return status;
}

static ts_status read_of(u8 *data, size_t skip, size_t n, const char *path)
{
	int file = open(path, O_RDONLY);
	assert_true(file >= 0);
	ts_status status = ts_packed_read(data, skip, n, file, path);
	close(file);
	return status;
}

static void packed_files_read_back_the_same(void **state)
{
	(void)state;
	static const size_t sizes[] = {0, 1, 128, 4096, 65536, 131072, 131073, 5000000};
	const char *path = scratch_path("again.npy.zst");
	for (u32 s = 0; s < sizeof sizes / sizeof *sizes; s++) {
		size_t n = sizes[s], skip = n < 128 ? 0 : 128, held_bytes = 4096;
		char head[4096];
		u64 held;
		u8 *data = make(n), *read = malloc(n + 1);
		assert_non_null(read);
		pack(path, data, n, n > 1000000 ? 77777 : n + 1);
		assert_int_equal(head_of(path, head, &held_bytes, &held), TS_OK);
		assert_true(held == n && held_bytes == (n < 4096 ? n : 4096));
		assert_memory_equal(head, data, held_bytes);
		if (read_of(read, skip, n - skip, path) != TS_OK) fail_msg("%s", ts_error_message());
		assert_memory_equal(read, data + skip, n - skip);
		free(read);
		free(data);
	}
}

static void packed_names_end_in_zst(void **state)
{
	(void)state;
	assert_true(ts_packed_is("00-scene.texel.npy.zst"));
	assert_false(ts_packed_is("00-scene.texel.npy") || ts_packed_is(".zst") || ts_packed_is("zst"));
}

/* Of a whole file of n bytes: read as one that holds `asked` of them. */
static void refuses(const char *path, size_t asked, const char *what)
{
	u8 *read = malloc(asked + 1);
	assert_non_null(read);
	if (read_of(read, 0, asked, path) == TS_OK) fail_msg("taken, though %s", what);
	says(what);
	free(read);
}

static void damaged_files_are_refused(void **state)
{
	(void)state;
	enum { N = 300000 };
	size_t bytes;
	u8 *data = make(N);
	const char *path = scratch_path("damaged.zst");
	pack(path, data, N, N);
	refuses(path, N - 1, "holds more than 299999 bytes");
	refuses(path, N + 1, "holds 300000 bytes; 300001 would be right");
	char *file = file_read(path, &bytes);
	/* Cut short: in its header, in each tenth, and by its last byte. */
	for (u32 i = 1; i <= 11; i++) {
		size_t n = i == 11 ? bytes - 1 : bytes * (i - 1) / 10 + 9;
		file_write(path, file, n);
		refuses(path, N, "ends within its frame of zstd");
	}
	/* Behind the frame: a byte, and the same frame again. */
	char *twice = malloc(2 * bytes);
	assert_non_null(twice);
	memcpy(twice, file, bytes);
	memcpy(twice + bytes, file, bytes);
	file_write(path, twice, bytes + 1);
	refuses(path, N, "has more behind its frame of zstd");
	file_write(path, twice, 2 * bytes);
	refuses(path, N, "has more behind its frame of zstd");
	free(twice);
	/* Another bit anywhere. */
	for (u32 i = 0; i < 64; i++) {
		size_t at = bytes * i / 64;
		file[at] ^= 4;
		file_write(path, file, bytes);
		refuses(path, N, "damaged.zst: ");
		file[at] ^= 4;
	}
	free(file);
	free(data);
}

/* The heads of files that are none, that do not say their size, and that say too much. */
static void wrong_heads_are_refused(void **state)
{
	(void)state;
	static const u8 tiny[] = {0x28, 0xb5, 0x2f, 0xfd, 0xe0, 0, 0, 0, 0, 0, 0, 4, 0, 1, 0, 0};
	static const struct {
		const char *data;
		size_t bytes;
		const char *says;
	} cases[] = {
		{"", 0, "not a file of zstd"},
		{"\x93NUMPY\x01", 8, "not a file of zstd"},
		{"\x28\xb5\x2f\xfd", 4, "not a file of zstd"},
		{"\x28\xb5\x2f\xfd\0\x58\x01\0", 9, "does not say its size"},
		{(const char *)tiny, sizeof tiny, "says that it holds 1125899906842624 bytes, more than 16 bytes of zstd can"},
	};
	const char *path = scratch_path("head.zst");
	for (u32 i = 0; i < sizeof cases / sizeof *cases; i++) {
		char head[4096];
		size_t n = sizeof head;
		u64 held;
		file_write(path, cases[i].data, cases[i].bytes);
		assert_int_equal(head_of(path, head, &n, &held), TS_ERROR);
		says(cases[i].says);
	}
}

/* A frame whose window would take more memory than 8 MiB; refused when its head is read. */
static void a_large_window_is_refused(void **state)
{
	(void)state;
	enum { N = 17 << 20 };
	char head[4096];
	size_t n = sizeof head, room = ZSTD_compressBound(N);
	u64 held;
	u8 *data = calloc(N, 1), *frame = malloc(room);
	assert_true(data != NULL && frame != NULL);
	ZSTD_CCtx *context = ZSTD_createCCtx();
	ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, 24);
	size_t bytes = ZSTD_compress2(context, frame, room, data, N);
	assert_false(ZSTD_isError(bytes));
	ZSTD_freeCCtx(context);
	const char *path = scratch_path("window.zst");
	file_write(path, frame, bytes);
	assert_int_equal(head_of(path, head, &n, &held), TS_ERROR);
	says("window.zst: zstd: Frame requires too much memory");
	free(frame);
	free(data);
}

static void a_full_disk_is_an_error(void **state)
{
	(void)state;
	enum { N = 300000 };
	ts_file file;
	u8 *data = make(N);
	ts_packer *packer = ts_packer_begin(N, "/dev/full");
	assert_int_equal(ts_file_begin(&file, "/dev/full"), TS_OK);
	ts_status status = ts_packer_put(packer, &file, data, N, true);
	if (status == TS_OK) status = ts_file_end(&file);
	assert_int_equal(status, TS_ERROR);
	says("/dev/full: cannot be written: No space left");
	ts_file_drop(&file);
	ts_packer_free(packer);
	free(data);
}

int main(void)
{
	const struct CMUnitTest packed[] = {
		cmocka_unit_test(packed_files_read_back_the_same), cmocka_unit_test(packed_names_end_in_zst),
		cmocka_unit_test(damaged_files_are_refused),       cmocka_unit_test(wrong_heads_are_refused),
		cmocka_unit_test(a_large_window_is_refused),       cmocka_unit_test(a_full_disk_is_an_error),
	};
	return cmocka_run_group_tests(packed, scratch_begin, scratch_remove);
}
