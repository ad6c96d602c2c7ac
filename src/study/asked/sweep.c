/* Combinations of parameters. */
#include "study/asked/sweep.h"
#include <stdio.h>
#include "study/asked/words.h"

enum { MAX_COMBINATIONS = 10000 };

static u32 count_values(const char *values)
{
	char item[TS_SWEEP_TEXT];
	u32 n = 0;
	while (ts_words_item(&values, item, sizeof item)) n++;
	return n;
}

u32 ts_sweep_count(const ts_sweep *sweep)
{
	u32 n = 1;
	for (u32 k = 0; k < sweep->n; k++) n *= sweep->swept[k].n;
	return n;
}

ts_status ts_sweep_add(ts_sweep *sweep, const ts_params *params, const char *name, const char *values)
{
	ts_params trial = *params;
	char item[TS_SWEEP_TEXT];
	if (sweep->n == TS_MAX_SWEEPS)
		return ts_fail("--set %s: at most %d parameters can have lists", name, TS_MAX_SWEEPS);
	for (const char *list = values; ts_words_item(&list, item, sizeof item);) {
		if (ts_params_set(&trial, name, item) != TS_OK) return TS_ERROR;
	}
	ts_swept *swept = &sweep->swept[sweep->n];
	snprintf(swept->name, sizeof swept->name, "%s", name);
	swept->values = values;
	swept->n = count_values(values);
	if ((u64)ts_sweep_count(sweep) * swept->n > MAX_COMBINATIONS)
		return ts_fail("--set %s: more than %d combinations", name, MAX_COMBINATIONS);
	sweep->n++;
	return TS_OK;
}

ts_status ts_sweep_set(const ts_sweep *sweep, u32 i, ts_params *params, char values[TS_MAX_SWEEPS][TS_SWEEP_TEXT])
{
	for (u32 k = sweep->n; k-- > 0;) {
		const ts_swept *swept = &sweep->swept[k];
		const char *list = swept->values;
		for (u32 place = 0; place <= i % swept->n; place++) ts_words_item(&list, values[k], TS_SWEEP_TEXT);
		i /= swept->n;
		if (ts_params_set(params, swept->name, values[k]) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}
