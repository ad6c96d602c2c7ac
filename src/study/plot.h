/* A plot of curves as SVG. */
#ifndef TS_STUDY_PLOT_H
#define TS_STUDY_PLOT_H
#include <stdio.h>
#include "kernels/base/compat.h"

enum { TS_PLOT_CURVES = 5 }; /* at most */

typedef struct {
	u32 curve;
	const char *label; /* of the point's dot; NULL: no dot */
	double x, y;       /* positive where axes are logarithmic */
	bool apart;        /* not joined to other points */
} ts_plot_point;

/* The other points of a curve are joined in their order. Texts may hold any UTF-8. */
typedef struct {
	const char *title, *x_axis, *y_axis;
	const char *curves[TS_PLOT_CURVES];
	u32 n_curves;
	const ts_plot_point *points;
	u32 n_points; /* at least one */
	bool even;    /* axes of even steps, not logarithmic ones */
	bool rises;   /* the legend stands below, not above */
} ts_plot;

/* Writes the plot with axes, a legend and a label at every dot. The caller checks the stream for errors. */
void ts_plot_svg(const ts_plot *plot, FILE *out);

#endif
