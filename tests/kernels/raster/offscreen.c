/* Visibility in off-screen views: what projects into an image has its bit, the paper's test by its words, the same bits
 * as the cubes' own kernel, and what a view leaves out. */
#include "kernels/raster/visibility.h"
#include "tests/kernels/points/views.h"

enum { N = 20000, N_VIEWS = 72, N_SAMPLES = 40 };

static ts_offscreen views[N_VIEWS];

static void random_views(u32 n)
{
	for (u32 v = 0; v < n; v++) {
		u32 parallel = random_bits() & 1;
		views[v] = view_from(uniform3(-4, 4), unit3(), parallel != 0 ? uniform(0.5f, 6) : uniform(0.1f, 3), 64,
		                     uniform_power(-7, 0), parallel);
		views[v].reach[1] *= uniform(0.5f, 1);
	}
}

static void find_bits(mesh *m, u32 n_views, u32 vertex_mode)
{
	ts_offscreen_args args = {.scene = mesh_arrays(m),
	                          .views = views,
	                          .bits = m->bits,
	                          .n_views = n_views,
	                          .n_words = 2,
	                          .vertex_mode = vertex_mode};
	for (u32 t = 0; t < m->n_triangles; t++) ts_k_offscreen_visibility_item(&args, t);
}

static void random_triangle(mesh *m, ts_v3 corner[3], u32 material)
{
	mesh_begin(m);
	do random_corners(corner, 4, 0.01f, 8);
	while (is_degenerate(corner));
	mesh_triangle(m, corner[0], corner[1], corner[2], material, 0);
}

/* On the axes of a view: across, up, ahead; `reach` where the image ends at this depth. */
typedef struct {
	double x, y, z, reach_x, reach_y;
} on_axes;

static on_axes on_axes_of(const ts_offscreen *view, d3 p)
{
	d3 d = d3_sub(p, d3_load(view->eye));
	double z = -d3_dot(d3_load(view->back), d), unit = view->orthographic != 0 ? 1 : z;
	return (on_axes){d3_dot(d3_load(view->right), d), d3_dot(d3_load(view->up), d), z, view->reach[0] * unit,
	                 view->reach[1] * unit};
}

static bool shows(const ts_offscreen *view, d3 p)
{
	on_axes at = on_axes_of(view, p);
	return at.z >= view->near + 1e-5 && fabs(at.x) <= at.reach_x - 1e-5 && fabs(at.y) <= at.reach_y - 1e-5;
}

/* `plane`: a triangle of which any point is in the image has its bit; most of those that have one do. */
static void what_an_image_shows_has_its_bit(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_seen[2] = {0}, n_set[2] = {0};
	for (u32 i = 0; i < N; i++) {
		mesh m;
		ts_v3 corner[3];
		random_triangle(&m, corner, 1);
		random_views(1);
		find_bits(&m, 1, 0);
		bool seen = false, set = m.bits[0] != 0;
		for (u32 k = 0; k < N_SAMPLES && !seen; k++) {
			f32 x = k < 3 ? k == 1 : uniform(0, 1), y = k < 3 ? k == 2 : uniform(0, 1 - x);
			d3 p = d3_mad(d3_of(corner[0]), d3_sub(d3_of(corner[1]), d3_of(corner[0])), x);
			seen = shows(&views[0], d3_mad(p, d3_sub(d3_of(corner[2]), d3_of(corner[0])), y));
		}
		if (seen) assert_true(set);
		n_seen[views[0].orthographic] += seen;
		n_set[views[0].orthographic] += set;
	}
	for (u32 k = 0; k < 2; k++) assert_true(n_seen[k] > N / 20 && n_set[k] < n_seen[k] * 3 / 2);
}

/* `vertex`: a corner ahead, in the frustum enlarged by a fifth. */
static void the_papers_test_is_of_corners_ahead(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_set = 0, n_sure = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		ts_v3 corner[3];
		random_triangle(&m, corner, 1);
		random_views(1);
		find_bits(&m, 1, 1);
		bool inner = false, outer = false;
		for (u32 k = 0; k < 3; k++) {
			on_axes at = on_axes_of(&views[0], d3_of(corner[k]));
			for (int sign = -1; sign <= 1; sign += 2) {
				bool in = at.z > -1e-5 * sign && fabs(at.x) <= 1.2 * at.reach_x + 1e-4 * sign &&
				          fabs(at.y) <= 1.2 * at.reach_y + 1e-4 * sign;
				*(sign < 0 ? &inner : &outer) |= in;
			}
		}
		n_set += m.bits[0] != 0;
		n_sure += inner == outer;
		if (inner == outer) assert_true((m.bits[0] != 0) == inner);
	}
	assert_true(n_set > N / 20 && n_sure > N * 9 / 10);
}

