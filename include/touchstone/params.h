/* Parameters: what a run can be told. params.def lists them. */
#ifndef TOUCHSTONE_PARAMS_H
#define TOUCHSTONE_PARAMS_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

#define PARAM_U32(field, name, def, min, max, unit, source, help) uint32_t field;
#define PARAM_F32(field, name, def, min, max, unit, source, help) float field;
#define PARAM_ENUM(field, name, def, choices, source, help) uint32_t field;
typedef struct {
#include <touchstone/params.def>
} ts_params;

/* Choices of the enumerated parameters, by place. */
enum { TS_EYE_NEAR, TS_EYE_FAR, TS_EYE_OUTSIDE };
enum { TS_SHAPE_SPHERE, TS_SHAPE_CYLINDER, TS_SHAPE_TORUS, TS_SHAPE_LATHE, TS_SHAPE_MIXED };
enum { TS_VISIBILITY_PLANE, TS_VISIBILITY_VERTEX };
enum { TS_DENSITY_DEFAULT, TS_DENSITY_PAPER };
enum { TS_CULL_EYE, TS_CULL_RASTER };
enum { TS_RATE_WATERTIGHT, TS_RATE_EXACT, TS_RATE_PAPER };
enum { TS_BUFFERED_DEFAULT, TS_BUFFERED_OFF, TS_BUFFERED_ON };
enum { TS_LAMP_LAMP, TS_LAMP_SCENE };
enum { TS_CONSERVATIVE_SAFE, TS_CONSERVATIVE_EXACT, TS_CONSERVATIVE_OFF };
enum { TS_SPLAT_SAFE, TS_SPLAT_PAPER };
enum { TS_SHADOW_RATE_SAFE, TS_SHADOW_RATE_UNIT, TS_SHADOW_RATE_PAPER };
enum { TS_SHADOW_DEPTH_PLANE, TS_SHADOW_DEPTH_POINT };
enum { TS_SEGMENTATION_SWEEPS, TS_SEGMENTATION_COMPONENTS };
enum { TS_SURFACE_PAPER, TS_SURFACE_ROBUST };
enum { TS_INTERPOLATION_PARAMETERS, TS_INTERPOLATION_MOMENTS };
enum { TS_SHARPNESS_TOKSVIG, TS_SHARPNESS_VMF };
enum { TS_INTEGRALS_STABLE, TS_INTEGRALS_PRINTED };
enum { TS_VIEW_FIELD_HALF, TS_VIEW_FIELD_ALL };
enum { TS_TOUCHING_SKIP, TS_TOUCHING_RENDER };
enum { TS_FUSION_MIN, TS_FUSION_PAPER };
enum { TS_SHADOW_TEST_PLANE, TS_SHADOW_TEST_DISTANCE };
enum { TS_FILTER_MIN, TS_FILTER_OBJECT, TS_FILTER_SCREEN };
enum { TS_BOUNDS_EXACT, TS_BOUNDS_BOTSCH };
enum { TS_SHADER_PHONG, TS_SHADER_NPR, TS_SHADER_PHONG_SHADOW, TS_SHADER_NPR_SHADOW };
enum { TS_ACCUMULATION_FIXED, TS_ACCUMULATION_FLOAT32, TS_ACCUMULATION_HALF, TS_ACCUMULATION_8BIT };
enum { TS_SAMPLES_FIXED, TS_SAMPLES_ADAPTIVE };
enum { TS_MVR_FACES_FIXED, TS_MVR_FACES_ADAPTIVE };
enum { TS_MVR_TRILINEAR, TS_MVR_SUPERSAMPLE };

/* One row of params.def, for programs that list parameters. Numbers are decimal text as written there. */
typedef struct {
	const char *name;
	const char *kind; /* "u32", "f32" or "enum" */
	const char *def, *min, *max;
	const char *unit;
	const char *choices; /* "a|b" of an enum, else "" */
	const char *source;  /* paper and section, or "" */
	const char *help;
} ts_param_info;

/* The table; *n receives its length. */
TS_API const ts_param_info *ts_param_table(size_t *n);

/* Sets every parameter to its default. */
TS_API void ts_params_default(ts_params *params);

/* Sets one parameter from text, as in --set name=value. On failure params is unchanged and the message names
 * the parameter, the value and the range. */
TS_API ts_status ts_params_set(ts_params *params, const char *name, const char *value);

/* Writes the value of table row `row` as text that ts_params_set reads back to the same bits. */
TS_API void ts_params_format(const ts_params *params, size_t row, char *text, size_t text_bytes);

/* Every parameter lies in its range; for a struct that was not filled by ts_params_set. */
TS_API ts_status ts_params_check(const ts_params *params);

#ifdef __cplusplus
}
#endif
#endif
