/* Reads, checks and joins the folders of shards, which are untrusted. */
#ifndef TS_CLI_REPORTS_MERGE_H
#define TS_CLI_REPORTS_MERGE_H
#include <jansson.h>
#include "cli/line/cli.h"

/* A shard's folder. */
typedef struct {
	const char *dir;
	json_t *sums;           /* of its SHA256SUMS: digests by names of files */
	json_t *report, *times; /* its report.json and times.json */
	json_t *shard;          /* of the report; not owned */
	u32 index, of;
} ts_part;
/* All shards of a run, by their index. */
typedef struct ts_parts {
	ts_part *part;
	u32 n;
	const char *command, *class_name; /* of all of them */
	json_t *cases;
	ts_status status; /* the worst status of all shards */
} ts_parts;

/* Reads and checks one folder. Ended by ts_part_end also on failure. */
ts_status ts_part_read(ts_part *part, const char *dir);
void ts_part_end(ts_part *part);
/* Reads a file that SHA256SUMS confirms, of at most so many bytes; to be released by free(). NULL with the message set.
 * No other file of the folder is read. */
char *ts_part_file(size_t *bytes, const ts_part *part, const char *name, u64 most);
/* Copies such a file into the output folder. */
ts_status ts_part_copy(const ts_part *part, const char *name);
ts_status ts_part_damaged(const ts_part *part, const char *what);

/* Joins the reports of a judging command, whose cases are rows. */
ts_status ts_merge_rows(ts_cli *cli, const ts_parts *parts);
/* Joins the renders of a series; NULL in a program that renders none. Each program has its own. */
typedef ts_status ts_merger(ts_cli *cli, const ts_parts *parts);
extern ts_merger *const ts_merge_renders;

#endif
