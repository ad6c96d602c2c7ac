/* Launches of stages: they name what their kernels have; filling makes what they write by its shape, once a stage or
 * once for all batches, and leaves what they do not bind NULL. One that fails ends the method. */
#include "kernels/points/mirror.h"
#include "kernels/points/splat.h"
#include "tests/methods/small.h"
#include "tests/whole.h"

static void launches_bind_only_known_members(void **state)
{
	(void)state;
	for (const ts_stage *const *s = ts_stages(); *s != NULL; s++) {
		for (u32 i = 0; (*s)->launches != NULL && (*s)->launches[i] != NULL; i++) {
			const ts_launch *launch = (*s)->launches[i];
			for (const ts_bind *b = launch->bind; b->how != TS_BINDS_END; b++) {
				if (!ts_launch_knows(launch, b->name)) fail_msg("%s: %s", (*s)->name, b->name);
			}
		}
	}
}

static void every_bound_pointer_has_a_buffer(void **state)
{
	(void)state;
	for (const ts_stage *const *s = ts_stages(); *s != NULL; s++) {
		for (u32 i = 0; (*s)->launches != NULL && (*s)->launches[i] != NULL; i++) {
			const ts_pointers *p = ts_kernel_pointers((*s)->launches[i]->kernel);
			for (u32 k = 0; k < p->n; k++) {
				const ts_bound b = ts_launch_bound((*s)->launches[i], &p->pointer[k]);
				bool of_buffer = b.role <= TS_ROLE_SUM;
				if (b.bound && of_buffer && b.to >= TS_N_BUFFERS) fail_msg("%s: %s", (*s)->name, p->pointer[k].name);
				if (b.bound && b.role == TS_ROLE_TALLY) assert_true(b.to < TS_TALLIES);
			}
		}
	}
}

/* A run with the sizes and inputs of splats, and nothing in them. */
static void begin(ts_run *run, const ts_scene *scene, const ts_params *params)
{
	static const ts_dim sizes[] = {TS_DIM_pieces, TS_DIM_points, TS_DIM_cubes, TS_DIM_views, TS_DIM_mirror_pixels};
	ts_run_begin(run, scene, params, 1);
	for (u32 i = 0; i < sizeof sizes / sizeof *sizes; i++) ts_run_set_size(run, sizes[i], 2);
	assert_non_null(ts_run_make(run, TS_B_split_piece));
	assert_non_null(ts_run_make(run, TS_B_align_frame));
	assert_non_null(ts_run_make(run, TS_B_visibility_bits));
	assert_non_null(ts_run_make(run, TS_B_points_record));
	ts_face *cubes = ts_run_make(run, TS_B_cube_size_face);
	for (u32 i = 0; i < 2; i++) cubes[i] = (ts_face){.n = 4 + i, .offset = i * 96};
	run->plan.units = run->n_units = 2;
}

