/* trace.json: who made the trace, its text, and the file. */
#include "trace/describe.h"
#include <stdio.h>
#include "kernels/base/compat.h"
#include "model/core.h"
#include "output/file.h"
#include "output/json/text.h"

json_t *ts_producer(const ts_run *run)
{
	const ts_backend *b = ts_run_backend(run);
	return json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s}", "name", "touchstone", "version", TS_VERSION, "commit",
	                 ts_commit(), "backend", b->name, "device", b->device, "compiler", b->compiler, "flags", b->flags);
}

static f32 load(u32 bits)
{
	volatile u32 v = bits;
	return ts_u2f(v);
}

static ts_measured of_this_process(void)
{
	f32 half_ulp = load(0x33800000u), one = load(0x3f800000u), least = load(0x00800000u);
	f32 up = load(0x3f800001u) + half_ulp, even = one + half_ulp;
	f32 product = load(0x3f800800u) * load(0x3f800800u);
	return (ts_measured){
		.rounds_to_nearest = ts_f2u(even) == 0x3f800000u && ts_f2u(up) == 0x3f800002u,
		.contracts = ts_f2u(product + load(0xbf801000u)) != 0u,
		.keeps_denormals = ts_f2u(least * load(0x3f000000u)) == 0x00400000u,
		.n_wrong = ts_selftest() != 0,
	};
}

json_t *ts_arithmetic(const ts_run *run)
{
	const ts_measured m = run->backend != NULL ? run->backend->arithmetic : of_this_process();
	return json_pack("{s:s, s:b, s:s, s:i}", "rounding", m.rounds_to_nearest ? "nearest even" : "other", "contraction",
	                 m.contracts, "denormals", m.keeps_denormals ? "kept" : "flushed", "selftest", (int)m.n_wrong);
}

json_t *ts_trace_params(const ts_params *params)
{
	json_t *object = json_object();
	size_t n;
	int failed = 0;
	const ts_param_info *table = ts_param_table(&n);
	for (size_t row = 0; row < n; row++) {
		char text[64];
		ts_params_format(params, row, text, sizeof text);
		failed |= json_object_set_new(object, table[row].name, json_string(text));
	}
	return ts_json_made(object, failed);
}

static json_t *plan_of(const ts_plan *plan)
{
	json_t *object = json_object();
	int failed = 0;
	for (u32 i = 0; i < TS_PLAN_ROWS; i++) {
		const ts_plan_row *row = &ts_plan_table[i];
		char name[64];
		snprintf(name, sizeof name, "%s%s%s", row->part, row->part[0] != 0 ? "." : "", row->name);
		failed |= json_object_set_new(object, name, json_integer(ts_plan_value(plan, row)));
	}
	return ts_json_made(object, failed);
}

static json_t *names_of(const ts_trace_description *about, const ts_buffer_id *ids)
{
	json_t *names = json_array();
	int failed = 0;
	for (; *ids != TS_N_BUFFERS; ids++) {
		if (about->files[*ids].made) failed |= json_array_append_new(names, json_string(ts_buffer_table[*ids].name));
	}
	return ts_json_made(names, failed);
}

/* SHA-256 of the lines "sha256  name" of these buffers. */
static json_t *chain(const ts_trace_description *about, const ts_buffer_id *ids)
{
	ts_digest digest;
	char hex[TS_DIGEST_BYTES], line[TS_DIGEST_BYTES + TS_EMIT_NAME];
	ts_digest_begin(&digest);
	for (; *ids != TS_N_BUFFERS; ids++) {
		const ts_trace_file *file = &about->files[*ids];
		if (!file->made) continue;
		int n = snprintf(line, sizeof line, "%s  %s\n", file->sha256, ts_buffer_table[*ids].name);
		ts_digest_add(&digest, line, (size_t)n);
	}
	ts_digest_end(&digest, hex);
	return json_string(hex);
}

static json_t *stage_of(const ts_trace_description *about, const ts_stage *stage, u32 number)
{
	const ts_buffer_id *inputs = ts_stage_inputs(stage);
	return json_pack("{s:i, s:s, s:s, s:s, s:s, s:o, s:o, s:o}", "number", (int)number, "name", stage->name, "kind",
	                 stage->kind, "paper", stage->paper, "doc", stage->doc, "reads", names_of(about, inputs), "writes",
	                 names_of(about, ts_stage_outputs(stage)), "inputs_sha256", chain(about, inputs));
}

static json_t *stages_of(const ts_trace_description *about)
{
	json_t *stages = json_array();
	int failed = 0;
	for (const ts_step *step = ts_pipeline_steps(about->pipeline); step->stage != NULL; step++) {
		const ts_stage *stage = ts_stage_find(step->stage);
		ts_buffer_id first = ts_stage_outputs(stage)[0];
		if (!ts_pipeline_takes(step, &about->run->params, true) || !about->files[first].made) continue;
		failed |= json_array_append_new(stages, stage_of(about, stage, ts_emit_number(about->pipeline, first)));
	}
	return ts_json_made(stages, failed);
}

