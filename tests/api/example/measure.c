/* Two methods beside rays: the error of a picture, the time of a stage, the bytes of a buffer.
 *     gcc measure.c $(pkg-config --cflags --libs touchstone) && ./a.out */
#include <stdio.h>
#include <touchstone/touchstone.h>

static int fail(void) { return fprintf(stderr, "%s\n", ts_error_message()), 2; }

int main(void)
{
	ts_context *context;
	ts_params *params;
	ts_scene *scene;
	ts_rendering *rendering;
	const ts_rendering_options options = {sizeof options, .methods = "epr,mvr", .truths = "B"};
	static const char *const names[] = {"epr", "mvr"};
	static const char *const small[][2] = {
		{"width", "96"}, {"height", "54"}, {"reflectors.count", "2"}, {"cube.max_px", "64"}};
	if (ts_context_open(&context, NULL) != TS_OK || ts_params_make(&params) != TS_OK) return fail();
	for (int i = 0; i < 4; i++)
		if (ts_params_set(params, small[i][0], small[i][1]) != TS_OK) return fail();
	if (ts_scene_open(context, &scene, "atrium:triangles=10000:texels=32", params, NULL) != TS_OK) return fail();
	if (ts_rendering_make(context, &rendering, scene, params, "reflections", &options) != TS_OK) return fail();
	for (int i = 0; i < 2; i++) {
		char name[64];
		double rmse;
		snprintf(name, sizeof name, "%s.rmse.B", names[i]);
		if (ts_rendering_figure_named(&rmse, rendering, name) != TS_OK) return fail();
		printf("%s %.6f\n", name, rmse);
	}
	double ms, bytes;
	if (ts_rendering_figure_named(&ms, rendering, "epr.ms.splat") != TS_OK ||
	    ts_rendering_figure_named(&bytes, rendering, "epr.bytes.points.record") != TS_OK)
		return fail();
	printf("epr.bytes.points.record %.0f\nepr.ms.splat %.1f\n", bytes, ms);
	ts_rendering_free(rendering);
	ts_scene_free(scene);
	ts_params_free(params);
	ts_context_close(context);
}
