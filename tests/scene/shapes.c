/* The shapes of the added reflectors: closed, outward, of the right volume, their normals agreeing with their faces. */
#include "kernels/base/vec.h"
#include "scene/sources.h"
#include "tests/model/test.h"

#define RADIUS 2.5f
static const double pi = 3.14159265358979323846;

static ts_scene *shape(u32 kind)
{
	ts_params params;
	ts_params_default(&params);
	ts_build *build = ts_build_new("shape");
	assert_non_null(build);
	ts_shape_add(build, kind, RADIUS, TS_NONE);
	ts_scene *scene;
	assert_int_equal(ts_build_finish(build, &params, NULL, &scene), TS_OK);
	return scene;
}

/* The first vertex in the same place. */
static u32 *weld(const ts_scene *scene)
{
	u32 *place = malloc(scene->n_vertices * sizeof *place);
	assert_non_null(place);
	for (u32 i = 0; i < scene->n_vertices; i++) {
		for (place[i] = 0; place[i] < i; place[i]++)
			if (memcmp(scene->vertices[place[i]].position, scene->vertices[i].position, 12) == 0) break;
	}
	return place;
}

static int compare_u64(const void *a, const void *b)
{
	u64 x, y;
	memcpy(&x, a, 8);
	memcpy(&y, b, 8);
	return x < y ? -1 : x > y;
}

/* Every edge once in each direction, and vertices - edges + faces. */
static void every_shape_is_closed(void **state)
{
	(void)state;
	const int euler[4] = {2, 2, 0, 2};
	for (u32 kind = 0; kind < 4; kind++) {
		ts_scene *scene = shape(kind);
		u32 *place = weld(scene), n = 0, n_places = 0;
		u64 *edges = malloc(3 * scene->n_triangles * sizeof *edges);
		assert_non_null(edges);
		for (u32 i = 0; i < scene->n_triangles; i++)
			for (u32 k = 0; k < 3; k++) {
				u64 from = place[scene->triangles[i].vertex[k]], to = place[scene->triangles[i].vertex[(k + 1) % 3]];
				assert_true(from != to);
				edges[n++] = from << 32 | to;
			}
		qsort(edges, n, sizeof *edges, compare_u64);
		for (u32 i = 0; i < n; i++) {
			u64 back = edges[i] << 32 | edges[i] >> 32;
			assert_true(i == 0 || edges[i] != edges[i - 1]);
			assert_non_null(bsearch(&back, edges, n, sizeof *edges, compare_u64));
		}
		for (u32 i = 0; i < scene->n_vertices; i++) n_places += place[i] == i;
		assert_int_equal((int)n_places - (int)n / 2 + (int)scene->n_triangles, euler[kind]);
		assert_in_range(scene->n_triangles, 1800, 2200);
		assert_int_equal(scene->n_degenerate, 0);
		free(edges);
		free(place);
		ts_scene_free(scene);
	}
}

static ts_v3 corner(const ts_scene *scene, u32 triangle, u32 k)
{
	return ts_load3(scene->vertices[scene->triangles[triangle].vertex[k]].position);
}

/* By the divergence theorem; positive only if the faces look outwards. The vase's is that of its spline, turned: cones
 * between its points, summed by another program. */
static void every_shape_has_its_volume(void **state)
{
	(void)state;
	const double expected[4] = {4.0 / 3.0 * pi, pi * 0.36 * 1.6, 2.0 * pi * pi * 0.6875 * 0.3125 * 0.3125, 1.791};
	const double tolerance[4] = {0.02, 0.005, 0.03, 0.01};
	for (u32 kind = 0; kind < 4; kind++) {
		ts_scene *scene = shape(kind);
		double volume = 0.0;
		for (u32 i = 0; i < scene->n_triangles; i++)
			volume += (double)ts_dot(corner(scene, i, 0), ts_cross(corner(scene, i, 1), corner(scene, i, 2))) / 6.0;
		volume /= (double)(RADIUS * RADIUS * RADIUS);
		if (fabs(volume / expected[kind] - 1.0) > tolerance[kind])
			fail_msg("shape %u: volume %g, expected %g", kind, volume, expected[kind]);
		ts_scene_free(scene);
	}
}

static void normals_agree_with_their_faces(void **state)
{
	(void)state;
	for (u32 kind = 0; kind < 4; kind++) {
		ts_scene *scene = shape(kind);
		for (u32 i = 0; i < scene->n_triangles; i++) {
			ts_v3 a = corner(scene, i, 0);
			ts_v3 face = ts_cross(ts_sub(corner(scene, i, 1), a), ts_sub(corner(scene, i, 2), a));
			for (u32 k = 0; k < 3; k++) {
				ts_v3 n = ts_load3(scene->vertices[scene->triangles[i].vertex[k]].normal);
				assert_float_equal(ts_length(n), 1.0f, 1e-6f);
				f32 cosine = ts_dot(n, ts_normalize(face));
				if (cosine < 0.8f) fail_msg("shape %u, triangle %u: cosine %g", kind, i, (double)cosine);
			}
		}
		ts_scene_free(scene);
	}
}

static void every_shape_fills_its_radius(void **state)
{
	(void)state;
	for (u32 kind = 0; kind < 4; kind++) {
		ts_scene *scene = shape(kind);
		f32 greatest = 0.0f;
		for (u32 i = 0; i < scene->n_vertices; i++)
			greatest = ts_max(greatest, ts_length(ts_load3(scene->vertices[i].position)));
		assert_true(greatest <= RADIUS * 1.000001f && greatest >= RADIUS * 0.97f);
		ts_scene_free(scene);
	}
}

static void the_sphere_is_round(void **state)
{
	(void)state;
	ts_scene *scene = shape(TS_SHAPE_SPHERE);
	for (u32 i = 0; i < scene->n_vertices; i++) {
		const ts_vertex *v = &scene->vertices[i];
		for (u32 k = 0; k < 3; k++) assert_float_equal(v->position[k], v->normal[k] * RADIUS, 2e-6f);
	}
	ts_scene_free(scene);
}

static void an_unknown_shape_fails(void **state)
{
	(void)state;
	ts_build *build = ts_build_new("shape");
	assert_non_null(build);
	ts_shape_add(build, TS_SHAPE_MIXED, 1.0f, TS_NONE);
	assert_true(ts_build_failed(build));
	ts_build_free(build);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_shape_is_closed),
		cmocka_unit_test(every_shape_has_its_volume),
		cmocka_unit_test(normals_agree_with_their_faces),
		cmocka_unit_test(every_shape_fills_its_radius),
		cmocka_unit_test(the_sphere_is_round),
		cmocka_unit_test(an_unknown_shape_fails),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
