/* Truths by a limited number of rays, params.truth_rays (METHODS 17). If all rays of a truth are more, it is made
 * twice: at every pixel by some of its items (samples of lights, directions, points of light), which gives the
 * picture; and at pixels chosen by a hash by all of them, which gives the figures. Counts alone say how many, so that
 * two runs, by whatever threads, give the same. */
#ifndef TS_TRUTH_SAMPLING_H
#define TS_TRUTH_SAMPLING_H
#include "../methods/stage.h"

/* Which of its items a pixel asks: all, or one at random of each of `asked` parts, as equal as may be. */
typedef struct {
	u64 items, asked;
	u32 pixel, seed;
} ts_share;

/* The j-th, below `items`; ascending. */
u64 ts_share_item(const ts_share *share, u64 j);

typedef struct {
	u64 rays;   /* params.truth_rays; 0: all */
	u32 pixels; /* of the picture; those of further samples follow one picture below the other */
	u32 seed;
	bool chosen;     /* what is asked now: the chosen pixels, all of their items; else every pixel, some of them */
	u64 items, some; /* of a pixel, and how many the picture has; as many, if the truth is made whole */
	u32 chance;      /* in 2^-32, that a pixel is chosen */
} ts_sampling;

ts_sampling ts_sampling_of(const ts_params *params);
/* Shares the rays out, half to the picture and half to the chosen pixels: `each` rays an item. */
void ts_sampling_plan(ts_sampling *sampling, u64 pixels, u64 items, u64 each);
/* Some items were left out. */
bool ts_sampling_is_part(const ts_sampling *sampling);
/* By the pixel's index and the seed alone: what a smaller chance chooses, a greater one does. The samples of a pixel
 * are chosen together. */
bool ts_sampling_chooses(const ts_sampling *sampling, u32 pixel);

enum { TS_ASKED = 16 }; /* pixels that are asked together */

/* What a truth asks at its pixels. */
typedef struct {
	const char *label;
	u64 n;                                 /* of what may have a pixel */
	u64 items, each;                       /* of a pixel; rays of an item, 0: it takes none */
	u32 (*pixel)(const void *user, u64 i); /* its index in the image; TS_NONE: there is nothing to ask */
	void (*ask)(const void *user, u64 i, const ts_share *share);
	const void *user;
	u32 threads;
	/* Instead of `ask`: of n of them together, at most TS_ASKED, whose rays go in packets; NULL: one by one. */
	void (*ask_all)(const void *user, const u64 *i, const ts_share *shares, u32 n);
} ts_truth_asked;

/* Asks, by all threads. sampling, NULL: all items of every pixel; its plan follows from `asked`. */
void ts_truth_ask(const ts_truth_asked *asked, ts_sampling *sampling);

#endif
