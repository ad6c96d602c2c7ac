/* libFuzzer on values of parameters: `make fuzz`. The first byte chooses the parameter, the rest is its text. What is
 * taken is printed, and reads back to the same bits; what is refused changes nothing. */
#include "model/param.h"
#include "tests/fuzz/folder.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	size_t n_params;
	const ts_param_info *params = ts_param_table(&n_params);
	ts_params before, after, again;
	if (n == 0) return 0;
	size_t row = data[0] % n_params;
	char *text = strndup((const char *)data + 1, n - 1), value[64];
	if (text == NULL) abort();
	ts_params_default(&before);
	again = after = before;
	if (ts_params_set(&after, params[row].name, text) == TS_OK) {
		ts_params_format(&after, row, value, sizeof value);
		assert(ts_params_set(&again, params[row].name, value) == TS_OK && ts_params_check(&after) == TS_OK);
		assert(memcmp(&again, &after, sizeof after) == 0);
	} else {
		fuzz_refused();
		assert(memcmp(&after, &before, sizeof before) == 0);
	}
	free(text);
	return 0;
}
