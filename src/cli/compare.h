/* What a comparison says, in each of its forms. */
#ifndef TS_CLI_COMPARE_H
#define TS_CLI_COMPARE_H
#include "../compare/compare.h"
#include "cli.h"
#include "../study/table.h"

enum { TS_LINE_TEXT = 2048 };

/* The line that can be pasted: stage, buffer, key, field, both values, distance, how many, and whether the stage's
 * inputs were the same. Of a buffer that is unlike. */
void ts_compare_line(char text[TS_LINE_TEXT], const ts_comparison *comparison, const ts_trace *reference,
                     ts_buffer_id id);
/* A row a buffer, the verdict, and the line of the first divergence; as text and as JSON. */
void ts_compare_report(ts_report *report, const ts_comparison *comparison, const ts_trace *reference,
                       const ts_trace *candidate, const ts_judging *judging);
/* A line a stage, in Test Anything Protocol. */
void ts_compare_tap(const ts_comparison *comparison, const ts_trace *reference, FILE *out);
/* JUnit XML, a uniquely named case a stage. */
ts_status ts_compare_junit(const ts_comparison *comparison, const ts_trace *reference, const char *path);

#endif
