/* The families, in the order of their rows in the engines' tables. */
#include "tools/tools.h"
#include "methods/tools/family.h"

#define TOOLS(name) extern const ts_family_tools ts_##name##_tools;
#include "families.def"

#define TOOLS(name) &ts_##name##_tools,
static const ts_family_tools *const families[] = {
#include "families.def"
};

enum { N_FAMILIES = sizeof families / sizeof *families };

/* Passes to `use` the lists of all families that have one, ended by NULL. */
#define HAND(use, type, list) \
	do { \
		static const type *lists[N_FAMILIES + 1]; \
		u32 n = 0; \
		for (u32 i = 0; i < N_FAMILIES; i++) { \
			if (families[i]->list != NULL) lists[n++] = families[i]->list; \
		} \
		use(lists); \
	} while (0)

void ts_tools_begin(void)
{
	HAND(ts_where_use, ts_where_rule, places);
	HAND(ts_tie_use, ts_tie_rule, ties);
	HAND(ts_decided_use, ts_margin_rule, margins);
	HAND(ts_check_use, ts_check_rule, checks);
	HAND(ts_probe_use, ts_probe_part, parts);
	HAND(ts_truths_use, ts_truth_kind, truths);
	HAND(ts_texels_use, ts_texel_rule, texels);
	HAND(ts_table_codes_use, ts_table_code, codes);
	HAND(ts_stage_pictures_use, ts_stage_picture_rule, pictures);
	HAND(ts_picture_marks_use, ts_picture_mark, marks);
	HAND(ts_viewer_use, ts_viewer_rule, viewers);
	HAND(ts_measure_keeps_use, ts_buffer_id, keeps);
	HAND(ts_measure_lowers_use, ts_lower_rule, lowers);
	HAND(ts_notes_use, ts_note_rule, notes);
	HAND(ts_sums_bytes_use, ts_bytes_rule, bytes);
	HAND(ts_sums_figures_use, ts_figures_rule, figures);
}
