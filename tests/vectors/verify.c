/* The arithmetic vectors on a backend: C's is right, one that errs in a primitive is named, and what fails is told. */
#include "tests/status.h"
#include "vectors/vectors.h"

static enum { RIGHT, WRONG, NO_LAUNCH, NO_FETCH } way;
static ts_c_backend in_c;
static u32 n_launches;

static ts_status fetch(void *resident)
{
	(void)resident;
	return ts_fail("the device was lost");
}

static void release(void *resident) { (void)resident; }

static const ts_residence lost = {fetch, release};

/* As in C; then the third primitive's first bit is wrong, or what it made cannot be had. */
static ts_status launch(ts_backend *backend, ts_frame *frame, const ts_launch *of, const void *args, u64 n)
{
	(void)backend;
	bool third = ++n_launches == 3;
	if (third && way == NO_LAUNCH) return ts_fail("the device is busy");
	ts_status status = in_c.backend.launch(&in_c.backend, frame, of, args, n);
	if (third && way == WRONG) *(u8 *)frame->lent[TS_WORK_other].data ^= 1;
	if (third && way == NO_FETCH) {
		frame->residence = &lost;
		frame->lent[TS_WORK_other].resident = &in_c;
	}
	return status;
}

static ts_status verified(u32 as, bool inexact)
{
	ts_c_begin(&in_c, 2);
	ts_c_backend backend = in_c;
	backend.backend.launch = launch;
	n_launches = 0;
	way = as;
	return ts_vectors_verify(&backend.backend, inexact);
}

static void refuses(u32 as, const char *words) { refused(verified(as, false), words); }

static void a_backend_that_errs_is_named(void **state)
{
	(void)state;
	char words[64];
	assert_int_equal(verified(RIGHT, false), TS_OK);
	assert_true(n_launches > 20);
	u32 first = 0; /* the third that is no composite */
	for (u32 seen = ts_vectors_place(0).composed ? 0 : 1; seen < 3; seen += !ts_vectors_place(++first).composed)
		continue;
	snprintf(words, sizeof words, "in 1 primitives: %s (1 of ", ts_vectors_at(first)->name);
	refuses(WRONG, words);
	assert_int_equal(verified(WRONG, true), TS_OK);
	refuses(NO_LAUNCH, "the device is busy");
	refuses(NO_FETCH, "the device was lost");
}

static void composites_are_verified_on_a_backend(void **state)
{
	(void)state;
	ts_c_begin(&in_c, 2);
	ts_c_backend backend = in_c;
	backend.backend.launch = launch;
	n_launches = 0;
	way = RIGHT;
	assert_int_equal(ts_vectors_verify_composites(&backend.backend), TS_OK);
	n_launches = 0;
	way = NO_FETCH;
	assert_int_equal(ts_vectors_verify_composites(&backend.backend), TS_ERROR);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(a_backend_that_errs_is_named),
	                                   cmocka_unit_test(composites_are_verified_on_a_backend)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
