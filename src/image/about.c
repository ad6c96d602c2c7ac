/* Describes a picture in its file. */
#include "image/about.h"
#include <stdio.h>
#include <string.h>
#include "model/core.h"

static void print_params(char *text, size_t text_bytes, const ts_params *params)
{
	ts_params defaults;
	size_t n, used = 0;
	const ts_param_info *table = ts_param_table(&n);
	ts_params_default(&defaults);
	text[0] = 0;
	for (size_t row = 0; row < n && used < text_bytes; row++) {
		char value[64], usual[64];
		ts_params_format(params, row, value, sizeof value);
		ts_params_format(&defaults, row, usual, sizeof usual);
		if (strcmp(value, usual) == 0) continue;
		used +=
			(size_t)snprintf(text + used, text_bytes - used, "%s%s=%s", used > 0 ? " " : "", table[row].name, value);
	}
}

void ts_about_make(ts_about *about, const char *scene, const char *effect, const char *shows, const ts_params *params)
{
	const ts_image_text texts[] = {
		{"Software", "touchstone " TS_VERSION}, {"touchstone:scene", scene},          {"touchstone:effect", effect},
		{"touchstone:shows", about->shows},     {"touchstone:params", about->params}, {NULL, NULL},
	};
	memcpy(about->texts, texts, sizeof texts);
	snprintf(about->shows, sizeof about->shows, "%s", shows);
	print_params(about->params, sizeof about->params, params);
}
