/* The folders of shards: read, checked, and put together. They are untrusted. */
#ifndef TS_CLI_MERGE_H
#define TS_CLI_MERGE_H
#include <jansson.h>
#include "cli.h"

/* A shard's folder. */
typedef struct {
	const char *dir;
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
	ts_status status; /* the worst that one of them ended with */
} ts_parts;

/* Reads and checks one folder. Ended by ts_part_end also on failure. */
ts_status ts_part_read(ts_part *part, const char *dir);
void ts_part_end(ts_part *part);
/* Copies a file of the folder into the one that is written. */
ts_status ts_part_copy(const ts_part *part, const char *name);
ts_status ts_part_damaged(const ts_part *part, const char *what);

/* Puts together what a command found that judges: its cases are rows of its report. */
ts_status ts_merge_rows(ts_cli *cli, const ts_parts *parts);
/* Puts together the renders of a series. */
ts_status ts_merge_series(ts_cli *cli, const ts_parts *parts);

#endif
