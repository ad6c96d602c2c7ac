/* Backends of devices through their functions: where memory is, work groups, offsets, prefix sums, whole pipelines. */
#include "tests/backends/device.h"
#include "backends/kernels.h"
#include "methods/pipeline.h"
#include "scene/sources.h"
#include "tests/kernels/points/mesh.h"
#include "trace/emitted/sums.h"

enum { MOST = 6000, GROUPS = 5 };
static const u32 groups[GROUPS] = {1, 32, 64, 256, 0};

/* Calls a test with each kind of memory of each kind of device. */
static void (*memory_test)(ts_backend *backend);
static void with_both(const ts_backend_kind *kind)
{
	for (u32 copies = 0; copies < (kind == &ts_cuda_kind ? 1 : 2); copies++) {
		ts_backend *backend = device_open(kind, (ts_backend_options){.work_group = 64, .copies = copies != 0});
		n_random = 0;
		memory_test(backend);
		backend->close(backend);
	}
}

static void with_memories(void (*test)(ts_backend *backend))
{
	memory_test = test;
	device_each(with_both);
}

/* And with work groups of every size. */
static void (*group_test)(ts_backend *backend);
static void with_all(const ts_backend_kind *kind)
{
	n_random = 0;
	for (u32 run = 0; run < 2 * GROUPS; run++) {
		ts_backend_options options = {.work_group = groups[run / 2], .copies = run % 2 != 0};
		if (options.work_group == 1 && kind == &ts_vulkan_kind) continue; /* groups are whole vectors */
		if (options.copies && kind == &ts_cuda_kind) continue;            /* always copies */
		ts_backend *backend = device_open(kind, options);
		group_test(backend);
		assert_int_equal(backend->finish(backend), TS_OK);
		backend->close(backend);
	}
}

static void with_groups(void (*test)(ts_backend *backend))
{
	group_test = test;
	device_each(with_all);
}

static void fill(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u8 byte)
{
	assert_int_equal(backend->fill(backend, frame, id, byte), TS_OK);
}

/* Pieces to cull, in a frame; the answer of the C kernel. */
typedef struct {
	ts_frame frame;
	u32 expected[MOST];
} pieces;

static pieces *make_pieces(void)
{
	pieces *p = mesh_alloc(1, sizeof *p);
	memset(p, 0, sizeof *p);
	ts_piece *piece = ts_frame_make1(&p->frame, TS_B_split_piece, MOST);
	f32 *scale = ts_frame_make1(&p->frame, TS_B_split_density, MOST);
	assert_non_null(ts_frame_make1(&p->frame, TS_B_cull_keep, MOST));
	for (u32 i = 0; i < MOST; i++) {
		piece[i] = (ts_piece){.b = {uniform(0, 0.5f)}, .c = {0, 1}, .triangle = i, .path = 1};
		scale[i] = random_bits() % 8 == 0 ? 0 : 1;
	}
	ts_cull_args args = {.pieces = piece, .scale = scale, .keep = p->expected, .unit = 1, .enabled = 1};
	for (u32 i = 0; i < MOST; i++) ts_k_cull_item(&args, i);
	return p;
}

static void free_pieces(pieces *p)
{
	ts_frame_clear(&p->frame);
	free(p);
}

/* Into the frame's buffer, or into memory that is lent. */
static const ts_launch into_buffer = TS_LAUNCH(cull, TS_ALL);
static const ts_launch into_lent = TS_LAUNCH(cull, TS_WORK(keep, other));

/* Culls n pieces from `first` on, and writes from `keep` on. */
static void cull(ts_backend *backend, const ts_launch *launch, pieces *p, u32 first, u32 *keep, u64 n)
{
	ts_cull_args args = {.pieces = (ts_piece *)ts_frame_handle(&p->frame, TS_B_split_piece) + first,
	                     .scale = (f32 *)ts_frame_handle(&p->frame, TS_B_split_density) + first,
	                     .keep = keep,
	                     .unit = 1,
	                     .enabled = 1};
	/* The chance is of the piece's own number, so an offset shows. */
	assert_int_equal(backend->launch(backend, &p->frame, launch, &args, n), TS_OK);
}

