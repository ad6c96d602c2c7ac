/* Look-ups of the first bounce, and queue and look-ups of each later one. */
#include <inttypes.h>
#include "kernels/points/lookup.h"
#include "kernels/points/samples.h"
#include "methods/points/points.h"
#include "methods/registry.h"

/* The first look-up finds a point or a colour per sample, and reads no points. */
static const ts_launch first =
	TS_LAUNCH(lookup, TS_WITH(view), TS_WITH(texels), TS_OUT(found, lookup_point), TS_BUT(from));
static const ts_launch first_colours =
	TS_LAUNCH(lookup, TS_WITH(view), TS_IN(texels, splat_depth_colour), TS_OUT(found, lookup_colour), TS_BUT(from));
/* A later bounce: counts and queues samples of the bounce before that see a mirror, then looks up, with points that are
 * stored or made again. */
typedef struct {
	ts_launch count, queue, look_up;
} later;

#define SECOND(points) \
	{ \
		TS_LAUNCH(bounce_count, points, TS_IN(found, lookup_point), TS_OUT(offset, lookup_second_offset)), \
			TS_LAUNCH(bounce_queue, points, TS_IN(found, lookup_point), TS_IN(offset, lookup_second_offset), \
		              TS_OUT(next_queue, lookup_second_parent)), \
			TS_LAUNCH(bounce, points, TS_WITH(texels), TS_IN(queue, lookup_second_parent), \
		              TS_OUT(found, lookup_second_point)), \
	}
#define THIRD(points) \
	{ \
		TS_LAUNCH(bounce_count, points, TS_IN(found, lookup_second_point), TS_OUT(offset, lookup_third_offset), \
		          TS_BUT(pixels)), \
			TS_LAUNCH(bounce_queue, points, TS_IN(found, lookup_second_point), TS_IN(offset, lookup_third_offset), \
		              TS_OUT(next_queue, lookup_third_parent), TS_IN(queue, lookup_second_parent), TS_BUT(pixels)), \
			TS_LAUNCH(bounce, points, TS_WITH(texels), TS_IN(queue, lookup_third_parent), \
		              TS_OUT(found, lookup_third_point), TS_BUT(pixels)), \
	}
#define STORED TS_STORED_POINTS(from)
#define AGAIN TS_COUNTED_POINTS(from)
static const later second[] = {SECOND(STORED), SECOND(AGAIN)};
static const later third[] = {THIRD(STORED), THIRD(AGAIN)};

u64 ts_size_lookup_samples(const ts_size_question *q)
{
	(void)q;
	return TS_N_SAMPLES;
}

ts_lookup_args ts_lookup_values(const ts_run *run, u32 bounce)
{
	bool again = ts_points_again(run);
	return (ts_lookup_args){
		.from = again ? ts_points_values(run) : (ts_points_args){.scene = ts_run_scene(run)},
		.n_pieces = again ? (u32)ts_run_size(run, TS_DIM_pieces) : 0,
		.n_samples = bounce > 0 ? TS_N_BOUNCE_SAMPLES : TS_N_SAMPLES,
		.first = bounce == 0,
	};
}

static void count_empty(ts_run *run, const u32 *found, u64 n)
{
	i64 empty = 0;
	for (u64 i = 0; i < n; i++) empty += found[i] == TS_NONE;
	ts_run_count(run, "look-ups", (i64)n);
	ts_run_count(run, "empty look-ups", empty);
}

static ts_status look_up(ts_run *run, const ts_launch *launch, u32 bounce)
{
	ts_lookup_args args = ts_lookup_values(run, bounce);
	return TS_RUN(run, launch, &args, ts_run_size(run, ts_bounce_table[bounce].entries));
}

static ts_status lookup(ts_run *run)
{
	if (look_up(run, &first, 0) != TS_OK) return TS_ERROR;
	const u32 *found = ts_frame_data(&run->frame, TS_B_lookup_point);
	count_empty(run, found, ts_frame_n(&run->frame, TS_B_lookup_point));
	return TS_OK;
}

static ts_status lookup_colour(ts_run *run)
{
	if (look_up(run, &first_colours, 0) != TS_OK) return TS_ERROR;
	const u32 *found = ts_frame_data(&run->frame, TS_B_lookup_colour);
	count_empty(run, found, ts_frame_n(&run->frame, TS_B_lookup_colour));
	return TS_OK;
}

/* The queue of a bounce: the samples of the bounce before that see a mirror. */
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
	own += ts_points_again(run);
	if (make_queue(run, own, bounce) != TS_OK) return TS_ERROR;
	if (look_up(run, &own->look_up, bounce) != TS_OK) return TS_ERROR;
	ts_buffer_id found = ts_bounce_table[bounce].found;
	count_empty(run, ts_frame_data(&run->frame, found), ts_frame_n(&run->frame, found));
	return TS_OK;
}

static ts_status lookup_second(ts_run *run) { return look_up_later(run, second, 1); }
static ts_status lookup_third(ts_run *run) { return look_up_later(run, third, 2); }

const ts_stage ts_stage_lookup = {
	.name = "lookup",
	.kind = "map",
	.paper = "EPR 4.1.3",
	.doc = "25 look-ups per reflective pixel",
	.run = lookup,
	.launches = TS_LAUNCHES(&first),
};

const ts_stage ts_stage_lookup_colour = {
	.name = "lookup.colour",
	.kind = "map",
	.paper = "EPR 3.5, 4.1.3",
	.doc = "25 look-ups of colours per reflective pixel",
	.run = lookup_colour,
	.launches = TS_LAUNCHES(&first_colours),
};

const ts_stage ts_stage_lookup_second = {
	.name = "lookup.second",
	.kind = "emit",
	.paper = "EPR 4.1.4",
	.doc = "four look-ups for each sample that sees a mirror",
	.run = lookup_second,
	.launches = TS_LAUNCHES(&second[0].count, &second[0].queue, &second[0].look_up, &second[1].count, &second[1].queue,
                            &second[1].look_up),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_lookup_third = {
	.name = "lookup.third",
	.kind = "emit",
	.paper = "EPR 4.1.4",
	.doc = "four look-ups for each sample of the second bounce that sees a mirror",
	.run = lookup_third,
	.launches = TS_LAUNCHES(&third[0].count, &third[0].queue, &third[0].look_up, &third[1].count, &third[1].queue,
                            &third[1].look_up),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
