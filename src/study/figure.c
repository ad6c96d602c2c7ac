/* Figures of what was measured by their names. */
#include "study/figure.h"
#include <ctype.h>
#include <math.h>
#include <touchstone/image.h>
#include "model/decimal.h"
#include "study/asked/words.h"

static double triangles(const ts_figure *f, const ts_figure_source *c) { return (void)f, c->scene->n_triangles; }
static double surfels(const ts_figure *f, const ts_figure_source *c) { return (void)f, c->scene->n_surfels; }
static double width(const ts_figure *f, const ts_figure_source *c) { return (void)f, TS_PARAM(c->params, width); }
static double height(const ts_figure *f, const ts_figure_source *c) { return (void)f, TS_PARAM(c->params, height); }

static double parameter(const ts_figure *f, const ts_figure_source *c)
{
	char text[64];
	size_t n, row = 0;
	const ts_param_info *table = ts_param_table(&n);
	while (row + 1 < n && strcmp(table[row].name, f->what) != 0) row++;
	ts_params_format(c->params, row, text, sizeof text);
	return ts_strtod(text, NULL);
}

void ts_figure_counter(char *name, size_t bytes, const char *counter)
{
	snprintf(name, bytes, "%s", counter);
	for (; *name != 0; name++)
		if (!isalnum((unsigned char)*name)) *name = '_';
}

static bool is_named(const char *counter, const char *name)
{
	char own[64];
	ts_figure_counter(own, sizeof own, counter);
	return strcmp(own, name) == 0;
}

static double counter(const ts_figure *f, const ts_figure_source *c)
{
	const ts_measure *m = &c->measures[f->variant];
	for (u32 i = 0; i < m->n_counters; i++)
		if (is_named(m->counters[i].name, f->what)) return (double)m->counters[i].value;
	return NAN;
}

/* Of the stages that ran; `none` if none did. */
static double milliseconds(const ts_figure *f, const ts_figure_source *c, double none)
{
	char stage[32];
	double sum = 0;
	bool any = false;
	for (const char *list = f->what; ts_words_item(&list, stage, sizeof stage);) {
		const ts_timing *timing = ts_measure_timing(&c->measures[f->variant], stage);
		sum += timing != NULL ? 1e3 * timing->seconds : 0;
		any |= timing != NULL;
	}
	return any ? sum : none;
}

static double of_stages(const ts_figure *f, const ts_figure_source *c) { return milliseconds(f, c, NAN); }
static double spent(const ts_figure *f, const ts_figure_source *c) { return milliseconds(f, c, 0); }

static double frame(const ts_figure *f, const ts_figure_source *c) { return 1e3 * c->measures[f->variant].seconds; }

/* Whether a buffer is in the list, or of one of its stages. */
static bool is_listed(const char *buffer, const char *list)
{
	char item[64];
	bool listed = false;
	while (ts_words_item(&list, item, sizeof item)) {
		size_t n = strlen(item);
		listed |= strncmp(buffer, item, n) == 0 && (buffer[n] == '.' || buffer[n] == 0);
	}
	return listed;
}

static double bytes(const ts_figure *f, const ts_figure_source *c)
{
	double sum = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++)
		if (is_listed(ts_buffer_table[id].name, f->what)) sum += (double)c->measures[f->variant].bytes[id];
	return sum;
}

static double cube_side(const ts_figure *f, const ts_figure_source *c)
{
	const ts_measure *m = &c->measures[f->variant];
	return m->n_in_sight > 0 ? m->mean_diameter : NAN;
}

static double cubes_in_sight(const ts_figure *f, const ts_figure_source *c)
{
	return c->measures[f->variant].n_in_sight;
}

static double looked(const ts_figure *f, const ts_figure_source *c)
{
	return c->looked != NULL ? c->looked[f->variant] : NAN;
}

static double pixels_seen(const ts_figure *f, const ts_figure_source *c)
{
	const ts_picture *image = &c->images[f->variant];
	size_t n = 0, n_pixels = (size_t)TS_PARAM(c->params, width) * TS_PARAM(c->params, height);
	for (size_t i = 0; image->seen != NULL && i < n_pixels; i++) n += image->seen[i];
	return image->seen != NULL ? (double)n : NAN;
}

