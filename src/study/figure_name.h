/* Finds what a name in an expression stands for: `epr.ms.frame`. */
#ifndef TS_STUDY_FIGURE_NAME_H
#define TS_STUDY_FIGURE_NAME_H
#include "study/figure.h"

/* A list of stages or buffers by one name. */
typedef struct {
	const char *name, *items; /* separated by commas */
} ts_named_list;

/* What names may refer to. */
typedef struct {
	const char *const *variants, *const *truths; /* names; truths ended by NULL */
	u32 n_variants;
	const ts_named_list *lists;
	u32 n_lists;
} ts_name_scope;

/* The number of a variant, or TS_NONE. */
u32 ts_name_variant(const ts_name_scope *scope, const char *name, size_t n);
bool ts_name_is_param(const char *name);
/* Refers to `name`, which must outlive the figure. The message of a failure names no place. */
ts_status ts_name_find(ts_figure *figure, const ts_name_scope *scope, const char *name);

#endif
