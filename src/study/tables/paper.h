/* A table of a paper as data: methods and scenes to run, figures to show, the paper's values, and relations that must
 * hold. */
#ifndef TS_STUDY_TABLES_PAPER_H
#define TS_STUDY_TABLES_PAPER_H
#include "study/bench_case.h"
#include "study/expression.h"
#include "study/frames.h"
#include "study/plot.h"
#include "study/results/table.h"

enum { TS_BENCH_FIGURES = 96, TS_BENCH_MEASURED = 256 }; /* at most */

typedef struct {
	const char *key, *head; /* of the column */
	int decimals;           /* TS_WHOLE: a count */
	const ts_term *terms;   /* of the expression */
	u32 n_terms;
	bool timed;    /* two runs differ */
	bool measured; /* the expression itself names what is measured */
} ts_bench_figure;
enum { TS_WHOLE = -1 };

/* Computes the figures that are missing, one after the other; `figures` is ended by one without a key. `measured` has
 * all values that expressions name; `before` is the scene's row before, or NULL. */
void ts_bench_derive(double *values, const double *measured, const double *before, const ts_bench_figure *figures);
/* Appends the value of a figure as a cell. */
void ts_bench_cell(ts_table *table, const ts_bench_figure *figure, double value);

/* Lists of figures end with this one. */
enum { TS_NO_FIGURE = 255 };
/* Characters of a reason and of a column's head, at most. */
enum { TS_PAPER_REASON = 300, TS_PAPER_HEAD = 60 };

/* A row as the paper prints it. */
typedef struct {
	const char *name;                 /* of the paper's scene */
	const char *builtin;              /* our scene of its kind */
	const char *file;                 /* beginning of the name of a file of the paper's scene */
	u32 objects;                      /* or pixels */
	double figures[TS_BENCH_FIGURES]; /* NaN: not printed, or derived here */
} ts_paper_row;

/* A part of a table: some of its figures as columns, behind three of scene, objects and source. */
enum { TS_PAPER_COLUMNS = TS_MAX_COLUMNS - 3 };
typedef struct {
	const char *key, *title;
	u8 figures[TS_PAPER_COLUMNS + 1]; /* ended by TS_NO_FIGURE */
} ts_paper_part;

typedef enum { TS_AT_MOST, TS_AT_LEAST, TS_BETWEEN, TS_OF_PAPER, TS_RISES_WITH, TS_GROWS, TS_STEADY } ts_relation_kind;

/* A bound on a figure, in rows whose figure `given` is at least `least` and at most `most`. TS_OF_PAPER bounds the
 * figure divided by the paper's, in rows that the paper has. TS_RISES_WITH must hold in nine out of ten pairs of all
 * rows. TS_GROWS bounds the least quotient of a row by the row before, TS_STEADY the quotient of the greatest by the
 * least, both in the rows of one scene. */
typedef struct {
	const char *text;
	u32 figure;
	ts_relation_kind kind;
	double low, high; /* bounds; TS_RISES_WITH: low is the other figure */
	u32 given;        /* TS_NO_FIGURE: all rows */
	double least, most;
	bool falls;          /* TS_RISES_WITH: the figure falls instead as the other rises */
	const char *because; /* printed with figure `cause` where the relation does not hold */
	u32 cause;
} ts_paper_relation;
#define TS_ANY TS_NO_FIGURE, 0, 0 /* `given`, `least` and `most`: all rows */

/* A plot of a scene's rows, one curve for each figure. */
typedef struct {
	const char *x_axis, *y_axis;
	u32 x;
	u8 curves[TS_PLOT_CURVES + 1];
	bool rises; /* as in a ts_plot */
} ts_paper_plot;

/* A picture of each row, of the last frame, with -o. */
typedef struct {
	u32 variant; /* whose image is kept */
	const char *name;
} ts_paper_picture;

