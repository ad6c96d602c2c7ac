/* A plot of curves as SVG 1.1, in a picture of 800 by 560. */
#include "study/plot.h"
#include <math.h>

enum { WIDTH = 800, HEIGHT = 560, LEFT = 70, RIGHT = 770, TOP = 50, BOTTOM = 500, LEGEND = 560 };

/* Distinguishable with any colour vision (Okabe and Ito 2002). */
static const char *const colours[TS_PLOT_CURVES] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"};

/* From values to pixels, evenly or logarithmically. */
typedef struct {
	double low, high, from, to;
	bool even;
} axis;

/* A value that is not above 0 has no logarithm: it stands at the low end. */
static double place(axis a, double value)
{
	double from_low = value > a.low ? log(value / a.low) : 0;
	double share = a.even ? (value - a.low) / (a.high - a.low) : from_low / log(a.high / a.low);
	return a.from + (a.to - a.from) * share;
}

/* A fifth wider on either side than the points; with even steps a third higher above, for the legend. */
static axis axis_of(const ts_plot *plot, bool across)
{
	double least = INFINITY, most = -INFINITY;
	for (u32 i = 0; i < plot->n_points; i++) {
		double value = across ? plot->points[i].x : plot->points[i].y;
		if (value > 0 || plot->even) least = fmin(least, value);
		most = fmax(most, value);
	}
	if (!plot->even && !(most > 0)) least = most = 1;
	axis r = {least / 1.2, most * 1.2, across ? LEFT : BOTTOM, across ? RIGHT : TOP, plot->even};
	if (plot->even) {
		double room = most > least ? 0 : fmax(fabs(most), 1) / 2;
		r.low = least - room;
		r.high = across ? most + room : most + room + (most - least) / 3;
	}
	return r;
}

static void put_text(FILE *out, const char *text)
{
	for (; *text != 0; text++) {
		switch (*text) {
		case '&': fputs("&amp;", out); break;
		case '<': fputs("&lt;", out); break;
		case '>': fputs("&gt;", out); break;
		default: fputc((unsigned char)*text < 32 ? '?' : *text, out);
		}
	}
}

static void text_at(FILE *out, double x, double y, const char *more, const char *text)
{
	fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" %s>", x, y, more);
	put_text(out, text);
	fputs("</text>\n", out);
}

static void line(FILE *out, double x0, double y0, double x1, double y1, const char *colour)
{
	fprintf(out, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n", x0, y0, x1, y1, colour);
}

static void tick(FILE *out, axis a, double value, bool across)
{
	char text[32];
	double at = place(a, value);
	snprintf(text, sizeof text, "%g", value);
	if (across) {
		line(out, at, TOP, at, BOTTOM, "#ddd");
		text_at(out, at, BOTTOM + 18, "text-anchor=\"middle\"", text);
	} else {
		line(out, LEFT, at, RIGHT, at, "#ddd");
		text_at(out, LEFT - 6, at + 4, "text-anchor=\"end\"", text);
	}
}

/* At 1, 2 and 5 times the powers of ten, or only at these if there are many; on a short axis at even steps. */
static void ticks(FILE *out, axis a, bool across)
{
	double length = a.high - a.low, power = pow(10, floor(log10(a.low))), step = pow(10, floor(log10(length)));
	if (length < 4 * step) step /= length < 2 * step ? 5 : 2;
	if (a.even || a.high / a.low < 5) {
		for (double k = ceil(a.low / step); k * step <= a.high; k++) tick(out, a, k * step + 0.0, across); /* no -0 */
		return;
	}
	for (; power > 0 && power <= a.high; power *= 10) {
		static const double at[] = {1, 2, 5};
		for (u32 k = 0; k < (a.high / a.low < 1e4 ? 3 : 1); k++) {
			if (power * at[k] >= a.low && power * at[k] <= a.high) tick(out, a, power * at[k], across);
		}
	}
}

static void curve(FILE *out, const ts_plot *plot, u32 c, axis x, axis y)
{
	fprintf(out, "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"2\" points=\"", colours[c]);
	for (u32 i = 0; i < plot->n_points; i++) {
		const ts_plot_point *p = &plot->points[i];
		if (p->curve == c && !p->apart) fprintf(out, "%.1f,%.1f ", place(x, p->x), place(y, p->y));
	}
	fputs("\"/>\n", out);
	for (u32 i = 0; i < plot->n_points; i++) {
		const ts_plot_point *p = &plot->points[i];
		if (p->curve != c || p->label == NULL) continue;
		fprintf(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n", place(x, p->x), place(y, p->y),
		        colours[c]);
		text_at(out, place(x, p->x) + 7, place(y, p->y) + (c % 2 == 0 ? -7 : 15), "font-size=\"11\"", p->label);
	}
}

void ts_plot_svg(const ts_plot *plot, FILE *out)
{
	axis x = axis_of(plot, true), y = axis_of(plot, false);
	fprintf(out,
	        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
	        "font-family=\"sans-serif\" font-size=\"12\">\n",
	        WIDTH, HEIGHT, WIDTH, HEIGHT);
	fprintf(out, "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n", WIDTH, HEIGHT);
	text_at(out, LEFT, 26, "font-size=\"15\"", plot->title);
	ticks(out, x, true);
	ticks(out, y, false);
	line(out, LEFT, BOTTOM, RIGHT, BOTTOM, "#000");
	line(out, LEFT, TOP, LEFT, BOTTOM, "#000");
	text_at(out, (LEFT + RIGHT) / 2, BOTTOM + 42, "text-anchor=\"middle\"", plot->x_axis);
	text_at(out, 0, 0, "text-anchor=\"middle\" transform=\"translate(14 275) rotate(-90)\"", plot->y_axis);
	u32 at = plot->rises ? BOTTOM - 6 - 18 * plot->n_curves : TOP + 12;
	for (u32 c = 0; c < plot->n_curves; c++, at += 18) {
		curve(out, plot, c, x, y);
		line(out, LEGEND, at, LEGEND + 24, at, colours[c]);
		text_at(out, LEGEND + 30, at + 4, "", plot->curves[c]);
	}
	fputs("</svg>\n", out);
}
