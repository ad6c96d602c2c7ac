/* The table of options, and what each makes of its value. */
#include <stdio.h>
#include <stdlib.h>
#include "cli/line/cli.h"
#include "model/decimal.h"
#include "study/asked/sweep.h"

static ts_status take_nothing(void *to, const ts_option *option, const char *text)
{
	(void)to;
	(void)option;
	(void)text;
	return TS_OK;
}

static ts_status take_flag(void *to, const ts_option *option, const char *text)
{
	(void)option;
	(void)text;
	*(bool *)to = true;
	return TS_OK;
}

static ts_status take_text(void *to, const ts_option *option, const char *text)
{
	(void)option;
	*(const char **)to = text;
	return TS_OK;
}

static ts_status take_param(void *to, const ts_option *option, const char *text)
{
	return ts_params_set(to, option->param, text);
}

static ts_status take_count(void *to, const ts_option *option, const char *text)
{
	char what[32];
	snprintf(what, sizeof what, "--%s", option->name);
	return ts_words_count(to, text, option->min, option->max, what);
}

static ts_status take_number(void *to, const ts_option *option, const char *text)
{
	u32 n = 0;
	char what[32];
	snprintf(what, sizeof what, "--%s", option->name);
	ts_status status = ts_words_count(&n, text, 0, 4294967295u, what);
	*(u64 *)to = n;
	return status;
}

static ts_status take_distance(void *to, const ts_option *option, const char *text)
{
	char *end;
	double distance = ts_strtod(text, &end);
	if (!ts_decimal_plain(text, end) || *end != 0 || !(distance >= 0) || distance > 1e30) {
		return ts_fail("--%s: \"%s\" is not a number from 0 to 1e30", option->name, text);
	}
	*(double *)to = distance;
	return TS_OK;
}

static ts_status take_truth(void *to, const ts_option *option, const char *text)
{
	(void)option;
	ts_job *job = &((ts_cli *)to)->job;
	job->judged = true;
	job->truth = text;
	return TS_OK;
}

static ts_status take_size(void *to, const ts_option *option, const char *text)
{
	(void)option;
	ts_job *job = &((ts_cli *)to)->job;
	job->sized = true;
	return ts_words_size(&job->params, text, "--size");
}

static ts_status take_frame(void *to, const ts_option *option, const char *text)
{
	(void)option;
	ts_job *job = &((ts_cli *)to)->job;
	job->framed = true;
	return ts_params_set(&job->params, "frame", text);
}

static ts_status take_frames(void *to, const ts_option *option, const char *text)
{
	(void)option;
	return ts_words_frames(&((ts_cli *)to)->job.frames, text);
}

static ts_status take_shard(void *to, const ts_option *option, const char *text)
{
	(void)option;
	return ts_shard_read(&((ts_cli *)to)->job.shard, text);
}

static ts_status take_exposure(void *to, const ts_option *option, const char *text)
{
	(void)option;
	ts_job *job = &((ts_cli *)to)->job;
	job->exposed = strcmp(text, "auto") == 0;
	return job->exposed ? TS_OK : ts_params_set(&job->params, "image.exposure", text);
}

static ts_status take_mirrors(void *to, const ts_option *option, const char *text)
{
	(void)option;
	ts_job *job = &((ts_cli *)to)->job;
	job->mirrored = true;
	return ts_params_set(&job->params, "reflectors.count", text);
}

static ts_status take_place(void *to, const ts_option *option, const char *text)
{
	if (ts_place_set(&((ts_cli *)to)->job.scene, option->name, text) == TS_OK) return TS_OK;
	return ts_fail("--%s", ts_error_message());
}

static ts_status take_fov(void *to, const ts_option *option, const char *text)
{
	ts_status status = ts_params_set(&((ts_cli *)to)->job.params, "eye.fov", text);
	return status == TS_OK ? take_place(to, option, text) : status;
}

static ts_status take_backend(void *to, const ts_option *option, const char *text)
{
	(void)option;
	ts_job *job = &((ts_cli *)to)->job;
	job->backend_named = true;
	if (ts_backend_find(&job->backend, job->backends, text) == TS_OK) return TS_OK;
	return ts_fail("--backend: %s", ts_error_message());
}

static ts_status take_device(void *to, const ts_option *option, const char *text)
{
	(void)option;
	ts_job *job = &((ts_cli *)to)->job;
	job->device_named = true;
	return ts_words_count(&job->device.device, text, 0, TS_MAX_DEVICES - 1, "--device");
}

static ts_status take_order(void *to, const ts_option *option, const char *text)
{
	(void)option;
	bool *arrival = &((ts_cli *)to)->job.how.arrival;
	*arrival = strcmp(text, "arrival") == 0;
	if (*arrival || strcmp(text, "canonical") == 0) return TS_OK;
	return ts_fail("--order: no order \"%s\"; there are canonical and arrival", text);
}

/* Takes one value or, for a sweep, several. */
static ts_status take_assignment(void *to, const ts_option *option, const char *text)
{
	(void)option;
	ts_job *job = &((ts_cli *)to)->job;
	char name[64];
	const char *equals = strchr(text, '=');
	if (equals == NULL) return ts_fail("--set %s: no \"=\"; write --set NAME=VALUE", text);
	snprintf(name, sizeof name, "%.*s", (int)(equals - text < 64 ? equals - text : 63), text);
	size_t n;
	const ts_param_info *params = ts_param_table(&n);
	ts_nearest nearest = ts_nearest_begin(name);
	for (size_t i = 0; i < n; i++) {
		ts_nearest_offer(&nearest, params[i].name);
		job->set[i] |= strcmp(params[i].name, name) == 0;
	}
	if (strcmp(name, "reflectors.count") == 0) job->mirrored = true;
	if (strcmp(name, "frame") == 0) job->framed = true;
	if (nearest.distance != 0) {
		const char *lists = ts_cli_find("list") != NULL ? "touchstone list params" : NULL;
		return ts_fail("--set %s: no such parameter%s", name, ts_nearest_hint(&nearest, lists));
	}
	return strchr(equals, ',') != NULL ? ts_sweep_add(&job->sweep, &job->params, name, equals + 1)
	                                   : ts_params_set(&job->params, name, equals + 1);
}

/* The offset of a field, if it has that type. */
#define AT(type, field) (offsetof(ts_cli, field) + 0 * sizeof(&((ts_cli *)0)->field == (type *)0))
#define NOTHING take_nothing, 0, 0, 0, NULL
#define FLAG(field) take_flag, AT(bool, field), 0, 0, NULL
#define TEXT(field) take_text, AT(const char *, field), 0, 0, NULL
#define COUNT(field, min, max) take_count, AT(u32, field), min, max, NULL
#define NUMBER(field) take_number, AT(u64, field), 0, 0, NULL
#define DISTANCE(field) take_distance, AT(double, field), 0, 0, NULL
#define PARAM(name) take_param, AT(ts_params, job.params), 0, 0, name
#define BY(function) function, 0, 0, 0, NULL
#define OPTION(id, group, name, letter, argument, standard, sets, help, list) \
	{TS_GROUP_##group, name, letter, argument, standard, sets, help, list},

const ts_option ts_option_table[TS_N_OPTIONS] = {
#include "cli/line/options.def"
};