/* n items of each kind and no other, wherever in their buffers they start. */
static void launch(ts_backend *backend, pieces *p, u32 first, u32 to, u32 n)
{
	fill(backend, &p->frame, TS_B_cull_keep, 0xee);
	cull(backend, &into_buffer, p, first, (u32 *)ts_frame_handle(&p->frame, TS_B_cull_keep) + to, n);
	const u32 *keep = ts_frame_data(&p->frame, TS_B_cull_keep);
	for (u32 i = 0; i < to; i++) assert_int_equal(keep[i], 0xeeeeeeee);
	assert_memory_equal(keep + to, p->expected + first, n * sizeof *keep);
	for (u32 i = to + n; i < MOST; i++) assert_int_equal(keep[i], 0xeeeeeeee);
	assert_int_equal(backend->finish(backend), TS_OK);
}

static void launches(ts_backend *backend)
{
	pieces *p = make_pieces();
	const u32 sizes[] = {0, 1, 2, 31, 32, 33, 63, 64, 65, 255, 257, 1000, MOST};
	for (u32 i = 0; i < sizeof sizes / sizeof *sizes; i++) {
		u32 room = MOST - sizes[i] + 1;
		launch(backend, p, 0, 0, sizes[i]);
		launch(backend, p, random_bits() % room, random_bits() % room, sizes[i]);
	}
	free_pieces(p);
}

static void a_launch_runs_each_item_once(void **state)
{
	(void)state;
	with_groups(launches);
}

/* What the host last wrote or the device last wrote, whoever looks. */
static void lend(ts_backend *backend)
{
	static u32 own[MOST + 2];
	pieces *p = make_pieces();
	for (u32 run = 0; run < 4; run++) {
		memset(own, 0x11 + (int)run, sizeof own);
		ts_frame_lend(&p->frame, TS_WORK_other, own, sizeof own);
		cull(backend, &into_lent, p, run, own + 1, MOST - run);
		assert_int_equal(ts_frame_recall(&p->frame, TS_WORK_other), TS_OK);
		assert_memory_equal(own + 1, p->expected + run, (MOST - run) * sizeof *own);
		assert_int_equal(own[0], 0x11111111 + run * 0x01010101);
		assert_int_equal(own[MOST + 1], 0x11111111 + run * 0x01010101);
	}
	assert_int_equal(ts_frame_recall(&p->frame, TS_WORK_other), TS_OK);
	ts_frame_lend(&p->frame, TS_WORK_other, own, sizeof own);
	cull(backend, &into_lent, p, 0, own, MOST);
	free_pieces(p); /* while the device may be at work on it */
	assert_int_equal(backend->finish(backend), TS_OK);
}

static void lent_memory_has_what_was_last_written(void **state)
{
	(void)state;
	with_memories(lend);
}

/* A buffer that both sides look at in turn, that is cut, dropped and made again. */
static void in_turn(ts_backend *backend)
{
	pieces *p = make_pieces();
	for (u32 run = 0; run < 20; run++) {
		u32 n = 1 + random_bits() % MOST;
		assert_non_null(ts_frame_make1(&p->frame, TS_B_cull_keep, MOST));
		for (u32 pass = 0; pass < 3; pass++) {
			fill(backend, &p->frame, TS_B_cull_keep, (u8)(run + pass));
			if (pass != 1) assert_int_equal(*(u8 *)ts_frame_data(&p->frame, TS_B_cull_keep), run + pass);
			cull(backend, &into_buffer, p, 0, ts_frame_handle(&p->frame, TS_B_cull_keep), n);
			const u32 *keep = ts_frame_data(&p->frame, TS_B_cull_keep);
			assert_memory_equal(keep, p->expected, n * sizeof *keep);
			assert_true(n == MOST || keep[n] == (run + pass) * 0x01010101);
		}
		ts_frame_cut(&p->frame, TS_B_cull_keep, n / 2);
		fill(backend, &p->frame, TS_B_cull_keep, 0x77);
		const u32 *keep = ts_frame_data(&p->frame, TS_B_cull_keep);
		for (u32 i = 0; i < n / 2; i++) assert_int_equal(keep[i], 0x77777777);
		assert_int_equal(keep[n / 2], p->expected[n / 2]);
	}
	free_pieces(p);
}

