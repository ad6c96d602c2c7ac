/* Truths of the light of many points by rays (METHODS 17): `vpls` gathers from all virtual point lights of MegaViews,
 * `glow` from all its particles, if nothing is between them and the pixel. */
#include "kernels/views/vpl_gather.h"
#include "methods/raster/tools/truth_gather.h"
#include "methods/stages.h"
#include "methods/views/tools/tools.h"
#include "methods/views/views.h"

typedef struct {
	const ts_truth *truth;
	const ts_vpl *vpls;
	f32 near, reach; /* world units: least distance of a light; surfaces this near a light stop nothing */
} tracer;

/* Lights that reach a pixel without occluders, and their contributions. */
typedef struct {
	ts_truth_pair pairs[TS_TRUTH_PAIRS];
	const ts_vpl *lights[TS_TRUTH_PAIRS];
	f32 forms[TS_TRUTH_PAIRS];
	u32 n;
} batch;

static ts_v3 add_seen(ts_v3 sum, const tracer *t, batch *b)
{
	bool sees[TS_TRUTH_PAIRS];
	ts_truth_sees_all(sees, t->truth, b->pairs, b->n);
	for (u32 i = 0; i < b->n; i++) sum = sees[i] ? ts_mad(sum, ts_load3(b->lights[i]->flux), b->forms[i]) : sum;
	b->n = 0;
	return sum;
}

static ts_v3 from_vpls(const void *user, const ts_share *share, ts_v3 p, ts_v3 n)
{
	const tracer *t = user;
	ts_v3 sum = {0, 0, 0};
	batch b;
	b.n = 0;
	for (u64 j = 0; j < share->asked; j++) {
		const ts_vpl *light = &t->vpls[ts_share_item(share, j)];
		ts_v3 from = ts_load3(light->position);
		f32 form = ts_k_vpl_form(ts_sub(p, from), ts_load3(light->normal), n, t->near);
		if (!(form > 0.0f)) continue;
		b.pairs[b.n] = (ts_truth_pair){p, from, t->reach};
		b.lights[b.n] = light;
		b.forms[b.n++] = form;
		if (b.n == TS_TRUTH_PAIRS) sum = add_seen(sum, t, &b);
	}
	sum = add_seen(sum, t, &b);
	return ts_scale(sum, ts_share_weight(share));
}

/* Traces lights of the given stages, in order; ended by NULL. */
static ts_status trace(ts_truth *truth, ts_run *run, ts_sampling *sampling, const char *const *makers,
                       const char *label)
{
	for (; *makers != NULL; makers++) {
		if (ts_run_stage(run, ts_stage_find(*makers)) != TS_OK) return TS_ERROR;
	}
	const ts_root *root = ts_frame_data(&run->frame, TS_B_octree_root);
	f32 leaf = root->side / (f32)(1 << TS_PARAM(&run->params, octree_levels));
	const tracer t = {
		.truth = truth,
		.vpls = ts_frame_data(&run->frame, TS_B_vpl_light),
		.near = TS_PARAM(&run->params, vpl_gather_near) * leaf,
		.reach = leaf * 1.73205077648162841796875f,
	};
	const ts_truth_gathered of = {label, from_vpls, &t, ts_frame_n(&run->frame, TS_B_vpl_light), 1};
	return ts_truth_gather(run, TS_B_indirect_irradiance, &of, sampling);
}

ts_status ts_truth_particles_begin(ts_run *run, const char *effect)
{
	static const ts_buffer_id needs[] = {TS_B_gbuffer_pixel, TS_N_BUFFERS};
	return ts_truth_begin(run, effect, needs);
}

ts_status ts_truth_vpls(ts_truth *truth, ts_run *run, ts_sampling *sampling)
{
	static const char *const at_light[] = {"octree.root", "voxel", "octree", "vpl", NULL};
	static const char *const at_random[] = {"octree.root", "voxel", "octree", "vpl.area", "vpl", NULL};
	return trace(truth, run, sampling, ts_vpl_at_random(&run->params) ? at_random : at_light, "truth vpls");
}

ts_status ts_truth_glow(ts_truth *truth, ts_run *run, ts_sampling *sampling)
{
	static const char *const makers[] = {"octree.root", "particle", NULL};
	return trace(truth, run, sampling, makers, "truth glow");
}
