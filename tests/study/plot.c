/* Plots: every point where its values say, ticks at round values on their lines, and a legend of the curves. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "study/plot.h"
#include "tests/model/test.h"

enum { LEFT = 70, RIGHT = 770, TOP = 50, BOTTOM = 500, MOST = 64, TEXT = 100000 };

static char svg[TEXT];

static void draw(const ts_plot *plot)
{
	FILE *out = fmemopen(svg, sizeof svg, "w");
	assert_non_null(out);
	ts_plot_svg(plot, out);
	assert_int_equal(fclose(out), 0);
}

/* Where values stand from low to high, between two places; the rule of the header in other words. */
static double at(double value, double low, double high, bool even, double from, double to)
{
	double share = even ? (value - low) / (high - low) : (log2(value) - log2(low)) / (log2(high) - log2(low));
	return from + (to - from) * share;
}

typedef struct {
	double x[2], y[2]; /* least and greatest of the axes */
	bool even;
} frame;

static frame frame_of(const ts_plot *plot)
{
	frame f = {{INFINITY, -INFINITY}, {INFINITY, -INFINITY}, plot->even};
	for (u32 i = 0; i < plot->n_points; i++) {
		const ts_plot_point *p = &plot->points[i];
		f.x[0] = fmin(f.x[0], p->x);
		f.x[1] = fmax(f.x[1], p->x);
		f.y[0] = fmin(f.y[0], p->y);
		f.y[1] = fmax(f.y[1], p->y);
	}
	if (plot->even) f.y[1] += (f.y[1] - f.y[0]) / 3;
	for (u32 k = 0; k < 2 && !plot->even; k++) {
		f.x[k] *= k == 0 ? 1 / 1.2 : 1.2;
		f.y[k] *= k == 0 ? 1 / 1.2 : 1.2;
	}
	return f;
}

static double across(const frame *f, double x) { return at(x, f->x[0], f->x[1], f->even, LEFT, RIGHT); }
static double up(const frame *f, double y) { return at(y, f->y[0], f->y[1], f->even, BOTTOM, TOP); }

static void has(const char *text)
{
	if (strstr(svg, text) == NULL) fail_msg("no %s in\n%s", text, svg);
}

static u32 count_of(const char *text)
{
	u32 n = 0;
	for (const char *p = svg; (p = strstr(p, text)) != NULL; p++) n++;
	return n;
}

/* Joined points are a curve's, in their order; points with a label have a dot, beside which it stands. */
static void judge_points(const ts_plot *plot)
{
	const frame f = frame_of(plot);
	const char *curve = svg;
	u32 n_dots = 0;
	for (u32 c = 0; c < plot->n_curves; c++) {
		curve = strstr(curve, "points=\"");
		assert_non_null(curve);
		curve += strlen("points=\"");
		for (u32 i = 0; i < plot->n_points; i++) {
			const ts_plot_point *p = &plot->points[i];
			char text[200];
			if (p->curve == c && !p->apart) {
				snprintf(text, sizeof text, "%.1f,%.1f ", across(&f, p->x), up(&f, p->y));
				if (strncmp(curve, text, strlen(text)) != 0) fail_msg("%s, not %.20s", text, curve);
				curve += strlen(text);
			}
			if (p->curve != c || p->label == NULL) continue;
			snprintf(text, sizeof text, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" ", across(&f, p->x), up(&f, p->y));
			has(text);
			snprintf(text, sizeof text, "<text x=\"%.1f\" y=\"%.1f\" font-size=\"11\">%s</text>", across(&f, p->x) + 7,
			         up(&f, p->y) + (c % 2 == 0 ? -7 : 15), p->label);
			has(text);
			n_dots++;
		}
		assert_int_equal(*curve, '"');
	}
	assert_int_equal(count_of("<circle "), n_dots);
	assert_int_equal(count_of("<polyline "), plot->n_curves);
}

