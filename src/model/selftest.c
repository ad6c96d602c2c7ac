/* Whether this process computes as the numeric contract requires (CONTRACT rule 8): here, and in each object with a
 * self-test. */
#include "model/selftest.h"
#include <stdio.h>
#include "model/core.h"

/* For the bits of an answer, in their order. */
static const char *const names[] = {
	"multiply-add (contracted to FMA)",
	"tiny results (flushed to zero)",
	"tiny operands (read as zero)",
	"rounding (not to nearest even)",
	"addition (re-associated)",
	"division (not correctly rounded)",
	"square root (not correctly rounded)",
	"right shift of a negative (not arithmetic)",
	"integer to float (not to nearest even)",
	"signed zero (lost)",
	"not-a-number (taken for a number)",
	"arithmetic of vectors (not that of single floats)",
};

TS_SELFTEST_OF(__BASE_FILE__, ts_selftest_all)

__attribute__((visibility("hidden"))) extern const ts_selftest_of __start_ts_selftests[], __stop_ts_selftests[];

/* Faults on any thread: here, and in the first file with a fault. */
typedef struct {
	unsigned here, there;
	const ts_selftest_of *first;
} answer;

static void ask_here(answer *r)
{
	for (const ts_selftest_of *of = __start_ts_selftests; of < __stop_ts_selftests; of++) {
		unsigned bad = of->bad();
		if (bad == 0) continue;
#pragma omp critical
		{
			r->here |= of->bad == ts_selftest_all ? bad : 0;
			if (r->first == NULL || of < r->first) *r = (answer){.here = r->here, .first = of};
			r->there |= of == r->first ? bad : 0;
		}
	}
}

static answer ask(uint32_t threads)
{
	answer r = {0};
	if (threads <= 1) {
		ask_here(&r);
		return r;
	}
#pragma omp parallel num_threads((int)threads)
	ask_here(&r);
	return r;
}

unsigned ts_selftest(void)
{
	answer r = ask(ts_threads_all());
	return r.here | r.there;
}

static void name(char *text, size_t text_bytes, unsigned bad)
{
	for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
		if (bad >> i & 1) {
			size_t used = strlen(text);
			snprintf(text + used, text_bytes - used, "%s%s", used ? ", " : "", names[i]);
		}
	}
}

ts_status ts_selftest_require(void) { return ts_selftest_require_on(ts_threads_all()); }

ts_status ts_selftest_require_on(uint32_t threads)
{
	answer r = ask(threads);
	if (r.first == NULL) return TS_OK;
	char text[512] = "";
	name(text, sizeof text, r.here != 0 ? r.here : r.there);
	return ts_fail_as(TS_KIND_DEVICE,
	                  "self-test: %s breaks the numeric contract in %s; build with the flags of the Makefile and leave "
	                  "the floating-point environment at its default",
	                  r.here != 0 ? "this build or process" : r.first->file, text);
}
