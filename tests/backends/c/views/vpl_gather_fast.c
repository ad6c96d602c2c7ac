/* Pixels gather by the fast path what they gather by the plain kernel: of lists short and long, of all views, without
 * shadows and with them, by plane and by distance, of lights to one side and to all, and of one where the place is. */
#include "backends/backend.h"
#include "backends/fast.h"
#include "kernels/views/vpl_gather.h"
#include "tests/kernels/views/tree.h"

enum { N = 300, PIXELS = 64, LIGHTS = 300, VIEW_NODES = 40, MOST_PX = 128, MOST_LIST = 30 };

static tree scene;
static ts_gpixel pixels[PIXELS];
static u32 offset[NODES + 1], list[NODES * MOST_LIST], sums[NODES * MOST_LIST], views[LIGHTS], leaves[LIGHTS];
static ts_cone cones[VIEW_NODES];
static ts_node nodes[VIEW_NODES];
static ts_vpl lights[LIGHTS];
static u32 depths[VIEW_NODES * 2 * MOST_PX * MOST_PX], shown[VIEW_NODES * 2 * MOST_PX * MOST_PX];
static f32 irradiance[2][PIXELS * 3];

/* In the root cube, or a little out of it. */
static ts_v3 random_place(void)
{
	ts_v3 at = uniform3(-0.05f, 1.05f);
	return ts_add(ts_load3(scene.root.lower), ts_scale(at, scene.root.side));
}

static void random_scene(void)
{
	u32 n = 1 + below(200);
	tree_begin(&scene, below(MOST + 1));
	for (u32 i = 0; i < n; i++) {
		u64 code = below(1u << (3 * scene.levels));
		scene.mask[ts_k_mask_word(scene.levels, code)] |= ts_k_mask_bit(code);
	}
	tree_finish(&scene);
}

static void random_lights(void)
{
	u32 first = 0;
	for (u32 i = 0; i < LIGHTS; i++) {
		bool to_all_sides = below(4) == 0;
		lights[i] = (ts_vpl){.bounce = 1};
		ts_store3(lights[i].position, random_place());
		if (!to_all_sides) ts_store3(lights[i].normal, direction());
		ts_store3(lights[i].flux, uniform3(0, 10));
		views[i] = (i * 7 + 3) % LIGHTS;
		leaves[i] = below(VIEW_NODES);
	}
	for (u32 i = 0; i < VIEW_NODES; i++) {
		u32 left = LIGHTS - first - (VIEW_NODES - 1 - i);
		cones[i] = (ts_cone){.first = first, .views = 1 + below(left < 20 ? left : 20)};
		first += cones[i].views;
		ts_store3(nodes[i].centre, random_place());
	}
}

static void random_lists(u32 n_lists)
{
	for (u32 i = 0; i < n_lists; i++) {
		u32 n = below(4) == 0 ? 0 : 1 + below(MOST_LIST), sum = 0;
		offset[i + 1] = offset[i] + n;
		for (u32 k = offset[i]; k < offset[i + 1]; k++) {
			list[k] = below(VIEW_NODES);
			sums[k] = sum += cones[list[k]].views;
		}
	}
}

static void random_maps(u32 n)
{
	for (u32 i = 0; i < VIEW_NODES * 2 * n * n; i++) {
		bool empty = below(4) == 0;
		depths[i] = empty ? TS_NONE : ts_f2u(ts_put(uniform(0, 1.5f) * scene.root.side));
		shown[i] = empty ? TS_NONE : below(scene.n);
	}
}

static void random_pixels(void)
{
	for (u32 i = 0; i < PIXELS; i++) {
		bool at_light = below(16) == 0;
		pixels[i] = (ts_gpixel){.depth = below(8) == 0 ? TS_SKY : 0.5f};
		ts_store3(pixels[i].position, at_light ? ts_load3(lights[below(LIGHTS)].position) : random_place());
		ts_store3(pixels[i].normal, direction());
	}
}

static ts_vpl_gather_args random_args(void)
{
	static const u32 px[] = {4, 8, 16, MOST_PX}, draws[] = {0, 1, 63, 64, 65, 200};
	random_scene();
	random_lights();
	u32 level = below(scene.levels + 1), n = px[below(32) == 0 ? 3 : below(3)];
	random_lists(scene.level[level + 1] - scene.level[level]);
	random_maps(n);
	random_pixels();
	return (ts_vpl_gather_args){.pixels = pixels,
	                            .root = &scene.root,
	                            .mask = scene.mask,
	                            .before = scene.before,
	                            .offset = offset,
	                            .list = list,
	                            .sums = sums,
	                            .cones = cones,
	                            .views = views,
	                            .leaves = leaves,
	                            .nodes = nodes,
	                            .lights = lights,
	                            .depths = depths,
	                            .shown = shown,
	                            .scene = scene.nodes,
	                            .levels = scene.levels,
	                            .level = level,
	                            .first = scene.level[level],
	                            .n_lights = LIGHTS,
	                            .draws = draws[below(6)],
	                            .seed = bits(),
	                            .n = n,
	                            .shadows = below(4) != 0,
	                            .near = uniform(0.001f, 2),
	                            .bias = uniform(0, 1),
	                            .bias_px = uniform(0, 2),
	                            .bias_slope = below(2) == 0 ? 0 : uniform(0, 2),
	                            .by_plane = below(2),
	                            .bias_plane = uniform(0, 2)};
}

/* Returns how many pixels are lit. */
static u32 compare(ts_vpl_gather_args args, u32 threads, u32 start)
{
	i64 astray[2] = {0, 0};
	for (u32 way = 0; way < 2; way++) {
		memset(irradiance[way], 0xff, sizeof irradiance[way]);
		args.irradiance = irradiance[way];
		args.n_astray = &astray[way];
		if (way == 0) ts_c_launch(TS_KERNEL_vpl_gather, &args, PIXELS, 1);
		if (way == 1) assert_true(ts_c_fast_vpl_gather(&args, PIXELS, threads));
	}
	u32 n_lit = 0;
	for (u32 i = 0; i < PIXELS; i++) {
		const f32 *a = irradiance[0] + (size_t)i * 3, *b = irradiance[1] + (size_t)i * 3;
		n_lit += a[0] > 0 ? 1 : 0;
		if (same_bits3(ts_load3(a), ts_load3(b)) && astray[0] == astray[1]) continue;
		fail_msg("random %u: pixel %u: %a, %a; astray %lld, %lld; level %u of %u, %u draws, "
		         "maps of %u, shadows %u, by plane %u",
		         start, i, (double)a[0], (double)b[0], (long long)astray[0], (long long)astray[1], args.level,
		         args.levels, args.draws, args.n, args.shadows, args.by_plane);
	}
	return n_lit;
}

static void fast_gathering_equals_the_kernel(void **state)
{
	(void)state;
	u32 n_lit = 0;
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		u32 start = n_random, threads = 1 + below(7);
		ts_vpl_gather_args args = random_args();
		n_lit += compare(args, threads, start);
	}
	assert_true(n_lit > N * PIXELS / 4);
}

/* Maps that are not fused are asked by the plain kernel. */
static void the_kernel_takes_maps_not_fused(void **state)
{
	(void)state;
	n_random = 0;
	ts_vpl_gather_args args = random_args();
	args.shadows = 1;
	args.depths = NULL;
	assert_false(ts_c_fast_vpl_gather(&args, PIXELS, 1));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(fast_gathering_equals_the_kernel),
	                                   cmocka_unit_test(the_kernel_takes_maps_not_fused)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
