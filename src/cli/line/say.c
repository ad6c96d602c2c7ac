/* Messages beside results and failures, on standard error: lines, and progress as one line that rewrites itself, on a
 * terminal only. */
#include <stdio.h>
#include <unistd.h>
#include "cli/line/cli.h"

/* Ten times per second is enough for an eye. */
static const double interval = 0.1;

static _Thread_local double last;

void ts_cli_progress(void *user, const char *label, uint64_t done, uint64_t total)
{
	(void)user;
	if (!isatty(STDERR_FILENO)) return;
	if (done >= total) {
		fputs("\r\033[K", stderr);
		last = 0;
	} else if (ts_seconds() - last >= interval) {
		double percent = 100.0 * (double)done / (double)total;
		fprintf(stderr, "\r\033[K%s: %.0f %%", label, percent);
		last = ts_seconds();
	}
	fflush(stderr);
}

void ts_cli_say(void *user, const char *line)
{
	(void)user;
	fprintf(stderr, "%s: %s\n", ts_program, line);
}

void ts_cli_listen(void) { ts_listen(&(ts_listener){.line = ts_cli_say, .progress = ts_cli_progress}); }
