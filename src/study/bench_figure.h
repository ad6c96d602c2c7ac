/* The figures of a table: measured ones, of the variants of a case, and ones derived from them, here and in the
 * paper. */
#ifndef TS_STUDY_BENCH_FIGURE_H
#define TS_STUDY_BENCH_FIGURE_H
#include "study/bench_case.h"
#include "study/results/table.h"

enum { TS_BENCH_FIGURES = 96 }; /* at most */

/* Kinds of figures. Measured ones are of variant a; derived ones are of figures a and b, of our row or of the
 * paper's. */
typedef enum {
	TS_FIGURE_TRIANGLES, /* of the scene */
	TS_FIGURE_SURFELS,
	TS_FIGURE_PIXELS,                    /* of the eye's image, millions */
	TS_FIGURE_PARAM,                     /* value of the parameter named in `what` */
	TS_FIGURE_COUNTER,                   /* value of the counter named in `what` */
	TS_FIGURE_MEMORY,                    /* that counter times b bytes, MiB */
	TS_FIGURE_BUFFERS,                   /* memory of the buffers of the stages named in `what`, MiB */
	TS_FIGURE_TRAVERSED,                 /* triangles in all passes over the geometry but the eye's */
	TS_FIGURE_DIAMETER,                  /* mean side of the cubes in sight, texels */
	TS_FIGURE_IN_SIGHT,                  /* cubes in sight */
	TS_FIGURE_TIME,                      /* of the whole frame, ms */
	TS_FIGURE_SURFEL_RATE,               /* surfels of the scene by TS_FIGURE_TIME, millions a second */
	TS_FIGURE_SEEN,                      /* pixels with a surface, of the image */
	TS_FIGURE_STAGE_TIME,                /* of the stages named in `what`, ms */
	TS_FIGURE_PART_TIME,                 /* as TS_FIGURE_STAGE_TIME, but 0 if none of the stages ran */
	TS_FIGURE_REST_TIME,                 /* of all other stages, ms */
	TS_FIGURE_RMSE,                      /* to the truth or, where a table has none or `what` says TS_TO_IMAGE, to
	                                      * variant b; grey levels */
	TS_FIGURE_PSNR,                      /* of the same two images, dB */
	TS_FIGURE_SSIM,                      /* of the same two images */
	TS_FIGURE_FLICKER,                   /* change since the frame before beyond that of variant b, or with b = a the
	                                      * whole change; grey levels; missing in the first frame */
	TS_FIGURE_RELATIVE,                  /* RMSE of radiance by the other's mean radiance, without the sky */
	TS_FIGURE_NEAR,                      /* TS_FIGURE_RELATIVE of pixels near a triangle of light (near_light.c) */
	TS_FIGURE_ELSEWHERE,                 /* TS_FIGURE_RELATIVE of all other pixels */
	TS_FIGURE_NEAR_SHARE,                /* % of those pixels */
	TS_FIGURE_NEAR_ERROR,                /* % of the sum of squared errors in radiance that is in those pixels */
	TS_FIGURE_MEDIAN,                    /* median over pixels of the error in radiance by the other's radiance */
	TS_FIGURE_BEYOND,                    /* % of pixels at which this error is above a tenth */
	TS_FIGURE_UNLIT,                     /* pixels where only the image has light, not the other */
	TS_FIGURE_GIVEN,                     /* their mean radiance, % of the mean of the other */
	TS_FIGURE_LOOKED,                    /* result of the table's own function `look` */
	TS_FIGURE_DERIVED,                   /* kinds from here on are derived */
	TS_FIGURE_RATIO = TS_FIGURE_DERIVED, /* a / b */
	TS_FIGURE_SAVED,                     /* 100 (1 - a / b) */
	TS_FIGURE_PERCENT,                   /* 100 a / b */
	TS_FIGURE_MORE,                      /* 100 (a - b) / 255 */
	TS_FIGURE_DIFFERENCE,                /* a - b */
	TS_FIGURE_SUM,                       /* of all from a to b */
	TS_FIGURE_GROWTH,                    /* e, where a grows as b^e since the row before */
	TS_FIGURE_RATE,                      /* a by b ms, per second */
} ts_figure_kind;

typedef struct {
	const char *key, *head; /* of the column */
	ts_figure_kind kind;
	u32 a, b;
	int decimals;     /* TS_WHOLE: a count */
	const char *what; /* names of several stages are separated by commas */
} ts_bench_figure;
enum { TS_WHOLE = -1 };
#define TS_TO_IMAGE "image" /* `what` of an error to the image of variant b although the table has a truth */

/* Whether the figure, or one that it is derived from, is a time, so that two runs differ. */
bool ts_bench_is_timed(const ts_bench_figure *figures, u32 at);

/* ts_bench_measure writes the measured figures of a case; missing ones are NAN. ts_bench_derive then computes, one
 * after the other, derived figures that are missing and whose operands are there; `before` is the scene's row before,
 * or NULL. `figures` is ended by one without a key. */
void ts_bench_measure(double *values, const ts_bench_figure *figures, const ts_bench_case *c);
void ts_bench_derive(double *values, const double *before, const ts_bench_figure *figures);
/* Appends the value of a figure as a cell. */
void ts_bench_cell(ts_table *table, const ts_bench_figure *figure, double value);

#endif
