/* Frames of the animation one after the other, and what figures are over them. */
#ifndef TS_CLI_FRAMES_H
#define TS_CLI_FRAMES_H
#include "job.h"
#include "table.h"

/* How many there are: 1 where none were said. */
u32 ts_frames_count(const ts_frames *frames);
/* Sets the k-th frame; the parameters keep theirs where none were said. */
void ts_frames_set(ts_params *params, const ts_frames *frames, u32 k);

/* Least, mean and greatest of a figure. Zero at first. */
typedef struct {
	double sum, least, most;
	u32 n, least_at, most_at; /* values; frames of the least and the greatest */
} ts_frame_spread;
/* NaN is no value. */
void ts_frame_spread_add(ts_frame_spread *spread, double value, u32 frame);
/* NaN of no values. */
double ts_frame_spread_mean(const ts_frame_spread *spread);

/* Its columns of a table and, of a spread that has values, their cells. */
#define TS_SPREAD_COLUMNS \
	{"mean", "mean", true}, {"least", "least", true}, {"least_at", "at frame", true}, {"most", "greatest", true}, \
	{ \
		"most_at", "at frame", true \
	}
void ts_frame_spread_cells(ts_table *table, const ts_frame_spread *spread, double mean, int decimals);

#endif
