/* The figures of a table. */
#include "study/bench_figure.h"
#include <math.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include "model/decimal.h"
#include "study/asked/words.h"

static double parameter(const ts_params *params, const char *name)
{
	char text[64];
	size_t n, row = 0;
	const ts_param_info *table = ts_param_table(&n);
	while (row + 1 < n && strcmp(table[row].name, name) != 0) row++;
	ts_params_format(params, row, text, sizeof text);
	return ts_strtod(text, NULL);
}

/* Sums the stages that ran; `none` if none did. */
static double milliseconds(const ts_measure *m, const char *list, double none)
{
	char stage[32];
	double sum = 0;
	bool any = false;
	while (ts_words_item(&list, stage, sizeof stage)) {
		const ts_timing *timing = ts_measure_timing(m, stage);
		sum += timing != NULL ? 1e3 * timing->seconds : 0;
		any |= timing != NULL;
	}
	return any ? sum : none;
}

static double buffer_bytes(const ts_measure *m, const char *list)
{
	char stage[32];
	double sum = 0;
	while (ts_words_item(&list, stage, sizeof stage)) {
		size_t n = strlen(stage);
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			const char *name = ts_buffer_table[id].name;
			if (strncmp(name, stage, n) == 0 && name[n] == '.') sum += (double)m->bytes[id];
		}
	}
	return sum;
}

static double mebibytes(double bytes) { return bytes / (1 << 20); }

static double counted(const ts_measure *m, const char *name)
{
	const ts_counter *counter = ts_measure_counter(m, name);
	return counter != NULL ? (double)counter->value : NAN;
}

/* NAN where the error is infinite, or needs triangles of light and there are none. */
static double light_error(const ts_picture *reference, const ts_picture *image, ts_figure_kind kind, u32 width,
                          u32 height)
{
	const f32 *light = reference->radiance, *other = image->radiance;
	const u8 *only = kind == TS_FIGURE_ELSEWHERE ? image->elsewhere : image->near;
	bool parted = kind >= TS_FIGURE_NEAR && kind <= TS_FIGURE_NEAR_ERROR;
	if (parted && only == NULL) return NAN;
	ts_light_metrics all = ts_metrics_light(light, other, image->seen, width, height), part = all;
	if (parted) part = ts_metrics_light(light, other, only, width, height);
	double r = part.relative;
	if (kind == TS_FIGURE_NEAR_SHARE) r = 100 * (double)part.pixels / (double)all.pixels;
	if (kind == TS_FIGURE_NEAR_ERROR) r = 100 * part.squares / all.squares;
	if (kind == TS_FIGURE_MEDIAN) r = all.median;
	if (kind == TS_FIGURE_BEYOND) r = 100 * all.beyond;
	if (kind == TS_FIGURE_UNLIT) r = (double)all.unlit;
	if (kind == TS_FIGURE_GIVEN) r = 100 * all.given;
	return isfinite(r) ? r : NAN;
}

static double error(const ts_bench_case *c, const ts_bench_figure *f)
{
	bool to_truth = c->judge != NULL && strcmp(f->what, TS_TO_IMAGE) != 0;
	const ts_picture *image = &c->images[f->a], *reference = to_truth ? &c->truth : &c->images[f->b];
	if (image->srgb == NULL || reference->srgb == NULL || image == reference) return NAN;
	u32 width = TS_PARAM(&c->params, width), height = TS_PARAM(&c->params, height);
	if (f->kind >= TS_FIGURE_RELATIVE) return light_error(reference, image, f->kind, width, height);
	ts_metrics found = ts_metrics_compare(reference->srgb, image->srgb, NULL, width, height);
	return f->kind == TS_FIGURE_PSNR ? found.psnr : f->kind == TS_FIGURE_SSIM ? found.ssim : found.rmse;
}

/* An image's own change is measured against a constant reference. */
static double flicker(const ts_bench_case *c, const ts_bench_figure *f)
{
	const ts_picture *image = &c->images[f->a], *other = &c->images[f->b];
	if (f->a == f->b) return ts_picture_change(image, NULL, &c->params);
	if (image->before == NULL || other->before == NULL) return NAN;
	return ts_metrics_flicker(other->before, other->srgb, image->before, image->srgb, NULL, TS_PARAM(&c->params, width),
	                          TS_PARAM(&c->params, height));
}

/* NAN for images that were not kept. */
static double seen(const ts_picture *image, size_t n_pixels)
{
	size_t n = 0;
	for (size_t i = 0; image->seen != NULL && i < n_pixels; i++) n += image->seen[i];
	return image->seen != NULL ? (double)n : NAN;
}

