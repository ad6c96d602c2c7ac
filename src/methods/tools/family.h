/* What a family of methods brings for the tools: its rows for each engine, which knows no method by name. A family's are
 * in its tools/tools.c. A list that a family has nothing for is NULL. */
#ifndef TS_METHODS_TOOLS_FAMILY_H
#define TS_METHODS_TOOLS_FAMILY_H
#include "../../compare/decided.h"
#include "../../compare/tie.h"
#include "../../probe/probe.h"
#include "../../replay/check.h"
#include "../../study/bench.h"
#include "../../truth/table.h"
#include "../../truth/texels.h"

typedef struct {
	const ts_tie_rule *ties;       /* ended by a row without `open` */
	const ts_margin_rule *margins; /* ended by a row of no elements */
	const ts_check_rule *checks;   /* ended by a row without `check` */
	const ts_truth_kind *truths;   /* ended by a row without a name */
	const ts_texel_rule *texels;   /* ended by a row without `judge` */
	const ts_bench_row *benches;   /* ended by a row without a name */
	const ts_probe_part *parts;    /* ended by a row without `answer` */
} ts_family_tools;

#endif
