/* The ground truths: a table, whose rows hold all that the command, its reports and the documents know of a truth; and
 * those of them that --truth names. */
#ifndef TS_STUDY_ASKED_TRUTHS_H
#define TS_STUDY_ASKED_TRUTHS_H
#include "methods/pipeline.h"
#include "truth/sampling.h"
#include "truth/truth.h"

enum { TS_MAX_TRUTHS = 32 }; /* sets of truths are the bits of a u32 */

/* A truth is made in one of three ways:
 * - `trace` makes what stage `image` shows, in a run of a method that made the buffers `needs`, which both read;
 * - `trace` does so in a run of its own, which `begin` starts and truths with the same `begin` share;
 * - `radiance` makes the whole picture. */
typedef struct {
	const char *name;          /* as in --truth; its picture is called "truth-NAME" */
	const char *effects;       /* whose truth it is, separated by blanks */
	const char *doc;           /* what its picture shows */
	const char *share;         /* whose error separates a method from this truth: "method", "sampling", "both", or "" */
	const char *against;       /* the truth with which this truth is compared; "": none */
	const char *against_share; /* whose error separates the two truths */
	const ts_buffer_id *needs; /* ended by TS_N_BUFFERS */
	ts_status (*begin)(ts_run *run, const char *effect);
	ts_status (*trace)(ts_truth *tree, ts_run *run, ts_sampling *sampling);
	const char *image;
	/* Counts the truth's first rays that hit something, and the method's look-ups that are empty there; adds to *n_hits
	 * and *n_missed. NULL: not counted. */
	ts_status (*missed)(u64 *n_hits, u64 *n_missed, ts_truth *tree, const ts_run *run, const ts_sampling *sampling);
	ts_status (*radiance)(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads,
	                      ts_sampling *sampling);
	bool (*exists)(const ts_scene *scene, const ts_params *params); /* NULL: for every scene */
	const char *why_not;                                            /* what is missing where the truth does not exist */
	/* Of a truth that cannot be made in part: the number of rays to which its work amounts; NULL: it can be made in
	 * part. */
	u64 (*rays)(const ts_scene *scene, const ts_params *params);
	/* The estimated bytes of memory that the truth needs beside a run of `method`; NULL: none. */
	u64 (*bytes)(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);
} ts_truth_kind;

/* Takes the truths of all families: lists ended by NULL, each ended by a row without a name. The rows must stay. */
void ts_truths_use(const ts_truth_kind *const *kinds);
/* All truths in that order, ended by NULL. The truths of one effect stand together. */
const ts_truth_kind *const *ts_truths(void);

/* Whether a truth can be made in a run of that method. */
bool ts_truth_starts_from(const ts_truth_kind *kind, const ts_pipeline *method);

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