static double measured(const ts_bench_figure *f, const ts_bench_case *c)
{
	if (f->kind == TS_FIGURE_TRIANGLES) return c->scene->n_triangles;
	if (f->kind == TS_FIGURE_SURFELS) return c->scene->n_surfels;
	if (f->kind == TS_FIGURE_PIXELS) return 1e-6 * TS_PARAM(&c->params, width) * TS_PARAM(&c->params, height);
	if (f->kind == TS_FIGURE_PARAM) return parameter(&c->params, f->what);
	if (f->kind >= TS_FIGURE_DERIVED || c->methods[f->a] == NULL) return NAN;
	const ts_measure *m = &c->measures[f->a];
	switch (f->kind) {
	case TS_FIGURE_COUNTER: return counted(m, f->what);
	case TS_FIGURE_MEMORY: return mebibytes(counted(m, f->what) * f->b);
	case TS_FIGURE_BUFFERS: return mebibytes(buffer_bytes(m, f->what));
	case TS_FIGURE_TRAVERSED: return (counted(m, "geometry traversals") - 1) * c->scene->n_triangles;
	case TS_FIGURE_DIAMETER: return m->n_in_sight > 0 ? m->mean_diameter : NAN;
	case TS_FIGURE_IN_SIGHT: return m->n_in_sight;
	case TS_FIGURE_TIME: return 1e3 * m->seconds;
	case TS_FIGURE_SURFEL_RATE: return 1e-6 * c->scene->n_surfels / m->seconds;
	case TS_FIGURE_SEEN:
		return seen(&c->images[f->a], (size_t)TS_PARAM(&c->params, width) * TS_PARAM(&c->params, height));
	case TS_FIGURE_STAGE_TIME: return milliseconds(m, f->what, NAN);
	case TS_FIGURE_PART_TIME: return milliseconds(m, f->what, 0);
	case TS_FIGURE_REST_TIME: return 1e3 * m->seconds - milliseconds(m, f->what, 0);
	case TS_FIGURE_RMSE:
	case TS_FIGURE_PSNR:
	case TS_FIGURE_SSIM:
	case TS_FIGURE_RELATIVE:
	case TS_FIGURE_NEAR:
	case TS_FIGURE_ELSEWHERE:
	case TS_FIGURE_NEAR_SHARE:
	case TS_FIGURE_NEAR_ERROR:
	case TS_FIGURE_MEDIAN:
	case TS_FIGURE_BEYOND:
	case TS_FIGURE_UNLIT:
	case TS_FIGURE_GIVEN: return error(c, f);
	case TS_FIGURE_FLICKER: return flicker(c, f);
	case TS_FIGURE_LOOKED: return c->looked[f->a];
	default: return NAN;
	}
}

bool ts_bench_is_timed(const ts_bench_figure *figures, u32 at)
{
	const ts_bench_figure *f = &figures[at];
	switch (f->kind) {
	case TS_FIGURE_TIME:
	case TS_FIGURE_SURFEL_RATE:
	case TS_FIGURE_STAGE_TIME:
	case TS_FIGURE_PART_TIME:
	case TS_FIGURE_REST_TIME:
	case TS_FIGURE_RATE: return true;
	default:
		return f->kind >= TS_FIGURE_DERIVED && (ts_bench_is_timed(figures, f->a) || ts_bench_is_timed(figures, f->b));
	}
}

void ts_bench_measure(double *values, const ts_bench_figure *figures, const ts_bench_case *c)
{
	for (u32 i = 0; figures[i].key != NULL; i++) values[i] = measured(&figures[i], c);
}

static double derived(ts_figure_kind kind, double a, double b)
{
	if (kind == TS_FIGURE_MORE) return 100 * (a - b) / 255;
	if (kind == TS_FIGURE_DIFFERENCE) return a - b;
	if (!(b > 0)) return NAN;
	if (kind == TS_FIGURE_RATE) return 1e3 / b;
	if (kind == TS_FIGURE_PERCENT) return 100 * a / b;
	return kind == TS_FIGURE_RATIO ? a / b : 100 * (1 - a / b);
}

static double sum(const double *values, const ts_bench_figure *f)
{
	double r = 0;
	for (u32 i = f->a; i <= f->b; i++) r += values[i];
	return r;
}

static double growth(const double *values, const double *before, const ts_bench_figure *f)
{
	double e = before != NULL ? log(values[f->a] / before[f->a]) / log(values[f->b] / before[f->b]) : NAN;
	return isfinite(e) ? e : NAN;
}

void ts_bench_derive(double *values, const double *before, const ts_bench_figure *figures)
{
	for (u32 i = 0; figures[i].key != NULL; i++) {
		const ts_bench_figure *f = &figures[i];
		if (f->kind < TS_FIGURE_DERIVED || !isnan(values[i])) continue;
		switch (f->kind) {
		case TS_FIGURE_SUM: values[i] = sum(values, f); break;
		case TS_FIGURE_GROWTH: values[i] = growth(values, before, f); break;
		default: values[i] = derived(f->kind, values[f->a], values[f->b]);
		}
	}
}

void ts_bench_cell(ts_table *table, const ts_bench_figure *figure, double value)
{
	if (!isnan(value) && figure->decimals == TS_WHOLE) {
		ts_table_count(table, (i64)value);
	} else {
		ts_table_known(table, value, figure->decimals);
	}
}
