/* The folder of a shard's results, which `merge` reads: report.json has a member "shard", and SHA256SUMS, for
 * sha256sum, names all other files. */
#ifndef TS_CLI_REPORTS_SHARDED_H
#define TS_CLI_REPORTS_SHARDED_H
#include "cli/line/cli.h"
#include "study/results/table.h"

#define TS_SHARDED_SUMS "SHA256SUMS"

typedef struct {
	const char *command;    /* "golden check" */
	const char *class_name; /* of its cases in JUnit XML */
	json_t *cases;          /* names of all cases, in their order */
	ts_status status;       /* with which the command ends */
	json_t *renders;        /* of a series, the results of its renders; otherwise NULL */
} ts_sharded;
/* Writes the report of a shard, otherwise like ts_results_report. */
ts_status ts_sharded_write(ts_report *report, const ts_cli *cli, const ts_sharded *sharded);
/* Whether a shard's report says that the option was typed: those of what is computed and how it is judged. The others,
 * of how it runs and where its output goes, are those of merge. */
bool ts_sharded_tells(u32 option);
/* Reads a file of a folder and takes its digest; to be released by free(). NULL with the message set. */
char *ts_sharded_read(size_t *bytes, char *hex, const char *dir, const char *name, u64 most);

#endif
