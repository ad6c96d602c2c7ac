/* Look-ups of the first bounce, and queue and look-ups of each later one. */
#include <inttypes.h>
#include "lookup.h"

const ts_bounce_buffers ts_bounce_table[TS_MAX_BOUNCES] = {
	{TS_N_BUFFERS, TS_B_pixel_record, TS_B_lookup_point, TS_B_shade_radiance},
	{TS_B_lookup2_offset, TS_B_lookup2_parent, TS_B_lookup2_point, TS_B_shade2_radiance},
	{TS_B_lookup3_offset, TS_B_lookup3_parent, TS_B_lookup3_point, TS_B_shade3_radiance},
};

ts_lookup_args ts_lookup_arguments(const ts_run *run, u32 bounce)
{
	const ts_bounce_buffers *own = &ts_bounce_table[bounce];
	return (ts_lookup_args){
		.scene = ts_run_arrays(run),
		.cubes = ts_frame_handle(&run->frame, TS_B_resize_face),
		.pieces = ts_frame_handle(&run->frame, TS_B_split_triangle),
		.frames = ts_frame_handle(&run->frame, TS_B_align_frame),
		.keys = ts_frame_handle(&run->frame, TS_B_points_key),
		.points = ts_frame_handle(&run->frame, TS_B_points_record),
		.pixels = ts_frame_handle(&run->frame, TS_B_pixel_record),
		.queue = bounce > 0 ? ts_frame_handle(&run->frame, own->queue) : NULL,
		.n_samples = bounce > 0 ? TS_N_BOUNCE_SAMPLES : TS_N_SAMPLES,
		.first = bounce == 0,
	};
}

static void count_empty(ts_run *run, ts_buffer_id id)
{
	const u32 *found = ts_frame_data(&run->frame, id);
	u64 n = ts_frame_n(&run->frame, id);
	i64 empty = 0;
	for (u64 i = 0; i < n; i++) empty += found[i] == TS_NONE;
	ts_run_count(run, "look-ups", (i64)n);
	ts_run_count(run, "empty look-ups", empty);
}

static ts_status look_up(ts_run *run, ts_lookup_args *args, u32 bounce, ts_kernel kernel)
{
	u64 n = ts_frame_n(&run->frame, ts_bounce_table[bounce].queue);
	args->texels = ts_frame_handle(&run->frame, TS_B_splat_depth_index);
	args->found = ts_frame_make2(&run->frame, ts_bounce_table[bounce].found, n, args->n_samples);
	if (args->found == NULL) return TS_ERROR;
	if (ts_run_launch(run, kernel, args, n) != TS_OK) return TS_ERROR;
	count_empty(run, ts_bounce_table[bounce].found);
	return TS_OK;
}

ts_status ts_stage_lookup(ts_run *run)
{
	ts_lookup_args args = ts_lookup_arguments(run, 0);
	args.view = ts_frame_handle(&run->frame, TS_B_eye_view);
	return look_up(run, &args, 0, TS_KERNEL_lookup);
}

/* The queue of a bounce: the samples of the one before that see a mirror. */
static ts_status make_queue(ts_run *run, u32 bounce)
{
	ts_lookup_args before = ts_lookup_arguments(run, bounce - 1);
	before.found = ts_frame_handle(&run->frame, ts_bounce_table[bounce - 1].found);
	u64 n = ts_frame_n(&run->frame, ts_bounce_table[bounce - 1].found);
	if (n >= TS_NONE) return ts_fail("%" PRIu64 " samples are more than 32-bit indices can name; take a smaller image", n);
	before.offset = ts_frame_make1(&run->frame, ts_bounce_table[bounce].offset, n + 1);
	if (before.offset == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_bounce_count, &before, n) != TS_OK) return TS_ERROR;
	u64 total;
	if (ts_run_scan(run, ts_bounce_table[bounce].offset, &total) != TS_OK) return TS_ERROR;
	before.next_queue = ts_frame_make1(&run->frame, ts_bounce_table[bounce].queue, total);
	if (before.next_queue == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_bounce_queue, &before, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "later look-ups", (i64)total);
	return TS_OK;
}

static ts_status bounce_stage(ts_run *run, u32 bounce)
{
	if (make_queue(run, bounce) != TS_OK) return TS_ERROR;
	ts_lookup_args args = ts_lookup_arguments(run, bounce);
	return look_up(run, &args, bounce, TS_KERNEL_bounce);
}

ts_status ts_stage_lookup2(ts_run *run) { return bounce_stage(run, 1); }
ts_status ts_stage_lookup3(ts_run *run) { return bounce_stage(run, 2); }