static json_t *buffer_of(const ts_trace_description *about, ts_buffer_id id)
{
	const ts_buffer_info *info = &ts_buffer_table[id];
	const ts_trace_file *file = &about->files[id];
	json_t *shape = json_array(), *sizes = json_array();
	int failed = 0;
	for (u32 i = 0; i < file->n_dims; i++)
		failed |= json_array_append_new(shape, json_integer((json_int_t)file->shape[i]));
	json_t *root = json_pack("{s:s, s:o, s:s, s:s, s:o, s:s, s:s, s:s, s:s, s:s}", "name", info->name, "file",
	                         file->has_file ? json_string(file->name) : json_null(), "element", info->element, "dtype",
	                         file->descr, "shape", shape, "sizes", info->shape, "order", info->order, "key", info->key,
	                         "doc", info->doc, "sha256", file->sha256);
	for (u32 i = 0; file->cropped && i < 4; i++) failed |= json_array_append_new(sizes, json_integer(about->crop[i]));
	if (file->cropped) failed |= json_object_set(root, "crop", sizes);
	json_decref(sizes);
	return ts_json_made(root, failed);
}

static json_t *buffers_of(const ts_trace_description *about)
{
	json_t *buffers = json_array();
	int failed = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (about->files[id].made) failed |= json_array_append_new(buffers, buffer_of(about, (ts_buffer_id)id));
	}
	return ts_json_made(buffers, failed);
}

static json_t *records(void)
{
	json_t *root = json_object();
	size_t n;
	int failed = 0;
	const ts_field_info *fields = ts_field_table(&n);
	for (size_t i = 0; i < n; i++) {
		json_t *list = json_object_get(root, fields[i].record);
		if (list == NULL) {
			list = json_array();
			failed |= json_object_set_new(root, fields[i].record, list);
		}
		if (failed != 0) break;
		failed |=
			json_array_append_new(list, json_pack("{s:s, s:s, s:i, s:s}", "name", fields[i].name, "type",
		                                          fields[i].type, "count", (int)fields[i].count, "doc", fields[i].doc));
	}
	return ts_json_made(root, failed);
}

static json_t *counters_of(const ts_run *run)
{
	json_t *counters = json_object();
	int failed = 0;
	for (u32 i = 0; i < run->n_counters; i++) {
		failed |= json_object_set_new(counters, run->counters[i].name, json_integer(run->counters[i].value));
	}
	return ts_json_made(counters, failed);
}

static json_t *conventions(void)
{
	return json_pack(
		"{s:s, s:s, s:s, s:s, s:s}", "space", "right-handed, +y up, world units of the scene", "view",
		"x right, y up, looking along -back; pixel centres at +1/2, rows from the top", "faces",
		"+X -X +Y -Y +Z -Z, rows from the top", "depth",
		"binary32 bits in the upper half of a 64-bit key, index in the lower; eye and face.*: axial depth, "
		"splat.*: distance",
		"matrices", "none: views are stored as axes");
}

json_t *ts_trace_describe(const ts_trace_description *about)
{
	static const ts_buffer_id scene[] = {TS_B_scene_vertex, TS_B_scene_triangle, TS_B_scene_material, TS_B_scene_slot,
	                                     TS_B_scene_image,  TS_B_scene_texel,    TS_B_scene_light,    TS_B_scene_object,
	                                     TS_B_scene_surfel, TS_B_scene_stand,    TS_B_scene_path,     TS_B_scene_motion,
	                                     TS_B_scene_info,   TS_N_BUFFERS};
	const ts_pipeline *p = about->pipeline;
	const char *order = about->run->arrival ? "arrival" : "canonical";
	return json_pack("{s:s, s:i, s:i, s:s, s:s, s:s, s:s, s:{s:o, s:o}, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}",
	                 "format", "touchstone-trace", "version", about->version, "contract", TS_CONTRACT_VERSION, "order",
	                 order, "pipeline", p->name, "effect", p->effect->name, "paper", p->paper, "scene", "name",
	                 ts_text_json(about->run->scene->name), "sha256", chain(about, scene), "producer",
	                 ts_producer(about->run), "arithmetic", ts_arithmetic(about->run), "conventions", conventions(),
	                 "params", ts_trace_params(&about->run->params), "plan", plan_of(&about->run->plan), "stages",
	                 stages_of(about), "buffers", buffers_of(about), "records", records(), "counters",
	                 counters_of(about->run));
}

ts_status ts_trace_write_json(const char *path, json_t *root)
{
	ts_file_text text;
	ts_status status = ts_file_text_begin(&text, path);
	if (status == TS_OK) {
		bool whole = json_dumpf(root, text.out, JSON_INDENT(1) | JSON_REAL_PRECISION(9)) == 0;
		whole &= fputc('\n', text.out) != EOF;
		status = ts_file_text_write(&text, path);
		if (!whole) status = ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
	}
	json_decref(root);
	return status;
}
