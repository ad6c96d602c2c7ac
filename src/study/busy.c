/* Other processes' processor time, from /proc/stat. */
#include "study/busy.h"
#include <math.h>
#include <stdio.h>
#include <sys/resource.h>
#include <unistd.h>

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
