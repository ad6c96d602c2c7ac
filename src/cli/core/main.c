/* The command `touchstone-core`: digests and goldens, in C with libc, libgomp and libcrypto, as a static binary; with
 * TS_REPORTS, which needs jansson, also the reports of `golden check` and `merge`. */
#include "cli/golden/golden.h"
#include "families/families.h"

const char *const ts_program = "touchstone-core";
const ts_golden_files ts_golden_by = {NULL, NULL, ts_builtin_open};
const ts_backend_kind *const ts_backend_kinds[] = {&ts_c_kind, NULL};

#ifdef TS_REPORTS
#include "cli/reports/merge.h"
#define REPORTS TS_OPT(JUNIT), TS_OPT(MARKDOWN), TS_OPT(TAP), TS_OPT(JSON), TS_OPT(OUTPUT), TS_OPT(FORCE), TS_OPT(QUIET)
#define FAILED .failed = ts_golden_failed
ts_golden_reporter *const ts_golden_report = ts_golden_report_checks;
ts_merger *const ts_merge_renders = NULL;
#else
#define REPORTS TS_OPT(QUIET)
#define FAILED .failed = NULL
ts_golden_reporter *const ts_golden_report = NULL;
#endif

const ts_command ts_command_table[] = {
	{"digest", "[SCENE]", "SHA-256 of every buffer of a built-in scene, in pipeline order", 0, 1, TS_OPT(EFFECT),
     TS_OPT(METHOD), TS_OPT(SIZE), TS_OPT(FRAME), TS_OPT(REFLECTORS), TS_OPT(SET), TS_OPT(THREADS),
     TS_OPT(NO_FAST_PATHS), TS_OPT(FLUSH_DENORMALS), .run = ts_digest_command},
	{"golden", "ACTION [CASE...]", "check, new or bless: goldens", 1, TS_MAX_ARGUMENTS, TS_OPT(SHARD), TS_OPT(THREADS),
     TS_OPT(NO_FAST_PATHS), TS_OPT(BACKEND), TS_OPT(BASELINE), TS_OPT(SKIP), TS_OPT(REASON), TS_OPT(GOLDENS), REPORTS,
     .run = ts_golden_command, .kept = sizeof(ts_golden_kept), FAILED},
#ifdef TS_REPORTS
	{"merge", "DIR...", "results of shards, put together", 1, TS_MAX_ARGUMENTS, REPORTS, .run = ts_merge_command},
#endif
	{"help", "[COMMAND]", "what a command does and takes", 0, 1, .run = ts_help_command},
	{0},
};

int main(int argc, char **argv)
{
	ts_families_begin();
	return ts_cli_main(argc, argv);
}
