/* The ground truths that --truth names. */
#ifndef TS_CLI_TRUTHS_H
#define TS_CLI_TRUTHS_H
#include "cli.h"

typedef struct {
	const char *name;    /* as typed */
	const char *picture; /* name of its picture: "truth-a" */
	const char *doc;     /* what that shows */
	const char *share;   /* whose error a method is apart from it by: "method", "sampling", "both" or "" */
	const char *of;      /* "reflections", "shadows", "indirect", "particles" or "surfels", which names of effects contain */
} ts_truth_kind;

/* At TS_AT_*. */
extern const ts_truth_kind ts_truth_kinds[TS_N_TRUTHS];

/* Reads a comma-separated list of names; NULL: each truth that the effect has; "none": none. */
ts_status ts_truths_parse(u32 *truths, const char *text);
/* Leaves the truths of `effect` only, if each was asked for; else fails on the first that it does not have. */
ts_status ts_truths_check(u32 *truths, const char *effect);
/* The text names truths and nothing else. */
bool ts_truths_named(const char *text);

#endif