static void filling_makes_buffers_once_by_their_shape(void **state)
{
	(void)state;
	static const ts_launch launch =
		TS_LAUNCH(splat, TS_BUT(from.scene), TS_IN(from.points, points_record), TS_WITH(tie), TS_BUT(bits));
	ts_params params = small_params(32, 16);
	ts_scene *scene = small_scene(&params);
	ts_run run;
	begin(&run, scene, &params);
	ts_splat_args args;
	memset(&args, 0x55, sizeof args);
	assert_int_equal(TS_FILL(&run, &launch, &args), TS_OK);
	assert_ptr_equal(args.cubes, run.frame.buffer[TS_B_cube_size_face].data);
	assert_ptr_equal(args.from.points, run.frame.buffer[TS_B_points_record].data);
	assert_true(args.bits == NULL && args.from.offset == NULL);
	assert_true(args.n_cubes == 0x55555555u);
	assert_true(args.n_writes == args.n_scatters + 1 && *args.n_writes == 0);
	assert_int_equal(ts_frame_n(&run.frame, TS_B_splat_tie), 6 * (16 + 25));
	for (u32 i = 0; i < 6 * (16 + 25); i++) assert_true(args.texels[i] == TS_EMPTY && args.tie[i] == 0);
	const u64 *texels = args.texels;
	assert_int_equal(TS_FILL(&run, &launch, &args), TS_OK);
	assert_ptr_equal(args.texels, texels);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* Of batches: what the batch is of is made anew, the rest once. */
static void each_batch_makes_its_own_anew(void **state)
{
	(void)state;
	static const ts_launch splats = TS_LAUNCH(splat, TS_BUT(from.scene));
	static const ts_launch marks = TS_LAUNCH(mirror, TS_BUT(view), TS_BUT(pixels), TS_BUT(mip));
	ts_params params = small_params(32, 16);
	ts_scene *scene = small_scene(&params);
	ts_run run;
	begin(&run, scene, &params);
	ts_splat_args splat;
	ts_mirror_args mirror;
	const f32 *radiance = NULL;
	for (run.first_unit = 0, run.n_units = 1; run.first_unit < 2; run.first_unit++) {
		memset(run.made, 0, sizeof run.made);
		assert_int_equal(TS_FILL(&run, &splats, &splat), TS_OK);
		assert_int_equal(TS_FILL(&run, &marks, &mirror), TS_OK);
		u32 side = 4 + run.first_unit;
		assert_int_equal(ts_frame_n(&run.frame, TS_B_splat_depth_index), 6 * side * side);
		if (run.first_unit > 0) assert_ptr_equal(mirror.radiance, radiance);
		radiance = mirror.radiance;
	}
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* A size that nobody counted is refused, and named. */
static void a_size_that_nobody_counted_is_refused(void **state)
{
	(void)state;
	ts_params params = small_params(32, 16);
	ts_scene *scene = small_scene(&params);
	ts_run run;
	ts_run_begin(&run, scene, &params, 1);
	assert_null(ts_run_make(&run, TS_B_align_frame));
	assert_non_null(strstr(ts_error_message(), "align.frame"));
	assert_non_null(strstr(ts_error_message(), "pieces"));
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* ---- a backend in C of which one call fails ---- */

typedef struct {
	ts_backend backend;
	ts_c_backend c;
	u32 n, failing; /* calls so far, and the one that fails */
} faulty;

static ts_status call(faulty *f) { return f->n++ == f->failing ? ts_fail("planted") : TS_OK; }

static ts_status faulty_launch(ts_backend *b, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	faulty *f = (faulty *)b;
	return call(f) == TS_OK ? f->c.backend.launch(&f->c.backend, frame, launch, args, n) : TS_ERROR;
}

static ts_status faulty_fill(ts_backend *b, ts_frame *frame, ts_buffer_id id, u8 byte)
{
	faulty *f = (faulty *)b;
	return call(f) == TS_OK ? f->c.backend.fill(&f->c.backend, frame, id, byte) : TS_ERROR;
}

static ts_status faulty_scan(ts_backend *b, ts_frame *frame, ts_buffer_id id, u64 *total)
{
	faulty *f = (faulty *)b;
	return call(f) == TS_OK ? f->c.backend.scan(&f->c.backend, frame, id, total) : TS_ERROR;
}

static ts_status run_faulty(const ts_pipeline *method, const ts_scene *scene, const ts_params *params, u32 failing,
                            u32 *n)
{
	ts_run run;
	faulty f = {.failing = failing};
	ts_run_begin(&run, scene, params, 1);
	ts_c_begin(&f.c, 1);
	f.backend = f.c.backend;
	f.backend.launch = faulty_launch;
	f.backend.fill = faulty_fill;
	f.backend.scan = faulty_scan;
	f.backend.at_once = NULL;
	run.backend = &f.backend;
	ts_status status = ts_pipeline_run(method, &run);
	ts_run_end(&run);
	*n = f.n;
	return status;
}

/* A call of the backend that fails ends the method at once, whichever it is. */
static void a_failed_call_ends_the_method(void **state)
{
	(void)state;
	enum { FEW = 24 };
	ts_scene *scene = NULL;
	ts_params params = small_params_of_all();
	for (const ts_pipeline *const *m = ts_pipelines(); *m != NULL; m++) {
		u32 n, done;
		small_scene_of(&scene, *m, &params);
		if (run_faulty(*m, scene, &params, UINT32_MAX, &n) != TS_OK) fail_msg("%s: %s", (*m)->name, ts_error_message());
		assert_true(n > 5);
		for (u32 at = 0; at < n; at += whole_or(1, 1 + n / FEW)) {
			if (run_faulty(*m, scene, &params, at, &done) == TS_OK)
				fail_msg("%s: call %u fails, the method does not", (*m)->name, at);
			if (done != at + 1) fail_msg("%s: call %u fails, and %u more follow", (*m)->name, at, done - at - 1);
			assert_non_null(strstr(ts_error_message(), "planted"));
		}
	}
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest launch[] = {
		cmocka_unit_test(launches_bind_only_known_members),          cmocka_unit_test(every_bound_pointer_has_a_buffer),
		cmocka_unit_test(filling_makes_buffers_once_by_their_shape), cmocka_unit_test(each_batch_makes_its_own_anew),
		cmocka_unit_test(a_size_that_nobody_counted_is_refused),     cmocka_unit_test(a_failed_call_ends_the_method),
	};
	return cmocka_run_group_tests(launch, NULL, NULL);
}
