/* Options of judging commands. */
#include "cli/relaxed.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

void ts_relaxed_text(char text[TS_RELAXED_TEXT], const ts_cli *cli)
{
	const ts_judging *judging = &cli->judging;
	const ts_relaxed *r = &judging->relaxations;
	const ts_tolerances *t = &judging->tolerances;
	FILE *out = fmemopen(text, TS_RELAXED_TEXT, "w");
	text[0] = 0;
	if (out == NULL) return;
	if (r->ulp > 0) fprintf(out, " --ulp %" PRIu64, r->ulp);
	if (r->abs > 0) fprintf(out, " --abs %.17g", r->abs);
	if (r->rel > 0) fprintf(out, " --rel %.17g", r->rel);
	if (cli->given[TS_OPTION_ALLOW]) fprintf(out, " --allow %" PRIu64, r->allow);
	if (cli->given[TS_OPTION_PERCENT]) fprintf(out, " --percent %.17g", t->percent);
	if (cli->given[TS_OPTION_HARDFAIL]) fprintf(out, " --hardfail %.17g", t->hardfail);
	if (cli->given[TS_OPTION_RMSE]) fprintf(out, " --rmse %.17g", t->rmse);
	if (cli->given[TS_OPTION_EXPOSURE]) {
		fprintf(out, " --exposure %.9g", (double)TS_PARAM(&cli->job.params, image_exposure));
	}
	if (r->decided) fprintf(out, " --decided");
	if (r->ignore != NULL) fprintf(out, " --ignore %.200s", r->ignore);
	if (judging->mask != NULL) fprintf(out, " --mask %.200s", judging->mask);
	if (judging->baseline != NULL) fprintf(out, " --baseline %.200s", judging->baseline);
	if (judging->skip != NULL) fprintf(out, " --skip %.200s", judging->skip);
	fclose(out);
	if (text[0] != 0) memmove(text, text + 1, strlen(text));
	ts_line_clean(text);
}
