/* Virtual point lights (instant radiosity, MegaViews section 4.1; SPEC 4.9): the texels of the reflective shadow maps that
 * send light on, all of them or so many at random, with repetition. Half a leaf's side above the surface, for a light in the
 * voxel of its own surface is in its shadow (SPEC 4.7). */
#ifndef TS_KERNELS_VPL_H
#define TS_KERNELS_VPL_H
#include "records.h"
#include "vec.h"

typedef struct {
	TS_GLOBAL const ts_patch *patches; /* rsm_patch.light */
	TS_GLOBAL const ts_root *root;
	TS_GLOBAL u32 *offset;             /* vpl.offset: counts, then their prefix sums */
	TS_GLOBAL ts_vpl *lights;
	u64 n_patches;
	u32 n_lit;                         /* patches that send light on */
	u32 n;                             /* lights; n_lit unless random */
	u32 random, seed, levels;
} ts_vpl_args;

#define TS_STREAM_VPL 4u

/* map over texels: 1 where it sends light on */
TS_FN void ts_k_vpl_count_item(const ts_vpl_args *args, u64 i)
{
	TS_GLOBAL const f32 *exitance = args->patches[i].exitance;
	args->offset[i] = exitance[0] > 0.0f || exitance[1] > 0.0f || exitance[2] > 0.0f ? 1u : 0u;
}

/* The texel that sends light on before which there are `rank` others. */
TS_FN u64 ts_k_vpl_texel(const ts_vpl_args *args, u32 rank)
{
	u64 low = 0u;
	u64 high = args->n_patches - 1u;
	while (low < high) {
		u64 middle = (low + high) / 2u;
		bool before = args->offset[middle + 1u] <= rank;
		low = before ? middle + 1u : low;
		high = before ? high : middle;
	}
	return low;
}

/* map over lights; there is a texel that sends light on */
TS_FN void ts_k_vpl_item(const ts_vpl_args *args, u64 i)
{
	u32 chance = ts_random((u32)i, TS_STREAM_VPL, args->seed);
	u32 rank = args->random != 0u ? (u32)(((u64)chance * args->n_lit) >> 32) : (u32)i;
	TS_GLOBAL const ts_patch *patch = &args->patches[ts_k_vpl_texel(args, rank)];
	TS_GLOBAL ts_vpl *light = &args->lights[i];
	ts_v3 a = ts_load3(patch->a);
	ts_v3 b = ts_load3(patch->b);
	ts_v3 c = ts_load3(patch->c);
	ts_v3 n = ts_load3(patch->normal);
	f32 third = 0.3333333432674407958984375f;
	f32 leaf = args->root->side / (f32)(1 << args->levels);
	f32 area = ts_length(ts_cross(ts_sub(b, a), ts_sub(c, a))) * 0.5f;
	f32 share = (f32)args->n_lit / (f32)args->n;
	ts_store3(light->position, ts_mad(ts_blend(ts_v3_make(third, third, third), a, b, c), n, leaf * 0.5f));
	ts_store3(light->normal, n);
	ts_store3(light->flux, ts_scale(ts_load3(patch->exitance), ts_flush(area * share)));
	light->bounce = 1u;
	light->pad0 = 0u;
	light->pad1 = 0u;
}

#endif
