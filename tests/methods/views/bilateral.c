/* The filter as a stage, on the G-buffer of a scene: constant light, noise, radius 0; rows before columns. */
#include <math.h>
#include "kernels/raster/gbuffer.h"
#include "tests/methods/small.h"

enum { WIDTH = 80, HEIGHT = 44, NUMBERS = WIDTH * HEIGHT * 3 };

typedef struct {
	ts_scene *scene;
	ts_run run;
	const ts_gpixel *pixels;
	f32 light[NUMBERS];
} world;

/* As far as the G-buffer, without light. */
static void begin(world *w)
{
	static const char *const stages[] = {"eye.view", "pose", "eye", "gbuffer"};
	ts_params params = small_params(WIDTH, HEIGHT);
	params.reflectors_count = 0;
	params.bilateral_px = 5;
	memset(w, 0, sizeof *w);
	w->scene = small_scene(&params);
	ts_run_begin(&w->run, w->scene, &params, 2);
	ts_pipeline_plan(ts_pipeline_find("indirect", "megaviews"), &w->run, NULL, NULL);
	for (u32 i = 0; i < sizeof stages / sizeof *stages; i++) {
		if (ts_run_stage(&w->run, ts_stage_find(stages[i])) != TS_OK) fail_msg("%s", ts_error_message());
	}
	w->pixels = ts_frame_data(&w->run.frame, TS_B_gbuffer_pixel);
	ts_frame_borrow(&w->run.frame, TS_B_vpl_gather_irradiance, w->light, NUMBERS);
}

static void end(world *w)
{
	ts_run_end(&w->run);
	ts_scene_free(w->scene);
}

static const f32 *filtered(world *w, ts_buffer_id id)
{
	if (ts_run_stage(&w->run, ts_stage_find("bilateral")) != TS_OK) fail_msg("%s", ts_error_message());
	return ts_frame_data(&w->run.frame, id);
}

static bool is_sky(const world *w, u32 number) { return w->pixels[number / 3].depth == TS_SKY; }

/* Of the same light everywhere nothing changes; of noise it is less; radius 0 leaves all as it is. */
static void filtering_lessens_noise_alone(void **state)
{
	(void)state;
	static world w;
	begin(&w);
	for (u32 k = 0; k < 3; k++) {
		for (u32 i = 0; i < NUMBERS; i++) {
			f32 noise = k == 0 ? 1 : ts_uniform(ts_random(i, 6, k));
			w.light[i] = is_sky(&w, i) ? 0 : noise;
		}
		w.run.params.bilateral_px = k == 2 ? 0 : 5;
		const f32 *light = filtered(&w, TS_B_indirect_irradiance);
		double before = 0, after = 0;
		for (u32 i = 0; i < NUMBERS; i++) {
			bool sky = is_sky(&w, i);
			if (k == 0) assert_true(fabsf(light[i] - w.light[i]) < 1e-6f);
			if (k == 2) assert_true(light[i] == w.light[i]);
			assert_true(light[i] >= 0 && light[i] <= 1 && (!sky || light[i] == 0));
			before += sky ? 0 : ((double)w.light[i] - 0.5) * ((double)w.light[i] - 0.5);
			after += sky ? 0 : ((double)light[i] - 0.5) * ((double)light[i] - 0.5);
		}
		assert_true(k != 1 || after < before / 3);
	}
	end(&w);
}

/* Light of one pixel stays in its row at first, then it is in others. */
static void rows_are_filtered_before_columns(void **state)
{
	(void)state;
	static world w;
	u32 n_beside = 0, n_below = 0;
	begin(&w);
	for (u32 row = 0; row < HEIGHT; row += 4) {
		u32 lit = 3 * (row * WIDTH + row);
		memset(w.light, 0, sizeof w.light);
		w.light[lit] = is_sky(&w, lit) ? 0 : 1;
		const f32 *rows = filtered(&w, TS_B_bilateral_filtered_rows);
		const f32 *light = ts_frame_data(&w.run.frame, TS_B_indirect_irradiance);
		for (u32 i = 0; i < NUMBERS; i++) {
			bool own = i / 3 / WIDTH == row;
			if (!own) assert_true(rows[i] == 0);
			n_beside += own && rows[i] > 0 && i != lit;
			n_below += !own && light[i] > 0;
		}
	}
	assert_true(n_beside > 20 && n_below > 20);
	end(&w);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(filtering_lessens_noise_alone),
	                                   cmocka_unit_test(rows_are_filtered_before_columns)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
