/* What is kept of what items tell: lines in their order, as deep as their calls, with their values; and who stored
 * where. */
#include "tests/explain/hand.h"

static u32 value_of(const ts_explanation *e, size_t number)
{
	u32 value;
	memcpy(&value, e->telling.bytes + e->telling.lines[number].value, sizeof value);
	return value;
}

static void lines_are_kept_in_their_order(void **state)
{
	(void)state;
	ts_explanation e;
	hand_begin(&e);
	ts_told_call(&hand_item);
	hand_tell(&hand_n, 7);
	assert_true(ts_told_test(&hand_test, true));
	ts_told_call(&hand_helper);
	assert_false(ts_told_test(&hand_test, false));
	hand_tell(&hand_result, 9);
	ts_told_end();
	ts_told(&hand_store, &hand_keys[2]);
	ts_told_end();
	hand_tell(&hand_n, 8);
	static const struct {
		const ts_told_site *site;
		u32 depth;
	} lines[] = {{&hand_item, 0}, {&hand_n, 1},      {&hand_test, 1},  {&hand_helper, 1},
	             {&hand_test, 2}, {&hand_result, 2}, {&hand_store, 1}, {&hand_n, 0}};
	assert_int_equal(e.telling.n_lines, sizeof lines / sizeof *lines);
	for (size_t i = 0; i < e.telling.n_lines; i++) hand_is(&e, i, lines[i].site, lines[i].depth);
	assert_true(value_of(&e, 1) == 7 && value_of(&e, 5) == 9 && value_of(&e, 6) == 12 && value_of(&e, 7) == 8);
	assert_true(e.telling.lines[2].yes && !e.telling.lines[4].yes);
	assert_ptr_equal(e.telling.lines[6].at, &hand_keys[2]);
	assert_int_equal(e.telling.n_bytes, 3 * sizeof(u32) + sizeof(u64));
	hand_end(&e);
}

/* Of functions that are no kernel's own only stores are heard, also of the kernel's that they call. */
static void of_primitives_only_stores_are_heard(void **state)
{
	(void)state;
	for (u32 primitives = 0; primitives < 2; primitives++) {
		ts_explanation e;
		hand_begin(&e);
		e.telling.primitives = primitives != 0;
		ts_told_call(&hand_item);
		ts_told_call(&hand_helper);
		hand_tell(&hand_n, 1);
		ts_told_call(&hand_item);
		assert_true(ts_told_test(&hand_test, true));
		ts_told_end();
		hand_tell(&hand_n, 2);
		ts_told(&hand_store, &hand_keys[0]);
		ts_told_end();
		hand_tell(&hand_n, 3);
		ts_told_end();
		hand_tell(&hand_n, 4);
		assert_int_equal(e.telling.n_lines, primitives ? 9 : 4);
		size_t behind = primitives ? 6 : 1;
		hand_is(&e, 0, &hand_item, 0);
		hand_is(&e, behind, &hand_store, primitives ? 2 : 1);
		hand_is(&e, behind + 1, &hand_n, 1);
		hand_is(&e, behind + 2, &hand_n, 0);
		assert_true(value_of(&e, behind + 1) == 3 && value_of(&e, behind + 2) == 4);
		hand_end(&e);
	}
}

/* Titles are lines, but for those of functions that are no kernel's own. */
static void titles_of_primitives_are_not_heard(void **state)
{
	(void)state;
	for (u32 primitives = 0; primitives < 2; primitives++) {
		ts_explanation e;
		hand_begin(&e);
		e.telling.primitives = primitives != 0;
		ts_told_title(&hand_bound);
		ts_told_call(&hand_helper);
		ts_told_title(&hand_find);
		ts_told_end();
		ts_told_title(&hand_offer);
		e.telling.listens = false;
		ts_told_title(&hand_bound);
		assert_int_equal(e.telling.n_lines, primitives ? 4 : 2);
		hand_is(&e, 0, &hand_bound, 0);
		if (primitives) hand_is(&e, 2, &hand_find, 1);
		hand_is(&e, e.telling.n_lines - 1, &hand_offer, 0);
		hand_end(&e);
	}
}

