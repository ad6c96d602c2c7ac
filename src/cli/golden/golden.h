/* The command `golden`: cases.txt in reference/goldens lists the runs, and a folder for each holds its results. Part of
 * the core. */
#ifndef TS_CLI_GOLDEN_GOLDEN_H
#define TS_CLI_GOLDEN_GOLDEN_H
#include <touchstone/image.h>
#include "cli/golden/baseline.h"
#include "cli/line/cli.h"
#include "golden/beside.h"
#include "golden/params.h"

enum { TS_MAX_CASES = 128, TS_CASE_NAME = 41, TS_CASE_TEXT = TS_GOLDEN_TEXT };

/* A line of cases.txt. */
typedef struct {
	char name[TS_CASE_NAME]; /* of a-z, 0-9 and -: also its folder */
	const ts_pipeline *pipeline;
	ts_golden_settings settings;
	bool small; /* small files are stored as they are */
} ts_case;

/* The cases and goldens of a `golden` command. */
typedef struct {
	ts_cli *cli;
	ts_golden_dir dir; /* reference/goldens/ */
	ts_case cases[TS_MAX_CASES];
	u32 n_cases;
	ts_baseline known, skips;
	const ts_case *chosen[TS_MAX_CASES]; /* cases to work on */
	u32 n_chosen;
} ts_goldens;

enum { TS_CASE_PATH = TS_GOLDEN_PATH + TS_CASE_NAME + 8 };
/* The folder of a case, or, with suffix ".new", of its proposal. */
void ts_case_path(char path[TS_CASE_PATH], const ts_goldens *goldens, const ts_case *c, const char *suffix);
/* Whether text can be the name of a case. */
bool ts_case_name(const char *text);
/* Reads cases.txt of goldens->dir. */
ts_status ts_cases_read(ts_goldens *goldens);
/* The case of that name; NULL with the message set. */
const ts_case *ts_cases_find(const ts_goldens *goldens, const char *name);

/* Writes params.txt of a case to the folder that is written: effect, method, scene and the parameters that they read,
 * NAME=VALUE lines. */
ts_status ts_case_write_params(const ts_case *c);
/* Compares params.txt of a folder with the case. TS_DIFFERENT: `text` says where. A parameter that the file does not
 * name, because it was added later, must have its default. */
ts_status ts_case_check_params(char *text, size_t text_bytes, const ts_case *c, const ts_golden_dir *dir);

/* Compares as ts_golden_compare does; then, in a program that reads PNG, the folder's preview with the computed
 * picture. */
ts_status ts_case_compare(char *text, const ts_case *c, const ts_golden_dir *dir, const ts_golden *stored,
                          const ts_golden *computed);
/* TS_DIFFERENT: the computed golden has numbers that no stage may store; `text` says how many. */
ts_status ts_case_strays(char *text, const ts_golden *computed);

/* Runs a case as ts_golden_compute does; refuses a case that does not fit the machine. Release by ts_golden_free, also
 * after a failure. */
ts_status ts_case_compute(ts_golden *golden, const ts_goldens *goldens, const ts_case *c, const ts_how *how);

/* The outcome of the check of a case. */
typedef enum {
	TS_CASE_SAME,
	TS_CASE_SKIPPED,
	TS_CASE_KNOWN,
	TS_CASE_DIFFERENT,
	TS_CASE_MISSING,
	TS_CASE_UNUSABLE,
	TS_CASE_LOST, /* with the process that ran it */
	TS_N_CASE_ENDS,
} ts_case_end;
typedef struct {
	const ts_case *of;
	ts_case_end end;
	ts_buffer_id first;      /* buffer that differs; TS_N_BUFFERS: none */
	const char *why;         /* reason if it is known or skipped; otherwise "" */
	char text[TS_CASE_TEXT]; /* the difference, or the error */
	double seconds;
} ts_checked;
/* What the worker keeps for one that follows it. */
typedef struct {
	ts_steps steps; /* cases */
	ts_checked checked[TS_MAX_CASES];
} ts_golden_kept;
/* The stage of the first buffer that differs. */
const char *ts_checked_stage(const ts_checked *checked);
/* "same", "different", ... */
const char *ts_case_word(ts_case_end end);
/* Reports the checks of a command that ends with `status`, in the forms of --json, --tap, --junit and -o; NULL in a
 * program without these options. Each program has its own. */
typedef ts_status ts_golden_reporter(const ts_goldens *goldens, const ts_checked *checked, u32 n, ts_status status);
extern ts_golden_reporter *const ts_golden_report;
ts_golden_reporter ts_golden_report_checks; /* that of the programs with these options */

/* The actions. */
ts_status ts_golden_check_action(const ts_goldens *goldens);
ts_status ts_golden_new_action(const ts_goldens *goldens);
ts_status ts_golden_bless_action(const ts_goldens *goldens);

/* What writes and reads previews, NULL in a program that cannot, and opens scenes. Each program has its own. */
typedef struct {
	ts_status (*write)(const char *path, const u8 *srgb, u32 width, u32 height, u32 channels,
	                   const ts_image_text *texts);
	ts_golden_decoder *read;
	ts_golden_opener *open;
} ts_golden_files;
extern const ts_golden_files ts_golden_by;

#endif
