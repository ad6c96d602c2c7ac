/* Printable lines. */
#include "model/core.h"
#include "tests/model/test.h"

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
	const struct CMUnitTest text[] = {
		cmocka_unit_test(every_control_byte_becomes_a_question_mark),
		cmocka_unit_test(controls_of_two_bytes_become_question_marks),
	};
	return cmocka_run_group_tests(text, NULL, NULL);
}
