/* Goldens that are computed; and degenerate triangles, in every method: no stage stores a number that none may have,
 * and the fast paths store what the kernels do. */
#include <math.h>
#include "golden/golden.h"
#include "kernels/base/scene.h"
#include "scene/sources.h"
#include "scene/surfel.h"
#include "tests/kernels/seeded.h"
#include "tests/methods/small.h"
#include "tests/model/test.h"
#include "tests/status.h"
#include "tests/whole.h"

static ts_golden golden;

static void compute(bool finite)
{
	ts_params params;
	ts_scene *scene;
	ts_params_default(&params);
	params.width = 24;
	params.height = 16;
	params.reflectors_count = 1;
	params.reflectors_px = 12;
	params.cube_max_px = 16;
	if (ts_scene_load(&scene, "scenes/triangle.gltf", &params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	if (!finite) scene->materials[0].emissive[0] = scene->materials[0].emissive[2] = INFINITY;
	const ts_golden_job job = {ts_pipeline_find("reflections", "mvr"), scene, &params, {.threads = 1}};
	if (ts_golden_compute(&golden, &job) != TS_OK) fail_msg("%s", ts_error_message());
	ts_scene_free(scene);
}

/* Floats that are not finite in what is kept. */
static u64 count_kept(void)
{
	u64 n = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_golden_file *file = &golden.file[id];
		assert_int_equal(file->data != NULL, golden.bytes[id] != 0);
		if (file->data == NULL) continue;
		const size_t at = file->npy.data_at;
		assert_int_equal(file->taken, file->bytes);
		assert_int_equal(file->bytes, at + file->npy.n * ts_buffer_table[id].element_bytes);
		n += ts_golden_strays((ts_buffer_id)id, file->data + at, file->bytes - at);
	}
	return n;
}

static void a_finite_golden_has_no_strays(void **state)
{
	(void)state;
	u32 width, height;
	compute(true);
	assert_true(count_kept() == 0 && golden.n_strays == 0 && golden.stray == TS_N_BUFFERS);
	assert_ptr_equal(ts_golden_image(&golden, &width, &height), golden.file[TS_B_image_srgb].data + 128);
	assert_true(width == 24 && height == 16);
	ts_golden_free(&golden);
}

static void infinite_floats_are_counted(void **state)
{
	(void)state;
	compute(false);
	const u64 n = count_kept();
	assert_true(n > 1 && golden.n_strays == n);
	assert_int_equal(golden.stray, TS_B_scene_material);
	ts_golden_free(&golden);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) assert_null(golden.file[id].data);
}

/* ---- triangles without area, too small, too large, in one plane, about the eye, on a lattice, near 0 ---- */

static ts_v3 near_to(ts_v3 p, f32 e) { return ts_add(p, uniform3(-e, e)); }

static void sliver(ts_v3 p[3])
{
	p[0] = uniform3(-4, 4);
	p[1] = uniform3(-4, 4);
	p[2] = near_to(ts_mad(p[0], ts_sub(p[1], p[0]), uniform(0, 1)), ldexpf(1, -(int)below(24)));
}

static void tiny(ts_v3 p[3])
{
	f32 e = ldexpf(1, -(int)below(24));
	p[0] = uniform3(-4, 4);
	p[1] = near_to(p[0], e);
	p[2] = near_to(p[0], e);
}

static void huge(ts_v3 p[3])
{
	f32 size = ldexpf(1, (int)below(24));
	for (u32 k = 0; k < 3; k++) p[k] = uniform3(-size, size);
}

/* A half of a square: edges whose ends are as far behind the eye as before it. */
static void ground(ts_v3 p[3])
{
	f32 size = ldexpf(1, 16 + (int)below(8)), side = below(2) == 0 ? size : -size;
	p[0] = ts_v3_make(-side, 0, side);
	p[1] = ts_v3_make(side, 0, side);
	p[2] = ts_v3_make(side, 0, -side);
}

static void coplanar(ts_v3 p[3])
{
	f32 y = below(3) == 0 ? 0.0625f : 0.0f;
	for (u32 k = 0; k < 3; k++) {
		f32 x = (f32)below(33) * 0.5f - 8;
		p[k] = ts_v3_make(x, y, (f32)below(33) * 0.5f - 8);
	}
}

static void around(ts_v3 p[3])
{
	p[0] = uniform3(-0.25f, 0.25f);
	p[1] = uniform3(-60, 60);
	p[2] = uniform3(-60, 60);
}

