/* The parameters of params.def: table, defaults, parsing and printing. */
#include <assert.h>
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "model/core.h"
#include "model/decimal.h"
#include "model/param.h"

#define PARAM_U32(field, name, def, min, max, unit, source, help) \
	{name, "u32", #def, #min, #max, unit, "", source, help},
#define PARAM_F32(field, name, def, min, max, unit, source, help) \
	{name, "f32", #def, #min, #max, unit, "", source, help},
#define PARAM_ENUM(field, name, def, choices, source, help) {name, "enum", #def, "0", "", "", choices, source, help},
static const ts_param_info table[] = {
#include "model/params.def"
};

#define PARAM_U32(field, ...) offsetof(ts_params, TS_PARAM_MEMBER(field)),
#define PARAM_F32(field, ...) offsetof(ts_params, TS_PARAM_MEMBER(field)),
#define PARAM_ENUM(field, ...) offsetof(ts_params, TS_PARAM_MEMBER(field)),
static const size_t offsets[] = {
#include "model/params.def"
};

enum { N_PARAMS = sizeof table / sizeof *table };
static_assert(sizeof(ts_params) == 4 * N_PARAMS, "every parameter is four bytes");

const ts_param_info *ts_param_table(size_t *n)
{
	*n = N_PARAMS;
	return table;
}

const ts_param_info *ts_param_at(size_t i) { return i < N_PARAMS ? &table[i] : NULL; }

static void store(ts_params *params, size_t row, const void *value) { memcpy((char *)params + offsets[row], value, 4); }

static bool parse_u32(uint32_t *value, const char *text)
{
	size_t length = strspn(text, "0123456789");
	if (length == 0 || length > 15 || text[length]) return false;
	uint64_t wide = strtoull(text, NULL, 10);
	*value = (uint32_t)wide;
	return wide <= UINT32_MAX;
}

static bool read_f32(float *value, const char *text)
{
	char *end;
	errno = 0;
	*value = ts_strtof(text, &end);
	return !*end && errno != ERANGE;
}

static bool parse_f32(float *value, const char *text)
{
	if (!ts_decimal_plain(text, text + strlen(text)) || !read_f32(value, text)) return false;
	*value = *value == 0 ? 0 : *value; /* not -0 */
	return true;
}

/* The shortest decimal text that reads back to the same bits. */
static void format_f32(float value, char *text, size_t text_bytes)
{
	for (int digits = 6; digits <= 9; digits++) {
		float back;
		snprintf(text, text_bytes, "%.*g", digits, (double)value);
		char *comma = strchr(text, ',');
		if (comma) *comma = '.';
		if (read_f32(&back, text) && memcmp(&back, &value, 4) == 0) return;
	}
}

/* The value is halved until 1 is left. */
static ts_status refuse_between(size_t row, uint32_t value)
{
	uint32_t below = 1;
	while (2 * below < value) below *= 2;
	return ts_fail("parameter %s: %" PRIu32 " is not a power of two; %" PRIu32 " or %" PRIu32 " would be right",
	               table[row].name, value, below, 2 * below);
}

static ts_status set_u32(ts_params *params, size_t row, const char *text)
{
	const ts_param_info *info = &table[row];
	uint32_t value, min, max;
	bool good_table = parse_u32(&min, info->min) && parse_u32(&max, info->max);
	assert(good_table);
	if (!parse_u32(&value, text) || value < min || value > max) {
		return ts_fail("parameter %s: \"%.80s\" is not a whole number from %s to %s%s%s", info->name, text, info->min,
		               info->max, *info->unit ? " " : "", info->unit);
	}
	bool halved = offsets[row] == offsetof(ts_params, TS_PARAM_MEMBER(view_map_px)) ||
	              offsets[row] == offsetof(ts_params, TS_PARAM_MEMBER(cube_view_px));
	if (halved && (value & (value - 1)) != 0) return refuse_between(row, value);
	store(params, row, &value);
	return TS_OK;
}

/* Kernels treat numbers nearer to zero than 2^-39 as zero (CONTRACT rule 10): refuse them rather than change them. */
static ts_status set_f32(ts_params *params, size_t row, const char *text)
{
	const ts_param_info *info = &table[row];
	float value, min, max;
	bool good_table = parse_f32(&min, info->min) && parse_f32(&max, info->max);
	assert(good_table);
	if (!parse_f32(&value, text) || value < min || value > max) {
		return ts_fail("parameter %s: \"%.80s\" is not a number from %s to %s%s%s", info->name, text, info->min,
		               info->max, *info->unit ? " " : "", info->unit);
	}
	if (value != 0 && value < 0x1p-39f && value > -0x1p-39f) {
		return ts_fail("parameter %s: \"%.80s\" is too near to 0: write 0, or at least 1.82e-12", info->name, text);
	}
	store(params, row, &value);
	return TS_OK;
}

/* The place-th of "a|b|c" in *choice and its length; 0 after the last. */
static size_t choice_at(const char *choices, uint32_t place, const char **choice)
{
	for (*choice = choices; place > 0; place--) {
		*choice = strchr(*choice, '|');
		if (!*choice) return 0;
		++*choice;
	}
	return strcspn(*choice, "|");
}

static ts_status set_enum(ts_params *params, size_t row, const char *text)
{
	const ts_param_info *info = &table[row];
	const char *choice;
	size_t length;
	for (uint32_t place = 0; (length = choice_at(info->choices, place, &choice)) > 0; place++) {
		if (strlen(text) == length && memcmp(text, choice, length) == 0) {
			store(params, row, &place);
			return TS_OK;
		}
	}
	return ts_fail("parameter %s: \"%.80s\" is not one of %s", info->name, text, info->choices);
}

static ts_status set_row(ts_params *params, size_t row, const char *text)
{
	switch (table[row].kind[0]) {
	case 'u': return set_u32(params, row, text);
	case 'f': return set_f32(params, row, text);
	default: return set_enum(params, row, text);
	}
}

/* The row of a name; TS_ERROR if there is none. */
static ts_status find(size_t *row, const char *name)
{
	for (*row = 0; *row < N_PARAMS; ++*row) {
		if (strcmp(table[*row].name, name) == 0) return TS_OK;
	}
	return ts_fail("there is no parameter \"%.80s\"; the table of parameters names all", name);
}

ts_status ts_params_set(ts_params *params, const char *name, const char *value)
{
	size_t row;
	if (TS_LACKS(params) || TS_LACKS(name) || TS_LACKS(value)) return TS_ERROR;
	if (find(&row, name) != TS_OK) return TS_ERROR;
	ts_floats_hold(1);
	ts_status status = set_row(params, row, value);
	ts_floats_give();
	return status;
}

ts_status ts_params_get(const ts_params *params, const char *name, char *text, size_t text_bytes)
{
	size_t row;
	char value[64];
	if (TS_LACKS(params) || TS_LACKS(name) || TS_LACKS(text) || find(&row, name) != TS_OK) return TS_ERROR;
	ts_floats_hold(1);
	ts_params_format(params, row, value, sizeof value);
	ts_floats_give();
	if (strlen(value) >= text_bytes) {
		return ts_fail("parameter %s: its value does not fit in %zu bytes; 64 would be right", name, text_bytes);
	}
	strcpy(text, value);
	return TS_OK;
}

ts_status ts_params_make(ts_params **params)
{
	if (TS_LACKS(params)) return TS_ERROR;
	*params = ts_alloc(1, sizeof **params, "parameters");
	if (*params == NULL) return TS_ERROR;
	ts_params_default(*params);
	return TS_OK;
}

ts_status ts_params_copy(ts_params **copy, const ts_params *params)
{
	if (TS_LACKS(copy)) return TS_ERROR;
	*copy = NULL;
	if (TS_LACKS(params) || ts_params_make(copy) != TS_OK) return TS_ERROR;
	**copy = *params;
	return TS_OK;
}

void ts_params_free(ts_params *params) { free(params); }

void ts_params_default(ts_params *params)
{
	for (size_t row = 0; row < N_PARAMS; row++) {
		bool good;
		if (table[row].kind[0] == 'e') {
			uint32_t place = 0;
			const char *choice;
			good = parse_u32(&place, table[row].def) && choice_at(table[row].choices, place, &choice) > 0;
			store(params, row, &place);
		} else {
			good = set_row(params, row, table[row].def) == TS_OK;
		}
		assert(good);
	}
}

void ts_params_format(const ts_params *params, size_t row, char *text, size_t text_bytes)
{
	assert(row < N_PARAMS);
	const ts_param_info *info = &table[row];
	const char *at = (const char *)params + offsets[row];
	uint32_t u;
	float f;
	memcpy(&u, at, 4);
	memcpy(&f, at, 4);
	if (info->kind[0] == 'u') {
		snprintf(text, text_bytes, "%" PRIu32, u);
	} else if (info->kind[0] == 'f') {
		format_f32(f, text, text_bytes);
	} else {
		const char *choice;
		int length = (int)choice_at(info->choices, u, &choice);
		snprintf(text, text_bytes, "%.*s", length, length ? choice : "");
	}
}

ts_status ts_params_check(const ts_params *params)
{
	ts_params copy = *params;
	for (size_t row = 0; row < N_PARAMS; row++) {
		char text[64];
		ts_params_format(params, row, text, sizeof text);
		if (set_row(&copy, row, text) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}
