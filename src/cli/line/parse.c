/* From argv to a ts_cli, by getopt_long and the table of options. */
#include <getopt.h>
#include <stdio.h>
#include <string.h>
#include "cli/line/cli.h"
#include "study/asked/truths.h"

/* The result of getopt_long for the first long option, above every letter. */
enum { LONG = 256 };

bool ts_command_takes(const ts_command *command, u32 option)
{
	static const ts_command each = {TS_OPT(TIMEOUT), TS_OPT(MEMORY), TS_OPT(NO_WORKER), TS_OPT(HELP)};
	return each.options[option] || command->options[option];
}

/* A command's options for getopt_long. */
typedef struct {
	struct option options[TS_N_OPTIONS + 1]; /* val is LONG and the place in ts_option_table */
	char letters[2 * TS_N_OPTIONS + 2];
} known;

static known known_of(const ts_command *command)
{
	known k = {.letters = ":"};
	u32 n = 0;
	size_t n_letters = 1;
	for (u32 i = 0; i < TS_N_OPTIONS; i++) {
		const ts_option *o = &ts_option_table[i];
		if (!ts_command_takes(command, i)) continue;
		int has_argument = o->argument[0] == 0 ? no_argument : required_argument;
		has_argument = o->argument[0] == '[' ? optional_argument : has_argument;
		k.options[n++] = (struct option){o->name, has_argument, NULL, LONG + (int)i};
		if (o->letter != 0) k.letters[n_letters++] = o->letter;
		if (o->letter != 0 && has_argument == required_argument) k.letters[n_letters++] = ':';
	}
	return k;
}

/* The option that getopt_long returned or complained of; NULL: no such letter. */
static const ts_option *option_of(int answer)
{
	if (answer >= LONG) return &ts_option_table[answer - LONG];
	for (u32 i = 0; i < TS_N_OPTIONS; i++) {
		if (answer > 0 && ts_option_table[i].letter == answer) return &ts_option_table[i];
	}
	return NULL;
}

/* Bytes of a multi-byte character are not printed. */
static ts_status refuse_letter(const ts_command *command, u32 letter)
{
	char text[8];
	snprintf(text, sizeof text, letter > 32 && letter < 127 ? "%c" : "\\x%02x", letter);
	return ts_fail("%s: no option -%s; \"%s help %s\" lists all", command->name, text, ts_program, command->name);
}

static ts_status refuse_name(const ts_command *command, const known *k, const char *typed)
{
	char name[64], lists[64];
	snprintf(name, sizeof name, "%.*s", (int)strcspn(typed, "="), typed);
	ts_nearest nearest = ts_nearest_begin(name + strspn(name, "-"));
	nearest.mark = "--";
	for (const struct option *o = k->options; o->name != NULL; o++) ts_nearest_offer(&nearest, o->name);
	snprintf(lists, sizeof lists, "%s help %s", ts_program, command->name);
	return ts_fail("%s: no option %s%s", command->name, name, ts_nearest_hint(&nearest, lists));
}

static ts_status refuse(const ts_command *command, const known *k, int answer, char **argv)
{
	const ts_option *o = option_of(optopt);
	if (answer == ':' && optopt < LONG) {
		return ts_fail("%s: option -%c needs a value, %s", command->name, o->letter, o->argument);
	}
	if (answer == ':') return ts_fail("%s: option --%s needs a value, %s", command->name, o->name, o->argument);
	if (optopt >= LONG) return ts_fail("%s: option --%s takes no value", command->name, o->name);
	return optopt != 0 ? refuse_letter(command, (unsigned char)optopt) : refuse_name(command, k, argv[optind - 1]);
}

static ts_status take_arguments(ts_cli *cli, const ts_command *command, int n, char **arguments)
{
	if ((u32)n < command->min_arguments) {
		return ts_fail("%s: too few arguments; write %s %s %s", command->name, ts_program, command->name,
		               command->arguments);
	}
	const char *last = n > 0 && cli->job.judged ? arguments[n - 1] : "";
	if (ts_truths_named(last)) {
		return ts_fail("%s: \"%s\" stands alone; write --truth=%s, with \"=\"", command->name, last, last);
	}
	if ((u32)n > command->max_arguments) {
		return ts_fail("%s: one argument too many, \"%s\"; write %s %s %s", command->name,
		               arguments[command->max_arguments], ts_program, command->name, command->arguments);
	}
	for (int i = 0; i < n; i++) cli->arguments[cli->n_arguments++] = arguments[i];
	return TS_OK;
}

static void set_defaults(ts_cli *cli)
{
	ts_job *job = &cli->job;
	memset(cli, 0, sizeof *cli);
	ts_params_default(&job->params);
	job->program = ts_program;
	job->backends = ts_backend_kinds;
	job->backend = ts_backend_kinds[0];
	job->scene.options.bytes = sizeof job->scene.options;
	cli->began = ts_seconds();
	cli->judging.first = 1;
	job->device = (ts_backend_options){.work_group = 64, .build = ""};
}

static ts_status note(ts_cli *cli, const ts_option *option, const char *text)
{
	u32 place = (u32)(option - ts_option_table);
	cli->given[place] = true;
	if (cli->n_typed == TS_MAX_TYPED) return ts_fail("--%s: at most %d options", option->name, TS_MAX_TYPED);
	cli->typed[cli->n_typed].option = place;
	cli->typed[cli->n_typed++].text = text;
	return TS_OK;
}

ts_status ts_cli_parse(ts_cli *cli, const ts_command *command, int argc, char **argv)
{
	known k = known_of(command);
	set_defaults(cli);
	opterr = 0;
	optind = 0; /* also resets getopt_long's place within a word */
	for (int answer; (answer = getopt_long(argc, argv, k.letters, k.options, NULL)) != -1;) {
		if (answer == '?' || answer == ':') return refuse(command, &k, answer, argv);
		const ts_option *o = option_of(answer);
		if (o->take((char *)cli + o->at, o, optarg) != TS_OK || note(cli, o, optarg) != TS_OK) return TS_ERROR;
	}
	if (cli->job.scene.options.n_mirrors > 0 && !cli->job.mirrored) {
		TS_PARAM_SET(&cli->job.params, reflectors_count, 0);
		cli->job.mirrored = true;
	}
	if (cli->job.frames.step > 0 && cli->job.framed)
		return ts_fail("--frame and --frames: either one frame or several");
	cli->job.typed = argv + 1;
	cli->job.n_typed = (u32)optind - 1;
	return cli->given[TS_OPTION_HELP] ? TS_OK : take_arguments(cli, command, argc - optind, argv + optind);
}
