/* Parameters: defaults, exact ranges, and text that reads back to the same bits. */
#include "model/core.h"
#include "model/param.h"
#include "tests/comma.h"
#include "tests/lcg.h"

static const ts_param_info *row_of(const char *name, size_t *row)
{
	size_t n;
	const ts_param_info *table = ts_param_table(&n);
	for (*row = 0; *row < n; ++*row) {
		if (strcmp(table[*row].name, name) == 0) return &table[*row];
	}
	fail_msg("no parameter %s", name);
	return NULL;
}

static void accepts(const char *name, const char *value)
{
	ts_params params;
	ts_params_default(&params);
	if (ts_params_set(&params, name, value)) fail_msg("%s=%s is refused: %s", name, value, ts_error_message());
}

/* The parameters stay as they were, and the message names parameter and value. */
static void refuses(const char *name, const char *value)
{
	ts_params params, before;
	ts_params_default(&params);
	before = params;
	if (ts_params_set(&params, name, value) != TS_ERROR) fail_msg("%s=%s is accepted", name, value);
	assert_memory_equal(&params, &before, sizeof params);
	assert_non_null(strstr(ts_error_message(), name));
	assert_non_null(strstr(ts_error_message(), value));
}

static void defaults_are_those_of_the_table(void **state)
{
	(void)state;
	ts_params params;
	memset(&params, 0xaa, sizeof params);
	ts_params_default(&params);
	assert_int_equal(params.width, 1920);
	assert_int_equal(params.height, 1080);
	assert_int_equal(params.eye_distance, TS_EYE_FAR);
	assert_int_equal(params.points_cull_unit, TS_CULL_RASTER);
	assert_true(params.light_ambient == 0.3f);
	assert_true(params.density_scale == 0.5f);
	size_t n;
	const ts_param_info *table = ts_param_table(&n);
	assert_int_equal(n * 4, sizeof params);
	for (size_t row = 0; row < n; row++) {
		char text[64];
		ts_params_format(&params, row, text, sizeof text);
		accepts(table[row].name, text);
		if (table[row].kind[0] != 'e') assert_true(strtod(text, NULL) == strtod(table[row].def, NULL));
		assert_true(strlen(table[row].help) > 0);
	}
}

static void ends_of_the_ranges_are_inside(void **state)
{
	(void)state;
	size_t n;
	const ts_param_info *table = ts_param_table(&n);
	for (size_t row = 0; row < n; row++) {
		if (table[row].kind[0] != 'e') {
			accepts(table[row].name, table[row].min);
			accepts(table[row].name, table[row].max);
		}
	}
	refuses("width", "15");
	refuses("width", "16385");
	refuses("eye.fov", "0.99999994");
	refuses("eye.fov", "150.00002");
	refuses("seed", "4294967296");
}

static void malformed_numbers_are_refused(void **state)
{
	(void)state;
	static const char *const bad[] = {"1e400", "nan",  "inf", "-inf", "60x", "60 ",  " 60",
	                                  "0x3c",  "--60", "6e",  ".",    "6,5", "60\n", "1e-400"};
	for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
		ts_params params;
		ts_params_default(&params);
		assert_int_equal(ts_params_set(&params, "eye.fov", bad[i]), TS_ERROR);
		assert_int_equal(ts_params_set(&params, "width", bad[i]), TS_ERROR);
		assert_null(strchr(ts_error_message(), '\n'));
	}
	refuses("width", "-64");
	refuses("width", "+64");
	refuses("width", "64.0");
	refuses("width", "18446744073709551680"); /* 2^64 + 64 */
	refuses("light.ambient", "-1");
	refuses("light.ambient", "1e-20");
	assert_int_equal(ts_params_set(&(ts_params){0}, "width", ""), TS_ERROR);
	assert_int_equal(ts_params_set(&(ts_params){0}, "eye.fov", ""), TS_ERROR);
}

static void maps_halve_down_to_a_texel(void **state)
{
	(void)state;
	for (uint32_t px = 4; px <= 256; px++) {
		char text[8];
		snprintf(text, sizeof text, "%u", (unsigned)px);
		if ((px & (px - 1)) == 0)
			accepts("view_map.px", text);
		else
			refuses("view_map.px", text);
	}
	assert_int_equal(ts_params_set(&(ts_params){0}, "view_map.px", "48"), TS_ERROR);
	assert_string_equal(ts_error_message(), "parameter view_map.px: 48 is not a power of two; 32 or 64 would be right");
}

static void choices_are_exact(void **state)
{
	(void)state;
	ts_params params;
	ts_params_default(&params);
	assert_int_equal(ts_params_set(&params, "reflectors.shape", "lathe"), TS_OK);
	assert_int_equal(params.reflectors_shape, TS_SHAPE_LATHE);
	assert_int_equal(ts_params_set(&params, "lookup.samples", "adaptive"), TS_OK);
	assert_int_equal(params.lookup_samples, TS_SAMPLES_ADAPTIVE);
	refuses("eye.distance", "nea");
	refuses("eye.distance", "nearest");
	refuses("eye.distance", "near|far");
	refuses("eye.distance", "0");
	assert_non_null(strstr(ts_error_message(), "near|far"));
	assert_int_equal(ts_params_set(&params, "eye.distance", ""), TS_ERROR);
	assert_int_equal(ts_params_set(&params, "eyes", "near"), TS_ERROR);
	assert_int_equal(ts_params_set(&params, "", "near"), TS_ERROR);
}

static void minus_zero_becomes_zero(void **state)
{
	(void)state;
	ts_params params;
	ts_params_default(&params);
	assert_int_equal(ts_params_set(&params, "light.ambient", "-0.0e5"), TS_OK);
	uint32_t bits;
	memcpy(&bits, &params.light_ambient, 4);
	assert_int_equal(bits, 0);
}

/* 100,000 random bit patterns of the exposure's range. */
static void text_reads_back_to_the_same_bits(void **state)
{
	(void)state;
	size_t row;
	row_of("image.exposure", &row);
	ts_params params, back;
	ts_params_default(&params);
	uint32_t seed = 1;
	for (int i = 0; i < 100000; i++) {
		uint32_t bits = 0x3a800000u + lcg_next(&seed) % (0x44800000u - 0x3a800000u + 1);
		memcpy(&params.image_exposure, &bits, 4);
		char text[64];
		ts_params_format(&params, row, text, sizeof text);
		assert_int_equal(ts_params_set(&back, "image.exposure", text), TS_OK);
		assert_memory_equal(&back.image_exposure, &bits, 4);
	}
}

static void locale_of_the_host_does_not_matter(void **state)
{
	(void)state;
	comma_begin();
	ts_params params;
	ts_params_default(&params);
	size_t row;
	row_of("density.scale", &row);
	char text[64];
	ts_params_format(&params, row, text, sizeof text);
	comma_end();
	assert_true(params.density_scale == 0.5f);
	assert_string_equal(text, "0.5");
}

int main(void)
{
	const struct CMUnitTest params[] = {
		cmocka_unit_test(defaults_are_those_of_the_table),
		cmocka_unit_test(ends_of_the_ranges_are_inside),
		cmocka_unit_test(malformed_numbers_are_refused),
		cmocka_unit_test(maps_halve_down_to_a_texel),
		cmocka_unit_test(choices_are_exact),
		cmocka_unit_test(minus_zero_becomes_zero),
		cmocka_unit_test(text_reads_back_to_the_same_bits),
		cmocka_unit_test(locale_of_the_host_does_not_matter),
	};
	return cmocka_run_group_tests(params, NULL, NULL);
}
