/* A sweep's lines. */
#include "render_csv.h"
#include <inttypes.h>

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
                                       "texels covered by rays",
                                       "holes",
                                       "leaks",
                                       "wrong depths",
                                       NULL};

/* "shading operations" to "shading_operations". */
static void put_name(const char *name)
{
	putchar(',');
	for (; *name != 0; name++) putchar(*name == ' ' ? '_' : *name);
}

static void put_head(const ts_render *render, const ts_csv *csv)
{
	for (u32 k = 0; k < csv->sweep->n; k++) printf("%s,", csv->sweep->swept[k].name);
	printf("method,milliseconds");
	if (render->mask != NULL) printf(",reflective_pixels");
	for (u32 i = 0; counters[i] != NULL; i++) put_name(counters[i]);
	for (u32 t = 0; t < TS_MAX_TRUTHS; t++) {
		const char *name = render->truths[t].name;
		if (render->truths[t].srgb != NULL) printf(",rmse_%s", name);
		if (render->truths[t].srgb != NULL && render->mask != NULL) printf(",reflective_rmse_%s", name);
	}
	putchar('\n');
}

static void put_errors(const ts_render *render, u32 method)
{
	for (u32 i = 0; i < render->n_pairs; i++) {
		const ts_pair *pair = &render->pairs[i];
		bool truth = pair->reference >= render->truths && pair->reference < render->truths + TS_MAX_TRUTHS;
		if (!truth || pair->image != &render->pictures[method]) continue;
		printf(",%.6f", pair->all.rmse);
		if (render->mask != NULL) printf(",%.6f", pair->reflective.rmse);
	}
}

void ts_render_csv(const ts_render *render, ts_csv *csv)
{
	if (!csv->headed) put_head(render, csv);
	csv->headed = true;
	for (u32 m = 0; m < render->n_methods; m++) {
		const ts_measure *measure = &render->measures[m];
		for (u32 k = 0; k < csv->sweep->n; k++) printf("%s,", csv->values[k]);
		printf("%s,%.3f", measure->method->name, measure->seconds * 1e3);
		if (render->mask != NULL) printf(",%" PRIu64, render->n_reflective);
		for (u32 i = 0; counters[i] != NULL; i++) {
			const ts_counter *counter = ts_measure_counter(measure, counters[i]);
			printf(",%" PRId64, counter != NULL ? counter->value : 0);
		}
		put_errors(render, m);
		putchar('\n');
	}
	fflush(stdout);
}
