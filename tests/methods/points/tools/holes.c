/* The off-screen buffers of iVIR against rays: the watertight rate leaves no hole and no leak, a theorem (texels.c);
 * the paper's rate leaves both, which shows that this test can fail. */
#include "methods/pipeline.h"
#include "methods/points/tools/tools.h"
#include "tests/model/test.h"

typedef struct {
	ts_truth *truth;
	ts_texel_counts counts;
} tally;

static ts_status judge(const ts_run *run, const ts_stage *stage, void *user)
{
	tally *t = user;
	if (ts_texels_find(ts_stage_outputs(stage)[0]) == NULL) return TS_OK;
	if (t->truth == NULL && ts_truth_new(&t->truth, run) != TS_OK) return TS_ERROR;
	return ts_truth_texels(&t->counts, t->truth, run, ts_stage_outputs(stage)[0]);
}

/* Batches are of several views, and the last one is smaller. */
static ts_params small_params(u32 rate)
{
	ts_params p;
	ts_params_default(&p);
	p.width = 96;
	p.height = 54;
	p.reflectors_count = 2;
	p.reflectors_px = 16;
	p.cube_px = 48;
	p.lamp_views = 5;
	p.lamp_views_a_pass = 3;
	p.depth_map_px = 80;
	p.lamp_cubes = 2;
	p.density_rate = rate;
	p.points_cull = 0;
	return p;
}

/* Counts over all texels of iVIR. */
static ts_texel_counts count(const char *effect, const ts_scene *scene, const ts_params *params)
{
	ts_run run;
	tally t = {0};
	ts_run_begin(&run, scene, params, 2);
	run.hook = judge;
	run.hook_user = &t;
	if (ts_pipeline_run(ts_pipeline_find(effect, "ivir"), &run) != TS_OK) fail_msg("%s", ts_error_message());
	assert_int_equal(ts_run_counter(&run, "density.capped"), 0);
	print_message("%s of %s, rate %u: %llu covered, %llu holes, %llu leaks, %llu apart\n", effect, scene->name,
	              (unsigned)params->density_rate, (unsigned long long)t.counts.covered,
	              (unsigned long long)t.counts.holes, (unsigned long long)t.counts.leaks,
	              (unsigned long long)t.counts.apart);
	ts_truth_free(t.truth);
	ts_run_end(&run);
	return t.counts;
}

static void check(const char *spec, u32 rate)
{
	static const char *const effects[] = {"soft-shadows", "omni-shadows", "reflections"};
	ts_scene *scene;
	ts_params params = small_params(rate);
	if (ts_scene_load(&scene, spec, &params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	for (u32 e = 0; e < 3; e++) {
		ts_texel_counts c = count(effects[e], scene, &params);
		assert_true(c.covered > 10000 && c.apart >= c.leaks);
		assert_true((c.holes == 0) == (rate == TS_DENSITY_RATE_WATERTIGHT));
		assert_true((c.leaks == 0) == (rate == TS_DENSITY_RATE_WATERTIGHT));
	}
	ts_scene_free(scene);
}

static void the_watertight_rate_leaves_no_hole(void **state) { check(*state, TS_DENSITY_RATE_WATERTIGHT); }
static void the_papers_rate_leaves_holes_and_leaks(void **state) { check(*state, TS_DENSITY_RATE_PAPER); }

int main(void)
{
	static char atrium[] = "atrium:triangles=10000:texels=32", gallery[] = "gallery:triangles=10000:texels=32";
	static char dining[] = "dining:triangles=10000:texels=32";
	const struct CMUnitTest tests[] = {
		{"watertight: atrium", the_watertight_rate_leaves_no_hole, NULL, NULL, atrium},
		{"watertight: gallery", the_watertight_rate_leaves_no_hole, NULL, NULL, gallery},
		{"watertight: dining", the_watertight_rate_leaves_no_hole, NULL, NULL, dining},
		{"paper: atrium", the_papers_rate_leaves_holes_and_leaks, NULL, NULL, atrium},
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