/* The two pictures of an error; false: one is missing. */
static bool pictures(const ts_figure *f, const ts_figure_source *c, const ts_picture **image, const ts_picture **other)
{
	*image = &c->images[f->variant];
	*other = f->other >= TS_FIGURE_TRUTHS ? &c->truths[f->other - TS_FIGURE_TRUTHS] : &c->images[f->other];
	return (*image)->srgb != NULL && (*other)->srgb != NULL;
}

static ts_metrics errors(const ts_figure *f, const ts_figure_source *c)
{
	const ts_picture *image, *other;
	if (!pictures(f, c, &image, &other)) return (ts_metrics){.psnr = NAN, .ssim = NAN, .rmse = NAN};
	return ts_picture_metrics(other, image, NULL, c->params);
}

static double rmse(const ts_figure *f, const ts_figure_source *c) { return errors(f, c).rmse; }
static double psnr(const ts_figure *f, const ts_figure_source *c) { return errors(f, c).psnr; }
static double ssim(const ts_figure *f, const ts_figure_source *c) { return errors(f, c).ssim; }

static double flicker(const ts_figure *f, const ts_figure_source *c)
{
	const ts_picture *image, *other;
	if (!pictures(f, c, &image, &other)) return NAN;
	if (image->before == NULL || other->before == NULL) return NAN;
	return ts_metrics_flicker(other->before, other->srgb, image->before, image->srgb, NULL, TS_PARAM(c->params, width),
	                          TS_PARAM(c->params, height));
}

/* An image's own change is measured against a constant reference. */
static double change(const ts_figure *f, const ts_figure_source *c)
{
	return ts_picture_change(&c->images[f->variant], NULL, c->params);
}

/* Compares the light of both pictures at the pixels of `only`; NULL: at all that see a surface. Returns false where a
 * picture is missing. */
static bool light(const ts_figure *f, const ts_figure_source *c, const u8 *only, ts_light_metrics *found)
{
	const ts_picture *image, *other;
	if (!pictures(f, c, &image, &other)) return false;
	return ts_picture_light(found, other, image, only != NULL ? only : image->seen, c->params) == TS_OK;
}

/* NaN where the error is infinite. */
static double known(double value) { return isfinite(value) ? value : NAN; }

static double relative(const ts_figure *f, const ts_figure_source *c)
{
	ts_light_metrics all;
	return light(f, c, NULL, &all) ? known(all.relative) : NAN;
}

static double near(const ts_figure *f, const ts_figure_source *c)
{
	ts_light_metrics part;
	const u8 *only = c->images[f->variant].near;
	return only != NULL && light(f, c, only, &part) ? known(part.relative) : NAN;
}

static double elsewhere(const ts_figure *f, const ts_figure_source *c)
{
	ts_light_metrics part;
	const u8 *only = c->images[f->variant].elsewhere;
	return only != NULL && light(f, c, only, &part) ? known(part.relative) : NAN;
}

static double near_share(const ts_figure *f, const ts_figure_source *c)
{
	ts_light_metrics all, part;
	const u8 *only = c->images[f->variant].near;
	if (only == NULL || !light(f, c, NULL, &all) || !light(f, c, only, &part)) return NAN;
	return known(100 * (double)part.pixels / (double)all.pixels);
}

static double near_error(const ts_figure *f, const ts_figure_source *c)
{
	ts_light_metrics all, part;
	const u8 *only = c->images[f->variant].near;
	if (only == NULL || !light(f, c, NULL, &all) || !light(f, c, only, &part)) return NAN;
	return known(100 * part.squares / all.squares);
}

static double median(const ts_figure *f, const ts_figure_source *c)
{
	ts_light_metrics all;
	return light(f, c, NULL, &all) ? known(all.median) : NAN;
}

static double beyond(const ts_figure *f, const ts_figure_source *c)
{
	ts_light_metrics all;
	return light(f, c, NULL, &all) ? known(100 * all.beyond) : NAN;
}

