/* Frames, figures of speed and growths as text: what a line says is what it has, and a mistake has its place. */
#include <math.h>
#include <string.h>
#include "study/tables/text.h"
#include "tests/status.h"

#define FRAME "frame S = reflections epr,mvr sponza.glb model points cube.px=256\n"
#define STAGES "stages maps = splat,cube_face\n"
#define GROWTH STAGES "growth g = reflections epr atrium "

static void lines_have_what_they_say(void **state)
{
	(void)state;
	ts_table_texts *texts;
	static const char text[] = FRAME STAGES
		"frame L = soft-shadows ivir atrium rays\n"
		"speed \"text\" \"times\" 2 at least 0.5 = S.epr.ms.maps / (threads * L.rays)\nspeed \"other\" \"\" whole = S.mvr.count.points\n"
		"growth g = reflections epr,mvr atrium:triangles= - 10k,1M maps \"views\" cube.px=64\n";
	if (ts_table_texts_read(&texts, text, "my.table") != TS_OK) fail_msg("%s", ts_error_message());
	const ts_speed_of *of = ts_table_texts_speed(texts);
	const ts_speed_scene *s = of->scenes, *l = s + 1;
	assert_true(strcmp(s->name, "S") == 0 && s->model && !s->rays && s->points && strcmp(s->set, "cube.px=256") == 0);
	assert_true(strcmp(s->methods[1], "mvr") == 0 && s->methods[2] == NULL && strcmp(s->spec, "sponza.glb") == 0);
	assert_true(!l->model && l->rays && !l->points && l->set[0] == 0 && l[1].name == NULL);
	const ts_speed_figure *f = of->figures;
	assert_true(f->bound == TS_SPEED_LEAST && f->goal == 0.5 && f->decimals == 2 && strcmp(f->unit, "times") == 0);
	assert_true(f[1].bound == TS_SPEED_SHOWN && f[1].decimals < 0 && f[2].text == NULL && of->n_names == 4);
	assert_true(of->names[0].scene == 0 && of->names[0].figure.variant == 0);
	assert_string_equal(of->names[0].figure.what, "splat,cube_face");
	assert_true(of->names[1].scene == TS_NONE && of->names[2].scene == 1 && of->names[3].figure.variant == 1);
	assert_string_equal(of->names[2].own->name, "rays");
	const ts_speed_growth *g = of->growths;
	assert_true(strcmp(g->values, "10k,1M") == 0 && strcmp(g->stages, "splat,cube_face") == 0);
	assert_true(strcmp(g->called, "views") == 0 && strcmp(g->of.set, "cube.px=64") == 0 && g[1].of.name == NULL);
	ts_table_texts_free(texts);
}

static void a_mistake_is_said_with_its_place(void **state)
{
	(void)state;
	static const char *const bad[][2] = {
		{"frame", ":1:6: a name is expected"},
		{"frame S = mirrors epr atrium", ":1:11: no effect \"mirrors\""},
		{"frame S = reflections epr,ivr atrium", ":1:27: no method \"ivr\" of reflections"},
		{"frame S = reflections ssagh atrium", ":1:23: no method \"ssagh\" of reflections"},
		{"frame S = reflections epr,mvr,ivir,vir,epr atrium", ":1:1: more than 4 methods"},
		{"frame S = reflections epr", ":1:26: a scene is expected"},
		{"frame S = reflections epr atrium fast", ":1:34: \"fast\": NAME=VALUE,... is expected"},
		{"frame S = reflections epr atrium cube.px=1.5", ":1:34: "},
		{FRAME "frame S = reflections epr atrium", ":2:7: the frame \"S\" stands above"},
		{FRAME "speed \"a\" \"\" 2 near 3 = 1", ":2:16: \"at most\", \"at least\" or \"=\" is expected"},
		{FRAME "speed \"a\" \"\" 2 at best 3 = 1", ":2:19: \"most\" or \"least\" is expected"},
		{FRAME "speed \"a\" \"\" 2 at most = 1", ":2:24: \"=\" is no number"},
		{FRAME "speed \"a\" \"\" 2 = ", ":2:17: an expression is expected"},
		{FRAME "speed \"a\" \"\" 2 = T.rays", ":2:18: T.rays: begins with no frame above, and is not \"threads\""},
		{FRAME "speed \"a\" \"\" 2 = S", ":2:18: S: begins with no frame above"},
		{FRAME "speed \"a\" \"\" 2 = S.ivir.ms.frame", ":2:18: ivir.ms.frame: no figure or variant above begins so"},
		{FRAME "speed \"a\" \"\" 2 = S.epr.ms.none", ":2:18: none is no stage, and no list of stages"},
		{FRAME "speed \"a\" \"\" 2 = S.epr.rmse.A", ":2:18: A is no variant"},
		{GROWTH "- 1,2 maps \"m\"", ":2:28: \"atrium\" takes no value: its end is no \"=\""},
		{GROWTH "cubes 1,2 maps \"m\"", ":2:35: no parameter \"cubes\""},
		{GROWTH "size 1x2 none \"m\"", ":2:44: no list of stages \"none\" above"},
		{GROWTH "threads 1,2 maps", ":2:51: what these stages are called is expected"},
		{GROWTH "threads 1,2 maps \"m\" x", ":2:56: \"x\": NAME=VALUE,... is expected"},
	};
	for (u32 i = 0; i < sizeof bad / sizeof *bad; i++) {
		ts_table_texts *texts;
		if (ts_table_texts_read(&texts, bad[i][0], "my.table") == TS_OK) fail_msg("read: %s", bad[i][0]);
		assert_null(texts);
		if (strstr(ts_error_message(), bad[i][1]) == NULL) fail_msg("%s\n%s", bad[i][0], ts_error_message());
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(lines_have_what_they_say),
	                                   cmocka_unit_test(a_mistake_is_said_with_its_place)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
