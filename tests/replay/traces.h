/* Traces of a small scene by methods of every kind, made once a program, and candidates with a buffer or two of their
 * own. */
#ifndef TS_TESTS_REPLAY_TRACES_H
#define TS_TESTS_REPLAY_TRACES_H
#include <sys/stat.h>
#include <unistd.h>
#include "replay/judge.h"
#include "tests/methods/small.h"
#include "tests/scratch.h"
#include "trace/write.h"

enum { MAX_TEXT = 4096 };

/* Views of shadows come in batches; only the last one is smaller. */
static const struct {
	const char *effect, *method;
	u32 lamp, buffered;
} traces_runs[] = {
	{"reflections", "epr", 0, 0},
	{"reflections", "mvr", 0, 0},
	{"reflections", "ivir", 0, 0},
	{"soft-shadows", "ivir", TS_LAMP_SCENE, 0},
	{"omni-shadows", "vir", 0, TS_BUFFERED_ON},
	{"soft-shadows", "mvr", 0, 0},
	{"soft-shadows", "pcss", TS_LAMP_SCENE, 0},
	{"omni-shadows", "epr", 0, 0},
	{"indirect", "hulls", TS_LAMP_SCENE, 0},
	{"indirect", "direct", 0, 0},
	{"indirect", "megaviews", 0, 0},
	{"reflections", "megaviews", 0, 0},
	{"reflections", "epr-bufferless", 0, 0},
	{"reflections", "epr-forward", 0, 0},
	{"surfels", "deferred", 0, 0},
	{"surfels", "phong", 0, 0},
};
enum {
	TRACES_IVIR = 2,
	TRACES_SOFT,
	TRACES_OMNI,
	TRACES_DEPTH,
	TRACES_PCSS,
	TRACES_EPR,
	TRACES_HULLS,
	TRACES_DIRECT,
	TRACES_MEGAVIEWS,
	TRACES_CUBES,
	TRACES_BUFFERLESS,
	TRACES_FORWARD,
	TRACES_SURFELS,
	TRACES_PHONG,
	N_TRACES
};
static ts_trace *traces[N_TRACES];
static ts_trace_writer *traces_writer;
static u32 traces_m;
static char *traces_paths[N_TRACES * TS_N_BUFFERS];
static u32 traces_n_paths;

static inline const char *traces_place(void *user, const char *name)
{
	(void)user;
	char *copy = strdup(scratch_path("%u/%s", (unsigned)traces_m, name)); /* stays, as the writer wants */
	assert_non_null(copy);
	assert_true(traces_n_paths < sizeof traces_paths / sizeof *traces_paths);
	return traces_paths[traces_n_paths++] = copy;
}

static inline ts_status traces_hook(const ts_run *run, const ts_stage *stage, void *user)
{
	(void)user;
	return ts_trace_write_stage(traces_writer, run, stage);
}

/* All textures become one of 4 x 4 texels, so that a replay reads little. */
static inline void traces_shrink(ts_scene *scene)
{
	assert_true(scene->n_images > 0 && scene->n_slots > 0 && scene->n_texels > 21);
	scene->images[0] = (ts_image){.width = 4, .height = 4, .n_levels = 3};
	scene->n_images = 1;
	scene->n_texels = 21;
	for (u32 i = 0; i < scene->n_slots; i++) scene->slots[i].image = 0;
}

static inline ts_params traces_params(u32 m)
{
	ts_params params = small_params(32, 24);
	params.lookup_bounces = 3;
	params.reflectors_count = 2;
	params.reflectors_px = 24;
	params.cube_max_px = 16;
	params.lamp_views = 5;
	params.lamp_cubes = 2;
	params.lamp_views_a_pass = 2;
	params.depth_map_px = 16;
	params.rsm_px = 4;
	params.depth_grid_px = 64;
	params.octree_levels = 3;
	params.vpl_gather_level = 2;
	params.view_map_px = params.cube_view_px = 4;
	params.vpl_paths = 20;
	if (m >= TRACES_SURFELS) params.surfels_from_mesh = 300;
	params.lamp_source = traces_runs[m].lamp;
	params.points_buffered = traces_runs[m].buffered;
	return params;
}

static inline void traces_make(u32 m, const ts_scene *scene)
{
	ts_params params = traces_params(m);
	traces_m = m;
	assert_int_equal(mkdir(scratch_path("%u", (unsigned)m), 0700), 0);
	ts_run run;
	ts_trace_options options = {.place = traces_place, .margins = m == TRACES_HULLS};
	ts_run_begin(&run, scene, &params, 2);
	run.margins = options.margins;
	run.traced = true;
	run.hook = traces_hook;
	const ts_pipeline *pipeline = ts_pipeline_find(traces_runs[m].effect, traces_runs[m].method);
	assert_int_equal(ts_trace_write_begin(&traces_writer, pipeline, &run, &options), TS_OK);
	assert_int_equal(ts_pipeline_run(pipeline, &run), TS_OK);
	assert_int_equal(ts_trace_write_end(traces_writer, &run), TS_OK);
	ts_trace_write_free(traces_writer);
	ts_run_end(&run);
	if (ts_trace_open_folder(&traces[m], scratch_path("%u", (unsigned)m)) != TS_OK) fail_msg("%s", ts_error_message());
}

