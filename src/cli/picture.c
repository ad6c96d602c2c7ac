/* Pictures: of runs, and of the truths. */
#include "picture.h"
#include "truths.h"
#include <stdio.h>
#include <stdlib.h>
#include "../kernels/srgb.h"
#include "../truth/truth.h"
#include "cli.h"

static void count_lit(ts_picture *picture, const ts_run *run)
{
	const ts_lamp *lamps = ts_frame_data(&run->frame, TS_B_lamp_shape);
	const u32 *lit = ts_frame_data(&run->frame, TS_B_resolve_lit);
	u64 n, n_lamps = ts_frame_n(&run->frame, TS_B_lamp_shape), all = 0;
	const u64 *seen = ts_run_seen(run, &n);
	for (u64 k = 0; k < n_lamps; k++) all += lamps[k].samples;
	picture->n_lamps = n_lamps;
	picture->n_samples = all;
	picture->lit = (ts_lit){ 0 };
	for (u64 i = 0; i < n; i++) {
		if (seen[i] == TS_EMPTY) continue;
		u64 reach = 0;
		for (u64 k = 0; k < n_lamps; k++) reach += lit[i * n_lamps + k];
		picture->lit.seen++;
		picture->lit.full += reach == all;
		picture->lit.part += reach > 0 && reach < all;
		picture->lit.none += reach == 0;
	}
}

static void mark_seen(ts_picture *picture, const ts_run *run)
{
	u64 n;
	const u64 *seen = ts_run_seen(run, &n);
	for (u64 i = 0; i < n; i++) picture->seen[i] = seen[i] != TS_EMPTY;
}

ts_status ts_picture_take(ts_picture *picture, const char *name, const ts_run *run)
{
	size_t n = (size_t)run->params.width * run->params.height * 3;
	snprintf(picture->name, sizeof picture->name, "%s", name);
	picture->radiance = ts_alloc(n, sizeof(f32), "a picture");
	picture->srgb = ts_alloc(n, 1, "a picture");
	picture->seen = ts_alloc(n / 3, 1, "a picture");
	if (picture->radiance == NULL || picture->srgb == NULL || picture->seen == NULL) return TS_ERROR;
	memcpy(picture->radiance, ts_frame_data(&run->frame, TS_B_image_radiance), n * sizeof(f32));
	memcpy(picture->srgb, ts_frame_data(&run->frame, TS_B_image_srgb), n);
	mark_seen(picture, run);
	if (run->frame.buffer[TS_B_resolve_lit].made) count_lit(picture, run);
	return TS_OK;
}

ts_status ts_picture_make(ts_picture *picture, const char *name, f32 *radiance, const ts_params *params)
{
	size_t n = (size_t)params->width * params->height * 3;
	snprintf(picture->name, sizeof picture->name, "%s", name);
	picture->radiance = radiance;
	picture->srgb = ts_alloc(n, 1, "a picture");
	for (size_t i = 0; i < n && picture->srgb != NULL; i++) {
		picture->srgb[i] = (u8)ts_srgb_byte(params->exposure * radiance[i]);
	}
	return picture->srgb != NULL ? TS_OK : TS_ERROR;
}

void ts_picture_free(ts_picture *picture)
{
	free(picture->radiance);
	free(picture->srgb);
	free(picture->seen);
	picture->radiance = NULL;
	picture->srgb = NULL;
	picture->seen = NULL;
}

static ts_status count_missed(ts_picture *picture, ts_truth *tree, const ts_run *run)
{
	u32 *hits;
	const u32 *found = ts_frame_data(&run->frame, TS_B_lookup_point);
	if (ts_truth_hits(tree, run, &hits) != TS_OK) return TS_ERROR;
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_lookup_point); i++) {
		picture->n_hits += hits[i] != TS_NONE;
		picture->n_missed += hits[i] != TS_NONE && found[i] == TS_NONE;
	}
	free(hits);
	return TS_OK;
}