static void both_sides_may_write_in_turn(void **state)
{
	(void)state;
	with_memories(in_turn);
}

/* Of bytes, whatever their number. */
static void fills(ts_backend *backend)
{
	for (u32 n = 0; n < 300; n++) {
		ts_frame frame = {.bytes = 0};
		u64 size = n < 40 ? n : n * 31;
		assert_non_null(ts_frame_make1(&frame, TS_B_splat_tie, size));
		fill(backend, &frame, TS_B_splat_tie, 0x5a);
		if (n % 2 != 0) ts_frame_data(&frame, TS_B_splat_tie);
		fill(backend, &frame, TS_B_splat_tie, (u8)(n + 128));
		const u8 *bytes = ts_frame_data(&frame, TS_B_splat_tie);
		for (u64 i = 0; i < size; i++) assert_int_equal(bytes[i], (u8)(n + 128));
		assert_int_equal(backend->finish(backend), TS_OK);
		ts_frame_clear(&frame);
	}
}

static void filling_sets_every_byte(void **state)
{
	(void)state;
	with_memories(fills);
}

/* Prefix sums against their definition, of counts below `range`. */
static void scan(ts_backend *backend, u32 n, u32 range)
{
	static u32 before[MOST];
	ts_frame frame = {.bytes = 0};
	u32 *counts = ts_frame_make1(&frame, TS_B_points_offset, n + 1);
	u64 total = 1, sum = 0;
	for (u32 i = 0; i < n; i++) counts[i] = before[i] = random_bits() % range;
	counts[n] = 0xeeeeeeee;
	assert_int_equal(backend->scan(backend, &frame, TS_B_points_offset, &total), TS_OK);
	counts = ts_frame_data(&frame, TS_B_points_offset);
	for (u32 i = 0; i < n; i++) {
		assert_int_equal(counts[i], (u32)sum);
		sum += before[i];
	}
	assert_true(total == sum && counts[n] == (u32)sum);
	ts_frame_clear(&frame);
}

static void scans(ts_backend *backend)
{
	static const u32 sizes[] = {0, 1, 2, 63, 64, 65, 2047, 2048, 2049, 4095, 4096, 4097, MOST};
	for (u32 i = 0; i < sizeof sizes / sizeof *sizes; i++) {
		for (u32 range = 1; range != 0; range *= 0x10000) scan(backend, sizes[i], range);
		scan(backend, sizes[i], 0xffffffff);
	}
	for (u32 i = 0; i < 30; i++) scan(backend, random_bits() % MOST, i % 2 != 0 ? 9 : 0xffffffff);
}

static void device_sums_follow_their_definition(void **state)
{
	(void)state;
	with_groups(scans);
}

/* What is run: with mirrors and without, where buffers of points and pixels are empty; depth maps of every
 * projection and cubes, made from stored points and on the spot, in batches that do not come out even. */
