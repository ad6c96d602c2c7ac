/* Where a frame's buffers are, on a device that fails: what it must keep to itself is told once. */
#include <string.h>
#include "backends/devices/resident.h"
#include "tests/model/test.h"

/* A device whose memory is the host's, of another address. */
static bool fails;

static void *make(ts_store *store, void *data, u64 bytes)
{
	(void)store;
	(void)data;
	return calloc(1, bytes);
}

static void release(ts_store *store, void *part)
{
	(void)store;
	free(part);
}

static ts_status upload(ts_store *store, void *part, const void *data, u64 bytes)
{
	(void)store;
	memcpy(part, data, bytes);
	return TS_OK;
}

static ts_status download(ts_store *store, void *part, void *data, u64 bytes)
{
	(void)store;
	if (fails) return ts_fail("the device was lost");
	memcpy(data, part, bytes);
	return TS_OK;
}

static ts_status wait_for(ts_store *store)
{
	(void)store;
	return fails ? ts_fail("the device was lost") : TS_OK;
}

static const ts_device about = {.name = "a device", .most = 1 << 20};
static ts_store store_of(void)
{
	return (ts_store){
		.about = &about, .make = make, .free = release, .upload = upload, .download = download, .wait = wait_for};
}

/* The device writes a byte into each element; the host reads the buffer. */
static const u32 *write_and_read(ts_store *store, ts_frame *frame)
{
	void *parts[TS_PARTS];
	frame->residence = &ts_store_residence;
	assert_non_null(ts_frame_make1(frame, TS_B_cull_keep, 8));
	assert_int_equal(ts_store_use(store, parts, &frame->buffer[TS_B_cull_keep], 0, TS_OVERWRITES), TS_OK);
	memset(parts[0], 0x33, 8 * sizeof(u32));
	return ts_frame_data(frame, TS_B_cull_keep);
}

static void a_failure_is_told_once(void **state)
{
	(void)state;
	ts_store store = store_of();
	for (u32 run = 0; run < 4; run++) {
		ts_frame frame = {.bytes = 0};
		fails = run % 2 == 0;
		const u32 *keep = write_and_read(&store, &frame);
		assert_int_equal(keep[7], fails ? 0 : 0x33333333);
		assert_int_equal(ts_store_finish(&store), fails ? TS_ERROR : TS_OK);
		if (fails) assert_string_equal(ts_error_message(), "the device was lost");
		ts_frame_clear(&frame);
	}
}

/* The fetch fails and keeps its message. The next finish tells it, though the device has nothing left to do. */
static void a_failed_fetch_keeps_its_message(void **state)
{
	(void)state;
	ts_store store = store_of();
	ts_frame frame = {.bytes = 0};
	fails = true;
	write_and_read(&store, &frame);
	fails = false;
	assert_int_equal(ts_store_finish(&store), TS_ERROR);
	assert_int_equal(ts_store_finish(&store), TS_OK);
	ts_frame_clear(&frame);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(a_failure_is_told_once),
	                                   cmocka_unit_test(a_failed_fetch_keeps_its_message)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