ts_status ts_picture_truth(ts_picture *picture, u32 truth, ts_run *run)
{
	double begin = ts_seconds();
	ts_truth *tree;
	ts_status status = ts_truth_new(&tree, run);
	if (status != TS_OK) return status;
	status = truth == TS_TRUTH_A ? ts_truth_a(tree, run) : ts_truth_b(tree, run);
	if (status == TS_OK && truth == TS_TRUTH_A) status = count_missed(picture, tree, run);
	if (status == TS_OK) status = ts_run_stage(run, ts_stage_find("image"));
	if (status == TS_OK) status = ts_frame_fetch(&run->frame);
	if (status == TS_OK) status = ts_picture_take(picture, truth == TS_TRUTH_A ? "truth-a" : "truth-b", run);
	ts_truth_free(tree);
	picture->seconds = ts_seconds() - begin;
	return status;
}

ts_status ts_picture_truth_c(ts_picture *picture, const ts_scene *scene, const ts_params *params, u32 threads)
{
	double begin = ts_seconds();
	f32 *radiance;
	ts_status status = ts_truth_c(&radiance, scene, params, TS_TRUTH_C_FACTOR, threads);
	if (status == TS_OK) status = ts_picture_make(picture, "truth-c", radiance, params);
	picture->seconds = ts_seconds() - begin;
	return status;
}

ts_status ts_picture_truth_surfels(ts_picture *picture, u32 at, const ts_scene *scene, const ts_params *params,
                                   u32 threads)
{
	double begin = ts_seconds();
	f32 *radiance;
	ts_status status = at == TS_AT_DISCS ? ts_truth_discs(&radiance, scene, params, threads)
	                                     : ts_truth_surface(&radiance, scene, params, threads);
	if (status == TS_OK) status = ts_picture_make(picture, ts_truth_kinds[at].picture, radiance, params);
	picture->seconds = ts_seconds() - begin;
	return status;
}

enum { MOST_TRACED = 3 };

/* Truths that start from a run of their own: their effects, what leads to them, and the stage that shows them. */
typedef struct {
	const char *of;
	ts_status (*begin)(ts_run *run, const char *effect);
	const char *image;
	struct { u32 at; ts_status (*trace)(ts_truth *tree, ts_run *run); } truths[MOST_TRACED]; /* TS_AT_* */
} traced;

static const traced traced_truths[] = {
	{ "shadows", ts_truth_shadow_begin, "shadow_image",
	  { { TS_AT_SAMPLES, ts_truth_samples }, { TS_AT_AREA, ts_truth_area } } },
	{ "indirect", ts_truth_indirect_begin, "indirect_image",
	  { { TS_AT_LIGHTS, ts_truth_lights }, { TS_AT_BOUNCE, ts_truth_bounce }, { TS_AT_VPLS, ts_truth_vpls } } },
	{ "particles", ts_truth_particles_begin, "indirect_image", { { TS_AT_GLOW, ts_truth_glow } } },
};

static const traced *traced_of(const char *effect)
{
	const traced *of = traced_truths;
	while (strstr(effect, of->of) == NULL) of++;
	return of;
}

/* One of them, and the picture from it. */
static ts_status take_traced(ts_picture *picture, const traced *of, u32 k, ts_truth *tree, ts_run *run)
{
	double begin = ts_seconds();
	ts_status status = of->truths[k].trace(tree, run);
	if (status == TS_OK) status = ts_run_stage(run, ts_stage_find(of->image));
	if (status == TS_OK) status = ts_picture_take(picture, ts_truth_kinds[of->truths[k].at].picture, run);
	picture->seconds = ts_seconds() - begin;
	return status;
}

ts_status ts_picture_truth_traced(ts_picture *pictures, u32 truths, const char *effect, const ts_scene *scene,
                                  const ts_params *params, u32 threads)
{
	ts_run run;
	ts_truth *tree = NULL;
	const traced *of = traced_of(effect);
	ts_run_begin(&run, scene, params, threads);
	ts_status status = of->begin(&run, effect);
	if (status == TS_OK) status = ts_truth_new(&tree, &run);
	for (u32 k = 0; k < MOST_TRACED && of->truths[k].trace != NULL && status == TS_OK; k++) {
		u32 at = of->truths[k].at;
		if ((truths & 1u << at) != 0) status = take_traced(&pictures[at], of, k, tree, &run);
	}
	ts_truth_free(tree);
	ts_run_end(&run);
	return status;
}
