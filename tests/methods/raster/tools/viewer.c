/* Copies for viewers: the eye as EXR, the image as EXR and PNG, which say what they show and hold what the run made. */
#include <sys/stat.h>
#include <touchstone/image.h>
#include "output/folder.h"
#include "study/measure.h"
#include "tests/methods/small.h"
#include "tests/scratch.h"

enum { WIDTH = 48, HEIGHT = 27, N = WIDTH * HEIGHT };

static const char *const files[] = {"eye.depth.exr", "eye.triangle.exr", "image.radiance.exr", "image.srgb.png"};
static const char *const shows[] = {"mvr-eye.depth", "mvr-eye.triangle", "mvr-image", "mvr-image"};

/* What the run made, kept by a hook behind it. */
static u64 keys[N];
static f32 radiance[3 * N];
static u8 srgb[3 * N];

static ts_status keep(ts_run *run, void *user)
{
	(void)user;
	memcpy(keys, ts_frame_data(&run->frame, TS_B_eye_depth_triangle), sizeof keys);
	memcpy(radiance, ts_frame_data(&run->frame, TS_B_image_radiance), sizeof radiance);
	memcpy(srgb, ts_frame_data(&run->frame, TS_B_image_srgb), sizeof srgb);
	return TS_OK;
}

static ts_status refuse(const char *dir) { return ts_fail("%s: there", dir); }

static int begin(void **state)
{
	ts_params params = small_params(WIDTH, HEIGHT);
	if (scratch_begin(state) != 0) return -1;
	TS_PARAM_SET(&params, reflectors_count, 2);
	ts_scene *scene = small_scene(&params);
	ts_measure m = {.viewer = "view"};
	const ts_how how = {.threads = 2};
	ts_status status = ts_folder_begin(scratch_path("out"), refuse);
	if (status == TS_OK) {
		status = ts_measure_run(&m, ts_pipeline_find("reflections", "mvr"), scene, &params, &how, keep, NULL);
	}
	if (status == TS_OK) status = ts_folder_commit();
	ts_scene_free(scene);
	return status == TS_OK ? 0 : -1;
}

static double value_of(u32 file, u32 i)
{
	bool sky = keys[i / 3] == TS_EMPTY;
	if (file == 0) return sky ? 0 : (double)ts_u2f((u32)(keys[i / 3] >> 32));
	if (file == 1) return sky ? 0 : (u32)keys[i / 3] + 1.0;
	return file == 2 ? (double)radiance[i] : srgb[i] / 255.0;
}

static void copies_hold_what_the_run_made(void **state)
{
	(void)state;
	for (u32 k = 0; k < 4; k++) {
		float *pixels;
		u32 width, height, channels;
		const char *path = scratch_path("out/view/%s", files[k]);
		if (ts_image_read(&pixels, &width, &height, &channels, path) != TS_OK) fail_msg("%s", ts_error_message());
		assert_true(width == WIDTH && height == HEIGHT && channels == (k < 2 ? 1 : 3));
		for (u32 i = 0; i < N * 3; i += 3 / channels) {
			assert_float_equal(pixels[i / (3 / channels)], value_of(k, i), 1e-6);
		}
		free(pixels);
	}
}

static void copies_say_what_they_show(void **state)
{
	(void)state;
	for (u32 k = 0; k < 4; k++) {
		static char bytes[1 << 20];
		FILE *file = fopen(scratch_path("out/view/%s", files[k]), "rb");
		assert_non_null(file);
		size_t n = fread(bytes, 1, sizeof bytes - 1, file), at = 0, length = strlen(shows[k]);
		fclose(file);
		while (at + length < n && memcmp(bytes + at, shows[k], length) != 0) at++;
		if (at + length >= n) fail_msg("%s does not say %s", files[k], shows[k]);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(copies_hold_what_the_run_made),
	                                   cmocka_unit_test(copies_say_what_they_show)};
	return cmocka_run_group_tests(tests, begin, scratch_remove);
}
