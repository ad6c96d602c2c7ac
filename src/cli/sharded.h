/* The folder of a shard's results: report.json has a member "shard", and SHA256SUMS, as sha256sum checks them, is of
 * all its files but times.json. `merge` reads it. */
#ifndef TS_CLI_SHARDED_H
#define TS_CLI_SHARDED_H
#include "../study/table.h"
#include "cli.h"

#define TS_SHARDED_SUMS "SHA256SUMS"

typedef struct {
	const char *command;    /* "golden check" */
	const char *class_name; /* of its cases in JUnit XML */
	json_t *cases;          /* names of all cases, in their order */
	ts_status status;       /* that the command ends with */
	json_t *renders;        /* of a series, what its renders gave; NULL */
} ts_sharded;
/* Writes the report as ts_results_report, as one of a shard. */
ts_status ts_sharded_write(ts_report *report, const ts_cli *cli, const ts_sharded *sharded);
/* What was typed that says what is worked on, but not how fast, which part, or what is written where; a new reference,
 * or NULL without memory. */
json_t *ts_sharded_typed(const ts_cli *cli);
/* The digest of a file; false: it cannot be read. */
bool ts_sharded_digest(char *hex, const char *path);

#endif