static inline int traces_begin(void **state)
{
	assert_int_equal(scratch_begin(state), 0);
	ts_params params = traces_params(0), of_surfels = traces_params(TRACES_SURFELS);
	ts_scene *scene = small_scene(&params), *surfels = small_scene(&of_surfels);
	traces_shrink(scene);
	for (u32 m = 0; m < N_TRACES; m++) traces_make(m, m >= TRACES_SURFELS ? surfels : scene);
	ts_scene_free(scene);
	ts_scene_free(surfels);
	return 0;
}

static inline int traces_end(void **state)
{
	for (u32 m = 0; m < N_TRACES; m++) ts_trace_close(traces[m]);
	while (traces_n_paths > 0) free(traces_paths[--traces_n_paths]);
	return scratch_remove(state);
}

/* A buffer of a trace, whole, in memory of malloc. */
static inline void *traces_read(ts_buffer *buffer, const ts_trace *trace, ts_buffer_id id)
{
	const ts_trace_item *item = &trace->item[id];
	size_t bytes = (size_t)item->npy.n * ts_buffer_table[id].element_bytes;
	FILE *file = fopen(item->path, "rb");
	void *data = malloc(bytes + 1);
	assert_true(file != NULL && data != NULL && fseek(file, (long)item->npy.data_at, SEEK_SET) == 0);
	assert_int_equal(fread(data, 1, bytes, file), bytes);
	fclose(file);
	*buffer = (ts_buffer){.data = data, .n = item->npy.n, .n_dims = item->npy.n_dims};
	memcpy(buffer->shape, item->npy.shape, sizeof buffer->shape);
	return data;
}

/* A candidate of its own buffers, n of them; `more` is JSON for each of their entries, as `, "crop": [...]`, and
 * `order` that of its points. Opened; to be closed. */
typedef struct {
	ts_buffer_id id;
	const ts_buffer *buffer;
} planted;

static inline ts_trace *traces_plant(u32 m, const planted *own, u32 n, const char *order, const char *more)
{
	static u32 n_made;
	const char *dir = scratch_path("candidate-%u", (unsigned)n_made++);
	char path[MAX_TEXT], header[TS_NPY_HEADER], descr[TS_NPY_DESCR];
	assert_int_equal(mkdir(dir, 0700), 0);
	snprintf(path, sizeof path, "%s/trace.json", dir);
	FILE *json = fopen(path, "w");
	assert_non_null(json);
	fprintf(json,
	        "{\"format\": \"touchstone-trace\", \"version\": 1, \"contract\": 1, \"pipeline\": \"%s\", "
	        "\"effect\": \"%s\", ",
	        traces[m]->pipeline->name, traces[m]->pipeline->effect->name);
	fprintf(json, "\"order\": \"%s\", \"buffers\": [", order);
	for (u32 i = 0; i < n; i++) {
		const char *name = ts_buffer_table[own[i].id].name;
		const ts_buffer *b = own[i].buffer;
		fprintf(json, "%s{\"name\": \"%s\", \"file\": \"%s.npy\"%s}", i > 0 ? ", " : "", name, name, more);
		snprintf(path, sizeof path, "%s/%s.npy", dir, name);
		FILE *file = fopen(path, "wb");
		ts_npy_descr(descr, own[i].id);
		fwrite(header, 1, ts_npy_header(header, descr, b->n_dims, b->shape), file);
		fwrite(b->data, ts_buffer_table[own[i].id].element_bytes, (size_t)b->n, file);
		assert_int_equal(fclose(file), 0);
	}
	fprintf(json, "]}\n");
	assert_int_equal(fclose(json), 0);
	ts_trace *trace;
	if (ts_trace_open_folder(&trace, dir) != TS_OK) fail_msg("%s", ts_error_message());
	return trace;
}

/* Closes a candidate and removes its folder. */
static inline void traces_drop(ts_trace *trace)
{
	char path[MAX_TEXT];
	snprintf(path, sizeof path, "%s/trace.json", trace->dir);
	assert_int_equal(unlink(path), 0);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (trace->item[id].path != NULL) assert_int_equal(unlink(trace->item[id].path), 0);
	}
	assert_int_equal(rmdir(trace->dir), 0);
	ts_trace_close(trace);
}

/* The next stage of a method behind `stage`; NULL: the first, or there is none. */
static inline const ts_stage *traces_next(u32 m, const ts_stage *stage)
{
	const ts_step *step = ts_pipeline_steps(traces[m]->pipeline);
	while (stage != NULL && strcmp(step->stage, stage->name) != 0) step++;
	if (stage != NULL) step++;
	while (step->stage != NULL && !ts_replay_takes(step, traces[m])) step++;
	return step->stage != NULL ? ts_stage_find(step->stage) : NULL;
}

#define FOR_STAGES(m, s) for (const ts_stage *s = traces_next(m, NULL); s != NULL; s = traces_next(m, s))

/* A method before has the stage, with the same inputs. */
static inline bool traces_known(u32 m, const ts_stage *stage)
{
	if (m == TRACES_OMNI && strncmp(stage->name, "scatter", 7) == 0) return false;         /* of stored points */
	if (m == TRACES_BUFFERLESS && ts_stage_reads(stage, TS_B_points_offset)) return false; /* of points made again */
	if (m == TRACES_PHONG && strcmp(stage->name, "surfel_blend") == 0) return false;       /* of shaded surfels */
	for (u32 before = 0; before < m; before++) {
		FOR_STAGES(before, s)
		{
			if (s == stage) return true;
		}
	}
	return false;
}

#endif
