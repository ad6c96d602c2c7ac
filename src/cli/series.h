/* Renders of several frames, or of several combinations of parameters: what they leave beside pictures of each. */
#ifndef TS_CLI_SERIES_H
#define TS_CLI_SERIES_H
#include "../study/contact.h"
#include "../study/frames.h"
#include "../study/plot.h"
#include "../study/sweep.h"
#include "merge.h"
#include "render.h"

/* What is told of a picture: counters, errors against each truth, and how it changed. */
enum { TS_MAX_FIGURES = 256, TS_FIGURE_NAME = 48 };
typedef struct {
	char name[TS_FIGURE_NAME];
	double value; /* NaN: the picture has none */
	int decimals;
} ts_figure;
typedef struct {
	ts_figure figure[TS_MAX_FIGURES];
	u32 n;
} ts_figures;
/* Of the i-th shown picture of a render that was compared. Names and order are those of all its pictures. */
void ts_series_figures(ts_figures *figures, const ts_render *render, u32 shown);

/* Least, mean and greatest of figures over frames. */
typedef struct {
	ts_figures figures; /* of the last frame; all but the values are those of every frame */
	ts_frame_spread spread[TS_MAX_FIGURES], milliseconds;
} ts_series_row;

/* Pictures that were made, for later combinations that change nothing that these depend on. The first that fit into an
 * eighth of the memory that a run may use are kept. */
typedef struct ts_kept ts_kept;
typedef struct {
	ts_kept *list;
	u64 bytes;
} ts_keep;

enum { TS_SERIES_NAME = TS_MAX_SWEEPS * 2 * (TS_SWEEP_TEXT + 1) };

/* A point of a plot. */
typedef struct {
	u32 along, figure, shown; /* axis: 0, the frame, or 1 + a swept parameter; row of the figures that are plotted */
	double x, y;
} ts_datum;

typedef struct {
	u32 combination, frame;
	u64 resident_bytes;
	double milliseconds[TS_MAX_SHOWN]; /* NaN: not shown */
} ts_series_time;

typedef struct {
	ts_cli *cli;
	ts_job *job; /* its parameters are those of the render that is made */
	ts_render *render;
	ts_report report;
	ts_file_text csv;
	ts_series_time *times; /* of each render */
	ts_contact contact;
	ts_keep keep;
	ts_series_row *rows[TS_MAX_SHOWN]; /* over the frames of a combination; NULL: not made yet */
	u8 *before[TS_MAX_SHOWN];          /* pictures of the frame before; NULL: there are none */
	u8 *mirrors_before, *mirrors_still;
	char values[TS_MAX_SWEEPS][TS_SWEEP_TEXT]; /* of the combination */
	char name[TS_SERIES_NAME];                 /* of the combination, "" or "cube.px=64"; and of a folder of it */
	char folder[TS_SERIES_NAME + 24];
	u32 combination, n_done; /* its place among all; renders before this one */
	u32 n_all;               /* renders of this shard */
	bool begun;              /* the report has its head */
	json_t *renders;         /* of a shard: what they gave */
	const ts_part *from;     /* of merge: the shard of this one, */
	const json_t *fetched;   /* and what this one gave */
	u32 absent;              /* truths that cannot be made, as the report has said */
	ts_datum *data;          /* of the plots */
	size_t n_data, data_capacity;
} ts_series;

/* Moves what was kept for this combination and frame into the render. */
void ts_keep_give(ts_series *series);
/* Takes the pictures of the render, but for those that do not fit, which stay. */
ts_status ts_keep_take(ts_series *series);
void ts_keep_free(ts_keep *keep);

/* Whether the shard has frame number k of a combination. A case is a combination, or, where there is no sweep, a
 * frame. */
bool ts_series_has(const ts_series *series, u32 combination, u32 k);
/* Keeps what this render gave: its figures, exactly. */
ts_status ts_series_record(ts_series *series);
/* Writes the report as one of a shard. */
ts_status ts_series_shard_write(ts_series *series);
/* Takes the pictures, times and figures of this render from the shard that made them, for merge. */
ts_status ts_series_fetch(ts_series *series);
ts_status ts_series_fetch_figures(ts_figures *figures, const ts_series *series, u32 shown);
/* Rows of names and of what they show, as the shard of this render has them. */
void ts_series_fetch_pictures(ts_table *table, const ts_series *series);
/* Copies the files of this render from there. */
ts_status ts_series_copy(ts_series *series);

/* Adds this render's figures to those of the combination, series->rows. */
ts_status ts_series_add(ts_series *series);
/* Tables of means and extremes over the frames, if there is one combination. */
void ts_series_report(ts_series *series);
/* Those figures as lines of CSV, a picture each; before the first the names of the columns. With times on standard
 * output too, if `print`. */
ts_status ts_series_csv(ts_series *series, bool print);
/* Keeps what the plots show of this frame, or of a whole combination. */
ts_status ts_series_plot_frame(ts_series *series);
ts_status ts_series_plot_combination(ts_series *series);
/* Writes errors and changes by frame and by each swept parameter that is a number, as SVG. */
ts_status ts_series_plots_write(ts_series *series);

#endif
