/* Frames of the animation, and least, mean and greatest of figures over them. */
#include "study/frames.h"
#include <math.h>

u32 ts_frames_count(const ts_frames *frames)
{
	return frames->step > 0 ? (frames->last - frames->first) / frames->step + 1 : 1;
}

void ts_frames_set(ts_params *params, const ts_frames *frames, u32 k)
{
	if (frames->step > 0) TS_PARAM_SET(params, frame, frames->first + k * frames->step);
}

void ts_frame_spread_add(ts_frame_spread *spread, double value, u32 frame)
{
	if (isnan(value)) return;
	if (spread->n == 0 || value < spread->least) {
		spread->least = value;
		spread->least_at = frame;
	}
	if (spread->n == 0 || value > spread->most) {
		spread->most = value;
		spread->most_at = frame;
	}
	spread->sum += value;
	spread->n++;
}

double ts_frame_spread_mean(const ts_frame_spread *spread) { return spread->n > 0 ? spread->sum / spread->n : NAN; }

void ts_frame_spread_cells(ts_table *table, const ts_frame_spread *spread, double mean, int decimals)
{
	ts_table_real(table, mean, decimals);
	ts_table_real(table, spread->least, decimals);
	ts_table_count(table, spread->least_at);
	ts_table_real(table, spread->most, decimals);
	ts_table_count(table, spread->most_at);
}
