/* Command lines that a test parses, or runs in its own process. */
#ifndef TS_TESTS_CLI_TYPED_H
#define TS_TESTS_CLI_TYPED_H
#include <jansson.h>
#include <unistd.h>
#include "cli/line/cli.h"
#include "tests/model/test.h"

enum { TYPED_WORDS = 160, TYPED_LINE = 4096 };

/* What was typed last, and its command. */
static ts_cli typed_cli;
static const char *typed_command;

/* Parses words, apart by blanks, the first of which is the command; they stay as long as no others are parsed. */
static inline ts_status typed_parse(const char *line)
{
	static char text[TYPED_LINE];
	static char *words[TYPED_WORDS];
	char *state = NULL;
	int n = 0;
	assert_true(strlen(line) < sizeof text);
	strcpy(text, line);
	for (char *word = strtok_r(text, " ", &state); word != NULL; word = strtok_r(NULL, " ", &state)) words[n++] = word;
	words[n] = NULL;
	assert_true(n > 0 && n < TYPED_WORDS);
	typed_command = words[0];
	return ts_cli_parse(&typed_cli, ts_cli_require(typed_command), n, words);
}

/* Runs a command line; *said: the JSON object that it printed, NULL: none. */
static inline ts_status typed_run(json_t **said, const char *line)
{
	FILE *out = tmpfile();
	int kept = dup(STDOUT_FILENO);
	assert_non_null(out);
	fflush(stdout);
	assert_true(kept >= 0 && dup2(fileno(out), STDOUT_FILENO) >= 0);
	ts_status status = typed_parse(line);
	if (status == TS_OK) status = ts_cli_require(typed_command)->run(&typed_cli);
	fflush(stdout);
	assert_true(dup2(kept, STDOUT_FILENO) >= 0);
	close(kept);
	rewind(out);
	*said = json_loadf(out, 0, NULL);
	fclose(out);
	return status;
}

#endif
