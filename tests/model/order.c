/* The order of bytes: each number of each record by its own member, and what a file says. */
#include "model/order.h"
#include "tests/model/test.h"

enum { ELEMENTS = 3, MOST_BYTES = 1024 };

/* One element as a struct: whether `there` holds the bytes of each number of `here` from last to first. */
static void is_reversed(const void *here, const void *there, size_t at, size_t bytes, u32 count)
{
	const u8 *a = (const u8 *)here + at, *b = (const u8 *)there + at;
	for (u32 k = 0; k < count; k++, a += bytes, b += bytes) {
		for (size_t i = 0; i < bytes; i++) assert_int_equal(a[i], b[bytes - 1 - i]);
	}
}

#define RECORD(name, doc) \
	static void reversed_##name(const void *here, const void *there) \
	{ \
		typedef name record;
#define FIELD(type, name, count, doc) is_reversed(here, there, offsetof(record, name), sizeof(type), count);
#define RECORD_END(name, bytes) }
#include <touchstone/records.def>

static void reversed_f32(const void *here, const void *there) { is_reversed(here, there, 0, 4, 1); }
static void reversed_u32(const void *here, const void *there) { is_reversed(here, there, 0, 4, 1); }
static void reversed_u64(const void *here, const void *there) { is_reversed(here, there, 0, 8, 1); }
static void reversed_u8(const void *here, const void *there) { is_reversed(here, there, 0, 1, 1); }

#define BUFFER(id, name, element, shape, order, key, doc) reversed_##element,
static void (*const reversed[])(const void *here, const void *there) = {
#include <touchstone/records.def>
};

static void each_number_is_reversed_by_itself(void **state)
{
	(void)state;
	u8 memory[ELEMENTS * MOST_BYTES], file[ELEMENTS * MOST_BYTES], again[ELEMENTS * MOST_BYTES];
	for (size_t i = 0; i < sizeof memory; i++) memory[i] = (u8)(i * 167 + i / 256);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		size_t bytes = ts_buffer_table[id].element_bytes;
		assert_true(bytes <= MOST_BYTES);
		ts_order_reverse(file, memory, (ts_buffer_id)id, ELEMENTS);
		for (u32 i = 0; i < ELEMENTS; i++) reversed[id](memory + i * bytes, file + i * bytes);
		ts_order_reverse(again, file, (ts_buffer_id)id, ELEMENTS);
		assert_memory_equal(again, memory, ELEMENTS * bytes);
	}
}

static void numbers_are_read_from_the_least_byte(void **state)
{
	(void)state;
	static const u8 file[] = {0x01, 0x82, 0x03, 0x84, 0x05, 0x86, 0x07, 0x88};
	u64 value = 0;
	for (size_t bytes = 1; bytes <= sizeof file; bytes++) {
		value += (u64)file[bytes - 1] << 8 * (bytes - 1);
		assert_true(ts_order_read(file, bytes) == value);
	}
}

int main(void)
{
	const struct CMUnitTest order[] = {
		cmocka_unit_test(each_number_is_reversed_by_itself),
		cmocka_unit_test(numbers_are_read_from_the_least_byte),
	};
	return cmocka_run_group_tests(order, NULL, NULL);
}
