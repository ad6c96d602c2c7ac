/* reference/goldens/cases.txt, one case per line: NAME: [EFFECT/]METHOD SCENE [OPTION...]; without an effect,
 * reflections. Files are relative to reference/goldens/. The file is untrusted. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/golden/golden.h"
#include "study/asked/methods.h"

enum { MOST_FILE_BYTES = 64 << 10, MOST_WORDS = 100 };

/* The line after a case's name is parsed as a command line. */
static const ts_command line_command = {
	"golden",
	"[EFFECT/]METHOD SCENE [OPTION...]",
	"",
	2,
	2,
	TS_OPT(SIZE),
	TS_OPT(FRAME),
	TS_OPT(REFLECTORS),
	TS_OPT(SET),
	TS_OPT(CAMERA),
	TS_OPT(EYE),
	TS_OPT(TARGET),
	TS_OPT(FOV),
	TS_OPT(REFLECTOR),
	TS_OPT(MIRROR),
	TS_OPT(LAMP),
	TS_OPT(ANIMATION),
	TS_OPT(FROM_MESH),
};

bool ts_case_name(const char *text)
{
	size_t n = strlen(text);
	return n > 0 && n < TS_CASE_NAME && strspn(text, "abcdefghijklmnopqrstuvwxyz0123456789-") == n && text[0] != '-';
}

static ts_status find_name(ts_case *c, const ts_goldens *goldens, char *line, char **rest)
{
	char *colon = strchr(line, ':');
	if (colon == NULL) return ts_fail("no \":\"; write NAME: [EFFECT/]METHOD SCENE [OPTION...]");
	*colon = 0;
	*rest = colon + 1;
	if (!ts_case_name(line)) {
		return ts_fail("\"%.60s\" is not a name of 1 to %d of a-z, 0-9 and \"-\"", line, TS_CASE_NAME - 1);
	}
	for (u32 i = 0; i < goldens->n_cases; i++) {
		if (strcmp(goldens->cases[i].name, line) == 0) return ts_fail("a second case of the name %s", line);
	}
	strcpy(c->name, line);
	return TS_OK;
}

/* Splits at blanks, takes --small out, and parses the rest. */
static ts_status parse_words(ts_cli *cli, bool *small, char *text)
{
	char *words[MOST_WORDS + 1] = {"golden"}, *state;
	int n = 1;
	for (char *word = strtok_r(text, " \t", &state); word != NULL; word = strtok_r(NULL, " \t", &state)) {
		if (n == MOST_WORDS) return ts_fail("more than %d words", MOST_WORDS - 1);
		if (strcmp(word, "--small") == 0) {
			*small = true;
		} else {
			words[n++] = word;
		}
	}
	ts_status status = ts_cli_parse(cli, &line_command, n, words);
	if (status != TS_OK) return status;
	u32 i = 0;
	while (i < TS_N_OPTIONS && cli->given[i] <= line_command.options[i]) i++;
	return i == TS_N_OPTIONS ? TS_OK : ts_fail("--%s is no part of a case", ts_option_table[i].name);
}

static ts_status find_method(ts_case *c, ts_cli *cli)
{
	char effect[32];
	const char *method = cli->arguments[0], *slash = strchr(method, '/');
	snprintf(effect, sizeof effect, "%s", ts_pipelines()[0]->effect->name);
	if (slash != NULL) {
		snprintf(effect, sizeof effect, "%.*s", (int)(slash - method < 31 ? slash - method : 31), method);
		method = slash + 1;
	}
	if (ts_effect_check(effect) != TS_OK) return TS_ERROR;
	c->pipeline = ts_pipeline_find(effect, method);
	ts_effect_params(&cli->job, effect);
	return c->pipeline != NULL ? TS_OK : ts_fail("no method \"%.60s\" of %s", method, effect);
}

/* In the order of the options, so that the order of typing does not matter. */
static ts_status take_places(ts_case *c, const ts_cli *cli)
{
	ts_status status = TS_OK;
	for (u32 option = 0; option < TS_N_OPTIONS; option++) {
		const char *name = ts_option_table[option].name;
		for (u32 i = 0; i < cli->n_typed && status == TS_OK && ts_place_is(name); i++) {
			if (cli->typed[i].option == option) status = ts_golden_place(&c->settings, name, cli->typed[i].text);
		}
	}
	return status;
}

static ts_status take_line(ts_case *c, ts_cli *cli)
{
	const char *scene = cli->arguments[1];
	if (find_method(c, cli) != TS_OK) return TS_ERROR;
	snprintf(c->settings.effect, sizeof c->settings.effect, "%s", c->pipeline->effect->name);
	snprintf(c->settings.method, sizeof c->settings.method, "%s", c->pipeline->name);
	c->settings.params = cli->job.params;
	if (strlen(scene) >= TS_GOLDEN_SCENE) return ts_fail("\"%.60s...\": beyond %d bytes", scene, TS_GOLDEN_SCENE - 1);
	strcpy(c->settings.scene, scene);
	return take_places(c, cli) == TS_OK ? ts_golden_bound(&c->settings) : TS_ERROR;
}

static ts_status read_case(ts_goldens *goldens, char *line)
{
	char *rest = line;
	ts_cli cli;
	if (goldens->n_cases == TS_MAX_CASES) return ts_fail("more than %d cases", TS_MAX_CASES);
	ts_case *c = &goldens->cases[goldens->n_cases];
	memset(c, 0, sizeof *c);
	if (find_name(c, goldens, line, &rest) != TS_OK || parse_words(&cli, &c->small, rest) != TS_OK) return TS_ERROR;
	if (take_line(c, &cli) != TS_OK) return TS_ERROR;
	goldens->n_cases++;
	return TS_OK;
}

ts_status ts_cases_read(ts_goldens *goldens)
{
	char *text, *end;
	size_t bytes;
	u32 number = 0;
	ts_status status = ts_golden_read_file(&text, &bytes, &goldens->dir, "cases.txt", MOST_FILE_BYTES);
	if (status != TS_OK) return status;
	if (strlen(text) != bytes) status = ts_fail("a byte that is no text");
	goldens->n_cases = 0;
	for (char *line = text; status == TS_OK && *line != 0; line = end) {
		number++;
		end = line + strcspn(line, "\n");
		if (*end != 0) *end++ = 0;
		line[strcspn(line, "#")] = 0;
		if (line[strspn(line, " \t")] != 0) status = read_case(goldens, line);
	}
	if (status == TS_OK && goldens->n_cases == 0) status = ts_fail("no case");
	if (status != TS_OK) ts_fail("%s/cases.txt:%u: %s", goldens->dir.path, (unsigned)number, ts_error_message());
	free(text);
	return status;
}

const ts_case *ts_cases_find(const ts_goldens *goldens, const char *name)
{
	ts_nearest nearest = ts_nearest_begin(name);
	for (u32 i = 0; i < goldens->n_cases; i++) {
		if (strcmp(goldens->cases[i].name, name) == 0) return &goldens->cases[i];
		ts_nearest_offer(&nearest, goldens->cases[i].name);
	}
	ts_fail("golden: no case \"%.60s\" in %s/cases.txt%s", name, goldens->dir.path, ts_nearest_hint(&nearest, NULL));
	return NULL;
}
