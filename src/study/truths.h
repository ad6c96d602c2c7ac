/* Finds the ground truths that --truth names. */
#ifndef TS_STUDY_TRUTHS_H
#define TS_STUDY_TRUTHS_H
#include "kernels/base/compat.h"
#include "truth/table.h"

/* The truth of that name and effect (NULL: of any effect); NULL: there is none. */
const ts_truth_kind *ts_truths_one(const char *name, const char *effect);
/* The truths of `effect` that the comma-separated `names` name, each as the bit of its row in ts_truths; NULL or
 * "all": all of them; "none": none. Fails on the first name that is no truth of the effect. */
ts_status ts_truths_find(u32 *truths, const char *effect, const char *names);
/* The bit of a row of ts_truths in a set of truths. */
u32 ts_truth_bit(const ts_truth_kind *kind);
/* Whether all names of the text are truths, of any effects. */
bool ts_truths_named(const char *text);
/* Writes the names of the effect's truths, with `last` between the last two: "A, B and C". */
void ts_truths_list(char *text, size_t bytes, const char *effect, const char *last);

#endif