/* Every grey line stands where the value beside it says. Returns how many values there are of an axis. */
static u32 judge_ticks(const ts_plot *plot, bool of_x, double *values)
{
	const frame f = frame_of(plot);
	u32 n = 0;
	for (const char *p = svg; (p = strstr(p, "stroke=\"#ddd\"/>\n<text ")) != NULL; p++) {
		const char *text = strchr(p, '\n') + 1, *line = p;
		double x0, y0, x1, y1, x, y, value = strtod(strchr(text, '>') + 1, NULL);
		while (line > svg && line[-1] != '\n') line--;
		assert_int_equal(sscanf(line, "<line x1=\"%lf\" y1=\"%lf\" x2=\"%lf\" y2=\"%lf\"", &x0, &y0, &x1, &y1), 4);
		assert_int_equal(sscanf(text, "<text x=\"%lf\" y=\"%lf\"", &x, &y), 2);
		if ((x0 == x1) != of_x) continue;
		double place = of_x ? across(&f, value) : up(&f, value);
		assert_true(fabs((of_x ? x0 : y0) - place) < 0.06);
		assert_true(of_x ? y0 == TOP && y1 == BOTTOM && x == x0 && y == BOTTOM + 18
		                 : y0 == y1 && x0 == LEFT && x1 == RIGHT && x == LEFT - 6 && fabs(y - y0 - 4) < 0.11);
		assert_true(n < MOST && place > (of_x ? LEFT : TOP) - 0.1 && place < (of_x ? RIGHT : BOTTOM) + 0.1);
		values[n++] = value;
	}
	return n;
}

static void assert_values(const double *values, u32 n, const char *right)
{
	char text[MOST * 20] = "";
	for (u32 i = 0; i < n; i++) snprintf(text + strlen(text), 20, "%s%g", i > 0 ? " " : "", values[i]);
	assert_string_equal(text, right);
}

static void judge_legend(const ts_plot *plot)
{
	for (u32 c = 0; c < plot->n_curves; c++) {
		char text[200];
		u32 y = (plot->rises ? BOTTOM - 6 - 18 * plot->n_curves : TOP + 12) + 18 * c;
		snprintf(text, sizeof text, "<line x1=\"560.0\" y1=\"%u.0\" x2=\"584.0\" y2=\"%u.0\" stroke=\"#", (unsigned)y,
		         (unsigned)y);
		has(text);
		snprintf(text, sizeof text, "<text x=\"590.0\" y=\"%u.0\" >%s</text>", (unsigned)y + 4, plot->curves[c]);
		has(text);
	}
}

/* Two curves, and a point apart of each. */
static void every_point_stands_where_its_values_say(void **state)
{
	(void)state;
	static const ts_plot_point points[] = {{0, "a", 2, 30, false},  {1, NULL, 3, 7000, false}, {0, NULL, 5, 50, false},
	                                       {1, "b", 700, 8, false}, {0, "", 900, 1000, true},  {1, "c", 40, 90, true}};
	double values[MOST];
	ts_plot plot = {.title = "Title", .x_axis = "across", .y_axis = "up", .curves = {"one", "two"}};
	plot.n_curves = 2;
	plot.points = points;
	plot.n_points = sizeof points / sizeof *points;
	for (u32 kind = 0; kind < 4; kind++) {
		plot.even = kind % 2 == 1;
		plot.rises = kind >= 2;
		draw(&plot);
		judge_points(&plot);
		judge_legend(&plot);
		u32 n = judge_ticks(&plot, true, values);
		assert_values(values, n, plot.even ? "100 200 300 400 500 600 700 800 900" : "2 5 10 20 50 100 200 500 1000");
		n = judge_ticks(&plot, false, values);
		assert_values(values, n,
		              plot.even ? "1000 2000 3000 4000 5000 6000 7000 8000 9000"
		                        : "10 20 50 100 200 500 1000 2000 5000");
		assert_int_equal(count_of("stroke=\"#000\"/>"), 2);
		has("<line x1=\"70.0\" y1=\"500.0\" x2=\"770.0\" y2=\"500.0\" stroke=\"#000\"/>");
		has("<line x1=\"70.0\" y1=\"50.0\" x2=\"70.0\" y2=\"500.0\" stroke=\"#000\"/>");
		has("<text x=\"70.0\" y=\"26.0\" font-size=\"15\">Title</text>");
		has("<text x=\"420.0\" y=\"542.0\" text-anchor=\"middle\">across</text>");
		has("rotate(-90)\">up</text>");
	}
}

