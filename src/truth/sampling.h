/* Truths by a limited number of rays, params.truth_rays (METHODS 17). A truth that would take more rays is made twice:
 * at every pixel by some of its items (samples of lights, directions, points of light), which gives the picture; and at
 * pixels chosen by a hash by all items, which gives the figures. Numbers of items and pixels follow from counts alone,
 * so that two runs, by any number of threads, give the same. */
#ifndef TS_TRUTH_SAMPLING_H
#define TS_TRUTH_SAMPLING_H
#include "kernels/base/compat.h"
#include "methods/stage.h"

/* Progress of work by rays that may take long, and once an estimate of its duration, by the time of the first rays. The
 * clock has no effect on results. */

typedef struct {
	const char *label;
	u64 rays; /* of the whole work; 0: it casts none */
	double begin;
	bool reported;
} ts_work;

ts_work ts_work_begin(const char *label, u64 rays);
/* Notes that `done` of `all` is done. Prints on standard error an estimated duration of at least 10 s. */
void ts_work_at(ts_work *work, u64 done, u64 all);
void ts_work_end(const ts_work *work);

/* The items that a pixel asks: all, or one at random of each of `asked` parts of nearly equal size. */
typedef struct {
	u64 items, asked;
	u32 pixel, seed;
} ts_share;

/* The j-th, below `items`; ascending. */
u64 ts_share_item(const ts_share *share, u64 j);

typedef struct {
	u64 rays;   /* params.truth_rays; 0: all */
	u32 pixels; /* of the picture; pictures of further samples follow, one below the other */
	u32 seed;
	bool chosen;     /* true: now the chosen pixels ask all items; false: now every pixel asks some */
	u64 items, some; /* items of a pixel, and those that the picture asks: all, if the truth is made whole */
	u32 chance;      /* in 2^-32, that a pixel is chosen */
} ts_sampling;

ts_sampling ts_sampling_of(const ts_params *params);
/* Shares out the rays, half to the picture and half to the chosen pixels; an item takes `each` rays. */
void ts_sampling_plan(ts_sampling *sampling, u64 pixels, u64 items, u64 each);
/* Whether some items are left out. */
bool ts_sampling_is_part(const ts_sampling *sampling);
/* Whether a pixel is chosen, by its index and the seed alone: a pixel chosen at a smaller chance is chosen at a greater
 * one. The samples of a pixel are chosen together. */
bool ts_sampling_chooses(const ts_sampling *sampling, u32 pixel);

enum { TS_ASKED = 16 }; /* pixels that are asked together */

/* The work of a truth at its pixels. */
typedef struct {
	const char *label;
	u64 n;                                 /* things that may belong to a pixel */
	u64 items, each;                       /* of a pixel; rays of an item, 0: it takes none */
	u32 (*pixel)(const void *user, u64 i); /* its index in the image; TS_NONE: there is nothing to ask */
	void (*ask)(const void *user, u64 i, const ts_share *share);
	const void *user;
	u32 threads;
	/* Instead of `ask`: asks n things together, at most TS_ASKED, whose rays go in packets; NULL: asked one by one. */
	void (*ask_all)(const void *user, const u64 *i, const ts_share *shares, u32 n);
} ts_truth_asked;

/* Asks by all threads. sampling: its plan follows from `asked`; NULL: all items of every pixel are asked. */
void ts_truth_ask(const ts_truth_asked *asked, ts_sampling *sampling);

#endif
