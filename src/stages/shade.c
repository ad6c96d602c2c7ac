/* Shading, from the last bounce back to the eye. */
#include <stdlib.h>
#include "lookup.h"

static ts_status shade(ts_run *run, u32 bounce)
{
	const ts_bounce_buffers *own = &ts_bounce_table[bounce];
	u64 n = ts_frame_n(&run->frame, own->queue);
	ts_lookup_args args = ts_lookup_arguments(run, bounce);
	args.found = ts_frame_handle(&run->frame, own->found);
	args.follow = bounce + 1 < TS_MAX_BOUNCES && bounce + 1 < run->params.bounces;
	args.adaptive = bounce == 0 && run->params.samples == TS_SAMPLES_ADAPTIVE;
	if (args.follow) {
		args.offset = ts_frame_handle(&run->frame, ts_bounce_table[bounce + 1].offset);
		args.next_radiance = ts_frame_handle(&run->frame, ts_bounce_table[bounce + 1].radiance);
	}
	args.radiance = ts_frame_make2(&run->frame, own->radiance, n, 3);
	if (args.radiance == NULL) return TS_ERROR;
	if (bounce == 0) {
		args.used = ts_frame_make1(&run->frame, TS_B_shade_used, n);
		if (args.used == NULL) return TS_ERROR;
	}
	return ts_run_launch(run, TS_KERNEL_shade, &args, n);
}

/* Shading operations if every point were shaded once and remembered. */
static ts_status count_distinct(ts_run *run)
{
	u64 n_points = ts_frame_n(&run->frame, TS_B_points_record);
	uint8_t *seen = ts_alloc_zero(n_points, 1, "points seen");
	if (seen == NULL) return TS_ERROR;
	i64 distinct = 0;
	for (u32 bounce = 0; bounce < run->params.bounces; bounce++) {
		const u32 *found = ts_frame_data(&run->frame, ts_bounce_table[bounce].found);
		u64 n = ts_frame_n(&run->frame, ts_bounce_table[bounce].found);
		for (u64 i = 0; i < n; i++) {
			if (found[i] == TS_NONE || seen[found[i]]) continue;
			seen[found[i]] = 1;
			distinct++;
		}
	}
	free(seen);
	ts_run_count(run, "distinct points shaded", distinct);
	return TS_OK;
}

ts_status ts_stage_shade3(ts_run *run)
{
	ts_run_count(run, "shading operations",
	             (i64)(ts_frame_n(&run->frame, TS_B_lookup3_parent) * TS_N_BOUNCE_SAMPLES));
	return shade(run, 2);
}

ts_status ts_stage_shade2(ts_run *run)
{
	ts_run_count(run, "shading operations",
	             (i64)(ts_frame_n(&run->frame, TS_B_lookup2_parent) * TS_N_BOUNCE_SAMPLES));
	return shade(run, 1);
}

ts_status ts_stage_shade(ts_run *run)
{
	if (shade(run, 0) != TS_OK) return TS_ERROR;
	const u32 *used = ts_frame_data(&run->frame, TS_B_shade_used);
	u64 n = ts_frame_n(&run->frame, TS_B_shade_used);
	i64 operations = 0;
	for (u64 i = 0; i < n; i++) operations += used[i];
	ts_run_count(run, "shading operations", operations);
	return count_distinct(run);
}
