/* Shading, from the last bounce back to the eye. */
#include <stdlib.h>
#include "kernels/points/lookup.h"
#include "methods/points/points.h"

/* With and without the next bounce's radiance. */
typedef struct {
	ts_launch last, followed;
} launches;

#define OF_PIXELS(points) \
	{ \
		TS_LAUNCH(shade, points, TS_IN(found, lookup_point), TS_OUT(radiance, shade_radiance), TS_WITH(used)), \
			TS_LAUNCH(shade, points, TS_IN(found, lookup_point), TS_OUT(radiance, shade_radiance), TS_WITH(used), \
		              TS_IN(offset, lookup_second_offset), TS_IN(next_radiance, shade_second_radiance)), \
	}
#define OF_SECOND(points) \
	{ \
		TS_LAUNCH(shade, points, TS_IN(found, lookup_second_point), TS_OUT(radiance, shade_second_radiance), \
		          TS_IN(queue, lookup_second_parent), TS_BUT(pixels)), \
			TS_LAUNCH(shade, points, TS_IN(found, lookup_second_point), TS_OUT(radiance, shade_second_radiance), \
		              TS_IN(queue, lookup_second_parent), TS_IN(offset, lookup_third_offset), \
		              TS_IN(next_radiance, shade_third_radiance), TS_BUT(pixels)), \
	}
#define OF_THIRD(points) \
	TS_LAUNCH(shade, points, TS_IN(found, lookup_third_point), TS_OUT(radiance, shade_third_radiance), \
	          TS_IN(queue, lookup_third_parent), TS_BUT(pixels))
/* With points that are stored, or made again. */
#define STORED TS_STORED_POINTS(from)
#define AGAIN TS_COUNTED_POINTS(from)
static const launches of_pixels[] = {OF_PIXELS(STORED), OF_PIXELS(AGAIN)};
static const launches of_second[] = {OF_SECOND(STORED), OF_SECOND(AGAIN)};
static const ts_launch of_third[] = {OF_THIRD(STORED), OF_THIRD(AGAIN)};
/* With colours instead of points. */
static const ts_launch of_colours =
	TS_LAUNCH(shade, TS_BUT(from), TS_IN(found, lookup_colour), TS_OUT(radiance, shade_radiance), TS_WITH(used));

static bool is_adaptive(const ts_run *run) { return TS_PARAM(&run->params, lookup_samples) == TS_SAMPLES_ADAPTIVE; }

static ts_status shade(ts_run *run, u32 bounce, const launches *own)
{
	ts_lookup_args args = ts_lookup_values(run, bounce);
	own += ts_points_again(run);
	args.follow = bounce + 1 < TS_PARAM(&run->params, lookup_bounces);
	args.adaptive = bounce == 0 && is_adaptive(run);
	const ts_launch *launch = args.follow ? &own->followed : &own->last;
	return TS_RUN(run, launch, &args, ts_run_size(run, ts_bounce_table[bounce].entries));
}

/* Shading operations if every point were shaded once and remembered. */
static ts_status count_distinct(ts_run *run)
{
	u64 n_points = ts_run_size(run, TS_DIM_points);
	uint8_t *seen = ts_alloc_zero(n_points, 1, "points seen");
	if (seen == NULL) return TS_ERROR;
	i64 distinct = 0;
	for (u32 bounce = 0; bounce < TS_PARAM(&run->params, lookup_bounces); bounce++) {
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

static void count_operations(ts_run *run, ts_dim entries)
{
	ts_run_count(run, "shading operations", (i64)(ts_run_size(run, entries) * TS_N_BOUNCE_SAMPLES));
}

static ts_status shade_third(ts_run *run)
{
	ts_lookup_args args = ts_lookup_values(run, 2);
	count_operations(run, TS_DIM_third_bounces);
	return TS_RUN(run, &of_third[ts_points_again(run)], &args, ts_run_size(run, TS_DIM_third_bounces));
}

static ts_status shade_second(ts_run *run)
{
	count_operations(run, TS_DIM_second_bounces);
	return shade(run, 1, of_second);
}

static ts_status shade_pixels(ts_run *run)
{
	if (shade(run, 0, of_pixels) != TS_OK) return TS_ERROR;
	const u32 *used = ts_frame_data(&run->frame, TS_B_shade_n_samples);
	u64 n = ts_frame_n(&run->frame, TS_B_shade_n_samples);
	i64 operations = 0;
	for (u64 i = 0; i < n; i++) operations += used[i];
	ts_run_count(run, "shading operations", operations);
	return count_distinct(run);
}

/* Nothing is lit: the operations are those of stage forward. */
static ts_status shade_colour(ts_run *run)
{
	ts_lookup_args args = ts_lookup_values(run, 0);
	args.coloured = 1;
	args.adaptive = is_adaptive(run);
	return TS_RUN(run, &of_colours, &args, ts_run_size(run, TS_DIM_mirror_pixels));
}

const ts_stage ts_stage_shade_third = {
	.name = "shade.third",
	.kind = "map",
	.paper = "EPR 4.1.4",
	.doc = "deferred shading of the third bounce",
	.run = shade_third,
	.launches = TS_LAUNCHES(&of_third[0], &of_third[1]),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_shade_second = {
	.name = "shade.second",
	.kind = "map",
	.paper = "EPR 4.1.4",
	.doc = "deferred shading of the second bounce",
	.run = shade_second,
	.launches = TS_LAUNCHES(&of_second[0].last, &of_second[0].followed, &of_second[1].last, &of_second[1].followed),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_shade = {
	.name = "shade",
	.kind = "map",
	.paper = "EPR 4.1.2",
	.doc = "eye-based deferred shading",
	.run = shade_pixels,
	.launches = TS_LAUNCHES(&of_pixels[0].last, &of_pixels[0].followed, &of_pixels[1].last, &of_pixels[1].followed),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_lookup_second_point, TS_B_lookup_third_point),
};

const ts_stage ts_stage_shade_colour = {
	.name = "shade.colour",
	.kind = "map",
	.paper = "EPR 3.5, 4.1.3",
	.doc = "the mean of the colours that each reflective pixel looked up",
	.run = shade_colour,
	.launches = TS_LAUNCHES(&of_colours),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
