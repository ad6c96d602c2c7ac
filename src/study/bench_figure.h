/* The figures of a table: what is measured of the variants of a case, and what follows from it, here and in the
 * paper. */
#ifndef TS_CLI_BENCH_FIGURE_H
#define TS_CLI_BENCH_FIGURE_H
#include "bench_case.h"
#include "table.h"

enum { TS_BENCH_FIGURES = 96 }; /* at most */

/* Measured: of variant a. Derived: of figures a and b, of our row or of the paper's. */
typedef enum {
	TS_FIGURE_TRIANGLES, /* of the scene */
	TS_FIGURE_SURFELS,
	TS_FIGURE_PIXELS,                    /* of the eye's image, millions */
	TS_FIGURE_PARAM,                     /* the parameter named in `what` */
	TS_FIGURE_COUNTER,                   /* named in `what` */
	TS_FIGURE_MEMORY,                    /* of what that counter counts, b bytes each, MiB */
	TS_FIGURE_BUFFERS,                   /* memory of the buffers of the stages named in `what`, MiB */
	TS_FIGURE_TRAVERSED,                 /* triangles in all passes over the geometry but the eye's */
	TS_FIGURE_DIAMETER,                  /* mean side of the cubes in sight, texels */
	TS_FIGURE_IN_SIGHT,                  /* cubes in sight */
	TS_FIGURE_TIME,                      /* of the whole frame, ms */
	TS_FIGURE_SURFEL_RATE,               /* surfels of the scene a second of that, millions */
	TS_FIGURE_SEEN,                      /* pixels with a surface, of the image */
	TS_FIGURE_STAGE_TIME,                /* of the stages named in `what`, ms */
	TS_FIGURE_PART_TIME,                 /* the same, but 0 where none of them ran */
	TS_FIGURE_REST_TIME,                 /* all others, ms */
	TS_FIGURE_RMSE,                      /* to the truth or, where a table has none or `what` says TS_TO_IMAGE, to
	                                      * variant b; grey levels */
	TS_FIGURE_PSNR,                      /* of the same, dB */
	TS_FIGURE_SSIM,                      /* of the same */
	TS_FIGURE_RELATIVE,                  /* the same in radiance by the mean of the other's, without the sky */
	TS_FIGURE_NEAR,                      /* that of pixels near a triangle of light (near_light.h) */
	TS_FIGURE_ELSEWHERE,                 /* and of all others */
	TS_FIGURE_NEAR_SHARE,                /* % of those pixels */
	TS_FIGURE_NEAR_ERROR,                /* % of the squares of errors in radiance that are in them */
	TS_FIGURE_MEDIAN,                    /* error of a pixel in radiance by the other's */
	TS_FIGURE_BEYOND,                    /* % of pixels where that is above a tenth */
	TS_FIGURE_UNLIT,                     /* pixels where only the image has light, not the other */
	TS_FIGURE_GIVEN,                     /* their mean radiance, % of the mean of the other */
	TS_FIGURE_LOOKED,                    /* what the table's own function says of the buffers */
	TS_FIGURE_DERIVED,                   /* from here on */
	TS_FIGURE_RATIO = TS_FIGURE_DERIVED, /* a / b */
	TS_FIGURE_SAVED,                     /* 100 (1 - a / b) */
	TS_FIGURE_PERCENT,                   /* 100 a / b */
	TS_FIGURE_MORE,                      /* 100 (a - b) / 255 */
	TS_FIGURE_DIFFERENCE,                /* a - b */
	TS_FIGURE_SUM,                       /* of all from a to b */
	TS_FIGURE_GROWTH,                    /* e, where a grows as b^e since the row before */
	TS_FIGURE_RATE,                      /* a second, of b in ms */
} ts_figure_kind;

typedef struct {
	const char *key, *head; /* of the column */
	ts_figure_kind kind;
	u32 a, b;
	int decimals;     /* TS_WHOLE: a count */
	const char *what; /* of stages several, separated by commas */
} ts_bench_figure;
enum { TS_WHOLE = -1 };
#define TS_TO_IMAGE "image" /* an error is to that of variant b, though the table has a truth */

/* Whether a clock says it, or what it is made of: two runs differ. */
bool ts_bench_is_timed(const ts_bench_figure *figures, u32 at);

/* Figures measured of a case; those that are not there are NAN. `derive` then fills in the others where both of theirs
 * are there and they are not, figure after figure; `before` is the row before it of the scene, or NULL. `figures` is
 * ended by one without a key. */
void ts_bench_measure(double *values, const ts_bench_figure *figures, const ts_bench_case *c);
void ts_bench_derive(double *values, const double *before, const ts_bench_figure *figures);
/* Appends it as a cell. */
void ts_bench_cell(ts_table *table, const ts_bench_figure *figure, double value);

#endif
