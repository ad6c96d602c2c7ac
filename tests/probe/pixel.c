/* Pixels of the eye, of one sample and of four: what an answer has, and what it says of the picture. */
#include "tests/probe/mvr.h"

enum { N_TRIED = 6 };

static traced four;

static int make_all(void **state)
{
	ts_params params = mvr_params();
	params.eye_samples = TS_EYE_SAMPLES_4;
	make(&four, "reflections", "mvr", &params);
	return mvr_make(state);
}

static int drop_all(void **state)
{
	drop(&four);
	return mvr_drop(state);
}

/* The picture of an answer is the run's: its light, and all of its three bytes. */
static void assert_image(const traced *t, const json_t *answer, u32 pixel)
{
	const u8 *srgb = (const u8 *)data(t, TS_B_image_srgb) + pixel * 3;
	const f32 *radiance = (const f32 *)data(t, TS_B_image_radiance) + pixel * 3;
	const json_t *bytes = get(answer, "image", "srgb");
	assert_string_equal(json_string_value(get(answer, "image", "check")), "bits agree with image.radiance");
	for (u32 c = 0; c < 3; c++) {
		assert_bits(shown(json_object_get(answer, "image"), "radiance", c), radiance[c]);
		assert_int_equal(json_integer_value(json_array_get(bytes, c)), srgb[c]);
	}
}

/* A pixel that is coloured, so that one byte is not another. */
static u32 coloured(const traced *t)
{
	const u8 *srgb = data(t, TS_B_image_srgb);
	for (;;) {
		u32 pixel = below(WIDTH * HEIGHT);
		const u8 *c = srgb + (size_t)pixel * 3;
		if (c[0] != c[1] && c[1] != c[2] && c[0] != c[2]) return pixel;
	}
}

static void pixels_agree_with_the_picture(void **state)
{
	(void)state;
	u32 n_shaded = 0;
	const u32 *mirrors = data(&mvr, TS_B_mirror_pixel_offset);
	for (u32 i = 0; i < N_TRIED; i++) {
		json_t *answer;
		u32 pixel = coloured(&mvr);
		require(ask_pixel(&mvr, pixel % WIDTH, pixel / WIDTH, &answer));
		assert_true(assert_agrees(answer) >= 3);
		assert_image(&mvr, answer, pixel);
		assert_string_equal(json_string_value(json_object_get(answer, "method")), "mvr");
		assert_string_equal(json_string_value(get(answer, "coverage", "check")), "bits agree with eye.depth_triangle");
		u64 key = ((const u64 *)data(&mvr, TS_B_eye_depth_triangle))[pixel];
		assert_int_equal(json_integer_value(get(answer, "surface", "triangle")), (u32)key);
		bool shaded = mirrors[pixel + 1] == mirrors[pixel]; /* else its light is that of a reflection */
		assert_int_equal(json_object_get(answer, "shading") != NULL, shaded);
		if (shaded)
			assert_string_equal(json_string_value(get(answer, "shading", "sum")),
			                    "terms add up to the bits of the total");
		n_shaded += shaded;
		assert_null(json_object_get(answer, "samples"));
		json_decref(answer);
	}
	assert_true(n_shaded > 2);
}

/* Of four samples each is told with its own surface, shading and light; the picture is their mean. */
static void each_sample_is_told_on_its_own(void **state)
{
	(void)state;
	const f32 *radiance = data(&four, TS_B_image_sample_radiance);
	for (u32 i = 0; i < N_TRIED; i++) {
		json_t *answer;
		u32 pixel = coloured(&four);
		require(ask_pixel(&four, pixel % WIDTH, pixel / WIDTH, &answer));
		assert_agrees(answer);
		assert_image(&four, answer, pixel);
		const json_t *samples = json_object_get(answer, "samples");
		assert_int_equal(json_array_size(samples), 4);
		for (u32 s = 0; s < 4; s++) {
			const json_t *sample = json_array_get(samples, s);
			assert_string_equal(json_string_value(json_object_get(sample, "check")),
			                    "bits agree with image.sample_radiance");
			for (u32 c = 0; c < 3; c++)
				assert_bits(shown(sample, "radiance", c), radiance[(s * WIDTH * HEIGHT + pixel) * 3 + c]);
		}
		json_decref(answer);
	}
}

