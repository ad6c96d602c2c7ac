/* Renders of several frames, or of several combinations of parameters: the outputs beside the pictures of each. */
#ifndef TS_CLI_SERIES_H
#define TS_CLI_SERIES_H
#include "cli/render.h"
#include "cli/reports/merge.h"
#include "study/asked/sweep.h"
#include "study/contact.h"
#include "study/frames.h"
#include "study/plot.h"

/* The figures of a picture: counters, errors against each truth, and changes. */
enum { TS_MAX_FIGURES = 256, TS_FIGURE_NAME = 48 };
typedef struct {
	char name[TS_FIGURE_NAME];
	double value; /* NaN: the picture has none */
	int decimals;
} ts_series_figure;
typedef struct {
	ts_series_figure figure[TS_MAX_FIGURES];
	u32 n;
} ts_series_figure_list;
/* The figures of the i-th shown picture of a render that was compared. All pictures of a render have the same names, in
 * the same order. */
void ts_series_figures(ts_series_figure_list *figures, const ts_render *render, u32 shown);

/* Least, mean and greatest of figures over frames. */
typedef struct {
	ts_series_figure_list figures; /* of the last frame; their names are those of every frame */
	ts_frame_spread spread[TS_MAX_FIGURES], milliseconds;
} ts_series_row;

/* Pictures that are kept for later combinations with the same values of all parameters that the pictures depend on. The
 * first pictures that fit into an eighth of the memory of a run are kept. */
typedef struct ts_kept ts_kept;
typedef struct {
	ts_kept *list;
	u64 bytes;
} ts_keep;

enum { TS_SERIES_NAME = TS_MAX_SWEEPS * 2 * (TS_SWEEP_TEXT + 1) };

/* A point of a plot. */
typedef struct {
	u32 along, figure, shown; /* axis: 0 the frame, or 1 + a swept parameter; row of the plotted figures; picture */
	double x, y;
} ts_datum;

typedef struct {
	u32 combination, frame;
	u64 resident_bytes;
	double milliseconds[TS_MAX_SHOWN]; /* NaN: not shown */
} ts_series_time;

typedef struct {
	ts_cli *cli;
	ts_job *job; /* has the parameters of the current render */
	ts_render *render;
	ts_report report;
	ts_file_text csv;
	ts_series_time *times; /* of each render */
	ts_contact contact;
	ts_keep keep;
	ts_series_row *rows[TS_MAX_SHOWN]; /* figures over the frames of a combination; NULL: not made yet */
	u8 *before[TS_MAX_SHOWN];          /* pictures of the frame before; NULL: there are none */
	u8 *mirrors_before, *mirrors_still;
	char values[TS_MAX_SWEEPS][TS_SWEEP_TEXT]; /* of the combination */
	char name[TS_SERIES_NAME];                 /* of the combination, "" or "cube.px=64", and of its folder */
	char folder[TS_SERIES_NAME + 24];
	u32 combination, n_done; /* index of the combination; renders before this one */
	u32 n_all;               /* renders of this shard */
	bool begun;              /* the report has its head */
	json_t *renders;         /* of a shard: results of its renders */
	const ts_part *from;     /* merge: the shard of this render */
	ts_scene reported;       /* merge: of the scene, what the shards report */
	const json_t *fetched;   /* merge: the results of this render */
	u32 absent;              /* truths that cannot be made and were reported */
	ts_datum *data;          /* of the plots */
	size_t n_data, data_capacity;
} ts_series;

/* Moves the pictures that were kept for this combination and frame into the render. */
void ts_keep_give(ts_series *series);
/* Takes the pictures of the render; pictures that do not fit stay. */
ts_status ts_keep_take(ts_series *series);
void ts_keep_free(ts_keep *keep);

/* Whether the shard has frame number k of a combination. A case is a combination, or, where there is no sweep, a
 * frame. */
bool ts_series_has(const ts_series *series, u32 combination, u32 k);
/* Records the figures of this render, exactly. */
ts_status ts_series_record(ts_series *series);
/* Writes the report as one of a shard. */
ts_status ts_series_shard_write(ts_series *series);
/* Takes the scene's figures, the exposure and the backend from the first shard, for merge: the scene is not opened. */
ts_status ts_series_fetch_head(ts_series *series);
/* Reports the truths that the shard of this combination lacks, unless the one before lacked the same. */
ts_status ts_series_fetch_missing(ts_series *series);
/* Takes the pictures, times and figures of this render from the shard that made them, for merge. */
ts_status ts_series_fetch(ts_series *series);
ts_status ts_series_fetch_figures(ts_series_figure_list *figures, const ts_series *series, u32 shown);
/* Rows of the pictures' table, as the shard of this render has them. */
void ts_series_fetch_pictures(ts_table *table, const ts_series *series);
/* Copies the files of this render from its shard. */
ts_status ts_series_copy(ts_series *series);

/* Joins shards of a series: the command runs again, except for the renders, which the shards made. */
ts_merger ts_merge_series;

/* Adds this render's figures to those of the combination, series->rows. */
ts_status ts_series_add(ts_series *series);
/* Tables of means and extremes over the frames, if there is one combination. */
void ts_series_report(ts_series *series);
/* Writes the figures as lines of CSV, one per picture; before the first the names of the columns. If `print`, also to
 * standard output, with times. */
ts_status ts_series_csv(ts_series *series, bool print);
/* Keeps the data of this frame, or of a whole combination, for the plots. */
ts_status ts_series_plot_frame(ts_series *series);
ts_status ts_series_plot_combination(ts_series *series);
/* Writes errors and changes by frame and by each swept parameter that is a number, as SVG. */
ts_status ts_series_plots_write(ts_series *series);

#endif
