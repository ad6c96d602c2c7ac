/* The command line: one table of commands, one table of options, one parser for all. */
#ifndef TS_CLI_CLI_H
#define TS_CLI_CLI_H
#include <touchstone/params.h>
#include <touchstone/scene.h>
#include "../core/core.h"
#include "../kernels/compat.h"
#include "backends.h"

/* Options, as bits: a command names those it takes. */
#define TS_OPT(n) (1ull << (n))
#define TS_OPT_METHOD TS_OPT(0)
#define TS_OPT_TRUTH TS_OPT(1)
#define TS_OPT_SIZE TS_OPT(2)
#define TS_OPT_FRAME TS_OPT(3)
#define TS_OPT_REFLECTORS TS_OPT(4)
#define TS_OPT_REFLECTOR TS_OPT(5)
#define TS_OPT_CAMERA TS_OPT(6)
#define TS_OPT_SET TS_OPT(7)
#define TS_OPT_THREADS TS_OPT(8)
#define TS_OPT_REFERENCE TS_OPT(9)
#define TS_OPT_OUTPUT TS_OPT(10)
#define TS_OPT_FORCE TS_OPT(11)
#define TS_OPT_JSON TS_OPT(12)
#define TS_OPT_NO_IMAGES TS_OPT(13)
#define TS_OPT_FLUSH_DENORMALS TS_OPT(14)
#define TS_OPT_SCENE TS_OPT(15)
#define TS_OPT_OBJECTS TS_OPT(16)
#define TS_OPT_RUNS TS_OPT(17)
#define TS_OPT_BACKEND TS_OPT(18)
#define TS_OPT_TRACE TS_OPT(19)
#define TS_OPT_TRACE_ONLY TS_OPT(20)
#define TS_OPT_CROP TS_OPT(21)
#define TS_OPT_ULP TS_OPT(22)
#define TS_OPT_ABS TS_OPT(23)
#define TS_OPT_REL TS_OPT(24)
#define TS_OPT_ALLOW TS_OPT(25)
#define TS_OPT_IGNORE TS_OPT(26)
#define TS_OPT_MASK TS_OPT(27)
#define TS_OPT_LAYOUT TS_OPT(28)
#define TS_OPT_ORDER TS_OPT(29)
#define TS_OPT_JUNIT TS_OPT(30)
#define TS_OPT_TAP TS_OPT(31)
#define TS_OPT_DECIDED TS_OPT(32)
#define TS_OPT_MARGINS TS_OPT(33)
#define TS_OPT_REASON TS_OPT(34)
#define TS_OPT_REFERENCE_DIR TS_OPT(35)
#define TS_OPT_CHECK TS_OPT(36)
#define TS_OPT_PIXEL TS_OPT(37)
#define TS_OPT_VIEW TS_OPT(38)
#define TS_OPT_TRIANGLE TS_OPT(39)
#define TS_OPT_POINT TS_OPT(40)
#define TS_OPT_STAGE TS_OPT(41)
#define TS_OPT_INPUTS TS_OPT(42)
#define TS_OPT_FORCED TS_OPT(43)
#define TS_OPT_VIEWER TS_OPT(44)
#define TS_OPT_DEVICE TS_OPT(45)
#define TS_OPT_WORK_GROUP TS_OPT(46)
#define TS_OPT_BUILD TS_OPT(47)
#define TS_OPT_INEXACT TS_OPT(48)
#define TS_OPT_REQUIRE TS_OPT(49)
#define TS_OPT_EFFECT TS_OPT(50)
#define TS_OPT_HELP TS_OPT(51)
#define TS_OPT_FROM_MESH TS_OPT(52)

enum { TS_MAX_ARGUMENTS = 2, TS_MAX_SWEEPS = 8, TS_SWEEP_TEXT = 48 };

/* A parameter of which several values were typed. */
typedef struct {
	char name[TS_SWEEP_TEXT];
	const char *values; /* separated by commas; belongs to argv */
	u32 n;
} ts_swept;
typedef struct { ts_swept swept[TS_MAX_SWEEPS]; u32 n; } ts_sweep;

/* What was typed. Strings belong to argv. */
struct ts_cli {
	u64 given;                      /* TS_OPT_* that were typed */
	const char *arguments[TS_MAX_ARGUMENTS];
	u32 n_arguments;
	char *const *options;           /* what else was typed */
	u32 n_options;
	ts_params params;
	ts_sweep sweep;
	ts_scene_options scene;
	const ts_backend_kind *backend;
	ts_backend_options device;      /* of the backend */
	const char *effect, *method, *scenes, *objects, *output, *trace_only, *crop;
	const char *ignore, *mask, *layout, *junit;
	const char *pixel, *view, *point;
	u64 ulp, allow, triangle;
	double abs, rel;
	const char *reason, *reference_dir;
	const char *check, *stage, *inputs, *truth;
	ts_how how;                     /* its backend is opened before the command runs */
	double open_s;                  /* that this took, its arithmetic checked */
	u32 runs;
};

typedef struct {
	const char *name;
	const char *arguments;          /* as in the usage line */
	const char *doc;                /* one line */
	const char *details;            /* for `help NAME`, may be empty */
	u32 min_arguments, max_arguments;
	u64 options;                    /* TS_OPT_* */
	ts_status (*run)(ts_cli *cli);
} ts_command;

typedef struct {
	u64 bit;
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
bool ts_cli_given(const ts_cli *cli, u64 option);

/* Reads a decimal count in [min, max]; `what` names it in the message. */
ts_status ts_cli_count(u32 *value, const char *text, u32 min, u32 max, const char *what);
/* Reads "WxH" into width and height; `what` names it in the message. */
ts_status ts_cli_size(ts_params *params, const char *text, const char *what);
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
ts_status ts_golden_command(ts_cli *cli);
ts_status ts_render_command(ts_cli *cli);
ts_status ts_info_command(ts_cli *cli);
ts_status ts_list_command(ts_cli *cli);
ts_status ts_bench_command(ts_cli *cli);
ts_status ts_compare_command(ts_cli *cli);
ts_status ts_vectors_command(ts_cli *cli);
ts_status ts_probe_command(ts_cli *cli);
ts_status ts_replay_command(ts_cli *cli);
/* Help of one command, or of all if NULL. */
void ts_help_print(const ts_command *command);

#endif
