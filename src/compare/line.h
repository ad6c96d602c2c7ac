/* The result of a comparison in words, the line of the first divergence and its parts; and as JSON. */
#ifndef TS_COMPARE_LINE_H
#define TS_COMPARE_LINE_H
#include <jansson.h>
#include "compare/compare.h"

enum { TS_DIFFERENCE_TEXT = 512, TS_FIRST_TEXT = 1152, TS_LINE_TEXT = 2048, TS_INPUTS_TEXT = 600 };

/* "pixel (35, 0), field normal[1]: ref 1 = 0x1p+0 (3f800000) candidate -1 = -0x1p+0 (bf800000) -2130706433 ulp". */
void ts_compare_difference(char text[TS_DIFFERENCE_TEXT], ts_buffer_id id, const ts_named *named);
/* The first difference of a buffer, " — first of " and the number of differences. */
void ts_compare_first(char text[TS_FIRST_TEXT], ts_buffer_id id, const ts_verdict *verdict);
/* Whether the inputs of the stage that makes a buffer were the same: "inputs identical". */
void ts_compare_inputs(char text[TS_INPUTS_TEXT], const ts_comparison *comparison, const ts_trace *reference,
                       ts_buffer_id id);
/* The line of the first divergence: stage and buffer, the first difference, and the inputs. */
void ts_compare_line(char text[TS_LINE_TEXT], const ts_comparison *comparison, const ts_trace *reference,
                     ts_buffer_id id);
/* "mirror_pixel.record: elements that differ, by field: position 12, normal 3"; whether there is anything to say. */
bool ts_compare_note(char text[TS_LINE_TEXT], ts_buffer_id id, const ts_verdict *verdict);
/* Floats from the reference's value to the candidate's; 0: they are no floats; INT64_MAX: one is a NaN. */
i64 ts_compare_ulps(ts_buffer_id id, const ts_difference *difference);
/* "missing", "not of the reference", "twice"; for two unequal values "different". */
const char *ts_compare_how(ts_how_unlike how);
/* "same", "different", ... */
const char *ts_compare_word(ts_judgement judgement);

/* Both sides, the first divergence, and each buffer that differs with its first differences; a new reference, or NULL
 * without memory. */
json_t *ts_compare_json(const ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate);

#endif