static void lattice(ts_v3 p[3])
{
	for (u32 k = 0; k < 3; k++) {
		f32 x = (f32)below(33) * 0.125f - 2, y = (f32)below(33) * 0.125f - 2;
		p[k] = ts_v3_make(x, y, (f32)below(33) * 0.125f - 2);
	}
}

static void small_numbers(ts_v3 p[3])
{
	f32 size = ldexpf(1, -(int)below(40));
	p[0] = uniform3(-size, size);
	p[1] = uniform3(-size, size);
	p[2] = uniform3(-2, 2);
}

static void (*const kinds[])(ts_v3 p[3]) = {sliver, tiny, huge, ground, coplanar, around, lattice, small_numbers};
enum { N_KINDS = sizeof kinds / sizeof *kinds };

/* ---- scenes ---- */

static void add_triangle(ts_build *build, u32 kind)
{
	ts_v3 p[3];
	u32 v[3];
	kinds[kind < N_KINDS ? kind : below(N_KINDS)](p);
	for (u32 k = 0; k < 3; k++) {
		ts_vertex vertex = {.colour = {1, 1, 1, 1}};
		ts_store3(vertex.position, p[k]);
		v[k] = ts_build_vertex(build, &vertex);
	}
	ts_build_triangle(build, v[0], v[1], v[2], 0);
	ts_surfel surfel = {.colour = {0.5f, 0.5f, 0.5f}};
	ts_store3(surfel.centre, p[0]);
	f32 normal[3], radius = ts_clamp(ts_length(ts_sub(p[1], p[0])), 0x1p-24f, 0x1p20f);
	ts_store3(normal, direction());
	ts_surfel_circle(&surfel, normal, radius);
	ts_build_surfel(build, &surfel);
}

static void add_lights(ts_build *build)
{
	for (u32 i = 0; i < 3; i++) {
		ts_light light = {.kind = i, .intensity = {1, 0.5f, 2}, .spot_scale = 2, .spot_offset = -1};
		ts_store3(light.position, uniform3(-4, 4));
		ts_store3(light.direction, direction());
		ts_build_light(build, &light);
	}
}

/* One kind of triangles, or all. */
static ts_scene *soup(const ts_params *params, u32 kind)
{
	static const u32 counts[] = {1, 2, 7, 33, 150};
	ts_build *build = ts_build_new("soup");
	ts_material material = ts_material_default();
	f32 radius = ldexpf(1, -(int)below(8));
	const f32 mirror[1][4] = {{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), radius}};
	ts_scene *scene = NULL;
	assert_non_null(build);
	material.flags = below(2) == 0 ? TS_DOUBLE_SIDED : 0;
	ts_build_material(build, &material);
	u32 n = counts[below(whole_or(5, 3))];
	for (u32 i = 0; i < n; i++) add_triangle(build, kind);
	add_lights(build);
	ts_reflectors_stand(build, mirror, 1);
	require(ts_build_finish(build, params, NULL, &scene));
	return scene;
}

/* ---- runs ---- */

static ts_params params_of(void)
{
	ts_params params = small_params_of_all();
	params.width = 48;
	params.height = 27;
	params.reflectors_count = 0;
	return params;
}

static void judge(const ts_scene *scene, const ts_params *params, const ts_pipeline *method)
{
	static ts_golden kernels, fast;
	ts_golden_job job = {method, scene, params, {.threads = 1, .no_fast_paths = true}};
	require(ts_golden_compute(&kernels, &job));
	if (kernels.n_strays != 0)
		fail_msg("%s: %u strays, the first in %s", method->name, (u32)kernels.n_strays,
		         ts_buffer_table[kernels.stray].name);
	job.how = (ts_how){.threads = 2};
	require(ts_golden_compute(&fast, &job));
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (strcmp(kernels.sums.hex[id], fast.sums.hex[id]) != 0)
			fail_msg("%s: %s: the fast path differs", method->name, ts_buffer_table[id].name);
	}
	ts_golden_free(&kernels);
	ts_golden_free(&fast);
}

static void degenerate_triangles_leave_no_strays(void **state)
{
	(void)state;
	u32 n = whole_or(200, N_KINDS + 1);
	ts_params params = params_of();
	for (u32 i = 0; i < n; i++) {
		ts_scene *scene = soup(&params, i % (N_KINDS + 1));
		for (const ts_pipeline *const *m = ts_pipelines(); *m != NULL; m++) judge(scene, &params, *m);
		ts_scene_free(scene);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_finite_golden_has_no_strays),
		cmocka_unit_test(infinite_floats_are_counted),
		seeded_test(degenerate_triangles_leave_no_strays),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
