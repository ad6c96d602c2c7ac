/* Whether a machine is quiet enough to be timed: other processes' processor time, from /proc/stat, and a loop that
 * slows down. */
#include "study/busy.h"
#include <math.h>
#include <stdio.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>
#include "study/speed_work.h"

#define SHARE 0.1 /* of the processors */

/* User, nice, system, interrupts and steal time, which the first line counts in ticks, with idle time between them. */
static bool read_all(double *seconds)
{
	double user, nice, system, idle, waits, hard, soft, stolen;
	FILE *in = fopen("/proc/stat", "r");
	if (in == NULL) return false;
	int n =
		fscanf(in, "cpu %lf %lf %lf %lf %lf %lf %lf %lf", &user, &nice, &system, &idle, &waits, &hard, &soft, &stolen);
	fclose(in);
	*seconds = (user + nice + system + hard + soft + stolen) / (double)sysconf(_SC_CLK_TCK);
	return n == 8;
}

static double used(int who)
{
	struct rusage use;
	if (getrusage(who, &use) != 0) return 0;
	return (double)use.ru_utime.tv_sec + (double)use.ru_stime.tv_sec +
	       1e-6 * ((double)use.ru_utime.tv_usec + (double)use.ru_stime.tv_usec);
}

ts_busy ts_busy_now(void)
{
	ts_busy now = {.seconds = ts_seconds(), .own = used(RUSAGE_SELF) + used(RUSAGE_CHILDREN)};
	now.known = read_all(&now.all);
	return now;
}

/* Each processor's count is off by a tick at either reading. */
static double slack(void) { return 2 * (double)sysconf(_SC_NPROCESSORS_ONLN) / (double)sysconf(_SC_CLK_TCK); }

double ts_busy_others(const ts_busy *before, const ts_busy *after)
{
	double seconds = after->seconds - before->seconds;
	if (!before->known || !after->known || !(seconds > 0)) return NAN;
	return fmax(((after->all - before->all) - (after->own - before->own) - slack()) / seconds, 0);
}

double ts_busy_limit(void) { return SHARE * (double)sysconf(_SC_NPROCESSORS_ONLN); }

#define SLOWER 1.1 /* than the best loop is not quiet */
#define LOAD 0.5   /* of the last minute, per processor */

enum { STEPS = 1 << 21, LOOPS = 3, FIRST_LOOPS = 20 };

static volatile u64 kept; /* keeps the loop from being optimized away */

/* One loop by each thread, of dependent steps: the slowest thread's seconds. */
static double loop(u32 threads)
{
	double slowest = 0;
	u64 all = kept;
#pragma omp parallel for num_threads((int)threads) schedule(static, 1) reduction(max : slowest) reduction(^ : all)
	for (u32 t = 0; t < threads; t++) {
		double begin = ts_seconds();
		u64 x = t + 1;
		for (u32 i = 0; i < STEPS; i++) {
			x ^= x << 13;
			x ^= x >> 7;
			x ^= x << 17;
		}
		all ^= x;
		slowest = ts_seconds() - begin;
	}
	kept = all;
	return slowest;
}

static double best_of(u32 loops, u32 threads)
{
	double best = INFINITY;
	for (u32 i = 0; i < loops; i++) best = fmin(best, loop(threads));
	return best;
}

/* Of the last minute; NAN where the system does not report it. */
static double load_now(void)
{
	double load;
	FILE *in = fopen("/proc/loadavg", "r");
	if (in == NULL) return NAN;
	bool read = fscanf(in, "%lf", &load) == 1;
	fclose(in);
	return read ? load : NAN;
}

static double others_now(void)
{
	const struct timespec half = {.tv_nsec = 500000000};
	ts_busy before = ts_busy_now();
	nanosleep(&half, NULL);
	ts_busy after = ts_busy_now();
	return ts_busy_others(&before, &after);
}

ts_status ts_quiet_begin(ts_quiet *quiet, ts_report *report, u32 threads, bool anyway)
{
	u32 processors = ts_processors();
	double others = others_now(), load = load_now(), most_load = LOAD * processors;
	*quiet = (ts_quiet){.threads = threads, .best = best_of(FIRST_LOOPS, threads), .anyway = anyway};
	bool busy = others > ts_busy_limit() || load > most_load;
	ts_report_line(report,
	               "quiet: load %.2f, at most %.2f; others use %.2f of %u processors, at most %.2f; a loop of %.2f ms "
	               "takes at most %.2f ms before and behind each row",
	               load, most_load, others, (unsigned)processors, ts_busy_limit(), 1e3 * quiet->best,
	               1e3 * SLOWER * quiet->best);
	ts_report_timed(report, "quiet",
	                json_pack("{sf sf sf sf sf sb}", "load", isnan(load) ? -1 : load, "load_limit", most_load, "others",
	                          isnan(others) ? -1 : others, "others_limit", ts_busy_limit(), "loop_ms",
	                          1e3 * quiet->best, "busy", (int)anyway));
	if (anyway) ts_report_line(report, "BUSY: --busy measures whatever else the machine does; nothing is judged");
	if (!busy || anyway) return TS_OK;
	return ts_fail(
		"bench speed: the machine is busy: load %.2f, at most %.2f, and others use %.2f of %u processors, at "
		"most %.2f; wait a minute, or write --busy, and nothing is judged",
		load, most_load, others, (unsigned)processors, ts_busy_limit());
}

static bool is_slow(const ts_quiet *quiet) { return best_of(LOOPS, quiet->threads) > SLOWER * quiet->best; }

void ts_quiet_before(ts_quiet *quiet)
{
	quiet->slow = is_slow(quiet);
	quiet->before = ts_busy_now();
}

bool ts_quiet_after(ts_quiet *quiet)
{
	ts_busy after = ts_busy_now();
	bool others = ts_busy_others(&quiet->before, &after) > ts_busy_limit();
	bool busy = quiet->slow || others || is_slow(quiet);
	quiet->n_busy += busy;
	return !busy && !quiet->anyway;
}
