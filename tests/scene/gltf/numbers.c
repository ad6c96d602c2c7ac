/* Numbers of glTF files against their definitions in double precision: KHR_texture_transform, the cones of
 * KHR_lights_punctual, and normalized integers. */
#include "scene/gltf/numbers.h"
#include "tests/kernels/seeded.h"

static void is_about(double value, double expected, double scale)
{
	if (!(fabs(value - expected) <= 1e-6 * scale)) fail_msg("%.9g, not %.9g", value, expected);
}

/* T * R * S, as the extension multiplies them. */
static void uv_are_scaled_turned_and_moved(void **state)
{
	(void)state;
	for (u32 i = 0; i < 1000; i++) {
		f32 m[6], offset[2] = {uniform(-2, 2), uniform(-2, 2)}, scale[2] = {uniform(-4, 4), uniform(-4, 4)};
		f32 rotation = uniform(-7, 7), u = uniform(0, 1), v = uniform(0, 1);
		double x = (double)scale[0] * (double)u, y = (double)scale[1] * (double)v, r = (double)rotation;
		ts_number_uv_transform(m, offset, rotation, scale);
		is_about((double)m[0] * (double)u + (double)m[1] * (double)v + (double)m[2],
		         cos(r) * x + sin(r) * y + (double)offset[0], 20);
		is_about((double)m[3] * (double)u + (double)m[4] * (double)v + (double)m[5],
		         -sin(r) * x + cos(r) * y + (double)offset[1], 20);
	}
}

/* All of the light inside the inner angle, none outside the outer. */
static void cone_falls_from_inner_to_outer(void **state)
{
	(void)state;
	for (u32 i = 0; i < 1000; i++) {
		f32 scale, offset, outer = uniform(0.1f, 1.57f), inner = outer * uniform(0, 0.9f);
		ts_number_cone(&scale, &offset, inner, outer);
		is_about(cos((double)inner) * (double)scale + (double)offset, 1, 1 + (double)scale);
		is_about(cos((double)outer) * (double)scale + (double)offset, 0, 1 + (double)scale);
	}
}

static void integers_become_shares(void **state)
{
	(void)state;
	for (u32 x = 0; x <= 65535; x++) {
		if (x <= 255) is_about((double)ts_number_unorm8(x), x / 255.0, 1);
		is_about((double)ts_number_unorm16(x), x / 65535.0, 1);
	}
	for (i32 x = -32768; x <= 32767; x++) {
		if (x >= -128 && x <= 127) is_about((double)ts_number_snorm8(x), fmax(x / 127.0, -1), 1);
		is_about((double)ts_number_snorm16(x), fmax(x / 32767.0, -1), 1);
	}
	assert_true(ts_number_unorm8(255) == 1 && ts_number_snorm16(-32768) == -1 && ts_number_snorm8(127) == 1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(uv_are_scaled_turned_and_moved),
		seeded_test(cone_falls_from_inner_to_outer),
		seeded_test(integers_become_shares),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