static double unlit(const ts_figure *f, const ts_figure_source *c)
{
	ts_light_metrics all;
	return light(f, c, NULL, &all) ? (double)all.unlit : NAN;
}

static double given(const ts_figure *f, const ts_figure_source *c)
{
	ts_light_metrics all;
	return light(f, c, NULL, &all) ? known(100 * all.given) : NAN;
}

const ts_figure_row ts_figure_rows[] = {
	{"scene.triangles", "triangles", "", TS_FIGURE_ALONE, true, false, triangles},
	{"scene.surfels", "surfels", "", TS_FIGURE_ALONE, true, false, surfels},
	{"image.width", "width of the eye's image", "pixels", TS_FIGURE_ALONE, true, false, width},
	{"image.height", "height of the eye's image", "pixels", TS_FIGURE_ALONE, true, false, height},
	{"param", "a parameter", "", TS_FIGURE_OF_PARAM, true, false, parameter},
	{"count", "a counter, with _ for blanks", "", TS_FIGURE_OF_COUNTER, false, false, counter},
	{"ms.frame", "time of the whole frame", "ms", TS_FIGURE_ALONE, false, true, frame},
	{"ms", "time of a stage, or of a list of them", "ms", TS_FIGURE_OF_STAGES, false, true, of_stages},
	{"spent", "the same, but 0 where none of them ran", "ms", TS_FIGURE_OF_STAGES, false, true, spent},
	{"bytes", "memory of a buffer, or of all of a stage or list", "bytes", TS_FIGURE_OF_BUFFERS, false, false, bytes},
	{"cubes.side", "mean side of the cubes in sight", "texels", TS_FIGURE_ALONE, false, false, cube_side},
	{"cubes.in_sight", "cubes in sight", "", TS_FIGURE_ALONE, false, false, cubes_in_sight},
	{"looked", "what the table's `look` computes", "", TS_FIGURE_ALONE, false, false, looked},
	{"pixels.seen", "pixels with a surface", "", TS_FIGURE_ALONE, false, false, pixels_seen},
	{"rmse", "RMSE of the variant's image to another variant's, or to the truth", "grey levels", TS_FIGURE_OF_IMAGE,
     false, false, rmse},
	{"psnr", "its PSNR", "dB", TS_FIGURE_OF_IMAGE, false, false, psnr},
	{"ssim", "its SSIM, 1 of equal ones", "", TS_FIGURE_OF_IMAGE, false, false, ssim},
	{"flicker", "change since the frame before beyond the other's", "grey levels", TS_FIGURE_OF_IMAGE, false, false,
     flicker},
	{"change", "change since the frame before", "grey levels", TS_FIGURE_ALONE, false, false, change},
	{"relative", "RMSE of radiance by the other's mean radiance, without the sky", "", TS_FIGURE_OF_IMAGE, false, false,
     relative},
	{"near", "`relative` of pixels near a triangle of light", "", TS_FIGURE_OF_IMAGE, false, false, near},
	{"elsewhere", "`relative` of all other pixels", "", TS_FIGURE_OF_IMAGE, false, false, elsewhere},
	{"near_share", "pixels near a triangle of light", "%", TS_FIGURE_OF_IMAGE, false, false, near_share},
	{"near_error", "the part of pixels near a triangle of light in the sum of squared errors", "%", TS_FIGURE_OF_IMAGE,
     false, false, near_error},
	{"median", "median over pixels of the error in radiance by the other's", "", TS_FIGURE_OF_IMAGE, false, false,
     median},
	{"beyond", "pixels whose error in radiance is above a tenth of the other's", "%", TS_FIGURE_OF_IMAGE, false, false,
     beyond},
	{"unlit", "pixels where only the image has light", "", TS_FIGURE_OF_IMAGE, false, false, unlit},
	{"given", "mean radiance where only the image has light, of the other's mean", "%", TS_FIGURE_OF_IMAGE, false,
     false, given},
	{0},
};

static bool is_there(const ts_figure *figure, const ts_figure_source *c)
{
	return figure->row->of_case || c->methods[figure->variant] != NULL;
}

