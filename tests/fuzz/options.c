/* libFuzzer on command lines: `make fuzz`. An input is the words behind `touchstone`, each ended by a byte 0. Nothing
 * is run. An accepted option is one of the command, and its parameters are in their ranges. The parser leaves names of
 * methods, truths and stages as they are: these are looked up then. */
#include "cli/line/cli.h"
#include "study/asked/methods.h"
#include "study/asked/sweep.h"
#include "study/asked/truths.h"
#include "study/trace.h"
#include "tests/fuzz/folder.h"

enum { MOST_WORDS = 64 };

/* The first, the last and a middle combination of a sweep. */
static void check_sweep(const ts_job *job)
{
	u32 n = ts_sweep_count(&job->sweep), places[3] = {0, n / 2, n - 1};
	for (u32 i = 0; i < 3; i++) {
		char values[TS_MAX_SWEEPS][TS_SWEEP_TEXT];
		ts_params params = job->params;
		ts_status status = ts_sweep_set(&job->sweep, places[i], &params, values);
		assert(status == TS_OK && ts_params_check(&params) == TS_OK);
	}
}

static void check_trace(const ts_job *job, const ts_pipeline *method)
{
	ts_tracing tracing;
	if (ts_tracing_make(&tracing, job, method) != TS_OK) {
		fuzz_refused();
		return;
	}
	const u32 *crop = tracing.options.crop;
	assert(crop[0] + crop[2] <= TS_PARAM(&job->params, width) && crop[1] + crop[3] <= TS_PARAM(&job->params, height));
}

static void check_names(const ts_job *job)
{
	const ts_pipeline *methods[TS_MAX_METHODS];
	const char *effect = job->effect != NULL ? job->effect : ts_pipelines()[0]->effect->name;
	u32 n, truths;
	if (ts_methods_find(methods, &n, effect, job->method) != TS_OK) {
		fuzz_refused();
		return;
	}
	assert(n > 0 && n <= TS_MAX_METHODS);
	for (u32 i = 0; i < n; i++) check_trace(job, methods[i]);
	if (ts_truths_find(&truths, effect, job->truth) != TS_OK) fuzz_refused();
}

static void take(int n, char **words)
{
	ts_cli cli;
	const ts_command *command = ts_cli_require(words[0]);
	if (command == NULL || ts_cli_parse(&cli, command, n, words) != TS_OK) {
		fuzz_refused();
		return;
	}
	for (u32 i = 0; i < TS_N_OPTIONS; i++) assert(!cli.given[i] || ts_command_takes(command, i));
	assert(ts_params_check(&cli.job.params) == TS_OK);
	if (cli.given[TS_OPTION_HELP]) return;
	assert(cli.n_arguments >= command->min_arguments && cli.n_arguments <= command->max_arguments);
	check_sweep(&cli.job);
	check_names(&cli.job);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	char *words[MOST_WORDS + 1];
	int n_words = 0;
	for (size_t at = 0; at < n && n_words < MOST_WORDS; at += strlen(words[n_words++]) + 1) {
		words[n_words] = strndup((const char *)data + at, n - at);
		if (words[n_words] == NULL) abort();
	}
	words[n_words] = NULL;
	if (n_words > 0) take(n_words, words);
	while (n_words > 0) free(words[--n_words]);
	return 0;
}