/* Lines behind the most are counted, their values are not kept; the store is of the line that would have been next. */
static void lines_behind_the_most_keep_no_value(void **state)
{
	(void)state;
	ts_explanation e;
	hand_begin(&e);
	e.telling.most = 2;
	e.telling.from = (const u8 *)&hand_keys[1];
	e.telling.to = (const u8 *)&hand_keys[2];
	for (u32 i = 0; i < 5; i++) hand_tell(&hand_n, i);
	ts_told(&hand_store, &hand_keys[1]);
	assert_true(ts_told_test(&hand_test, true));
	assert_true(e.telling.n_lines == 2 && e.telling.n_more == 5 && e.telling.n_bytes == 2 * sizeof(u32));
	assert_true(value_of(&e, 1) == 1 && e.telling.stored && e.telling.stores == 2);
	hand_end(&e);
}

/* Every store that shares a byte with what is watched is noticed, and no other; the last one is remembered. */
static void every_store_into_the_watched_is_noticed(void **state)
{
	(void)state;
	static u8 bytes[64];
	for (int silent = 0; silent < 2; silent++) {
		for (int at = 8; at < 48; at++) {
			ts_explanation e;
			hand_begin(&e);
			e.telling.listens = !silent;
			e.telling.from = bytes + 24;
			e.telling.to = bytes + 28;
			hand_tell(&hand_n, 1);
			ts_told(&hand_store, bytes + at);
			assert_int_equal(e.telling.stored, at > 24 - 8 && at < 28);
			assert_int_equal(e.telling.stores, e.telling.stored && !silent);
			ts_told(&hand_store, bytes + 24);
			ts_told(&hand_store, bytes + 28);
			assert_true(e.telling.stored && e.telling.stores == (silent ? 0 : 2));
			assert_int_equal(e.telling.n_lines, silent ? 0 : 4);
			hand_end(&e);
		}
	}
}

/* Who does not listen hears nothing, and tests decide as ever. */
static void who_does_not_listen_hears_nothing(void **state)
{
	(void)state;
	ts_explanation e;
	hand_begin(&e);
	e.telling.listens = false;
	ts_told_call(&hand_item);
	assert_true(ts_told_test(&hand_test, true) && !ts_told_test(&hand_test, false));
	hand_tell(&hand_n, 1);
	ts_told_end();
	ts_told_end();
	assert_true(e.telling.n_lines == 0 && e.telling.depth == 0 && e.telling.hidden == 0 && e.telling.n_more == 0);
	hand_end(&e);
}

/* Lines or bytes that no memory could hold: the line is not kept, and nothing is heard from then on. */
static void without_memory_no_line_is_kept(void **state)
{
	(void)state;
	for (u32 of_bytes = 0; of_bytes < 2; of_bytes++) {
		ts_explanation e;
		hand_begin(&e);
		hand_tell(&hand_n, 5);
		size_t held = of_bytes ? 1 : (size_t)PTRDIFF_MAX;
		e.telling.n_lines = held;
		if (of_bytes) e.telling.n_bytes = (size_t)PTRDIFF_MAX;
		hand_tell(&hand_n, 6);
		assert_true(e.telling.failed && e.telling.n_lines == held);
		assert_non_null(strstr(ts_error_message(), "an explanation: "));
		assert_true(ts_told_test(&hand_test, true));
		hand_tell(&hand_n, 7);
		assert_int_equal(e.telling.n_lines, held);
		assert_int_equal(value_of(&e, 0), 5);
		hand_end(&e);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(lines_are_kept_in_their_order),
		cmocka_unit_test(of_primitives_only_stores_are_heard),
		cmocka_unit_test(titles_of_primitives_are_not_heard),
		cmocka_unit_test(lines_behind_the_most_keep_no_value),
		cmocka_unit_test(every_store_into_the_watched_is_noticed),
		cmocka_unit_test(who_does_not_listen_hears_nothing),
		cmocka_unit_test(without_memory_no_line_is_kept),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