double ts_figure_error(const ts_figure *figure, const ts_figure_source *source)
{
	return figure->row->value == rmse && is_there(figure, source) ? errors(figure, source).rmse_error : 0;
}

double ts_figure_value(const ts_figure *figure, const ts_figure_source *source)
{
	return is_there(figure, source) ? figure->row->value(figure, source) : NAN;
}

u32 ts_name_variant(const ts_name_scope *scope, const char *name, size_t n)
{
	for (u32 i = 0; i < scope->n_variants; i++)
		if (strncmp(scope->variants[i], name, n) == 0 && scope->variants[i][n] == 0) return i;
	return TS_NONE;
}

static bool is_buffer(const char *name)
{
	u32 id = 0;
	while (id < TS_N_BUFFERS && strcmp(ts_buffer_table[id].name, name) != 0) id++;
	return id < TS_N_BUFFERS;
}

bool ts_name_is_param(const char *name)
{
	size_t n, i = 0;
	const ts_param_info *table = ts_param_table(&n);
	while (i < n && strcmp(table[i].name, name) != 0) i++;
	return i < n;
}

/* A stage, or a list, whose items are then the object. */
static bool is_stages(ts_figure *figure, const ts_name_scope *scope)
{
	for (u32 i = 0; i < scope->n_lists; i++) {
		if (strcmp(scope->lists[i].name, figure->what) != 0) continue;
		figure->what = scope->lists[i].items;
		return true;
	}
	return ts_stage_find(figure->what) != NULL;
}

static u32 find_image(const ts_name_scope *scope, const char *name)
{
	for (u32 t = 0; scope->truths[t] != NULL; t++)
		if (strcmp(scope->truths[t], name) == 0) return TS_FIGURE_TRUTHS + t;
	return ts_name_variant(scope, name, strlen(name));
}

/* Why there is no such object; NULL: there is. */
static const char *find_object(ts_figure *figure, const ts_name_scope *scope)
{
	const char *name = figure->what;
	switch (figure->row->object) {
	case TS_FIGURE_OF_STAGES: return is_stages(figure, scope) ? NULL : "no stage, and no list of stages";
	case TS_FIGURE_OF_BUFFERS:
		return is_stages(figure, scope) || is_buffer(name) ? NULL : "no buffer, no stage, and no list of stages";
	case TS_FIGURE_OF_PARAM: return ts_name_is_param(name) ? NULL : "no parameter";
	case TS_FIGURE_OF_IMAGE:
		figure->other = find_image(scope, name);
		if (figure->other != TS_NONE) return NULL;
		return scope->own_truth ? "no variant; the table's truth is \"truth\"" : "no variant, and no truth";
	default: return NULL; /* counters are known when a method has run */
	}
}

/* Whether a name is the row's; then *object is what stands behind the row's name. */
static bool is_row(const ts_figure_row *row, const char *name, const char **object)
{
	size_t n = strlen(row->name);
	if (strncmp(row->name, name, n) != 0) return false;
	bool alone = row->object == TS_FIGURE_ALONE;
	*object = alone ? name + n : name + n + 1;
	return alone ? name[n] == 0 : name[n] == '.' && name[n + 1] != 0;
}

ts_status ts_name_find(ts_figure *figure, const ts_name_scope *scope, const char *name)
{
	const char *behind = strchr(name, '.'), *why;
	u32 variant = behind != NULL ? ts_name_variant(scope, name, (size_t)(behind - name)) : TS_NONE;
	*figure = (ts_figure){.variant = variant};
	for (figure->row = ts_figure_rows; figure->row->name != NULL; figure->row++) {
		bool of_case = figure->row->of_case;
		if (!of_case && variant == TS_NONE) continue;
		if (!is_row(figure->row, of_case ? name : behind + 1, &figure->what)) continue;
		why = find_object(figure, scope);
		return why == NULL ? TS_OK : ts_fail("%s is %s", figure->what, why);
	}
	if (variant == TS_NONE) return ts_fail("%s: no figure or variant above begins so", name);
	return ts_fail("%s: a variant has no such figure; `touchstone list figures` lists all", name);
}
