/* Messages of failures, and untrusted text on its way out. */
#include <pthread.h>
#include <wchar.h>
#include "model/core.h"
#include "tests/model/test.h"

static void message_is_formatted(void **state)
{
	(void)state;
	assert_int_equal(ts_fail("%s: %d of %d", "file", 3, 7), TS_ERROR);
	assert_string_equal(ts_error_message(), "file: 3 of 7");
}

static void control_characters_become_question_marks(void **state)
{
	(void)state;
	char text[256];
	for (int i = 1; i < 256; i++) text[i - 1] = (char)i;
	text[255] = '\0';
	ts_fail("%s", text);
	const char *message = ts_error_message();
	assert_int_equal(strlen(message), 255);
	for (int i = 1; i < 256; i++) {
		char expected = i < 0x20 || i == 0x7f ? '?' : (char)i;
		assert_int_equal(message[i - 1], expected);
	}
	ts_fail("a\n\033[31mb\xc2\x9b"
	        "2Jc");
	assert_string_equal(ts_error_message(), "a??[31mb??2Jc");
}

static void letters_beyond_ascii_survive(void **state)
{
	(void)state;
	ts_fail("%s", "caf\xc3\xa9 \xe6\xa8\xa1");
	assert_string_equal(ts_error_message(), "caf\xc3\xa9 \xe6\xa8\xa1");
}

/* A wide character that the locale has no bytes for. */
static void what_cannot_be_formatted_is_said(void **state)
{
	(void)state;
	const wchar_t lone[] = {0xd800, 0};
	assert_int_equal(ts_fail("%ls", lone), TS_ERROR);
	assert_string_equal(ts_error_message(), "a message could not be formatted");
}

static void last_message_may_be_an_argument(void **state)
{
	(void)state;
	ts_fail("inner");
	ts_fail("outer: %s", ts_error_message());
	assert_string_equal(ts_error_message(), "outer: inner");
}

/* A line that ends with the last message is of the same kind, however long; another is not. */
static void kinds_stay_as_messages_grow(void **state)
{
	(void)state;
	char path[900];
	memset(path, 'p', sizeof path);
	path[sizeof path - 1] = 0;
	assert_int_equal(ts_fail_as(TS_KIND_FILE, "%s: absent", path), TS_ERROR);
	assert_int_equal(ts_error_kind(), TS_KIND_FILE);
	ts_fail("%s: %s", path, ts_error_message());
	assert_int_equal(ts_error_kind(), TS_KIND_FILE);
	ts_fail("outer: %s", ts_error_message());
	assert_int_equal(ts_error_kind(), TS_KIND_FILE);
	ts_fail("%s; and more", ts_error_message());
	assert_int_equal(ts_error_kind(), TS_KIND_ARGUMENT);
	ts_refuse("element 5");
	assert_int_equal(ts_error_kind(), TS_KIND_FORMAT);
}

/* Nothing more than its being of the arguments is known. */
static void blame_spares_known_kinds(void **state)
{
	(void)state;
	assert_int_equal(ts_blame(ts_fail("line 3"), TS_KIND_FORMAT), TS_ERROR);
	assert_int_equal(ts_error_kind(), TS_KIND_FORMAT);
	assert_null(ts_alloc(SIZE_MAX, 2, "all"));
	assert_int_equal(ts_blame(TS_ERROR, TS_KIND_FORMAT), TS_ERROR);
	assert_int_equal(ts_error_kind(), TS_KIND_MEMORY);
	ts_fail("line 4");
	assert_int_equal(ts_blame(TS_DIFFERENT, TS_KIND_FORMAT), TS_DIFFERENT);
	assert_int_equal(ts_error_kind(), TS_KIND_ARGUMENT);
}

/* A refusal is one until something fails. */
static void refusals_are_told_from_failures(void **state)
{
	(void)state;
	ts_fail("disk");
	assert_false(ts_refused());
	assert_int_equal(ts_refuse("element %d", 5), TS_ERROR);
	assert_string_equal(ts_error_message(), "element 5");
	assert_true(ts_refused());
	ts_fail("memory");
	assert_false(ts_refused());
}

/* Whatever the length, the cut is marked and does not split a two-byte letter. */
static void long_messages_are_cut_and_say_so(void **state)
{
	(void)state;
	for (int shift = 0; shift < 2; shift++) {
		char text[5000] = "x";
		for (int i = shift; i + 2 < (int)sizeof text; i += 2) memcpy(text + i, "\xc3\xa9", 3);
		ts_fail("%s", text);
		const char *message = ts_error_message();
		size_t length = strlen(message);
		assert_true(length > 500 && length < sizeof text - 3);
		assert_string_equal(message + length - 3, "...");
		assert_int_equal((length - 3 - (size_t)shift) % 2, 0);
	}
}

static void *fail_elsewhere(void *seen)
{
	*(bool *)seen = ts_error_message()[0] == '\0';
	ts_fail("theirs");
	return NULL;
}

static void threads_have_their_own(void **state)
{
	(void)state;
	bool began_empty = false;
	pthread_t thread;
	ts_fail("ours");
	assert_int_equal(pthread_create(&thread, NULL, fail_elsewhere, &began_empty), 0);
	assert_int_equal(pthread_join(thread, NULL), 0);
	assert_true(began_empty);
	assert_string_equal(ts_error_message(), "ours");
}

static void every_control_byte_becomes_a_question_mark(void **state)
{
	(void)state;
	char text[256];
	for (int i = 1; i < 256; i++) text[i - 1] = (char)i;
	text[255] = '\0';
	ts_line_clean(text);
	assert_int_equal(strlen(text), 255);
	for (int i = 1; i < 256; i++) assert_int_equal(text[i - 1], i < 0x20 || i == 0x7f ? '?' : (char)i);
}

/* U+0080 to U+009F are control characters of two bytes; U+00A0 and those whose first byte only is the same are not. */
static void controls_of_two_bytes_become_question_marks(void **state)
{
	(void)state;
	char text[] = "\xc2\x80|\xc2\x9f|\xc2\xa0|\xc3\x9f|\x9b|\xc2";
	ts_line_clean(text);
	assert_string_equal(text, "??|??|\xc2\xa0|\xc3\x9f|\x9b|\xc2");
}

int main(void)
{
	const struct CMUnitTest error[] = {
		cmocka_unit_test(what_cannot_be_formatted_is_said),
		cmocka_unit_test(message_is_formatted),
		cmocka_unit_test(control_characters_become_question_marks),
		cmocka_unit_test(letters_beyond_ascii_survive),
		cmocka_unit_test(last_message_may_be_an_argument),
		cmocka_unit_test(refusals_are_told_from_failures),
		cmocka_unit_test(kinds_stay_as_messages_grow),
		cmocka_unit_test(blame_spares_known_kinds),
		cmocka_unit_test(long_messages_are_cut_and_say_so),
		cmocka_unit_test(threads_have_their_own),
		cmocka_unit_test(every_control_byte_becomes_a_question_mark),
		cmocka_unit_test(controls_of_two_bytes_become_question_marks),
	};
	return cmocka_run_group_tests(error, NULL, NULL);
}
