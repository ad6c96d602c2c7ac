/* Fragments side by side equal ts_k_fragment_at bit for bit: of triangles of any size, across planes, behind the eye,
 * degenerate, that cover their pixels or do not; of views with one sample and with four. */
#include "backends/c/raster/fragment_batch.h"
#include "kernels/raster/eye_sample.h"
#include "tests/backends/c/raster/triangles.h"

enum { N = 1500, SIDE = 64 };

static ts_camera_k random_view(void)
{
	ts_camera_k v = {.focal = power(3, 13), .near = power(-6, 1), .width = 1 + (i32)below(SIDE), .side = 1};
	v.height = 1 + (i32)below(SIDE);
	v.back = direction();
	v.right = ts_normalize(ts_cross(v.back, direction()));
	v.up = ts_cross(v.back, v.right);
	v.eye = below(4) == 0 ? ts_v3_make(0, 0, 0) : uniform3(-4, 4);
	if (below(2) == 0) {
		v.shift_x = 128 - ts_eye_sample[below(4)][0];
		v.shift_y = 128 - ts_eye_sample[below(4)][1];
		v.side = 0.5f;
	}
	return v;
}

/* Keys of what is drawn, in the order of pixels; of half of the pixels, any. */
static void draw(u64 *keys, const ts_arrays *scene, const ts_camera_k *view)
{
	const ts_band whole = ts_k_band(0, 0);
	ts_target target = ts_k_keys(keys);
	for (u32 i = 0; i < SIDE * SIDE; i++) keys[i] = TS_EMPTY;
	for (u32 t = 0; t < scene->n_triangles; t++) {
		ts_corners c = ts_k_corners(scene, t);
		if (!ts_k_is_degenerate(c.n)) ts_k_draw(scene, view, &c, t, &whole, &target);
	}
}

static bool equal(const ts_fragment_batch *b, u32 i, const ts_arrays *scene, const ts_camera_k *view)
{
	ts_corners t = ts_k_corners(scene, b->triangle[i]);
	ts_fragment f = ts_k_fragment_at(view, &t, b->x[i], b->y[i]);
	return same_bits3(f.w, ts_lane3(&b->w, i)) && same_bits3(t.n, ts_lane3(&b->normal, i)) && same_bits(f.z, b->z[i]) &&
	       same_bits3(ts_blend(f.w, t.a, t.b, t.c), ts_lane3(&b->p, i)) &&
	       same_bits(ts_k_fragment_footprint(view, &t, &f), b->footprint[i]);
}

static void check(ts_fragment_batch *b, const ts_arrays *scene, const ts_camera_k *view, u32 start)
{
	ts_fragments_find(b, scene, view);
	for (u32 i = 0; i < b->n; i++) {
		if (equal(b, i, scene, view)) continue;
		fail_msg("random %u: triangle %u at %d, %d", start, b->triangle[i], b->x[i], b->y[i]);
	}
	b->n = 0;
}

static void fragments_abreast_equal_the_kernel(void **state)
{
	(void)state;
	static small_scene s;
	static u64 keys[SIDE * SIDE];
	u32 n_drawn = 0;
	for (u32 k = 0; k < N; k++) {
		u32 start = n_random, n = 1 + below(500);
		ts_arrays scene = triangles(&s);
		ts_camera_k view = random_view();
		ts_fragment_batch b = {.n = 0};
		draw(keys, &scene, &view);
		for (u32 i = 0; i < n; i++) {
			i32 x = (i32)below((u32)view.width), y = (i32)below((u32)view.height);
			u64 key = keys[y * view.width + x];
			if (key == TS_EMPTY || below(4) == 0) key = below(scene.n_triangles);
			n_drawn += key > scene.n_triangles;
			ts_fragment_add(&b, (u32)key, x, y, i);
			if (b.n == TS_ABREAST) check(&b, &scene, &view, start);
		}
		check(&b, &scene, &view, start);
	}
	assert_true(n_drawn > 10 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(fragments_abreast_equal_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
