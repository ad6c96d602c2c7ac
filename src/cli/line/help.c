/* `help [COMMAND]`: tables, made from those of commands, of options and of help.def. */
#include <stdio.h>
#include <string.h>
#include "cli/line/cli.h"

enum { WIDTH = 80, INDENT = 2, GAP = 2, MOST_CELLS = 4, MOST_ROWS = 32 };

typedef enum { ARGUMENTS, OUTPUT, EXIT, VARIABLES, FILES, EXAMPLES } section;

static const struct {
	const char *command;
	section section;
	ts_help_row row;
} texts[] = {
#define HELP(command, section, left, text) {command, section, {left, text}},
#include "cli/line/help.def"
};

static int larger(int a, size_t b) { return a > (int)b ? a : (int)b; }

/* How much of the text fits into `width` columns: whole words, and at least one. */
static int fitting(const char *text, int width)
{
	int fits = 0;
	for (int at = 0; fits == 0 || at <= width; at++) {
		if (text[at] == ' ' || text[at] == 0) fits = at;
		if (text[at] == 0) return fits;
	}
	return fits;
}

/* Prints texts beside each other, each wrapped within its column. */
static void print_cells(const char *const *texts_of, const int *widths, u32 n, int indent)
{
	const char *rest[MOST_CELLS];
	memcpy(rest, texts_of, n * sizeof *rest);
	for (bool more = true; more;) {
		int blanks = indent;
		more = false;
		for (u32 i = 0; i < n; i++) {
			const int bytes = fitting(rest[i], widths[i]);
			if (bytes > 0) printf("%*s%.*s", blanks, "", bytes, rest[i]);
			blanks = widths[i] - bytes + GAP + (bytes > 0 ? 0 : blanks);
			rest[i] += bytes + (rest[i][bytes] == ' ');
			more |= rest[i][0] != 0;
		}
		putchar('\n');
	}
}

void ts_help_table(const char *title, const ts_help_row *rows, u32 n)
{
	int widths[2] = {0, 0};
	if (n == 0) return;
	for (u32 i = 0; i < n; i++) widths[0] = larger(widths[0], strlen(rows[i].left));
	widths[1] = WIDTH - INDENT - widths[0] - GAP;
	printf("\n%s:\n", title);
	for (u32 i = 0; i < n; i++) print_cells((const char *const[]){rows[i].left, rows[i].text}, widths, 2, INDENT);
}

void ts_help_item(const char *left, const char *text)
{
	const int step = 2 * INDENT;
	print_cells(&left, (const int[]){WIDTH - INDENT}, 1, INDENT);
	print_cells(&text, (const int[]){WIDTH - INDENT - step}, 1, INDENT + step);
}

/* The rows of help.def for a command. */
static u32 rows_of(ts_help_row *rows, const char *command, section of)
{
	u32 n = 0;
	for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
		if (texts[i].section == of && strcmp(texts[i].command, command) == 0) rows[n++] = texts[i].row;
	}
	return n;
}

/* The cells of an option's row; `what` also receives the list of its values. */
static void cells_of(const char **cells, char name[32], char what[256], const ts_option *o)
{
	const bool listed = o->list[0] != 0 && ts_cli_find("list") != NULL;
	snprintf(name, 32, o->letter != 0 ? "--%s, -%c" : "--%s", o->name, o->letter);
	snprintf(what, 256, "%s%s%s", o->help, listed ? "; see: list " : "", listed ? o->list : "");
	memcpy(cells, (const char *[]){name, o->argument, o->standard, what}, MOST_CELLS * sizeof *cells);
}

static void print_group(const ts_command *command, ts_group group, const char *title, const int *widths)
{
	const char *cells[MOST_CELLS];
	char name[32], what[256];
	for (u32 i = 0; i < TS_N_OPTIONS; i++) {
		if (ts_option_table[i].group != group || !ts_command_takes(command, i)) continue;
		if (title != NULL) printf(" %s\n", title);
		title = NULL;
		cells_of(cells, name, what, &ts_option_table[i]);
		print_cells(cells, widths, MOST_CELLS, INDENT);
	}
}

