/* The fast picture equals the plain kernel bit for bit: of pixels that name triangles in front of the eye, across the
 * near plane, behind it, degenerate, or beside the pixel; of the sky; of mirrors, or without any; in full light or in
 * part of it; of samples of pixels; with display values and without. */
#include "tests/backends/c/raster/scribble.h"

enum { N = 60, LIGHTS = 8 };

typedef struct {
	u64 keys[PIXELS];
	u32 offset[PIXELS + 1], lit[PIXELS * LIGHTS];
	f32 reflected[PIXELS * 3];
	ts_lamp lamps[LIGHTS];
} input;

typedef struct {
	f32 radiance[PIXELS * 3];
	u8 srgb[PIXELS * 3];
} output;

static void random_input(input *in, const ts_run *run, u32 n_lights, u32 n_triangles)
{
	memcpy(in->keys, ts_frame_data(&run->frame, TS_B_eye_depth_triangle), sizeof in->keys);
	scribble(in->keys, PIXELS, n_triangles);
	for (u32 k = 0; k < LIGHTS; k++) in->lamps[k].samples = 1 + below(32);
	for (u32 i = 0; i < PIXELS; i++) {
		in->offset[i + 1] = in->offset[i] + (below(3) == 0 ? 1 : 0);
		for (u32 k = 0; k < 3; k++) in->reflected[i * 3 + k] = uniform(-0.5f, 2);
		for (u32 k = 0; k < n_lights; k++) in->lit[i * n_lights + k] = below(in->lamps[k].samples + 1);
	}
}

static void check(const ts_run *run, u32 n_triangles)
{
	static input in;
	static output plain, fast;
	u32 start = n_random;
	ts_view view = *(const ts_view *)ts_frame_data(&run->frame, TS_B_eye_view);
	if (below(4) == 0) view.near = uniform(0.5f, 8);
	ts_image_args args = {
		.scene = ts_run_arrays(run), .view = &view, .depth_triangle = in.keys, .exposure = uniform(0, 4)};
	assert_true(args.scene.n_lights <= LIGHTS);
	random_input(&in, run, args.scene.n_lights, n_triangles);
	if (below(2) == 0) args.offset = in.offset, args.reflected = in.reflected;
	if (below(2) == 0) args.lit = in.lit, args.lamps = in.lamps;
	bool shown = below(2) == 0;
	args.samples = EYE_SAMPLES;
	memset(&plain, 0x55, sizeof plain);
	memset(&fast, 0x55, sizeof fast);
	args.radiance = plain.radiance;
	args.srgb = shown ? plain.srgb : NULL;
	ts_image_args other = args;
	other.radiance = fast.radiance;
	other.srgb = shown ? fast.srgb : NULL;
	u32 n = 1 + below(PIXELS);
	launch_both(TS_KERNEL_image, ts_c_fast_image, &args, &other, n);
	if (memcmp(&plain, &fast, sizeof plain) != 0) fail_msg("random %u: %u pixels", start, n);
}

static void the_fast_picture_equals_the_kernel(void **state)
{
	(void)state;
	with_run(check, N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(the_fast_picture_equals_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
