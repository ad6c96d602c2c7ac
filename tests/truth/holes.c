/* The off-screen buffers of iVIR against rays: the watertight rate leaves no hole and no leak, a theorem (texels.c); the
 * paper's rate leaves both, which shows that this test can fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "../../src/pipelines/pipeline.h"
#include "../../src/truth/truth.h"

typedef struct { ts_truth *truth; ts_texel_counts counts; } tally;

static ts_status judge(const ts_run *run, const ts_stage *stage, void *user)
{
	tally *t = user;
	if (!ts_truth_judges(stage->writes[0])) return TS_OK;
	if (t->truth == NULL && ts_truth_new(&t->truth, run) != TS_OK) return TS_ERROR;
	return ts_truth_texels(&t->counts, t->truth, run, stage->writes[0]);
}

static ts_params small_params(void)
{
	ts_params p;
	ts_params_default(&p);
	p.width = 240;
	p.height = 135;
	p.reflectors = 2;
	p.reflector_px = 40;
	p.face_px = 48;
	p.views = 6;
	p.pass = 4;
	p.map_px = 96;
	p.light_samples = 2;
	p.cull = 0;
	return p;
}

/* Counts over all texels of a method; *capped: pieces that got fewer points than they need. */
static ts_texel_counts count(const char *effect, const char *method, const char *spec, const ts_params *params, i64 *capped)
{
	ts_scene *scene;
	ts_run run;
	tally t = { 0 };
	if (ts_scene_open(&scene, spec, params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	ts_run_begin(&run, scene, params, 2);
	run.hook = judge;
	run.hook_user = &t;
	if (ts_pipeline_run(ts_pipeline_find(effect, method), &run) != TS_OK) fail_msg("%s", ts_error_message());
	*capped = ts_run_counter(&run, "density.capped");
	print_message("%s of %s by %s, rate %u: %llu covered, %llu holes, %llu leaks, %llu apart\n", effect, spec, method,
	              (unsigned)params->rate, (unsigned long long)t.counts.covered, (unsigned long long)t.counts.holes,
	              (unsigned long long)t.counts.leaks, (unsigned long long)t.counts.apart);
	ts_truth_free(t.truth);
	ts_run_end(&run);
	ts_scene_free(scene);
	return t.counts;
}

static const char *const effects[] = { "soft-shadows", "omni-shadows", "reflections" };

static void test_watertight(void **state)
{
	ts_params params = small_params();
	for (u32 e = 0; e < 3; e++) {
		i64 capped;
		ts_texel_counts c = count(effects[e], "ivir", *state, &params, &capped);
		assert_true(c.covered > 10000 && capped == 0);
		assert_int_equal(c.holes, 0);
		assert_int_equal(c.leaks, 0);
	}
}

static void test_paper(void **state)
{
	ts_params params = small_params();
	params.rate = 2;
	for (u32 e = 0; e < 3; e++) {
		i64 capped;
		ts_texel_counts c = count(effects[e], "ivir", *state, &params, &capped);
		assert_true(c.holes > 0 && c.leaks > 0 && c.apart >= c.leaks);
	}
}

int main(void)
{
	static char atrium[] = "atrium:triangles=10000", gallery[] = "gallery:triangles=10000", dining[] = "dining:triangles=10000";
	const struct CMUnitTest tests[] = {
		{ "watertight: atrium", test_watertight, NULL, NULL, atrium },
		{ "watertight: gallery", test_watertight, NULL, NULL, gallery },
		{ "watertight: dining", test_watertight, NULL, NULL, dining },
		{ "paper: atrium", test_paper, NULL, NULL, atrium },
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