/* The faces of cubes as views: bit for bit what the cubes' kernel finds, in both modes. */
static void faces_of_cubes_find_the_same_bits(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_set = 0;
	for (u32 i = 0; i < 400; i++) {
		mesh m;
		mesh_begin(&m);
		for (u32 k = 0; k < MESH_TRIANGLES; k++) {
			ts_v3 corner[3];
			random_corners(corner, 4, 0.01f, 8);
			mesh_triangle(&m, corner[0], corner[1], corner[2], k & 1, k % 14 < 12 ? k % 14 : 0);
		}
		for (u32 r = 0; r < MESH_CUBES; r++) {
			ts_v3 centre = uniform3(-4, 4);
			mesh_cube(&m, centre, uniform_power(-2, 4), random_bits() % 5 * 16);
			for (u32 face = 0; face < 6; face++) {
				ts_camera_k camera = ts_k_cube_view(&m.cubes[r], face);
				ts_offscreen *view = &views[r * 6 + face];
				*view = (ts_offscreen){.focal = camera.focal,
				                       .near = camera.near,
				                       .width = m.cubes[r].n,
				                       .height = m.cubes[r].n,
				                       .reach = {1, 1},
				                       .object = m.cubes[r].object};
				ts_store3(view->eye, camera.eye);
				ts_store3(view->right, camera.right);
				ts_store3(view->up, camera.up);
				ts_store3(view->back, camera.back);
			}
		}
		u64 by_cubes[MESH_TRIANGLES * 2];
		ts_visibility_args args = {.scene = mesh_arrays(&m),
		                           .cubes = m.cubes,
		                           .bits = by_cubes,
		                           .n_cubes = MESH_CUBES,
		                           .n_words = 2,
		                           .vertex_mode = i & 1};
		for (u32 t = 0; t < MESH_TRIANGLES; t++) ts_k_visibility_item(&args, t);
		find_bits(&m, N_VIEWS, i & 1);
		assert_memory_equal(by_cubes, m.bits, sizeof by_cubes);
		for (u32 v = 0; v < N_VIEWS; v++) n_set += ts_k_offscreen_bit(m.bits, v);
	}
	assert_true(n_set > 1000);
}

/* Bit v is what view v finds alone; there are none beyond the last view. */
static void each_view_finds_its_own_bit(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < 200; i++) {
		mesh m;
		ts_v3 corner[3];
		random_triangle(&m, corner, i & 1);
		random_views(N_VIEWS);
		memset(m.bits, 0xff, sizeof m.bits);
		find_bits(&m, N_VIEWS, 0);
		u64 all[2] = {m.bits[0], m.bits[1]};
		assert_true(all[1] >> (N_VIEWS - 64) == 0);
		for (u32 v = 0; v < N_VIEWS; v++) {
			views[0] = views[v];
			find_bits(&m, 1, 0);
			assert_true(m.bits[0] == (u64)ts_k_offscreen_bit(all, v) && m.bits[1] == 0);
		}
	}
}

/* One-sided backs are left out, judged from the eye or along the rays; so are the view's own object, triangles without
 * area, and everything if the view has no size. */
static void backs_and_own_objects_are_left_out(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_back = 0;
	for (u32 i = 0; i < N; i++) {
		mesh m;
		ts_v3 corner[3];
		random_triangle(&m, corner, 1);
		random_views(1);
		find_bits(&m, 1, 0);
		u64 both = m.bits[0];
		d3 a = d3_of(corner[0]), n = d3_unit(d3_cross(d3_sub(d3_of(corner[1]), a), d3_sub(d3_of(corner[2]), a)));
		d3 way = views[0].orthographic != 0 ? d3_load(views[0].back) : d3_sub(d3_load(views[0].eye), a);
		m.triangles[0].material = 0;
		find_bits(&m, 1, 0);
		if (fabs(d3_dot(n, way)) > 0.02) assert_true(m.bits[0] == (d3_dot(n, way) > 0 ? both : 0));
		n_back += m.bits[0] != both;
		m.triangles[0].material = 1;
		views[0].object = 0;
		find_bits(&m, 1, 0);
		assert_true(m.bits[0] == 0);
		views[0].object = 1;
		find_bits(&m, 1, 0);
		assert_true(m.bits[0] == both);
		views[0].width = 0;
		find_bits(&m, 1, 0);
		assert_true(m.bits[0] == 0);
		views[0].width = 64;
		m.vertices[2] = m.vertices[1];
		find_bits(&m, 1, 0);
		assert_true(m.bits[0] == 0);
	}
	assert_true(n_back > N / 20);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(what_an_image_shows_has_its_bit),    cmocka_unit_test(the_papers_test_is_of_corners_ahead),
		cmocka_unit_test(faces_of_cubes_find_the_same_bits),  cmocka_unit_test(each_view_finds_its_own_bit),
		cmocka_unit_test(backs_and_own_objects_are_left_out),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
