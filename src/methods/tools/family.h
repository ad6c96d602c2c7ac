/* The rows of a family of methods for each engine, since engines know no method by name. The rows of a family are in
 * its tools/tools.c; an empty list is NULL. */
#ifndef TS_METHODS_TOOLS_FAMILY_H
#define TS_METHODS_TOOLS_FAMILY_H
#include "compare/decided.h"
#include "probe/probe.h"
#include "replay/check.h"
#include "study/asked/truths.h"
#include "study/notes.h"
#include "study/stage_pictures.h"
#include "study/sums.h"
#include "study/tables/text.h"
#include "trace/where.h"
#include "truth/texels.h"

typedef struct {
	const ts_where_rule *places;           /* ended by a row without `where` */
	const ts_tie_rule *ties;               /* ended by a row without `open` */
	const ts_margin_rule *margins;         /* ended by a row of no elements */
	const ts_check_rule *checks;           /* ended by a row without `check` */
	const ts_truth_kind *truths;           /* ended by a row without a name */
	const ts_texel_rule *texels;           /* ended by a row without `judge` */
	const ts_table_code *codes;            /* ended by a row without a name */
	const ts_probe_part *parts;            /* ended by a row without `answer` */
	const ts_stage_picture_rule *pictures; /* ended by a row without `take` */
	const ts_picture_mark *marks;          /* ended by NULL */
	const ts_viewer_rule *viewers;         /* ended by a row without `write` */
	const ts_buffer_id *keeps;             /* ended by TS_N_BUFFERS */
	const ts_lower_rule *lowers;           /* ended by a row without `param` */
	const ts_note_rule *notes;             /* ended by a row without `take` */
	const ts_bytes_rule *bytes;            /* ended by a row without `bytes` */
	const ts_figures_rule *figures;        /* ended by a row without `put` */
} ts_family_tools;

#endif