static const struct {
	const char *effect, *method;
	u32 reflectors;
	const char *set[3][2];
} runs[] = {
	{"reflections", "epr", 2, {{"seed", "0"}}},
	{"reflections", "mvr", 2, {{"seed", "0"}}},
	{"reflections", "epr", 0, {{"seed", "0"}}},
	{"reflections", "epr-bufferless", 2, {{"lookup.bounces", "3"}, {"points.conservative", "off"}}},
	{"reflections", "epr-bufferless", 0, {{"seed", "0"}}},
	{"reflections", "epr-forward", 2, {{"lookup.samples", "adaptive"}}},
	{"reflections", "epr-forward", 0, {{"forward.viewer", "eye"}}},
	{"reflections", "mvr", 0, {{"seed", "0"}}},
	{"reflections", "ivir", 2, {{"density.rate", "watertight"}}},
	{"reflections", "ivir", 0, {{"density.rate", "watertight"}}},
	{"reflections", "ivir", 2, {{"scatter.at", "centre"}, {"points.buffered", "off"}}},
	{"reflections", "vir", 2, {{"points.buffered", "off"}, {"points.snap", "off"}, {"points.conservative", "off"}}},
	{"reflections", "epr", 2, {{"eye.samples", "4"}}},
	{"soft-shadows", "mvr", 0, {{"eye.samples", "4"}, {"lamp.source", "scene"}}},
	{"soft-shadows", "ivir", 0, {{"lamp.source", "scene"}, {"density.rate", "watertight"}}},
	{"soft-shadows", "ivir", 2, {{"lamp.source", "lamp"}, {"points.buffered", "on"}, {"density.rate", "exact"}}},
	{"soft-shadows", "vir", 0, {{"lamp.source", "scene"}, {"visibility.test", "vertex"}}},
	{"soft-shadows", "ivir", 0, {{"lamp.source", "scene"}, {"scatter.at", "centre"}}},
	{"soft-shadows", "mvr", 0, {{"lamp.source", "scene"}}},
	{"omni-shadows", "ivir", 0, {{"density.rate", "paper"}}},
	{"omni-shadows", "epr", 0, {{"shadow_splat.rate", "paper"}}},
	{"soft-shadows", "pcss", 0, {{"lamp.source", "scene"}}},
	{"omni-shadows", "vir", 2, {{"points.buffered", "on"}}},
	{"omni-shadows", "mvr", 0, {{"depth_map.bias", "0"}}},
	{"indirect", "hulls", 0, {{"lamp.source", "scene"}, {"hull.cosine", "ours"}, {"segment.method", "sweeps"}}},
	{"indirect",
     "hulls",
     2,
     {{"segment.method", "components"}, {"hull.sharpness", "vmf"}, {"hull.interpolation", "moments"}}},
	{"indirect", "hulls", 0, {{"hull.cosine", "quadrature"}, {"hull.surface", "paper"}, {"hull.integrals", "printed"}}},
	{"indirect", "hulls", 0, {{"corner.facing", "paper"}, {"hull.corners", "rectangle"}}},
	{"indirect", "hulls", 0, {{"eye.samples", "4"}, {"gloss.lobe", "on"}}},
	{"indirect", "direct", 0, {{"lamp.source", "lamp"}}},
	{"area-light", "hulls", 0, {{"lamp.radius", "0.2"}}},
	{"area-light", "direct", 0, {{"lamp.radius", "0.1"}, {"lamp.source", "scene"}}},
	{"area-light", "hulls", 0, {{"lamp.radius", "0"}, {"lamp.source", "scene"}}},
	{"area-light", "direct", 0, {{"lamp.radius", "0"}}},
	{"indirect", "megaviews", 0, {{"vpl.paths", "90"}, {"traverse.queue_mb", "1"}, {"bilateral.px", "3"}}},
	{"indirect",
     "megaviews",
     2,
     {{"vpl_gather.lights", "0"}, {"vpl_gather.cutoff", "5"}, {"view_map.multipixel", "mips"}}},
	{"indirect", "manylods", 0, {{"vpl.paths", "90"}, {"view_map.fusion", "paper"}, {"vpl_gather.shadows", "off"}}},
	{"indirect", "bruteforce", 0, {{"vpl.paths", "40"}, {"view_map.multipixel", "texels"}, {"view_map.apart", "0"}}},
	{"particles", "megaviews", 0, {{"particle.count", "200"}, {"traverse.queue_mb", "1"}}},
	{"particles", "manylods", 0, {{"particle.count", "90"}, {"vpl_gather.cutoff", "5"}}},
	{"particles", "megaviews", 0, {{"particle.count", "90"}, {"eye.samples", "4"}, {"bilateral.px", "3"}}},
	{"surfels",
     "deferred",
     0,
     {{"surfels.from_mesh", "3000"}, {"deferred.shader", "phong_shadow"}, {"depth_map.px", "64"}}},
	{"surfels", "ewa", 0, {{"surfels.from_mesh", "3000"}, {"deferred.shader", "npr"}}},
	{"surfels", "deferred", 0, {{"surfels.from_mesh", "3000"}, {"surfel_blend.accumulation", "half"}}},
	{"surfels", "deferred", 0, {{"surfels.from_mesh", "3000"}, {"surfel_blend.accumulation", "8bit"}}},
	{"surfels", "ewa", 0, {{"surfels.from_mesh", "3000"}, {"surfel_blend.accumulation", "float32"}}},
};
enum { N_RUNS = sizeof runs / sizeof *runs };

