/* The table of ground truths. A row holds all that the command, its reports and the documents know of a truth. */
#ifndef TS_TRUTH_TABLE_H
#define TS_TRUTH_TABLE_H
#include "../methods/pipeline.h"
#include "sampling.h"
#include "truth.h"

enum { TS_MAX_TRUTHS = 32 }; /* sets of them are the bits of a u32 */

/* A truth is made in one of three ways:
 * - `trace` makes what stage `image` shows, in a run of a method that made the buffers `needs`, which both read;
 * - `trace` does so in a run of its own, which `begin` starts and truths with the same `begin` share;
 * - `radiance` makes the whole picture. */
typedef struct {
	const char *name;          /* as in --truth; its picture is called "truth-NAME" */
	const char *effects;       /* whose truth it is, separated by blanks */
	const char *doc;           /* what its picture shows */
	const char *share;         /* whose error sets a method apart from it: "method", "sampling", "both", or "" */
	const char *against;       /* the truth that it is compared with itself; "": none */
	const char *against_share; /* whose error sets the two apart */
	const ts_buffer_id *needs; /* ended by TS_N_BUFFERS */
	ts_status (*begin)(ts_run *run, const char *effect);
	ts_status (*trace)(ts_truth *tree, ts_run *run, ts_sampling *sampling);
	const char *image;
	/* Adds its first rays that hit something, and the method's look-ups that are empty there; NULL: not counted. */
	ts_status (*missed)(u64 *n_hits, u64 *n_missed, ts_truth *tree, const ts_run *run, const ts_sampling *sampling);
	ts_status (*radiance)(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads,
	                      ts_sampling *sampling);
	bool (*exists)(const ts_scene *scene, const ts_params *params); /* NULL: for every scene */
	const char *why_not;                                            /* what is missing where it does not exist */
	/* How many rays its work is worth, if it cannot be made in part; NULL: it can. */
	u64 (*rays)(const ts_scene *scene, const ts_params *params);
	/* Bytes that it is estimated to need of memory beside a run of `method`; NULL: none. */
	u64 (*bytes)(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);
} ts_truth_kind;

/* Takes the truths of all families: lists ended by NULL, each ended by a row without a name. The rows must stay. */
void ts_truths_use(const ts_truth_kind *const *kinds);
/* All of them in that order, ended by NULL. The truths of one effect stand together. */
const ts_truth_kind *const *ts_truths(void);

/* Whether it can be made in a run of that method. */
bool ts_truth_starts_from(const ts_truth_kind *kind, const ts_pipeline *method);

#endif
