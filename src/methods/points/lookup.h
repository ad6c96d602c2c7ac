/* The buffers of each bounce, which the look-up and shade stages share. */
#ifndef TS_METHODS_POINTS_LOOKUP_H
#define TS_METHODS_POINTS_LOOKUP_H
#include "kernels/points/lookup.h"
#include "methods/points/points.h"
#include "methods/stages.h"

enum { TS_MAX_BOUNCES = 3 };

typedef struct {
	ts_dim entries;
	ts_buffer_id offset;   /* entries before each sample of the bounce before */
	ts_buffer_id queue;    /* entries; pixels at the first bounce */
	ts_buffer_id found;    /* points seen */
	ts_buffer_id radiance; /* of the entries */
} ts_bounce_buffers;
static const ts_bounce_buffers ts_bounce_table[TS_MAX_BOUNCES] = {
	{TS_DIM_mirror_pixels, TS_B_none, TS_B_mirror_pixel_record, TS_B_lookup_point, TS_B_shade_radiance},
	{TS_DIM_second_bounces, TS_B_lookup_second_offset, TS_B_lookup_second_parent, TS_B_lookup_second_point,
     TS_B_shade_second_radiance},
	{TS_DIM_third_bounces, TS_B_lookup_third_offset, TS_B_lookup_third_parent, TS_B_lookup_third_point,
     TS_B_shade_third_radiance},
};

/* Arguments of the kernels of bounce 0, 1 or 2, without pointers. */
ts_lookup_args ts_lookup_values(const ts_run *run, u32 bounce);

#endif
