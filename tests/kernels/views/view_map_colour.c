/* Colour in maps of views, in closed form by ambient light alone: means of a leaf's triangles without those of the
 * view's own reflector, inner nodes as they are, and the background. */
#include <string.h>
#include "kernels/views/view_map_colour.h"
#include "tests/kernels/small.h"

enum { N_TRIANGLES = 4, N_NODES = 2, N_VIEWS = 3, SIDE = 4, MAP = 2 * SIDE * SIDE };

static small_scene s;
static ts_node nodes[N_NODES], views[1];
static ts_node_surface surfaces[N_NODES];

/* Two reflectors, a wall and a lamp in a leaf, below a root that is of another material. */
static void make_scene(void)
{
	small_clear(&s);
	for (u32 i = 0; i < N_TRIANGLES; i++) {
		ts_v3 p = uniform3(-0.1f, 0.1f);
		small_add(&s, p, ts_add(p, uniform3(-1, 1)), ts_add(p, uniform3(-1, 1)), i, i);
		ts_store3(s.materials[i].base, uniform3(0, 1));
		s.materials[i].metallic = uniform(0, 1);
		ts_store3(s.materials[i].emissive, uniform3(0, 1));
	}
	s.objects[0].reflector = 0;
	s.objects[1].reflector = 1;
	s.materials[3].flags = TS_UNLIT;
	s.ambient = 0.75f;
	nodes[1] = (ts_node){.radius = 0.5f, .child = TS_NONE, .level = 1};
	nodes[0] = (ts_node){.radius = 1, .child = 1, .children = 1, .parent = TS_NONE};
	views[0] = (ts_node){.centre = {0.5f, 3, 0}, .child = TS_NONE, .parent = TS_NONE};
}

/* What a leaf sends of ambient light without one of its triangles; mirrors are diffuse, an unlit lamp is as it is. */
static void expected_of(double expected[3], u32 without)
{
	double n = 0, metallic = 0, base[3] = {0}, emissive[3] = {0};
	for (u32 i = 0; i < N_TRIANGLES; i++) {
		const ts_material *m = &s.materials[i];
		bool mirror = i < 2, lamp = i == 3;
		if (i == without) continue;
		n++;
		metallic += lamp ? 1 : mirror ? 0 : (double)m->metallic;
		for (u32 c = 0; c < 3; c++) {
			base[c] += lamp ? 0 : (double)m->base[c];
			emissive[c] += (double)(lamp ? m->base[c] : m->emissive[c]);
		}
	}
	for (u32 c = 0; c < 3; c++) expected[c] = emissive[c] / n + 0.75 * (base[c] / n) * (1 - metallic / n);
}

static void nodes_show_their_ambient_light(void **state)
{
	(void)state;
	static f32 colours[N_VIEWS * MAP * 3];
	static u32 shown[MAP];
	static const u32 offset[2] = {0, N_TRIANGLES}, triangles[N_TRIANGLES] = {0, 1, 2, 3}, leaves[N_VIEWS] = {0, 0, 0};
	const ts_root root = {.lower = {-1, -1, -1}, .side = 2};
	for (u32 world = 0; world < 200; world++) {
		make_scene();
		ts_octree_surface_args of = {.scene = small_arrays(&s),
		                             .root = &root,
		                             .nodes = nodes,
		                             .offset = offset,
		                             .triangles = triangles,
		                             .surfaces = surfaces,
		                             .levels = 1,
		                             .first = 1};
		ts_k_leaf_surface_item(&of, 0);
		surfaces[0] = (ts_node_surface){.base = {0.5f, 0.25f, 1}, .emissive = {0, 1, 0}, .occlusion = 0.5f};
		for (u32 i = 0; i < MAP; i++) shown[i] = i % 3 == 0 ? TS_NONE : i % 3 - 1;
		const ts_view_map_colour_args args = {
			.of = of, .views = views, .leaves = leaves, .shown = shown, .colours = colours, .n = SIDE};
		for (u32 i = 0; i < N_VIEWS * MAP; i++) ts_k_view_map_colour_item(&args, i);
		for (u32 i = 0; i < N_VIEWS * MAP; i++) {
			double expected[3] = {0.5 * 0.375, 1 + 0.25 * 0.375, 0.375};
			ts_v3 sky = ts_k_background();
			if (shown[i % MAP] == 1) expected_of(expected, i / MAP < 2 ? i / MAP : TS_NONE);
			if (shown[i % MAP] == TS_NONE) memcpy(expected, (double[]){sky.x, sky.y, sky.z}, sizeof expected);
			for (u32 c = 0; c < 3; c++) assert_true(fabs((double)colours[3 * i + c] - expected[c]) < 1e-6);
		}
	}
}

/* A mean normal turns to the viewer: a sun behind the viewer lights the node whichever way it looks. */
static void mean_normals_turn_to_the_viewer(void **state)
{
	(void)state;
	f32 colours[2 * MAP * 3];
	u32 shown[MAP], leaf[1] = {0};
	ts_octree_surface_args of = {.nodes = nodes, .surfaces = surfaces, .first = 1};
	make_scene();
	s.lights[s.n_lights++] =
		(ts_light){.kind = TS_LIGHT_KIND_DIRECTIONAL, .direction = {0, -1, 0}, .intensity = {1, 1, 1}};
	of.scene = small_arrays(&s);
	memset(shown, 0, sizeof shown);
	for (u32 turned = 0; turned < 2; turned++) {
		surfaces[0] = (ts_node_surface){.base = {1, 1, 1}, .roughness = 1, .occlusion = 1};
		surfaces[0].normal[1] = turned ? -0.25f : 0.25f;
		const ts_view_map_colour_args args = {
			.of = of, .views = views, .leaves = leaf, .shown = shown, .colours = colours + turned * MAP * 3, .n = SIDE};
		for (u32 i = 0; i < MAP; i++) ts_k_view_map_colour_item(&args, i);
	}
	assert_memory_equal(colours, colours + MAP * 3, MAP * 3 * sizeof *colours);
	assert_true(colours[0] > 0.75f + 0.25f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(nodes_show_their_ambient_light),
	                                   seeded_test(mean_normals_turn_to_the_viewer)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
