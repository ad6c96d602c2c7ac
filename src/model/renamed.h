/* Names of buffers, stages, parameters and sizes that were changed (renamed.def): the old ones work until 0.2. An
 * option's old name is refused, by a line with the new one. */
#ifndef TS_MODEL_RENAMED_H
#define TS_MODEL_RENAMED_H

typedef enum { TS_NAME_buffer, TS_NAME_stage, TS_NAME_param, TS_NAME_size, TS_NAME_option } ts_name_kind;

/* A row of the table: an old name, and what it is now. */
typedef struct {
	ts_name_kind kind;
	const char *old, *now;
} ts_renamed;

/* The name of today: `name` itself, unless it is an old one. */
const char *ts_name_now(ts_name_kind kind, const char *name);
/* The same of a name that was typed: about each old one a line on standard error says once what it is called now. */
const char *ts_name_typed(ts_name_kind kind, const char *name);

/* Takes another table, ended by a row without names; NULL: that of renamed.def. For tests. */
void ts_renamed_use(const ts_renamed *rows);

#endif