typedef struct ts_paper_table {
	const char *name, *title;
	const char *effect;
	const char *scenes;                /* unless --scene says otherwise */
	const char *models;                /* files of the folder TS_SCENES, of which missing ones are left out; or NULL */
	const char *alone;                 /* those of them that stand alone, without a room; or NULL */
	const char *alone_set;             /* for their rows, as `defaults`, instead of what `defaults` says of the same */
	const char *objects_head;          /* "mirrors", "lights", "pixels"; NULL: a row a scene */
	const char *objects_param;         /* NULL: objects are sizes, WxH */
	const char *objects;               /* unless --objects says otherwise */
	u32 most;                          /* bound of objects; 0: TS_BENCH_OBJECTS */
	u32 sampled;                       /* surfels to make of the triangles of scenes without surfels; 0: none */
	u32 most_long;                     /* methods that take long are left out at more objects; 0: never */
	const char *set;                   /* for all rows */
	const char *defaults;              /* for all rows, for parameters that nobody set */
	const char *size;                  /* unless --size says otherwise; NULL: 1920 x 1080 */
	const char *note;                  /* a line above the table, or NULL */
	bool timed;                        /* --runs; else one run, of counts */
	const char *judge;                 /* the truth to which errors are, unless --truth says otherwise; NULL: none */
	bool rays;                         /* judge off-screen texels and shadows by rays, once */
	bool own_camera;                   /* models are seen through their first camera, as by render */
	u32 nearest;                       /* the paper's row is the one nearest in this figure; or TS_NO_FIGURE */
	double (*look)(const ts_run *run); /* for figures of TS_FIGURE_LOOKED; or NULL */
	const ts_bench_variant *variants;
	const ts_figure *measured; /* what the figures name, ended by one without a row */
	const ts_bench_figure *figures;
	const ts_paper_part *parts;         /* ended by one without a key */
	const ts_paper_relation *relations; /* ended by one without a text; or NULL */
	const ts_paper_plot *plot;          /* with -o; or NULL */
	const ts_paper_picture *pictures;   /* ended by one without a name; the others differ from the first; or NULL */
	const ts_paper_row *rows;           /* ended by one without a name */
} ts_paper_table;

/* One of our rows, with the paper's row beside it. */
typedef struct {
	char scene[96];
	u32 of_scene; /* its number; names may be the same */
	u32 objects;
	double here[TS_BENCH_FIGURES];
	ts_frame_spread over[TS_BENCH_FIGURES]; /* the frames */
	double others;                          /* processors that other processes used meanwhile; NAN: not known */
	const ts_paper_row *row;                /* NULL: none */
	double paper[TS_BENCH_FIGURES];
} ts_paper_line;

/* Finds the paper's row for a line of ours, if there is one. */
void ts_paper_compare(ts_paper_line *line, const ts_paper_table *table, const char *spec);
/* Reports the spread of each figure over the frames, in JSON and CSV: tables "over_frames" and, for times,
 * "milliseconds_over_frames". Least and greatest are of the first run. */
void ts_paper_report_frames(ts_report *report, const ts_paper_table *table, const ts_paper_line *lines, u32 n);
/* Reports the parts and the relations; a time is not judged in rows in which other processes used more than
 * ts_busy_limit. */
void ts_paper_report(ts_report *report, const ts_paper_table *table, const ts_paper_line *lines, u32 n);
/* Writes a plot a scene, PART_1.svg and so on, named after the first part. */
ts_status ts_paper_plots(const ts_paper_table *table, const ts_paper_line *lines, u32 n);
/* Writes the pictures of a case as ROW-SCENE-NAME.png, those of the truth and of differences as well, with the number
 * of objects behind the scene if rows have one. Differences are as of `render`. */
ts_status ts_paper_pictures(const ts_paper_table *table, const ts_bench_case *c, const ts_paper_line *line, u32 row);
/* Fails unless the items of a list are such as the table's rows vary. */
ts_status ts_paper_check_objects(const ts_paper_table *table, const char *objects);
/* Measures and prints a table. */
ts_status ts_paper_bench(const ts_job *job, const ts_paper_table *table);

#endif
