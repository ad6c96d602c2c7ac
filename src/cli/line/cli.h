/* The command line: one table of commands, one table of options, one parser for all. */
#ifndef TS_CLI_LINE_CLI_H
#define TS_CLI_LINE_CLI_H
#include "cli/line/worker.h"
#include "kernels/base/compat.h"
#include "model/core.h"
#include "study/asked/job.h"
#include "study/asked/words.h"

/* Groups of options, in the order of `help`. */
typedef enum {
	TS_GROUP_METHODS,
	TS_GROUP_EYE,
	TS_GROUP_SCENE,
	TS_GROUP_PLACE,
	TS_GROUP_JUDGE,
	TS_GROUP_RUN,
	TS_GROUP_GOLDENS,
	TS_GROUP_OUTPUT,
	TS_GROUP_PROCESS,
	TS_N_GROUPS,
} ts_group;

/* Options: their indices in the table, and the way in which the row of a command names those it takes. */
enum {
#define OPTION(id, ...) TS_OPTION_##id,
#include "cli/line/options.def"
#undef OPTION
	TS_N_OPTIONS,
};
#define TS_OPT(id) .options[TS_OPTION_##id] = true

enum { TS_MAX_ARGUMENTS = 1000, TS_MAX_TYPED = 256 };

/* Tolerances of images. Those that are typed must all hold. */
typedef struct {
	double percent;  /* of the pixels may differ, */
	double hardfail; /* no channel by more than this, */
	double rmse;     /* and the root mean square of all differences is at most this */
} ts_tolerances;

/* Relaxations of traces. */
typedef struct {
	u64 ulp;
	double abs, rel;
	bool decided;
	u64 allow;
	const char *ignore;
} ts_relaxed;

/* Options by which a comparison judges and writes. Strings are NULL if they were not typed. */
typedef struct {
	ts_relaxed relaxations;
	ts_tolerances tolerances; /* of images */
	const char *mask;         /* file */
	const char *layout;
	bool forced;                 /* each stage by the candidate's own inputs */
	u32 first;                   /* differences to show per buffer, at least 1 */
	const char *baseline, *skip; /* files */
	const char *junit, *markdown;
	bool tap;
	bool reported; /* the files of --junit and --markdown are written */
} ts_judging;

/* The command line as it was typed. Strings belong to argv. */
typedef struct {
	double began; /* ts_seconds */
	bool given[TS_N_OPTIONS];
	struct {
		u32 option;
		const char *text;  /* NULL: no value */
	} typed[TS_MAX_TYPED]; /* options in their order */
	u32 n_typed;
	const char *arguments[TS_MAX_ARGUMENTS];
	u32 n_arguments;
	ts_job job;
	ts_judging judging; /* of compare */
	struct {
		const char *pixel, *view, *point;
		u64 triangle, item;
		const char *kernel, *element;
		bool primitives, outline;
		u32 lines; /* 0: the default */
	} place;       /* of probe and explain */
	struct {
		const char *reason, *dir;
	} golden;
	const char *check, *stage, *inputs;
	struct {
		double ppd;
		u32 probes;
	} report;
	bool flush_denormals;
	const struct ts_parts *parts; /* merge: shards from which renders are taken; NULL: renders are made */
	struct {
		u32 seconds, mib; /* at most; 0: no limit */
		bool none;
	} worker;
	ts_steps *steps;     /* NULL without a worker */
	char no_device[512]; /* why the backend has none; "": it has one */
} ts_cli;

typedef struct {
	const char *name;
	const char *arguments; /* as in the usage line */
	const char *doc;       /* one line; help.def has the rest of `help NAME` */
	u32 min_arguments, max_arguments;
	bool options[TS_N_OPTIONS]; /* those it takes */
	ts_status (*run)(ts_cli *cli);
	bool says_skipped; /* also runs where the backend has no device, to say of each case that it was skipped */
	size_t kept;       /* bytes at ts_cli.steps, which begin with those; 0: the work has no steps */
	/* Called after TS_ERROR or TS_SKIPPED ended the command and was printed; NULL: nothing. */
	void (*failed)(const ts_cli *cli, ts_status status);
	void (*print_more)(void); /* prints the tables of `help NAME`; NULL: there are none */
} ts_command;

typedef struct ts_option ts_option;
struct ts_option {
	ts_group group;
	const char *name;
	char letter;          /* its short form; 0: none */
	const char *argument; /* "" none, "[...]" optional */
	const char *standard; /* the default as `help` prints it; "" none */
	ts_status (*take)(void *to, const ts_option *option, const char *text);
	size_t at;         /* of `to` in ts_cli */
	u32 min, max;      /* of a count */
	const char *param; /* that is set */
	const char *help;
	const char *list; /* WHAT of `list WHAT`, which prints its values; "" none */
};

/* The program's table of commands, ended by a row without a name. */
extern const ts_command ts_command_table[];
/* The program's name in messages. */
extern const char *const ts_program;

extern const ts_option ts_option_table[TS_N_OPTIONS];
/* Whether the command takes the option at that index of the table. Every command takes --help. */
bool ts_command_takes(const ts_command *command, u32 option);

/* The command of that name; NULL if this program has none. */
const ts_command *ts_cli_find(const char *name);
/* The command of that name; NULL with the message set. */
const ts_command *ts_cli_require(const char *name);
/* From now on messages go to standard error: lines, and on a terminal progress, as one line that rewrites itself. */
void ts_cli_listen(void);
void ts_cli_say(void *user, const char *line);
void ts_cli_progress(void *user, const char *label, uint64_t done, uint64_t total);
/* Runs what argv asks for and returns the exit code; a failure is printed as one line on standard error. */
int ts_cli_main(int argc, char **argv);

/* Reads argv[1...] of a command into *cli. */
ts_status ts_cli_parse(ts_cli *cli, const ts_command *command, int argc, char **argv);

/* Refuses output options of a judging command that contradict each other. */
ts_status ts_judging_check(const ts_cli *cli);

/* Commands. */
ts_status ts_help_command(ts_cli *cli);
ts_status ts_digest_command(ts_cli *cli);
ts_status ts_golden_command(ts_cli *cli);
void ts_golden_failed(const ts_cli *cli, ts_status status);
ts_status ts_merge_command(ts_cli *cli);
ts_status ts_render_command(ts_cli *cli);
void ts_render_help(void);
ts_status ts_info_command(ts_cli *cli);
ts_status ts_list_command(ts_cli *cli);
ts_status ts_bench_command(ts_cli *cli);
ts_status ts_compare_command(ts_cli *cli);
/* Write the file of --junit if nothing was judged. */
void ts_compare_failed(const ts_cli *cli, ts_status status);
ts_status ts_report_command(ts_cli *cli);
ts_status ts_vectors_command(ts_cli *cli);
ts_status ts_probe_command(ts_cli *cli);
void ts_probe_help(void);
ts_status ts_replay_command(ts_cli *cli);
ts_status ts_explain_command(ts_cli *cli);
/* Help of one command, or of all if NULL. */
void ts_help_print(const ts_command *command);

/* A row of a table of `help`. */
typedef struct {
	const char *left, *text;
} ts_help_row;

/* Prints a titled table with two columns of text, within 80 columns; nothing if n is 0. */
void ts_help_table(const char *title, const ts_help_row *rows, u32 n);
/* Prints a row with its text below the left cell. */
void ts_help_item(const char *left, const char *text);

#endif