static void pixels_outside_the_eye_are_refused(void **state)
{
	(void)state;
	json_t *answer;
	static const u32 outside[][2] = {{WIDTH, 0}, {0, HEIGHT}, {TS_NONE, 3}, {3, TS_NONE}};
	for (u32 i = 0; i < 4; i++) {
		char words[80];
		snprintf(words, sizeof words, "no pixel (%u, %u); the eye has 24 x 16", (unsigned)outside[i][0],
		         (unsigned)outside[i][1]);
		assert_refused(ask_pixel(&mvr, outside[i][0], outside[i][1], &answer), words);
		assert_null(answer);
	}
	require(ask_pixel(&mvr, WIDTH - 1, HEIGHT - 1, &answer));
	json_decref(answer);
}

/* Makes the copy of a buffer a crop: from (5, 4), 10 wide and 6 high. */
static void crop(damaged *d, ts_buffer_id id, u32 channels)
{
	enum { X = 5, Y = 4, W = 10, H = 6 };
	size_t bytes = ts_buffer_table[id].element_bytes * channels;
	u8 *at = d->data;
	for (u32 y = 0; y < H; y++) memmove(at + y * W * bytes, at + ((Y + y) * WIDTH + X) * bytes, W * bytes);
	ts_trace_item *item = &d->probe->trace->item[id];
	item->cropped = true;
	memcpy(item->crop, (u32[]){X, Y, W, H}, sizeof item->crop);
	item->npy.shape[0] = H;
	item->npy.shape[1] = W;
	item->npy.n = (u64)H * W * channels;
}

static const u32 corners[4][2] = {{5, 4}, {14, 4}, {5, 9}, {14, 9}};
static const u32 beside[5][2] = {{4, 4}, {15, 4}, {5, 3}, {14, 10}, {0, 0}};

static ts_status ask(ts_probe *probe, const u32 *place, json_t **answer)
{
	return ts_probe_ask(probe, &(ts_probe_question){.subject = TS_PROBE_PIXEL, .x = place[0], .y = place[1]}, answer);
}

/* Outside its crop a picture says nothing of a pixel, and inside what it says is of that pixel. */
static void a_cropped_picture_says_nothing_outside(void **state)
{
	(void)state;
	json_t *answer;
	damaged d;
	damage(&d, &mvr, TS_B_image_radiance);
	crop(&d, TS_B_image_radiance, 3);
	for (u32 i = 0; i < 4; i++) {
		require(ask(d.probe, corners[i], &answer));
		assert_image(&mvr, answer, corners[i][1] * WIDTH + corners[i][0]);
		json_decref(answer);
	}
	for (u32 i = 0; i < 5; i++) {
		require(ask(d.probe, beside[i], &answer));
		assert_null(json_object_get(json_object_get(answer, "image"), "check"));
		assert_non_null(get(answer, "image", "srgb"));
		json_decref(answer);
	}
	damage_end(&d);
}

static void without_the_keys_there_is_no_answer(void **state)
{
	(void)state;
	json_t *answer;
	damaged d;
	damage(&d, &mvr, TS_B_eye_depth_triangle);
	crop(&d, TS_B_eye_depth_triangle, 1);
	for (u32 i = 0; i < 4; i++) {
		require(ask(d.probe, corners[i], &answer));
		assert_true(assert_agrees(answer) >= 3);
		json_decref(answer);
	}
	for (u32 i = 0; i < 5; i++) assert_refused(ask(d.probe, beside[i], &answer), "is outside its crop");
	d.probe->trace->item[TS_B_eye_depth_triangle].path = NULL;
	assert_refused(ask(d.probe, corners[0], &answer), "this needs eye.depth_triangle");
	damage_end(&d);
}

/* Light that differs from what was computed is told with its bits. */
static void wrong_light_is_told_with_its_bits(void **state)
{
	(void)state;
	json_t *answer;
	damaged d;
	f32 *radiance = damage(&d, &mvr, TS_B_image_radiance);
	u32 place[2] = {7, 3}, first = (3 * WIDTH + 7) * 3;
	char right[96];
	radiance[first + 2] += 1.0f;
	snprintf(right, sizeof right, "bits differ from image.radiance, which holds %08x %08x %08x",
	         (unsigned)ts_f2u(radiance[first]), (unsigned)ts_f2u(radiance[first + 1]),
	         (unsigned)ts_f2u(radiance[first + 2]));
	require(ask(d.probe, place, &answer));
	assert_string_equal(json_string_value(get(answer, "image", "check")), right);
	json_decref(answer);
	damage_end(&d);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(pixels_agree_with_the_picture),       cmocka_unit_test(each_sample_is_told_on_its_own),
		cmocka_unit_test(pixels_outside_the_eye_are_refused),  cmocka_unit_test(a_cropped_picture_says_nothing_outside),
		cmocka_unit_test(without_the_keys_there_is_no_answer), cmocka_unit_test(wrong_light_is_told_with_its_bits),
	};
	return cmocka_run_group_tests(tests, make_all, drop_all);
}
