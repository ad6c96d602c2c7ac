/* A plot of curves as SVG. */
#ifndef TS_CLI_PLOT_H
#define TS_CLI_PLOT_H
#include <stdio.h>
#include "../kernels/compat.h"

enum { TS_PLOT_CURVES = 5 }; /* at most */

typedef struct {
	u32 curve;
	const char *label;
	double x, y;             /* positive */
} ts_plot_point;

/* The points of a curve are joined in their order. Texts may hold any UTF-8. */
typedef struct {
	const char *title, *x_axis, *y_axis;
	const char *curves[TS_PLOT_CURVES];
	u32 n_curves;
	const ts_plot_point *points;
	u32 n_points;            /* at least one */
} ts_plot;

/* Writes it with logarithmic axes, a legend and a label at every point. Whether all was written is the stream's to say. */
void ts_plot_svg(const ts_plot *plot, FILE *out);

#endif