static void print_options(const ts_command *command)
{
	static const char *const titles[TS_N_GROUPS] = {
		"methods and parameters",
		"eye and picture",
		"scene",
		"what is looked at",
		"judgement",
		"how it runs",
		"goldens",
		"what is written",
		"the process",
	};
	static const char *const heads[MOST_CELLS] = {"Options:", "value", "default", "what"};
	const char *cells[MOST_CELLS];
	char name[32], what[256];
	int widths[MOST_CELLS], left = WIDTH - INDENT;
	for (u32 c = 0; c < MOST_CELLS; c++) widths[c] = (int)strlen(heads[c]);
	for (u32 i = 0; i < TS_N_OPTIONS; i++) {
		cells_of(cells, name, what, &ts_option_table[i]);
		for (u32 c = 0; c + 1 < MOST_CELLS && ts_command_takes(command, i); c++)
			widths[c] = larger(widths[c], strlen(cells[c]));
	}
	for (u32 c = 0; c + 1 < MOST_CELLS; c++) left -= widths[c] + GAP;
	widths[MOST_CELLS - 1] = left;
	putchar('\n');
	print_cells(heads, (const int[]){widths[0] + INDENT, widths[1], widths[2], left}, MOST_CELLS, 0);
	for (u32 group = 0; group < TS_N_GROUPS; group++) print_group(command, group, titles[group], widths);
}

static void print_exits(const ts_command *command)
{
	ts_help_row rows[MOST_ROWS];
	u32 n = rows_of(rows, command->name, EXIT);
	rows[n++] = (ts_help_row){"2", "could not: one line on standard error says why"};
	if (ts_command_takes(command, TS_OPTION_REQUIRE)) {
		rows[n++] = (ts_help_row){"77", "the backend has no device here, and --require is not given"};
	}
	ts_help_table("Exit codes", rows, n);
}

static void print_command(const ts_command *command)
{
	ts_help_row rows[MOST_ROWS];
	printf("%s %s %s [OPTION]...\n  %s\n", ts_program, command->name, command->arguments, command->doc);
	ts_help_table("Arguments", rows, rows_of(rows, command->name, ARGUMENTS));
	if (command->print_more != NULL) command->print_more();
	print_options(command);
	ts_help_table("Output", rows, rows_of(rows, command->name, OUTPUT));
	print_exits(command);
	ts_help_table("Environment", rows, rows_of(rows, command->name, VARIABLES));
	printf("\nExamples:\n");
	const u32 n = rows_of(rows, command->name, EXAMPLES);
	for (u32 i = 0; i < n; i++) {
		char typed[WIDTH];
		snprintf(typed, sizeof typed, "%s %s", ts_program, rows[i].left);
		ts_help_item(typed, rows[i].text);
	}
}

void ts_help_print(const ts_command *command)
{
	ts_help_row rows[MOST_ROWS];
	u32 n = 0;
	if (command != NULL) {
		print_command(command);
		return;
	}
	printf("%s %s: a bit-exact reference for point-based rendering\n", ts_program, TS_VERSION);
	for (const ts_command *c = ts_command_table; c->name != NULL; c++) rows[n++] = (ts_help_row){c->name, c->doc};
	ts_help_table("Commands", rows, n);
	ts_help_table("Environment", rows, rows_of(rows, ts_program, VARIABLES));
	ts_help_table("Files", rows, rows_of(rows, ts_program, FILES));
	printf("\nExit codes: 0 done or same, 1 compared and different, 2 could not, 77 skipped.\n");
	printf("\"%s help COMMAND\" has arguments, options and examples.\n", ts_program);
}

ts_status ts_help_command(ts_cli *cli)
{
	const ts_command *command = cli->n_arguments > 0 ? ts_cli_require(cli->arguments[0]) : NULL;
	if (cli->n_arguments > 0 && command == NULL) return TS_ERROR;
	ts_help_print(command);
	return TS_OK;
}
