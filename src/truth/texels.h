/* Judges by rays the texels in which a method looks things up, by rules of families. */
#ifndef TS_TRUTH_TEXELS_H
#define TS_TRUTH_TEXELS_H
#include "truth/truth.h"

enum { TS_MOST_REASONS = 10 };

typedef struct {
	u64 covered; /* texels whose ray hits what the view may show */
	u64 holes;   /* of `covered`, those that hold nothing */
	u64 leaks;   /* of `covered`, those whose depth is farther than the hit by more than the rule allows: something
	              * shows through */
	u64 apart;   /* of `covered`, those whose depth is, within the same tolerance, neither the hit's nor, where the rule
	              * casts more rays, that of another place of the texel: leaks, and surfaces that reach into texels */
	u32 one_of;  /* a ray was cast for one texel in so many, chosen by a hash; 0: for all */
	u64 asked;   /* places whose shadows were judged */
	u64 lit;     /* of `asked`, those lit by the texels although something stops the ray: light leaks */
	u64 dark;    /* of `asked`, those in shadow by the texels although nothing stops the ray */

	const char *const *reasons; /* ended by NULL; each of `lit` and `dark` counts for one. NULL: none are told */
	u64 because[TS_MOST_REASONS];
} ts_texel_counts;

/* A rule: `judge` adds the counts of a buffer of the run's batch to *counts, when the stage that wrote the buffer has
 * run. */
typedef struct {
	ts_buffer_id buffer;
	ts_status (*judge)(ts_texel_counts *counts, ts_truth *truth, const ts_run *run, ts_buffer_id buffer);
} ts_texel_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `judge`. They must stay. */
void ts_texels_use(const ts_texel_rule *const *rules);

/* The rule of a buffer; NULL: rays do not judge it. */
const ts_texel_rule *ts_texels_find(ts_buffer_id buffer);

#endif