static ts_params params_of(u32 run)
{
	ts_params params;
	ts_params_default(&params);
	params.width = 48;
	params.height = 32;
	params.reflectors_count = runs[run].reflectors;
	params.reflectors_px = 16;
	params.cube_max_px = 16;
	params.lamp_views = 7;
	params.lamp_cubes = 3;
	params.lamp_views_a_pass = 2;
	params.depth_map_px = 24;
	params.rsm_px = 6;
	params.depth_grid_px = 64;
	params.octree_levels = 4;
	for (u32 i = 0; i < 3 && runs[run].set[i][0] != NULL; i++) {
		assert_int_equal(ts_params_set(&params, runs[run].set[i][0], runs[run].set[i][1]), TS_OK);
	}
	return params;
}

/* One more, all around: in the middle of the box. */
static void add_bulb(ts_scene *scene)
{
	ts_light *lights = realloc(scene->lights, (scene->n_lights + 1) * sizeof *lights);
	assert_non_null(lights);
	ts_v3 sum = ts_add(ts_load3(scene->info.box_min), ts_load3(scene->info.box_max));
	lights[scene->n_lights] = (ts_light){.kind = TS_LIGHT_KIND_POINT, .intensity = {3, 3, 3}};
	ts_store3(lights[scene->n_lights++].position, ts_scale(sum, 0.5f));
	scene->lights = lights;
}

/* The digests of a run; NULL: by the C backend. */
static void digests(ts_sums *sums, u32 run, ts_backend *backend)
{
	static ts_scene *scenes[3];
	ts_params params = params_of(run);
	const ts_how how = {.threads = 2, .backend = backend};
	ts_scene **scene = &scenes[params.surfels_from_mesh > 0 ? 2 : params.reflectors_count != 0];
	if (*scene == NULL) {
		assert_int_equal(ts_builtin_open(scene, "dining:triangles=10000:texels=32", &params, NULL), TS_OK);
		if (params.surfels_from_mesh > 0) add_bulb(*scene);
	}
	ts_status status = ts_sums_of(sums, ts_pipeline_find(runs[run].effect, runs[run].method), *scene, &params, &how);
	if (status != TS_OK) fail_msg("%s", ts_error_message());
}

/* Whole pipelines with memory of either kind. */
static void pipelines(ts_backend *backend)
{
	static ts_sums expected[N_RUNS], found;
	for (u32 run = 0; run < N_RUNS; run++) {
		if (expected[run].hex[TS_B_image_srgb][0] == 0) digests(&expected[run], run, NULL);
		digests(&found, run, backend);
		for (u32 id = 0; id < TS_N_BUFFERS; id++) assert_string_equal(found.hex[id], expected[run].hex[id]);
		assert_int_equal(strlen(found.hex[TS_B_image_srgb]), 64);
	}
}

static void whole_pipelines_have_the_bits_of_c(void **state)
{
	(void)state;
	with_memories(pipelines);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_launch_runs_each_item_once),        cmocka_unit_test(lent_memory_has_what_was_last_written),
		cmocka_unit_test(both_sides_may_write_in_turn),        cmocka_unit_test(filling_sets_every_byte),
		cmocka_unit_test(device_sums_follow_their_definition), cmocka_unit_test(whole_pipelines_have_the_bits_of_c),
	};
	device_begin();
	return cmocka_run_group_tests(tests, NULL, NULL);
}
