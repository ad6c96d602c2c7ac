/* The buffers of each bounce. */
#include "lookup.h"

const ts_bounce_buffers ts_bounce_table[TS_MAX_BOUNCES] = {
	{TS_DIM_mirror_pixels, TS_B_none, TS_B_mirror_pixel_record, TS_B_lookup_point, TS_B_shade_radiance},
	{TS_DIM_second_bounces, TS_B_lookup_second_offset, TS_B_lookup_second_parent, TS_B_lookup_second_point,
     TS_B_shade_second_radiance},
	{TS_DIM_third_bounces, TS_B_lookup_third_offset, TS_B_lookup_third_parent, TS_B_lookup_third_point,
     TS_B_shade_third_radiance},
};
