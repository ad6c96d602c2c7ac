/* Figures of what was measured by their names: of a variant (`epr.ms.splat`, `epr.count.points`, `epr.rmse.C`), of the
 * scene, the image and the parameters. */
#ifndef TS_STUDY_FIGURE_H
#define TS_STUDY_FIGURE_H
#include "study/measure.h"

enum { TS_FIGURE_TRUTHS = 128 }; /* truths are numbered from here, variants from 0 */

/* What is measured: variants by their number, and truths. */
typedef struct {
	const ts_scene *scene;
	const ts_params *params;
	const ts_pipeline *const *methods; /* of variants; NULL: that one was not run */
	const ts_measure *measures;
	const ts_picture *images, *truths;
	const double *looked; /* NULL: nothing is looked at */
} ts_figure_source;

/* What a figure's name has behind it. */
typedef enum {
	TS_FIGURE_ALONE,
	TS_FIGURE_OF_COUNTER,
	TS_FIGURE_OF_STAGES, /* a stage, or a list of them that the table names */
	TS_FIGURE_OF_BUFFERS,
	TS_FIGURE_OF_PARAM,
	TS_FIGURE_OF_IMAGE, /* another variant, or a truth */
} ts_figure_object;

typedef struct ts_figure ts_figure;

/* A kind of figure. */
typedef struct {
	const char *name; /* without the variant and the object */
	const char *doc, *unit;
	ts_figure_object object;
	bool of_case; /* of the scene, the image and the parameters: no variant stands before the name */
	bool timed;   /* two runs differ */
	double (*value)(const ts_figure *figure, const ts_figure_source *c);
} ts_figure_row;

/* One figure. */
struct ts_figure {
	const ts_figure_row *row;
	u32 variant, other; /* other: a variant, or TS_FIGURE_TRUTHS and the number of a truth */
	const char *what;   /* the object: a counter; a parameter; stages or buffers, separated by commas */
};

/* All kinds, ended by one without a name. */
extern const ts_figure_row ts_figure_rows[];

/* Writes the name of a counter as figures have it. */
void ts_figure_counter(char *name, size_t bytes, const char *counter);
/* The value; NaN: it is missing, as that of a variant which was not run, or of a stage that it does not have. */
double ts_figure_value(const ts_figure *figure, const ts_figure_source *source);
/* The standard error of a value that is estimated; otherwise 0. */
double ts_figure_error(const ts_figure *figure, const ts_figure_source *source);

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
	bool own_truth; /* there is one, "truth" */
} ts_name_scope;

/* The number of a variant, or TS_NONE. */
u32 ts_name_variant(const ts_name_scope *scope, const char *name, size_t n);
bool ts_name_is_param(const char *name);
/* Refers to `name`, which must outlive the figure. The message of a failure names no place. */
ts_status ts_name_find(ts_figure *figure, const ts_name_scope *scope, const char *name);

#endif
