/* A sequence of frames of the animation, and the spread of figures over it. */
#ifndef TS_STUDY_FRAMES_H
#define TS_STUDY_FRAMES_H
#include "study/asked/job.h"
#include "study/results/table.h"

/* The number of frames; 1 without --frames. */
u32 ts_frames_count(const ts_frames *frames);
/* Sets the parameter `frame` to the k-th frame; without --frames does nothing. */
void ts_frames_set(ts_params *params, const ts_frames *frames, u32 k);

/* Least, mean and greatest of a figure. To be zero before the first value. */
typedef struct {
	double sum, least, most;
	u32 n, least_at, most_at; /* values; frames of the least and the greatest */
} ts_frame_spread;
/* Adds a value of a frame; NaN is ignored. */
void ts_frame_spread_add(ts_frame_spread *spread, double value, u32 frame);
/* The mean; NaN if there are no values. */
double ts_frame_spread_mean(const ts_frame_spread *spread);

/* The columns of a spread in a table, and their cells for a spread that has values. */
#define TS_SPREAD_COLUMNS \
	{"mean", "mean", true}, {"least", "least", true}, {"least_at", "at frame", true}, {"most", "greatest", true}, \
	{ \
		"most_at", "at frame", true \
	}
void ts_frame_spread_cells(ts_table *table, const ts_frame_spread *spread, double mean, int decimals);

#endif
