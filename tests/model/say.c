/* Who hears of the work, and who ends it. */
#include <pthread.h>
#include "model/core.h"
#include "tests/model/test.h"
#include "tests/status.h"

static int asked, yes_at;

static int cancelled(void *user)
{
	(void)user;
	return ++asked == yes_at;
}

static void listen(int yes)
{
	asked = 0;
	yes_at = yes;
	ts_listen(&(ts_listener){.cancelled = cancelled});
}

static int deaf(void **state)
{
	(void)state;
	ts_listen(&(ts_listener){.cancelled = NULL});
	return 0;
}

static void nobody_stops_what_nobody_can_cancel(void **state)
{
	(void)state;
	assert_null(ts_stop_here());
	assert_false(ts_stopped(NULL) || ts_cancelled());
	assert_int_equal(ts_go_on(), TS_OK);
}

/* Who has said yes is not asked again, until somebody listens anew. */
static void a_yes_is_kept(void **state)
{
	(void)state;
	listen(2);
	assert_false(ts_cancelled());
	assert_int_equal(ts_go_on(), TS_OK);
	assert_true(ts_cancelled() && ts_cancelled() && ts_stopped(ts_stop_here()));
	assert_int_equal(asked, 2);
	assert_int_equal(ts_go_on(), TS_ERROR);
	says("cancelled");
	assert_int_equal(ts_error_kind(), TS_KIND_CANCELLED);
	listen(0);
	assert_false(ts_stopped(ts_stop_here()));
	assert_int_equal(ts_go_on(), TS_OK);
}

/* Turns of a loop until it is stopped. */
static void *turn(void *stop)
{
	while (!ts_stopped(stop)) continue;
	return NULL;
}

/* A loop of two threads ends, though one of them alone may ask; and that one asks now and then. */
static void one_thread_asks_for_all(void **state)
{
	(void)state;
	pthread_t other;
	listen(4);
	ts_stop *stop = ts_stop_here();
	assert_int_equal(pthread_create(&other, NULL, turn, stop), 0);
	uint64_t turns = 0;
	while (!ts_stopped(stop)) turns++;
	assert_int_equal(pthread_join(other, NULL), 0);
	assert_int_equal(asked, 4);
	assert_true(turns > 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_teardown(nobody_stops_what_nobody_can_cancel, deaf),
		cmocka_unit_test_teardown(a_yes_is_kept, deaf),
		cmocka_unit_test_teardown(one_thread_asks_for_all, deaf),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
