/* Changed names of buffers, stages, parameters and sizes (renamed.def): the old names work until 0.2. An old name of an
 * option is refused with a line that tells the new one. */
#ifndef TS_MODEL_RENAMED_H
#define TS_MODEL_RENAMED_H

typedef enum { TS_NAME_buffer, TS_NAME_stage, TS_NAME_param, TS_NAME_size, TS_NAME_option } ts_name_kind;

/* A row of the table: an old name and the present one. */
typedef struct {
	ts_name_kind kind;
	const char *old, *now;
} ts_renamed;

/* The present name: `name` itself, unless the table has it as an old one. */
const char *ts_name_now(ts_name_kind kind, const char *name);
/* As ts_name_now, for a name that was typed: for each old name one line on standard error tells the present one,
 * once. */
const char *ts_name_typed(ts_name_kind kind, const char *name);

/* For tests: replaces the table by `rows`, ended by a row without names; NULL: the table of renamed.def. */
void ts_renamed_use(const ts_renamed *rows);

#endif
