/* Display values by a table, with the bits of ts_srgb_byte. */
#ifndef TS_BACKENDS_C_RASTER_SRGB_TABLE_H
#define TS_BACKENDS_C_RASTER_SRGB_TABLE_H
#include "kernels/base/srgb.h"

/* Display values are 0 below 2^-13. From there to 1, numbers with the same exponent and the same 8 highest bits of the
 * fraction have at most one threshold between them. */
#define TS_SRGB_LEAST 0x39000000u
#define TS_SRGB_SHIFT 15u
#define TS_SRGB_PLACES ((0x3f800000u - TS_SRGB_LEAST) >> TS_SRGB_SHIFT)

typedef struct {
	u8 first[TS_SRGB_PLACES]; /* display value of the least number of each entry */
} ts_srgb_table;

static inline void ts_srgb_table_make(ts_srgb_table *table)
{
	for (u32 i = 0; i < TS_SRGB_PLACES; i++)
		table->first[i] = (u8)ts_srgb_byte(ts_u2f(TS_SRGB_LEAST + (i << TS_SRGB_SHIFT)));
}

static inline u8 ts_srgb_find(const ts_srgb_table *table, f32 l)
{
	if (!(l < 1.0f)) return l >= 1.0f ? 255 : 0;
	if (l < ts_u2f(TS_SRGB_LEAST)) return 0;
	u8 n = table->first[(ts_f2u(l) - TS_SRGB_LEAST) >> TS_SRGB_SHIFT];
	return n < 255 && l >= ts_srgb_threshold[n] ? (u8)(n + 1) : n;
}

#endif
