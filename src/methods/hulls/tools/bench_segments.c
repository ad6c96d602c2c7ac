/* `bench ssagh-segments`: how many labels the four sweeps of SSAGH's algorithm 1 find in the depth of whole images,
 * beside the connected components that they stand for. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "kernels/hulls/segment.h"
#include "methods/hulls/tools/tools.h"
#include "methods/pipeline.h"
#include "study/bench_case.h"

/* Counts of blocks and labels. */
typedef struct {
	i64 blocks, labels, components, equal; /* equal: blocks with equal numbers of both */
	i64 most_labels, most_components, most_excess;
	i64 joined; /* labels of several components */
} tally;

typedef struct {
	const ts_job *job;
	ts_table table;
	i64 joined, labels, components;
} work;

/* clang-format off */
static const ts_column columns[] = { { "scene", "scene", false }, { "of", "of blocks", false },
	{ "blocks", "blocks", true }, { "labels", "labels a block", true }, { "components", "components", true },
	{ "excess", "excess", true },
	{ "most_excess", "most excess", true }, { "most_labels", "most labels", true },
	{ "most_components", "most components", true }, { "equal_percent", "as many, %", true },
	{ "joined", "joined", true }, { 0 } };
/* clang-format on */

/* The stages before segmentation. */
static const char *const stages[] = {"eye.view", "pose", "eye", "gbuffer", "depth_grid", "segment", NULL};

static void add_to(tally *t, const tally *block)
{
	i64 excess = block->labels - block->components;
	t->blocks++;
	t->labels += block->labels;
	t->components += block->components;
	t->equal += excess == 0;
	t->joined += block->joined;
	t->most_labels = block->labels > t->most_labels ? block->labels : t->most_labels;
	t->most_components = block->components > t->most_components ? block->components : t->most_components;
	t->most_excess = excess > t->most_excess ? excess : t->most_excess;
}

static tally count_block(const u32 *swept, const u32 *exact, u32 grid, u32 block)
{
	tally t = {.blocks = 1};
	bool used[TS_BLOCK_TEXELS] = {false}, joined[TS_BLOCK_TEXELS] = {false};
	u32 component[TS_BLOCK_TEXELS]; /* that had the label last */
	memset(component, 0xff, sizeof component);
	for (u32 p = 0; p < TS_BLOCK_TEXELS; p++) {
		u64 at = ts_k_block_texel(grid, block, p % TS_BLOCK, p / TS_BLOCK);
		u32 label = swept[at];
		t.labels += component[label] == TS_NONE;
		joined[label] |= component[label] != TS_NONE && component[label] != exact[at];
		component[label] = exact[at];
		t.components += !used[exact[at]];
		used[exact[at]] = true;
	}
	for (u32 l = 0; l < TS_BLOCK_TEXELS; l++) t.joined += joined[l];
	return t;
}

static void add_row(ts_table *table, const char *scene, const char *of, const tally *t)
{
	double blocks = t->blocks > 0 ? (double)t->blocks : 1;
	ts_table_text(table, scene);
	ts_table_text(table, of);
	ts_table_count(table, t->blocks);
	ts_table_real(table, (double)t->labels / blocks, 2);
	ts_table_real(table, (double)t->components / blocks, 2);
	ts_table_real(table, (double)(t->labels - t->components) / blocks, 2);
	ts_table_count(table, t->most_excess);
	ts_table_count(table, t->most_labels);
	ts_table_count(table, t->most_components);
	ts_table_real(table, 100 * (double)t->equal / blocks, 1);
	ts_table_count(table, t->joined);
	ts_table_say(table);
}

/* The result of numpy for 300 blocks of discs before slopes. */
static void add_synthetic_row(ts_table *table)
{
	ts_table_text(table, "discs (FIGURES 7)");
	ts_table_text(table, "all");
	ts_table_count(table, 300);
	ts_table_real(table, 12.45, 2);
	ts_table_real(table, 4.25, 2);
	ts_table_real(table, 8.2, 2);
	ts_table_none(table);
	ts_table_count(table, 63);
	ts_table_count(table, 21);
	ts_table_real(table, 32, 1);
	ts_table_count(table, 0);
}

