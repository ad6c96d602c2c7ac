/* The buffers of each bounce, which the look-up and shade stages share. */
#ifndef TS_STAGES_LOOKUP_H
#define TS_STAGES_LOOKUP_H
#include "../../kernels/points/lookup.h"
#include "../stages.h"
#include "points.h"

enum { TS_MAX_BOUNCES = 3 };

typedef struct {
	ts_dim entries;
	ts_buffer_id offset;   /* entries before each sample of the bounce before */
	ts_buffer_id queue;    /* entries; pixels at the first bounce */
	ts_buffer_id found;    /* points seen */
	ts_buffer_id radiance; /* of the entries */
} ts_bounce_buffers;
extern const ts_bounce_buffers ts_bounce_table[TS_MAX_BOUNCES];

/* Arguments of the kernels of bounce 0, 1 or 2, without pointers. */
ts_lookup_args ts_lookup_values(const ts_run *run, u32 bounce);

#endif
