/* The cubes of a trace's reflectors. */
#include <inttypes.h>
#include "methods/points/tools/probe.h"

const ts_face *ts_probe_cubes(const ts_probe *p) { return p->whole[TS_B_cube_size_face]; }
u32 ts_probe_n_cubes(const ts_probe *p) { return (u32)ts_probe_n(p, TS_B_cube_size_face); }
u32 ts_probe_n_words(const ts_probe *p) { return (ts_probe_n_cubes(p) * 6 + 63) / 64; }

ts_status ts_probe_fetch_bits(ts_probe *p, u32 triangle, u64 *bits)
{
	u32 n = ts_probe_n_words(p);
	return ts_probe_fetch(p, TS_B_visibility_bits, (u64)triangle * n, n, bits);
}

/* Each cube's texels begin where the last one's end. */
static ts_status check_cubes(const ts_probe *p, u64 *n_texels)
{
	const ts_face *cubes = ts_probe_cubes(p);
	*n_texels = 0;
	for (u32 r = 0; r < ts_probe_n_cubes(p); r++) {
		if (cubes[r].n > TS_PROBE_SIDE || cubes[r].offset != *n_texels) {
			return ts_fail("%s: element %u: size %u at texel %" PRIu64 "; it would begin at %" PRIu64,
			               p->trace->item[TS_B_cube_size_face].path, (unsigned)r, (unsigned)cubes[r].n, cubes[r].offset,
			               *n_texels);
		}
		*n_texels += (u64)6 * cubes[r].n * cubes[r].n;
	}
	return TS_OK;
}

ts_status ts_probe_read_cubes(ts_probe *p)
{
	u64 n_texels;
	if (ts_probe_scene(p) != TS_OK || ts_probe_whole(p, TS_B_cube_size_face) == NULL) return TS_ERROR;
	if (ts_probe_n(p, TS_B_cube_size_face) > 65536) return ts_fail("%s: too large", p->trace->dir);
	if (check_cubes(p, &n_texels) != TS_OK || ts_probe_shapes(p, n_texels) != TS_OK) return TS_ERROR;
	return ts_probe_points_again(p);
}
