/* `help [COMMAND]`: made from the tables of commands and options. */
#include <stdio.h>
#include <string.h>
#include "cli.h"

/* Below its names the lines of its help, and at their end its short form and the list that has its values. */
static void print_option(const ts_option *option)
{
	char left[48];
	const char *space = option->argument[0] != 0 && option->argument[0] != '[' ? " " : "";
	snprintf(left, sizeof left, "--%s%s%s", option->name, space, option->argument);
	for (const char *line = option->help; line != NULL;) {
		const char *end = strchr(line, '\n');
		printf("  %-22s %.*s", line == option->help ? left : "", (int)strcspn(line, "\n"), line);
		if (end == NULL && option->letter != 0) printf(". Short: -%c%s%s", option->letter, space, option->argument);
		if (end == NULL && option->list[0] != 0 && ts_cli_find("list") != NULL) printf("; see: list %s", option->list);
		putchar('\n');
		line = end != NULL ? end + 1 : NULL;
	}
}

static void print_command(const ts_command *command)
{
	printf("%s %s %s\n  %s\n", ts_program, command->name, command->arguments, command->doc);
	if (command->details[0] != 0) printf("\n%s\n", command->details);
	if (command->print_more != NULL) command->print_more();
	printf("\nOptions:\n");
	for (u32 i = 0; i < TS_N_OPTIONS; i++) {
		if (ts_command_takes(command, i)) print_option(&ts_option_table[i]);
	}
}

void ts_help_print(const ts_command *command)
{
	if (command != NULL) {
		print_command(command);
		return;
	}
	printf("%s %s: a bit-exact reference for point-based rendering\n\nCommands:\n", ts_program, TS_VERSION);
	for (const ts_command *c = ts_command_table; c->name != NULL; c++) {
		char left[48];
		snprintf(left, sizeof left, "%s %s", c->name, c->arguments);
		printf("  %-28s %s\n", left, c->doc);
	}
	printf("\nExit codes: 0 done or same, 1 compared and different, 2 could not, 77 skipped.\n");
	printf("\"%s help COMMAND\" tells more.\n", ts_program);
}

ts_status ts_help_command(ts_cli *cli)
{
	const ts_command *command = cli->n_arguments > 0 ? ts_cli_require(cli->arguments[0]) : NULL;
	if (cli->n_arguments > 0 && command == NULL) return TS_ERROR;
	ts_help_print(command);
	return TS_OK;
}
