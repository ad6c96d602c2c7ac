/* Of the failures of many threads one is kept, whole. */
#include <assert.h>
#include "tests/model/test.h"
#include "truth/first_error.h"

enum { N_THREADS = 8, N_ROUNDS = 200 };

static void the_first_error_is_kept(void **state)
{
	(void)state;
	ts_first_error error;
	ts_first_error_begin(&error);
	assert_null(ts_first_error_text(&error));
	ts_first_error_keep(&error, 4, NULL);
	ts_first_error_keep(&error, 5, "later");
	assert_string_equal(ts_first_error_text(&error), "error 4, no text");
	ts_first_error_end(&error);
}

static void a_long_text_is_cut(void **state)
{
	(void)state;
	char text[1024];
	ts_first_error error;
	memset(text, 'x', sizeof text);
	text[sizeof text - 1] = 0;
	ts_first_error_begin(&error);
	ts_first_error_keep(&error, 1, text);
	assert_int_equal(strlen(ts_first_error_text(&error)), sizeof error.text - 1);
	ts_first_error_end(&error);
}

typedef struct {
	ts_first_error *error;
	int code;
} failing;

/* Each thread's text is a run of its own letter, of its own length. */
static void *fail_once(void *user)
{
	failing *f = user;
	char text[64] = "";
	memset(text, 'a' + f->code, 20 + (size_t)f->code);
	ts_first_error_keep(f->error, f->code, text);
	assert(ts_first_error_text(f->error) != NULL);
	return NULL;
}

static void one_error_of_many_is_kept_whole(void **state)
{
	(void)state;
	for (int round = 0; round < N_ROUNDS; round++) {
		ts_first_error error;
		pthread_t thread[N_THREADS];
		failing each[N_THREADS];
		ts_first_error_begin(&error);
		for (int i = 0; i < N_THREADS; i++) {
			each[i] = (failing){&error, i};
			assert_int_equal(pthread_create(&thread[i], NULL, fail_once, &each[i]), 0);
		}
		for (int i = 0; i < N_THREADS; i++) pthread_join(thread[i], NULL);
		const char *text = ts_first_error_text(&error);
		size_t code = (size_t)(text[6] - '0'), length = 20 + code;
		assert_int_equal(strlen(text), 9 + length);
		for (size_t i = 0; i < length; i++) assert_int_equal(text[9 + i], 'a' + (int)code);
		ts_first_error_end(&error);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_first_error_is_kept),
		cmocka_unit_test(a_long_text_is_cut),
		cmocka_unit_test(one_error_of_many_is_kept_whole),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
