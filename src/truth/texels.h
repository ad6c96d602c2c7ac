/* What rays say of the texels that a method looked things up in: rules of families. */
#ifndef TS_TRUTH_TEXELS_H
#define TS_TRUTH_TEXELS_H
#include "truth.h"

enum { TS_MOST_REASONS = 10 };

typedef struct {
	u64 covered; /* texels whose ray hits what the view may show */
	u64 holes;   /* of these, those that hold nothing */
	u64 leaks;   /* of these, those that hold what is farther than the hit by more than the rule allows: something shows
	              * through */
	u64 apart;  /* of these, those whose depth is not the hit's within as much, nor, where the rule asks more rays, that
	            * of any other place of the texel: leaks, and what reaches into texels */
	u32 one_of; /* of this many texels one, by a hash, was sent a ray; 0: they all were */
	u64 asked;  /* places whose shadows were asked for */
	u64 lit;    /* of these, those that the texels let through, and something stops: light leaks */
	u64 dark;   /* of these, those that the texels stop, and nothing does */

	const char *const *reasons; /* why, ended by NULL: of `lit` and `dark` each counts once. NULL: none are told */
	u64 because[TS_MOST_REASONS];
} ts_texel_counts;

/* `judge` adds to *counts what a buffer of the run's batch is like, when the stage that wrote it has run. */
typedef struct {
	ts_buffer_id buffer;
	ts_status (*judge)(ts_texel_counts *counts, ts_truth *truth, const ts_run *run, ts_buffer_id buffer);
} ts_texel_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `judge`. They must stay. */
void ts_texels_use(const ts_texel_rule *const *rules);

/* The rule of a buffer; NULL: rays do not judge it. */
const ts_texel_rule *ts_texels_find(ts_buffer_id buffer);

#endif
