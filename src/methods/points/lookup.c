/* Look-ups of the first bounce, and queue and look-ups of each later one. */
#include "lookup.h"
#include <inttypes.h>

/* Mirrors tell which pixel sees which point, and nothing of points. */
static const ts_launch first = TS_LAUNCH(lookup, TS_WITH(view), TS_WITH(texels), TS_OUT(found, lookup_point),
                                         TS_BUT(scene), TS_BUT(pieces), TS_BUT(frames), TS_BUT(keys), TS_BUT(points));
/* A later bounce: samples of the one before that see a mirror are counted and queued, then look up. */
typedef struct {
	ts_launch count, queue, look_up;
} later;

static const later second = {
	TS_LAUNCH(bounce_count, TS_IN(found, lookup_point), TS_OUT(offset, lookup_second_offset)),
	TS_LAUNCH(bounce_queue, TS_IN(found, lookup_point), TS_IN(offset, lookup_second_offset),
              TS_OUT(next_queue, lookup_second_parent)),
	TS_LAUNCH(bounce, TS_WITH(texels), TS_IN(queue, lookup_second_parent), TS_OUT(found, lookup_second_point)),
};
static const later third = {
	TS_LAUNCH(bounce_count, TS_IN(found, lookup_second_point), TS_OUT(offset, lookup_third_offset), TS_BUT(pixels)),
	TS_LAUNCH(bounce_queue, TS_IN(found, lookup_second_point), TS_IN(offset, lookup_third_offset),
              TS_OUT(next_queue, lookup_third_parent), TS_IN(queue, lookup_second_parent), TS_BUT(pixels)),
	TS_LAUNCH(bounce, TS_WITH(texels), TS_IN(queue, lookup_third_parent), TS_OUT(found, lookup_third_point),
              TS_BUT(pixels)),
};

ts_lookup_args ts_lookup_values(const ts_run *run, u32 bounce)
{
	return (ts_lookup_args){
		.scene = ts_run_scene(run),
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

static ts_status look_up(ts_run *run, const ts_launch *launch, u32 bounce)
{
	ts_lookup_args args = ts_lookup_values(run, bounce);
	u64 n = ts_run_size(run, ts_bounce_table[bounce].entries);
	if (TS_RUN(run, launch, &args, n) != TS_OK) return TS_ERROR;
	count_empty(run, ts_bounce_table[bounce].found);
	return TS_OK;
}

static ts_status lookup(ts_run *run) { return look_up(run, &first, 0); }

/* The queue of a bounce: the samples of the one before that see a mirror. */
static ts_status make_queue(ts_run *run, const later *own, u32 bounce)
{
	ts_lookup_args before = ts_lookup_values(run, bounce - 1);
	u64 total, n = ts_run_size(run, ts_bounce_table[bounce - 1].entries) * before.n_samples;
	if (n >= TS_NONE)
		return ts_fail("%" PRIu64 " samples are more than 32-bit indices can name; take a smaller image", n);
	if (TS_RUN(run, &own->count, &before, n) != TS_OK) return TS_ERROR;
	if (ts_launch_sum(run, &own->count, "offset", &total) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &own->queue, &before, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "later look-ups", (i64)total);
	return TS_OK;
}

static ts_status look_up_later(ts_run *run, const later *own, u32 bounce)
{
	return make_queue(run, own, bounce) == TS_OK ? look_up(run, &own->look_up, bounce) : TS_ERROR;
}

static ts_status lookup_second(ts_run *run) { return look_up_later(run, &second, 1); }
static ts_status lookup_third(ts_run *run) { return look_up_later(run, &third, 2); }

const ts_stage ts_stage_lookup = {
	.name = "lookup",
	.kind = "map",
	.paper = "EPR 4.1.3",
	.doc = "25 look-ups a reflective pixel",
	.run = lookup,
	.launches = TS_LAUNCHES(&first),
};

const ts_stage ts_stage_lookup_second = {
	.name = "lookup.second",
	.kind = "emit",
	.paper = "EPR 4.1.4",
	.doc = "four look-ups for each sample that sees a mirror",
	.run = lookup_second,
	.launches = TS_LAUNCHES(&second.count, &second.queue, &second.look_up),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_lookup_third = {
	.name = "lookup.third",
	.kind = "emit",
	.paper = "EPR 4.1.4",
	.doc = "the same once more",
	.run = lookup_third,
	.launches = TS_LAUNCHES(&third.count, &third.queue, &third.look_up),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
