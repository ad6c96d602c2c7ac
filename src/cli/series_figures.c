/* Figures of pictures, per frame and per combination of a sweep. */
#include <math.h>
#include "cli/series.h"

static const char *const counters[] = {"points",
                                       "shading operations",
                                       "look-ups",
                                       "empty look-ups",
                                       "cube texels",
                                       "geometry traversals",
                                       "triangles processed",
                                       "pieces culled",
                                       "point-view scatters",
                                       "texel writes",
                                       "shadows asked of rays",
                                       "lit but by rays",
                                       "dark but by rays",
                                       "texels a ray",
                                       "texels covered by rays",
                                       "holes",
                                       "leaks",
                                       "wrong depths",
                                       NULL};

/* "shading operations", "" to "shading_operations"; "rmse", "truth-b" to "rmse_truth-b". */
static void put(ts_series_figure_list *figures, const char *name, const char *against, double value, int decimals)
{
	ts_series_figure *figure = &figures->figure[figures->n];
	if (figures->n == TS_MAX_FIGURES) return;
	figures->n++;
	figure->value = value;
	figure->decimals = decimals;
	snprintf(figure->name, sizeof figure->name, "%s%s%s", name, against[0] != 0 ? "_" : "", against);
	for (char *at = figure->name; *at != 0; at++) *at = *at == ' ' ? '_' : *at;
}

/* Counters that a method lacks are 0; truths have none. */
static void put_counters(ts_series_figure_list *figures, const ts_render *render, u32 shown)
{
	for (u32 i = 0; counters[i] != NULL; i++) {
		const ts_counter *counter = NULL;
		if (shown < TS_MAX_METHODS) counter = ts_measure_counter(&render->measures[shown], counters[i]);
		double none = shown < TS_MAX_METHODS ? 0 : NAN;
		put(figures, counters[i], "", counter != NULL ? (double)counter->value : none, 0);
	}
}

static const ts_pair *find_pair(const ts_render *render, const ts_picture *reference, const ts_picture *image)
{
	for (u32 i = 0; i < render->n_pairs; i++) {
		if (render->pairs[i].reference == reference && render->pairs[i].image == image) return &render->pairs[i];
	}
	return NULL;
}

static bool is_swept(const ts_sweep *sweep, const char *param)
{
	u32 k = 0;
	while (k < sweep->n && strcmp(sweep->swept[k].name, param) != 0) k++;
	return k < sweep->n;
}

/* Errors to a requested truth, whether or not the scene has it. */
static void put_errors(ts_series_figure_list *figures, const ts_render *render, u32 truth, const ts_picture *image)
{
	char name[24];
	const ts_pair *pair = find_pair(render, ts_render_shown(render, truth), image);
	ts_render_name(name, sizeof name, render, truth);
	bool mirrors = render->mirrors != NULL, sequence = render->job->frames.step > 0;
	bool estimates = TS_PARAM(&render->job->params, truth_rays) > 0 || is_swept(&render->job->sweep, "truth.rays");
	put(figures, "rmse", name, pair != NULL ? pair->all.rmse : NAN, 6);
	if (estimates) put(figures, "rmse_error", name, pair != NULL ? pair->all.rmse_error : NAN, 6);
	if (mirrors) put(figures, "reflective_rmse", name, pair != NULL ? pair->reflective.rmse : NAN, 6);
	if (mirrors && estimates) {
		put(figures, "reflective_rmse_error", name, pair != NULL ? pair->reflective.rmse_error : NAN, 6);
	}
	put(figures, "ssim", name, pair != NULL ? pair->all.ssim : NAN, 6);
	if (mirrors) put(figures, "reflective_ssim", name, pair != NULL ? pair->reflective.ssim : NAN, 6);
	if (sequence) put(figures, "flicker", name, pair != NULL ? pair->flicker : NAN, 6);
	if (sequence && mirrors) put(figures, "reflective_flicker", name, pair != NULL ? pair->reflective_flicker : NAN, 6);
}

void ts_series_figures(ts_series_figure_list *figures, const ts_render *render, u32 shown)
{
	const ts_picture *image = ts_render_shown(render, shown);
	figures->n = 0;
	if (render->mirrors != NULL) put(figures, "reflective pixels", "", (double)render->mirrors->n_reflective, 0);
	put_counters(figures, render, shown);
	for (u32 t = 0; t < TS_MAX_TRUTHS; t++) {
		if ((render->job->truths >> t & 1) != 0) put_errors(figures, render, TS_MAX_METHODS + t, image);
	}
	if (render->job->frames.step == 0) return;
	put(figures, "change", "", ts_picture_change(image, NULL, &render->job->params), 6);
	if (render->mirrors == NULL) return;
	bool known = render->mirrors_still != NULL;
	double change = known ? ts_picture_change(image, render->mirrors_still, &render->job->params) : NAN;
	put(figures, "reflective change", "", change, 6);
}
