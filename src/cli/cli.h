/* The command line: one table of commands, one table of options, one parser for all. */
#ifndef TS_CLI_CLI_H
#define TS_CLI_CLI_H
#include <touchstone/params.h>
#include <touchstone/scene.h>
#include "../core/core.h"
#include "../kernels/compat.h"
#include "backends.h"

#define TS_VERSION "0.1.0"

/* Options, as bits: a command names those it takes. */
enum {
	TS_OPT_METHOD = 1 << 0,
	TS_OPT_TRUTH = 1 << 1,
	TS_OPT_SIZE = 1 << 2,
	TS_OPT_FRAME = 1 << 3,
	TS_OPT_REFLECTORS = 1 << 4,
	TS_OPT_REFLECTOR = 1 << 5,
	TS_OPT_CAMERA = 1 << 6,
	TS_OPT_SET = 1 << 7,
	TS_OPT_THREADS = 1 << 8,
	TS_OPT_REFERENCE = 1 << 9,
	TS_OPT_OUTPUT = 1 << 10,
	TS_OPT_FORCE = 1 << 11,
	TS_OPT_JSON = 1 << 12,
	TS_OPT_NO_IMAGES = 1 << 13,
	TS_OPT_FLUSH_DENORMALS = 1 << 14,
	TS_OPT_SCENE = 1 << 15,
	TS_OPT_OBJECTS = 1 << 16,
	TS_OPT_RUNS = 1 << 17,
	TS_OPT_BACKEND = 1 << 18,
	TS_OPT_HELP = 1 << 19,
	TS_OPT_CHECK = 1 << 20
};

/* Truths, as bits. */
enum { TS_TRUTH_A = 1, TS_TRUTH_B = 2, TS_TRUTH_C = 4 };

enum { TS_MAX_ARGUMENTS = 2 };

/* What was typed. Strings belong to argv. */
typedef struct {
	u32 given;                      /* TS_OPT_* that were typed */
	const char *arguments[TS_MAX_ARGUMENTS];
	u32 n_arguments;
	ts_params params;
	ts_scene_options scene;
	const ts_backend *backend;
	const char *method, *scenes, *objects, *output, *check;
	u32 truths;                     /* TS_TRUTH_* */
	u32 threads, runs;
} ts_cli;

typedef struct {
	const char *name;
	const char *arguments;          /* as in the usage line */
	const char *doc;                /* one line */
	const char *details;            /* for `help NAME`, may be empty */
	u32 min_arguments, max_arguments;
	u32 options;                    /* TS_OPT_* */
	ts_status (*run)(ts_cli *cli);
} ts_command;

typedef struct {
	u32 bit;
	const char *name, *argument;    /* argument: "" none, "[...]" optional */
	const char *help;
	const char *list;               /* `list` tells more of its values; "" no */
} ts_option;

/* Each program's own table, ended by a row without a name. */
extern const ts_command ts_command_table[];
/* The program's name in messages. */
extern const char *const ts_program;

/* All options, ended by a row without a name. */
extern const ts_option ts_option_table[];

/* The command of that name; NULL if this program has none. */
const ts_command *ts_cli_find(const char *name);
/* The same; NULL with the message set. */
const ts_command *ts_cli_require(const char *name);
/* Runs what argv asks for and returns the exit code; a failure is printed as one line on standard error. */
int ts_cli_main(int argc, char **argv);

/* Reads argv[1...] of a command into *cli. */
ts_status ts_cli_parse(ts_cli *cli, const ts_command *command, int argc, char **argv);
bool ts_cli_given(const ts_cli *cli, u32 option);

/* Reads a decimal count in [min, max]; `what` names it in the message. */
ts_status ts_cli_count(u32 *value, const char *text, u32 min, u32 max, const char *what);
/* Copies the next item of a comma-separated list to `item` and moves *list behind it: false at the end. An item that
 * does not fit is cut, and so matches no name. */
bool ts_cli_item(const char **list, char *item, size_t item_bytes);

/* The nearest of the names offered so far to what was typed, for "did you mean". */
typedef struct {
	const char *typed, *best;
	u32 distance;
} ts_nearest;
ts_nearest ts_nearest_begin(const char *typed);
void ts_nearest_offer(ts_nearest *nearest, const char *name);

/* Commands. */
ts_status ts_help_command(ts_cli *cli);
ts_status ts_digest_command(ts_cli *cli);
ts_status ts_render_command(ts_cli *cli);
ts_status ts_info_command(ts_cli *cli);
ts_status ts_list_command(ts_cli *cli);
ts_status ts_bench_command(ts_cli *cli);
ts_status ts_vectors_command(ts_cli *cli);
/* Help of one command, or of all if NULL. */
void ts_help_print(const ts_command *command);

#endif
