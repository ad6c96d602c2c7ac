/* SPDX-License-Identifier: Apache-2.0 */
/* Tables of figures: the papers', and your own (reference/BENCH.md). */
#ifndef TOUCHSTONE_BENCH_H
#define TOUCHSTONE_BENCH_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/context.h>
#include <touchstone/params.h>
#include <touchstone/status.h>
#include <touchstone/tree.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Options of a table. Only `bytes` must be set; 0 is what the table says. */
typedef struct {
	size_t bytes;        /* sizeof(ts_bench_options) */
	const char *scenes;  /* separated by commas, as of ts_scene_open */
	const char *objects; /* numbers of mirrors, lights, ...: what the table's rows vary */
	uint32_t runs;       /* of which times are medians */
} ts_bench_options;

/* Measures a table.
 * In: table: a name that `touchstone list benches` prints, or the path of a file, FILE.table or FILE.table:NAME;
 * params: what differs from the defaults goes before what the table says; options NULL: all defaults.
 * Out: *figures is what `touchstone bench TABLE --json` prints: a list of rows for each part of the table, and
 * "relations", what must hold; to be released by ts_tree_free; NULL on failure.
 * Fails with file, line and column if a file's table cannot be read; and on tables of machines, as "speed", which the
 * command alone measures. */
TS_API ts_status ts_bench_table(ts_context *context, ts_tree **figures, const char *table, const ts_params *params,
                                const ts_bench_options *options);

#ifdef __cplusplus
}
#endif
#endif
