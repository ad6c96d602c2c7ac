/* Who keeps the machine busy: another process counts, this one and its children that ended do not. */
#include <math.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include "study/busy.h"
#include "tests/model/test.h"

/* Takes so many seconds of a core, however long it waits for one. */
static void spin(double seconds)
{
	double end = (double)clock() + seconds * CLOCKS_PER_SEC;
	while ((double)clock() < end) continue;
}

static double own_of(const ts_busy *a, const ts_busy *b) { return b->own - a->own; }

static void another_process_counts_as_busy(void **state)
{
	(void)state;
	ts_busy before = ts_busy_now();
	if (!before.known) skip();
	pid_t child = fork();
	assert_true(child >= 0);
	if (child == 0) {
		spin(0.8);
		_exit(0);
	}
	nanosleep(&(struct timespec){.tv_nsec = 600 * 1000 * 1000}, NULL);
	ts_busy meanwhile = ts_busy_now();
	assert_true(own_of(&before, &meanwhile) < 0.1);
	assert_true(ts_busy_others(&before, &meanwhile) > 0.3);
	assert_int_equal(waitpid(child, NULL, 0), child);
	ts_busy after = ts_busy_now();
	assert_true(own_of(&before, &after) > 0.4); /* it ended, and was ours */
}

/* The work of this process is in the system's count, and not others'. */
static void own_work_does_not_count(void **state)
{
	(void)state;
	ts_busy before = ts_busy_now();
	if (!before.known) skip();
	spin(0.5);
	ts_busy after = ts_busy_now();
	double all = after.all - before.all, own = own_of(&before, &after);
	assert_true(own > 0.1 && all > own - 0.1);
	assert_true(ts_busy_others(&before, &after) <= fmax(all - own, 0) / (after.seconds - before.seconds));
}

static void ticks_say_nothing_of_a_moment(void **state)
{
	(void)state;
	double tick = 1 / (double)sysconf(_SC_CLK_TCK), n = (double)sysconf(_SC_NPROCESSORS_ONLN);
	ts_busy before = {.known = true}, moment = {.known = true, .seconds = tick / 2, .all = tick};
	ts_busy second = {.known = true, .seconds = 1, .all = 2 * n * tick + 0.75, .own = 0.25};
	assert_true(ts_busy_others(&before, &moment) == 0);
	assert_float_equal(ts_busy_others(&before, &second), 0.5, 1e-9);
}

static void an_unknown_count_says_nothing(void **state)
{
	(void)state;
	ts_busy none = {.known = false}, now = ts_busy_now();
	assert_true(isnan(ts_busy_others(&none, &now)) && isnan(ts_busy_others(&now, &now)));
	assert_true(ts_busy_limit() >= 0.1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(another_process_counts_as_busy),
		cmocka_unit_test(own_work_does_not_count),
		cmocka_unit_test(ticks_say_nothing_of_a_moment),
		cmocka_unit_test(an_unknown_count_says_nothing),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