/* Ticks by the length of an axis: powers alone on a long one, even steps on a short one, of 1, 2 or 5. */
static void ticks_are_round_and_neither_few_nor_many(void **state)
{
	(void)state;
	static const struct {
		double from, to;
		bool even;
		const char *right;
	} rows[] = {
		{1e-3, 1e4, false, "0.001 0.01 0.1 1 10 100 1000 10000"},
		{1, 2.1, false, "1 1.2 1.4 1.6 1.8 2 2.2 2.4"},
		{3, 9, false, "3 4 5 6 7 8 9 10"},
		{-2, 3, true, "-2 -1 0 1 2 3"},
		{0, 4, true, "0 1 2 3 4"},
		{0, 2, true, "0 0.5 1 1.5 2"},
		{0, 1.5, true, "0 0.2 0.4 0.6 0.8 1 1.2 1.4"},
		{100, 130, true, "100 105 110 115 120 125 130"},
	};
	for (u32 i = 0; i < sizeof rows / sizeof *rows; i++) {
		double values[MOST];
		const ts_plot_point points[] = {{0, NULL, rows[i].from, 1, false}, {0, NULL, rows[i].to, 2, false}};
		const ts_plot plot = {.title = "",
		                      .x_axis = "",
		                      .y_axis = "",
		                      .curves = {""},
		                      .n_curves = 1,
		                      .points = points,
		                      .n_points = 2,
		                      .even = rows[i].even};
		draw(&plot);
		judge_points(&plot);
		assert_values(values, judge_ticks(&plot, true, values), rows[i].right);
	}
}

/* What has no logarithm stands at the low end, which the others set; so does a lone value of 0. */
static void a_value_of_zero_stands_at_the_low_end(void **state)
{
	(void)state;
	static const ts_plot_point points[] = {{0, "", 1, 0, false}, {0, "", 10, 5, false}, {0, "", 100, 50, false}};
	ts_plot plot = {.title = "", .x_axis = "", .y_axis = "", .curves = {""}, .n_curves = 1, .points = points};
	char text[80];
	plot.n_points = 3;
	draw(&plot);
	snprintf(text, sizeof text, "points=\"%.1f,500.0 %.1f,%.1f ", at(1, 1 / 1.2, 120, false, LEFT, RIGHT),
	         at(10, 1 / 1.2, 120, false, LEFT, RIGHT), at(5, 5 / 1.2, 60, false, BOTTOM, TOP));
	has(text);
	plot.n_points = 1;
	draw(&plot);
	has("points=\"420.0,500.0 \"");
	plot.even = true;
	draw(&plot);
	has("points=\"420.0,275.0 \"");
}

static void texts_are_escaped(void **state)
{
	(void)state;
	static const ts_plot_point points[] = {{0, "a<b>&\tc", 1, 1, false}};
	const ts_plot plot = {.title = "x & y",
	                      .x_axis = "<",
	                      .y_axis = ">",
	                      .curves = {"&"},
	                      .n_curves = 1,
	                      .points = points,
	                      .n_points = 1};
	draw(&plot);
	has(">a&lt;b&gt;&amp;?c</text>");
	has(">x &amp; y</text>");
	has("\">&lt;</text>");
	has(")\">&gt;</text>");
	has(">&amp;</text>");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_point_stands_where_its_values_say),
		cmocka_unit_test(ticks_are_round_and_neither_few_nor_many),
		cmocka_unit_test(a_value_of_zero_stands_at_the_low_end),
		cmocka_unit_test(texts_are_escaped),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