static void report_scene(work *w, const char *spec, const u32 *swept, const u32 *exact, u32 grid)
{
	const char *slash = strrchr(spec, '/'), *name = slash != NULL ? slash + 1 : spec;
	tally all = {0}, parted = {0};
	for (u32 b = 0; b < grid / TS_BLOCK * (grid / TS_BLOCK); b++) {
		tally block = count_block(swept, exact, grid, b);
		add_to(&all, &block);
		if (block.components > 1) add_to(&parted, &block);
	}
	add_row(&w->table, name, "all", &all);
	add_row(&w->table, name, "parted", &parted);
	w->joined += all.joined;
	w->labels += all.labels;
	w->components += all.components;
}

/* Labels by sweeps or by components; to be released by free(), NULL on failure. */
static ts_status segment(u32 **labels, const work *w, const ts_scene *scene, const ts_params *params, u32 segmentation)
{
	ts_run run;
	ts_params own = *params;
	TS_PARAM_SET(&own, segment_method, segmentation);
	*labels = NULL;
	ts_run_begin(&run, scene, &own, w->job->how.threads);
	ts_run_how(&run, &w->job->how);
	ts_status status = TS_OK;
	for (u32 k = 0; stages[k] != NULL && status == TS_OK; k++) status = ts_run_stage(&run, ts_stage_find(stages[k]));
	if (status == TS_OK) status = ts_frame_fetch(&run.frame);
	u64 n = ts_frame_n(&run.frame, TS_B_segment_label);
	if (status == TS_OK) *labels = ts_alloc(n, sizeof **labels, "labels");
	if (*labels != NULL) memcpy(*labels, ts_frame_data(&run.frame, TS_B_segment_label), n * sizeof **labels);
	ts_run_end(&run);
	return *labels != NULL ? TS_OK : TS_ERROR;
}

static ts_status add_scene(void *user, const char *spec)
{
	work *w = user;
	ts_scene *scene;
	ts_params params = w->job->params;
	u32 *swept = NULL, *exact = NULL;
	if (ts_scene_load(&scene, spec, &params, &w->job->scene.options) != TS_OK) return TS_ERROR;
	ts_status status = segment(&swept, w, scene, &params, TS_SEGMENTATION_SWEEPS);
	if (status == TS_OK) status = segment(&exact, w, scene, &params, TS_SEGMENTATION_COMPONENTS);
	if (status == TS_OK) report_scene(w, spec, swept, exact, TS_PARAM(&params, depth_grid_px));
	free(swept);
	free(exact);
	ts_scene_free(scene);
	return status;
}

static void report_claims(ts_report *report, const work *w)
{
	ts_table t = ts_bench_relations_begin();
	ts_bench_relation_add(&t, &(ts_bench_relation){.text = "labels that join components",
	                                               .bound = "0",
	                                               .here = (double)w->joined,
	                                               .paper = NAN,
	                                               .holds = w->joined == 0,
	                                               .because = TS_OURS "sweeps carry labels over edges"});
	ts_bench_relation_add(&t, &(ts_bench_relation){.text = "labels by components",
	                                               .bound = "at least 1",
	                                               .here = (double)w->labels / (double)w->components,
	                                               .paper = NAN,
	                                               .decimals = 3,
	                                               .holds = w->labels >= w->components,
	                                               .because = TS_OURS "sweeps join components"});
	ts_report_table(report, &t);
}

static ts_status work_on(const ts_job *job, ts_report *report, const void *user)
{
	(void)user;
	work w = {.job = job};
	w.table = ts_table_begin("ssagh_segments", "SSAGH, algorithm 1: labels by four sweeps", columns);
	ts_bench_head(report, job, true);
	ts_report_line(report,
	               "Parted blocks have several components, and so have joined labels. Excess: labels too many.");
	ts_status status = ts_bench_scenes(job, "atrium,gallery,dining", "sponza.glb,sibenik.glb,breakfast_room.glb",
	                                   report, add_scene, &w);
	if (status != TS_OK) {
		ts_table_end(&w.table);
		return status;
	}
	add_synthetic_row(&w.table);
	ts_report_table(report, &w.table);
	report_claims(report, &w);
	return TS_OK;
}

ts_status ts_bench_segments(const ts_job *job)
{
	ts_job own = *job;
	ts_status status = ts_bench_set(&own.params, "reflectors.count=0");
	return status == TS_OK ? ts_bench_with_report(&own, work_on, NULL) : status;
}
