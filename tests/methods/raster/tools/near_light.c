/* Pixels near a triangle of light: against every triangle for every pixel, without quarters and boxes. */
#include "kernels/base/records.h"
#include "methods/raster/tools/tools.h"
#include "tests/lcg.h"
#include "tests/model/test.h"

enum { WIDTH = 37, HEIGHT = 29, N = WIDTH * HEIGHT, PATCHES = 40 };

static u32 seed;

static f32 draw(f32 scale) { return scale * ((f32)(lcg_next(&seed) >> 8) / 8388608.0f - 1); }

static bool is_near(const ts_gpixel *pixel, const ts_patch *patches, u32 n)
{
	for (u32 k = 0; k < n; k++) {
		double apart = 0, side = 0;
		for (u32 c = 0; c < 3; c++) {
			const f32 *a = patches[k].a, *b = patches[k].b, *third = patches[k].c;
			double d = (double)pixel->position[c] - ((double)a[c] + (double)b[c] + (double)third[c]) / 3;
			double s = (double)b[c] - (double)a[c];
			apart += d * d;
			side += s * s;
		}
		if (side > 0 && apart <= side) return true;
	}
	return false;
}

/* Surfaces that lie as pixels do, and as they like. */
static void put_pixels(ts_gpixel *pixels, u32 round)
{
	for (u32 i = 0; i < N; i++) {
		pixels[i] = (ts_gpixel){.depth = round % 4 == 3 || draw(1) > 0.7f ? 1.0f : 0.5f};
		const f32 at[3] = {(f32)(i % WIDTH) / WIDTH, (f32)(i / WIDTH) / HEIGHT, draw(0.1f)};
		for (u32 c = 0; c < 3; c++) pixels[i].position[c] = round % 2 == 0 ? at[c] : draw(1);
	}
	if (round % 4 == 3) pixels[N - 1].depth = 0.5f;
}

/* The last `n` of the patches are there; one more, around all, stands behind them and is none. */
static void judge(u32 round, u32 n)
{
	static ts_gpixel pixels[N];
	static ts_patch patches[PATCHES + 1];
	ts_picture picture = {.near = NULL};
	ts_run *run = calloc(1, sizeof *run);
	assert_non_null(run);
	seed = round;
	put_pixels(pixels, round);
	memset(patches, 0, sizeof patches);
	for (u32 k = 0; k < n; k++) {
		f32 middle[3] = {draw(1), draw(1), draw(1)}, size = k % 5 == 0 ? 0 : 0.3f;
		for (u32 c = 0; c < 3; c++) {
			patches[k].a[c] = middle[c] + draw(size);
			patches[k].b[c] = k % 5 == 0 ? patches[k].a[c] : middle[c] + draw(size);
			patches[k].c[c] = middle[c] + draw(size);
		}
	}
	patches[n].a[0] = 1000;
	ts_params_default(&run->params);
	TS_PARAM_SET(&run->params, width, WIDTH);
	TS_PARAM_SET(&run->params, height, HEIGHT);
	ts_frame_borrow(&run->frame, TS_B_gbuffer_pixel, pixels, N);
	ts_frame_borrow(&run->frame, TS_B_rsm_patch, patches, n);
	assert_int_equal(ts_near_light_mark(&picture, run), TS_OK);
	for (u32 i = 0; i < N; i++) {
		bool sky = pixels[i].depth == 1.0f, right = !sky && is_near(&pixels[i], patches, n);
		if (picture.near[i] != right || picture.elsewhere[i] != (!sky && !right))
			fail_msg("round %u, pixel %u", (unsigned)round, (unsigned)i);
	}
	ts_picture_free(&picture);
	ts_frame_clear(&run->frame);
	free(run);
}

static void pixels_near_light_are_all_found(void **state)
{
	(void)state;
	for (u32 round = 0; round < 40; round++) judge(round, round % 8 == 7 ? 0 : 1 + round);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(pixels_near_light_are_all_found)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
