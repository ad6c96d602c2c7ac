/* Reading glTF: small files made here, judged by closed forms. Every file is one mesh of a few corners in a data URI.
 */
#include "kernels/base/shade.h"
#include "tests/scene/gltf/files.h"

#define TRIANGLE "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]"
#define ONE_NODE "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]"

/* (0,0,0) (1,0,0) (0,1,0) (1,1,0) (0,0,1) (1,0,1), then indices 0 1 2 2 1 3 as bytes at 72, as shorts at 80, as
 * words at 92, and at 116 the bytes 0 51 255 128. */
static unsigned char buffer[120];

static void put_float(size_t at, f32 x) { memcpy(buffer + at, &x, 4); }

static int set_up(void **state)
{
	(void)state;
	const u32 indices[6] = {0, 1, 2, 2, 1, 3};
	const unsigned char bytes[4] = {0, 51, 255, 128};
	for (size_t i = 0; i < 6; i++) {
		put_float(12 * i, (f32)(i & 1));
		put_float(12 * i + 4, i == 2 || i == 3 ? 1.0f : 0.0f);
		put_float(12 * i + 8, i > 3 ? 1.0f : 0.0f);
		buffer[72 + i] = (unsigned char)indices[i];
		memcpy(buffer + 80 + 2 * i, &indices[i], 2);
		memcpy(buffer + 92 + 4 * i, &indices[i], 4);
	}
	memcpy(buffer + 116, bytes, 4);
	return 0;
}

/* Loads a file whose JSON is `body` beside an asset, the buffer as bufferViews/0, and accessors/0 of 3, /1 of 4, /2 of
 * 6 positions, /3 /4 /5 of 6 indices of 1, 2 and 4 bytes. `accessors` adds more, each with a leading comma. */
static ts_build *load_with(const char *body, const char *accessors, const char *reflector)
{
	char text[8192], data[161];
	base64(data, buffer, sizeof buffer);
	snprintf(text, sizeof text,
	         "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":120,\"uri\":"
	         "\"data:application/octet-stream;base64,%s\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":120}],"
	         "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":3},"
	         "{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":4},"
	         "{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":6},"
	         "{\"bufferView\":0,\"byteOffset\":72,\"componentType\":5121,\"type\":\"SCALAR\",\"count\":6},"
	         "{\"bufferView\":0,\"byteOffset\":80,\"componentType\":5123,\"type\":\"SCALAR\",\"count\":6},"
	         "{\"bufferView\":0,\"byteOffset\":92,\"componentType\":5125,\"type\":\"SCALAR\",\"count\":6}%s],%s}",
	         data, accessors, body);
	return load_text(text, reflector, 8);
}

static ts_build *load(const char *body)
{
	ts_build *build = load_with(body, "", NULL);
	if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
	return build;
}

static void refuse_with(const char *body, const char *accessors, const char *reflector, const char *words)
{
	assert_refused(load_with(body, accessors, reflector), words);
}

static void refuse(const char *body, const char *words) { refuse_with(body, "", NULL, words); }

static void assert_near(f32 a, f32 b)
{
	if (ts_abs(a - b) > 1e-6f) fail_msg("%.9g is not %.9g", (double)a, (double)b);
}

static void assert_v3(const f32 *v, f32 x, f32 y, f32 z)
{
	assert_near(v[0], x);
	assert_near(v[1], y);
	assert_near(v[2], z);
}

static const f32 *corner(const ts_scene *scene, u32 triangle, u32 k)
{
	return scene->vertices[scene->triangles[triangle].vertex[k]].position;
}

/* Twice the area vector of a triangle. */
static ts_v3 area(const ts_scene *scene, u32 triangle)
{
	ts_v3 a = ts_load3(corner(scene, triangle, 0));
	return ts_cross(ts_sub(ts_load3(corner(scene, triangle, 1)), a), ts_sub(ts_load3(corner(scene, triangle, 2)), a));
}

static void a_triangle_is_read_as_it_is(void **state)
{
	(void)state;
	ts_build *build = load(ONE_NODE "," TRIANGLE);
	const ts_scene *scene = ts_build_peek(build);
	assert_int_equal(scene->n_triangles, 1);
	assert_int_equal(scene->n_vertices, 3);
	assert_true(scene->triangles[0].material == 0 && scene->materials[0].metallic == 1.0f); /* 3.9.6 */
	assert_v3(corner(scene, 0, 1), 1.0f, 0.0f, 0.0f);
	assert_v3(scene->vertices[0].normal, 0.0f, 0.0f, 0.0f);
	for (u32 i = 0; i < 4; i++)
		assert_true(scene->vertices[0].colour[i] == 1.0f && scene->vertices[0].tangent[i] == 0.0f);
	ts_build_free(build);
}

static void indices_of_any_width_are_read(void **state)
{
	(void)state;
	for (int accessor = 3; accessor < 6; accessor++) {
		char body[512];
		snprintf(body, sizeof body,
		         ONE_NODE ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":%d}]}]",
		         accessor);
		ts_build *build = load(body);
		const ts_scene *scene = ts_build_peek(build);
		assert_int_equal(scene->n_triangles, 2);
		assert_int_equal(scene->n_vertices, 4);
		assert_v3(corner(scene, 1, 2), 1.0f, 1.0f, 0.0f);
		ts_build_free(build);
	}
	refuse(ONE_NODE ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":3}]}]",
	       "index 3 at 5; there are 3 vertices");
}

/* Only what triangles use becomes a vertex. */
static void only_used_vertices_are_kept(void **state)
{
	(void)state;
	ts_build *build = load(ONE_NODE ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":2},\"indices\":3}]}]");
	assert_int_equal(ts_build_peek(build)->n_vertices, 4);
	ts_build_free(build);
}

/* All triangles of a strip face alike; a fan turns about its first corner. */
static void strips_and_fans_become_triangles(void **state)
{
	(void)state;
	ts_build *build = load(ONE_NODE ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"mode\":5},"
	                                "{\"attributes\":{\"POSITION\":2},\"mode\":6}]}]");
	const ts_scene *scene = ts_build_peek(build);
	assert_int_equal(scene->n_triangles, 2 + 4);
	for (u32 i = 0; i < 2; i++)
		assert_v3(&(f32[3]){area(scene, i).x, area(scene, i).y, area(scene, i).z}[0], 0.0f, 0.0f, 1.0f);
	for (u32 i = 2; i < 6; i++) assert_v3(corner(scene, i, 2), 0.0f, 0.0f, 0.0f);
	ts_build_free(build);
}

static void lines_draw_nothing(void **state)
{
	(void)state;
	ts_build *build = load(ONE_NODE ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":3}]}]");
	assert_int_equal(ts_build_peek(build)->n_triangles, 0);
	assert_note(build, "lines are not drawn");
	ts_build_free(build);
}

/* Index 2 of the three positions is replaced by the fourth one. */
static void sparse_items_replace_others(void **state)
{
	static const char sparse[] =
		",{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":3,\"sparse\":{\"count\":1,\"indices\":"
		"{\"bufferView\":0,\"byteOffset\":74,\"componentType\":5121},\"values\":{\"bufferView\":0,\"byteOffset\":36}}}";
	(void)state;
	ts_build *build =
		load_with(ONE_NODE ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":6}}]}]", sparse, NULL);
	assert_false(ts_build_failed(build));
	assert_v3(corner(ts_build_peek(build), 0, 1), 1.0f, 0.0f, 0.0f);
	assert_v3(corner(ts_build_peek(build), 0, 2), 1.0f, 1.0f, 0.0f);
	ts_build_free(build);
}

/* Accessors without a buffer view are zeros, and where they are sparse the file's items among zeros. */
static void accessors_without_a_view_are_zeros(void **state)
{
	static const char more[] =
		",{\"componentType\":5126,\"type\":\"VEC3\",\"count\":3}"
		",{\"componentType\":5126,\"type\":\"VEC3\",\"count\":4,\"sparse\":{\"count\":2,\"indices\":{\"bufferView\":0,"
		"\"byteOffset\":73,\"componentType\":5121},\"values\":{\"bufferView\":0,\"byteOffset\":12}}}"
		",{\"componentType\":5123,\"type\":\"SCALAR\",\"count\":6}"
		",{\"componentType\":5126,\"type\":\"VEC2\",\"count\":3}";
	(void)state;
	ts_build *build =
		load_with(ONE_NODE ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":6,\"TEXCOORD_0\":9}},"
	                       "{\"attributes\":{\"POSITION\":7},\"indices\":4},"
	                       "{\"attributes\":{\"POSITION\":0},\"indices\":8}]}]",
	              more, NULL);
	if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
	const ts_scene *scene = ts_build_peek(build);
	assert_int_equal(scene->n_notes, 0);
	assert_int_equal(scene->n_triangles, 1 + 2 + 2);
	assert_int_equal(scene->n_vertices, 3 + 4 + 1);
	for (u32 k = 0; k < 3; k++) assert_v3(corner(scene, 0, k), 0.0f, 0.0f, 0.0f);
	assert_v3(corner(scene, 1, 0), 0.0f, 0.0f, 0.0f);
	assert_v3(corner(scene, 1, 1), 1.0f, 0.0f, 0.0f);
	assert_v3(corner(scene, 1, 2), 0.0f, 1.0f, 0.0f);
	assert_v3(corner(scene, 2, 2), 0.0f, 0.0f, 0.0f);
	for (u32 k = 0; k < 6; k++) assert_int_equal(scene->triangles[3 + k / 3].vertex[k % 3], 7);
	ts_build_free(build);
}

static void too_many_zeros_are_refused(void **state)
{
	static const char *const more[3] = {
		",{\"componentType\":5126,\"type\":\"VEC3\",\"count\":2000000000}",
		(",{\"componentType\":5126,\"type\":\"VEC3\",\"count\":2000000000,\"sparse\":{\"count\":1,\"indices\":{"
	     "\"bufferView\":0,\"byteOffset\":73,\"componentType\":5121},\"values\":{\"bufferView\":0}}}"),
		",{\"componentType\":5125,\"type\":\"SCALAR\",\"count\":2000000000}",
	};
	static const char *const primitive[3] = {"\"POSITION\":6}", "\"POSITION\":6}", "\"POSITION\":0},\"indices\":6"};
	(void)state;
	for (int i = 0; i < 3; i++) {
		char body[256];
		snprintf(body, sizeof body, ONE_NODE ",\"meshes\":[{\"primitives\":[{\"attributes\":{%s}]}]", primitive[i]);
		refuse_with(body, more[i], NULL, "accessors/6: 2000000000 items without a bufferView; at most 65536 are read");
	}
}

/* A file that holds no buffer at all. */
static void a_file_without_a_buffer_is_read(void **state)
{
	(void)state;
	ts_build *build = load_text("{\"asset\":{\"version\":\"2.0\"},\"accessors\":[{\"componentType\":5126,\"type\":"
	                            "\"VEC3\",\"count\":3},{\"componentType\":5121,\"type\":\"SCALAR\",\"count\":3}],"
	                            "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
	                            "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]}",
	                            NULL, 8);
	if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
	assert_int_equal(ts_build_peek(build)->n_triangles, 1);
	ts_build_free(build);
}

static void normalized_integers_are_accepted(void **state)
{
	static const char more[] =
		",{\"bufferView\":0,\"byteOffset\":116,\"componentType\":5121,\"type\":\"VEC4\",\"count\":1,\"normalized\":"
		"true}"
		",{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":1}"
		",{\"bufferView\":0,\"byteOffset\":116,\"componentType\":5123,\"type\":\"VEC2\",\"count\":1,\"normalized\":"
		"true}"
		",{\"bufferView\":0,\"byteOffset\":72,\"componentType\":5121,\"type\":\"SCALAR\",\"count\":1}";
	static const char body[] = ONE_NODE ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":7,\"COLOR_0\":6,"
										"\"TEXCOORD_1\":8},\"mode\":6}]}]";
	(void)state;
	ts_build *build = load_with(body, more, NULL);
	if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
	assert_int_equal(ts_build_peek(build)->n_triangles, 0);
	assert_note(build, "complete no triangle");
	ts_build_free(build);
}

static void colours_of_vertices_are_read(void **state)
{
	static const char more[] =
		",{\"bufferView\":0,\"byteOffset\":108,\"componentType\":5121,\"type\":\"VEC4\",\"count\":3,"
		"\"normalized\":true}";
	static const char body[] =
		ONE_NODE ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"COLOR_0\":6}}]}]";
	(void)state;
	ts_build *build = load_with(body, more, NULL);
	if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
	const f32 *colour = ts_build_peek(build)->vertices[2].colour;
	assert_true(colour[0] == 0.0f && colour[1] == 51.0f / 255.0f && colour[2] == 1.0f && colour[3] == 128.0f / 255.0f);
	ts_build_free(build);
}

/* Translation after rotation after scale: (1,0,0) is doubled, turned a quarter about z, moved. */
static void nodes_scale_then_turn_then_move(void **state)
{
	(void)state;
	ts_build *build =
		load("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"translation\":[0,0,10],\"children\":[1]},{\"mesh\":0,"
	         "\"translation\":[5,0,0],\"rotation\":[0,0,2,2],\"scale\":[2,3,1]}]," TRIANGLE);
	const ts_scene *scene = ts_build_peek(build);
	assert_v3(corner(scene, 0, 0), 5.0f, 0.0f, 10.0f);
	assert_v3(corner(scene, 0, 1), 5.0f, 2.0f, 10.0f);
	assert_v3(corner(scene, 0, 2), 2.0f, 0.0f, 10.0f);
	ts_build_free(build);
}

/* The positions serve as normals too: (1,0,0) under a shear-free non-uniform scale that mirrors. */
static void mirroring_nodes_keep_fronts_in_front(void **state)
{
	(void)state;
	ts_build *build = load("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"scale\":[-1,1,1]}],"
	                       "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":0}}]}]");
	const ts_scene *scene = ts_build_peek(build);
	assert_v3(corner(scene, 0, 1), 0.0f, 1.0f, 0.0f);
	assert_v3(corner(scene, 0, 2), -1.0f, 0.0f, 0.0f);
	assert_true(area(scene, 0).z > 0.0f);
	assert_v3(scene->vertices[1].normal, -1.0f, 0.0f, 0.0f);
	assert_v3(scene->vertices[2].normal, 0.0f, 1.0f, 0.0f);
	ts_build_free(build);
}

/* Normals of a sheared mesh stay perpendicular to its images: x' = x + y carries normal (1,0,0) to (1,-1,0). */
static void sheared_normals_stay_perpendicular(void **state)
{
	(void)state;
	ts_build *build =
		load("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"matrix\":[1,0,0,0,1,1,0,0,0,0,1,0,7,8,9,1]}],"
	         "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":0}}]}]");
	const ts_scene *scene = ts_build_peek(build);
	f32 half = ts_sqrt(0.5f);
	assert_v3(corner(scene, 0, 0), 7.0f, 8.0f, 9.0f);
	assert_v3(corner(scene, 0, 2), 8.0f, 9.0f, 9.0f);
	assert_v3(scene->vertices[1].normal, half, -half, 0.0f);
	ts_build_free(build);
}

static void flattened_normals_are_none(void **state)
{
	(void)state;
	ts_build *build = load("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"scale\":[1,0,1]}],"
	                       "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":0}}]}]");
	for (u32 i = 0; i < 3; i++) assert_v3(ts_build_peek(build)->vertices[i].normal, 0.0f, 0.0f, 0.0f);
	ts_build_free(build);
}

static void wrong_graphs_of_nodes_are_refused(void **state)
{
	(void)state;
	refuse("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"children\":[0]}]," TRIANGLE,
	       "nodes/0 is its own ancestor");
	refuse("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{},{\"children\":[2]},{\"children\":[3,4]},{\"children\":[1]},{}]",
	       "is its own ancestor");
	refuse("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[1,2]},{\"children\":[3]},{\"children\":[3]},{"
	       "\"mesh\":0}]," TRIANGLE,
	       "nodes/3 is a child of nodes/1 and of nodes/2");
	refuse("\"scenes\":[{\"nodes\":[1]}],\"nodes\":[{\"mesh\":0}]," TRIANGLE, "scenes/0/nodes/0 is 1");
	refuse("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"rotation\":[0,0,0,0]}]," TRIANGLE, "length 0");
	refuse("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"translation\":[1e9,0,0]}]," TRIANGLE, "16777216");
	refuse("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"scale\":[1,1,1],\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,"
	       "0,0,0,1]}]," TRIANGLE,
	       "both matrix and scale");
}

/* The scene of `roots`, of four nodes in a chain 0 1 2 and 3, each a triangle and each one further up, is that of
 * `plain`, but for a note. */
static void assert_drawn_once(const char *roots, const char *plain)
{
	ts_build *build[2];
	for (int i = 0; i < 2; i++) {
		char body[512];
		snprintf(body, sizeof body,
		         "\"scenes\":[{\"nodes\":[%s]}],\"nodes\":[{\"mesh\":0,\"translation\":[0,1,0],\"children\":[1]},"
		         "{\"mesh\":0,\"translation\":[0,1,0],\"children\":[2]},{\"mesh\":0,\"translation\":[0,1,0]},"
		         "{\"mesh\":0}]," TRIANGLE,
		         i ? plain : roots);
		build[i] = load(body);
	}
	const ts_scene *a = ts_build_peek(build[0]), *b = ts_build_peek(build[1]);
	assert_int_equal(a->n_vertices, b->n_vertices);
	assert_memory_equal(a->vertices, b->vertices, b->n_vertices * sizeof *b->vertices);
	assert_note(build[0], "listed again as a root");
	bool below = strcmp(plain, "1") == 0; /* what is not drawn */
	assert_int_equal(b->n_notes, below ? 1 : 0);
	if (below) assert_note(build[1], "nodes/1 is a root of the scene and a child of nodes/0, which is not drawn");
	for (int i = 0; i < 2; i++) ts_build_free(build[i]);
}

/* As UniGLTF and others write it. A root whose parents the scene does not draw is a root. */
static void a_root_and_child_is_drawn_once(void **state)
{
	(void)state;
	assert_drawn_once("0,1,2,3", "0,3");
	assert_drawn_once("3,2,1,0", "3,0");
	assert_drawn_once("0,2,3", "0,3"); /* between them one that is no root */
	assert_drawn_once("3,0,3,3", "3,0");
	assert_drawn_once("2,1", "1");
	ts_build *build = load("\"scenes\":[{\"nodes\":[1]}],\"nodes\":[{\"children\":[1]},{\"mesh\":0}]," TRIANGLE);
	assert_int_equal(ts_build_peek(build)->n_triangles, 1);
	ts_build_free(build);
}

/* Of a tree with names: what has triangles at or below it, parents first, whatever is a mirror. */
static void names_of_nodes_come_parents_first(void **state)
{
	(void)state;
	static const char tree[] = "\"scenes\":[{\"nodes\":[0,4]}],\"nodes\":[{\"name\":\"all\",\"children\":[1,3]},"
							   "{\"name\":\"two\",\"mesh\":0,\"children\":[2]},{\"mesh\":0},{\"name\":\"none\"},"
							   "{\"name\":\"two\",\"mesh\":0},{\"name\":\"beside\",\"mesh\":0}]," TRIANGLE;
	for (u32 run = 0; run < 2; run++) {
		ts_build *build = load_with(tree, "", run == 0 ? NULL : "two");
		const ts_named_node *n = ts_build_peek(build)->nodes;
		assert_int_equal(ts_build_peek(build)->n_nodes, 3);
		assert_true(strcmp(n[0].name, "all") == 0 && strcmp(n[1].name, "two") == 0 && strcmp(n[2].name, "two") == 0);
		assert_true(n[0].n_triangles == 2 && n[1].n_triangles == 2 && n[2].n_triangles == 1);
		ts_build_free(build);
	}
}

static void only_perspective_cameras_are_read(void **state)
{
	(void)state;
	ts_build *build =
		load("\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"name\":\"eye\",\"camera\":0,\"translation\":[1,2,3],"
	         "\"scale\":[2,5,2]},{\"camera\":1}],\"cameras\":[{\"type\":\"perspective\",\"perspective\":"
	         "{\"yfov\":1.5707963267948966,\"znear\":0.1}},{\"type\":\"orthographic\",\"orthographic\":"
	         "{\"xmag\":1,\"ymag\":1,\"znear\":0,\"zfar\":9}}]");
	const ts_scene *scene = ts_build_peek(build);
	assert_int_equal(scene->n_cameras, 1);
	assert_string_equal(scene->cameras[0].name, "eye");
	assert_v3(scene->cameras[0].eye, 1.0f, 2.0f, 3.0f);
	assert_v3(scene->cameras[0].right, 1.0f, 0.0f, 0.0f);
	assert_v3(scene->cameras[0].up, 0.0f, 1.0f, 0.0f);
	assert_v3(scene->cameras[0].back, 0.0f, 0.0f, 1.0f);
	assert_near(scene->cameras[0].yfov, 0.25f);
	assert_note(build, "not a perspective one");
	ts_build_free(build);
}

/* Inner half angle 0, outer 60 degrees: 1 / (1 - 1/2), and -1/2 of that. */
static void lights_have_their_cones_and_colours(void **state)
{
	(void)state;
	ts_build *build =
		load("\"extensionsUsed\":[\"KHR_lights_punctual\"],\"extensions\":{\"KHR_lights_punctual\":{\"lights\":["
	         "{\"type\":\"spot\",\"color\":[1,0.5,0],\"intensity\":8,\"range\":3,\"spot\":{\"outerConeAngle\":"
	         "1.0471975511965976}},{\"type\":\"directional\"}]}},\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":["
	         "{\"translation\":[0,4,0],\"rotation\":[-1,0,0,1],\"extensions\":{\"KHR_lights_punctual\":"
	         "{\"light\":0}}},{\"extensions\":{\"KHR_lights_punctual\":{\"light\":1}}}]");
	const ts_scene *scene = ts_build_peek(build);
	assert_int_equal(scene->n_lights, 2);
	const ts_light *spot = &scene->lights[0], *sun = &scene->lights[1];
	assert_int_equal(spot->kind, TS_LIGHT_KIND_SPOT);
	assert_v3(spot->position, 0.0f, 4.0f, 0.0f);
	assert_v3(spot->direction, 0.0f, -1.0f, 0.0f);
	assert_v3(spot->intensity, 8.0f, 4.0f, 0.0f);
	assert_near(spot->range, 3.0f);
	assert_near(spot->spot_scale, 2.0f);
	assert_near(spot->spot_offset, -1.0f);
	assert_int_equal(sun->kind, TS_LIGHT_KIND_DIRECTIONAL);
	assert_v3(sun->direction, 0.0f, 0.0f, -1.0f);
	assert_v3(sun->intensity, 1.0f, 1.0f, 1.0f);
	ts_build_free(build);
}

#define PIXEL \
	"\"images\":[{\"uri\":\"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4" \
	"38AAAAQBAYDFKhhdAAAAAElFTkSuQmCC\"}],\"textures\":[{\"source\":0,\"sampler\":0}],\"samplers\":[{\"wrapS\":33071," \
	"\"wrapT\":33648,\"minFilter\":9728}]"
#define TEXTURED "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"material\":0}]}]"

static void materials_keep_what_is_drawn(void **state)
{
	(void)state;
	ts_build *build =
		load(ONE_NODE "," TEXTURED "," PIXEL ",\"materials\":[{\"name\":\"glass\",\"doubleSided\":true,\"alphaMode\":"
	                  "\"BLEND\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.25,0.5,1,0.75],\"metallicFactor\":0,"
	                  "\"baseColorTexture\":{\"index\":0},\"metallicRoughnessTexture\":{\"index\":0,\"texCoord\":1}},"
	                  "\"normalTexture\":{\"index\":0,\"scale\":2},\"emissiveTexture\":{\"index\":0},"
	                  "\"emissiveFactor\":[1,0.5,0],\"extensions\":{\"KHR_materials_emissive_strength\":"
	                  "{\"emissiveStrength\":4},\"KHR_materials_unlit\":{}}}]");
	const ts_scene *scene = ts_build_peek(build);
	const ts_material *m = &scene->materials[scene->triangles[0].material];
	assert_int_equal(m->flags, TS_DOUBLE_SIDED | TS_MASKED | TS_UNLIT);
	assert_true(m->alpha_cutoff == 0.5f && m->metallic == 0.0f && m->roughness == 1.0f && m->normal_scale == 2.0f);
	assert_v3(m->base, 0.25f, 0.5f, 1.0f);
	assert_v3(m->emissive, 4.0f, 2.0f, 0.0f);
	assert_int_equal(m->slot[TS_SLOT_OCCLUSION], TS_NONE);
	assert_int_equal(scene->n_slots, 4);
	assert_int_equal(scene->n_images, 2);
	const ts_slot *base = &scene->slots[m->slot[TS_SLOT_BASE]], *rough = &scene->slots[m->slot[TS_SLOT_METALROUGH]];
	assert_int_equal(base->wrap[0], TS_CLAMP);
	assert_int_equal(base->wrap[1], TS_MIRROR);
	assert_int_equal(base->image, scene->slots[m->slot[TS_SLOT_EMISSIVE]].image);
	assert_int_not_equal(base->image, rough->image);
	assert_int_equal(rough->uv_set, 1);
	assert_note(build, "\"glass\"");
	assert_note(build, "filters");
	assert_note(build, "TEXCOORD_1");
	ts_build_free(build);
}

/* A quarter turn maps u to -v and v to u: (0,1) of the extension's picture lands on (1,0) plus the offset. */
static void a_texture_transform_turns_and_moves(void **state)
{
	(void)state;
	ts_build *build =
		load(ONE_NODE "," TEXTURED "," PIXEL ",\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":"
	                  "{\"index\":0,\"extensions\":{\"KHR_texture_transform\":{\"offset\":[0.5,0.25],\"rotation\":"
	                  "1.5707963267948966,\"scale\":[2,3],\"texCoord\":1}}}}}]");
	const ts_slot *slot = &ts_build_peek(build)->slots[0];
	assert_v3(slot->transform, 0.0f, 3.0f, 0.5f);
	assert_v3(slot->transform + 3, -2.0f, 0.0f, 0.25f);
	assert_int_equal(slot->uv_set, 1);
	ts_build_free(build);
}

static void wrong_materials_are_refused(void **state)
{
	(void)state;
	refuse(ONE_NODE "," TEXTURED ",\"materials\":[{\"alphaMode\":\"GLASS\"}]", "one of OPAQUE MASK BLEND");
	refuse(ONE_NODE "," TEXTURED ",\"materials\":[{\"pbrMetallicRoughness\":{\"roughnessFactor\":-3}}]",
	       "roughnessFactor is -3");
	refuse(ONE_NODE "," TEXTURED ",\"materials\":[{\"emissiveTexture\":{\"index\":0}}],\"textures\":[{\"source\":0}],"
	                "\"images\":[{\"uri\":\"absent-from-here.png\"}]",
	       "absent-from-here.png");
	refuse(ONE_NODE "," TEXTURED, "meshes/0/primitives/0/material is 0; the file has no materials");
}

static void reflectors_are_named_or_marked(void **state)
{
	static const char body[] =
		"\"scenes\":[{\"nodes\":[0,1,3]}],\"nodes\":[{\"name\":\"floor\",\"mesh\":0},{\"name\":\"ball\","
		"\"children\":[2],\"extras\":{\"reflector\":true}},{\"name\":\"shell\",\"mesh\":0},"
		"{\"name\":\"wall\",\"mesh\":0}]," TRIANGLE;
	(void)state;
	for (int named = 0; named < 2; named++) {
		ts_build *build = load_with(body, "", named ? "wall" : NULL);
		if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
		const ts_scene *scene = ts_build_peek(build);
		assert_int_equal(scene->n_objects, 2);
		assert_int_equal(scene->info.n_reflectors, 1);
		assert_int_equal(scene->objects[1].n_vertices, 3);
		assert_int_equal(scene->objects[1].reflector, 0);
		assert_int_equal(scene->objects[1].period, 0);
		for (u32 i = 0; i < 9; i++) assert_int_equal(scene->vertices[i].object, named ? i >= 6 : i >= 3 && i < 6);
		ts_build_free(build);
	}
	refuse_with(body, "", "door", "\"floor\", \"ball\", \"shell\", \"wall\"");
	refuse("\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"name\":\"void\",\"extras\":{\"reflector\":true}}]",
	       "\"void\" has no triangles");
}

static void only_required_extensions_are_refused(void **state)
{
	(void)state;
	ts_build *build = load(ONE_NODE "," TRIANGLE ",\"extensionsUsed\":[\"VENDOR_thing\"]");
	assert_note(build, "\"VENDOR_thing\" is not supported");
	ts_build_free(build);
	refuse(ONE_NODE "," TRIANGLE ",\"extensionsRequired\":[\"VENDOR_thing\"]",
	       "requires the extension \"VENDOR_thing\"");
}

/* Compressed data are refused by the name of what compressed them; uncompressed copies beside them are read. */
static void compressed_data_are_refused_by_name(void **state)
{
	static const char *const names[3] = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
	                                     "KHR_meshopt_compression"};
	(void)state;
	for (int i = 0; i < 3; i++) {
		char body[512], message[128];
		snprintf(body, sizeof body, ONE_NODE "," TRIANGLE ",\"extensionsUsed\":[\"%s\"]", names[i]);
		snprintf(message, sizeof message, "compressed by %s, which is not read; write it without", names[i]);
		ts_build *build = load(body);
		assert_int_equal(ts_build_peek(build)->n_triangles, 1);
		assert_note(build, names[i]);
		ts_build_free(build);
		snprintf(body, sizeof body, ONE_NODE "," TRIANGLE ",\"extensionsRequired\":[\"%s\"]", names[i]);
		refuse(body, message);
		snprintf(body, sizeof body,
		         ONE_NODE ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":6}}]}],"
		                  "\"extensionsUsed\":[\"%s\"]",
		         names[i]);
		refuse_with(body, ",{\"componentType\":5126,\"type\":\"VEC3\",\"count\":3}", NULL, message);
	}
	assert_refused(load_text("{\"asset\":{\"version\":\"2.0\"},\"extensionsUsed\":[\"EXT_meshopt_compression\"],"
	                         "\"buffers\":[{\"byteLength\":4}]}",
	                         NULL, 8),
	               "buffers/0 is compressed by EXT_meshopt_compression");
}

static void a_refusal_leaves_the_next_file_loadable(void **state)
{
	refuse("\"nodes\":7", "nodes is 7");
	a_triangle_is_read_as_it_is(state);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_triangle_is_read_as_it_is),
		cmocka_unit_test(indices_of_any_width_are_read),
		cmocka_unit_test(only_used_vertices_are_kept),
		cmocka_unit_test(strips_and_fans_become_triangles),
		cmocka_unit_test(lines_draw_nothing),
		cmocka_unit_test(sparse_items_replace_others),
		cmocka_unit_test(accessors_without_a_view_are_zeros),
		cmocka_unit_test(too_many_zeros_are_refused),
		cmocka_unit_test(a_file_without_a_buffer_is_read),
		cmocka_unit_test(normalized_integers_are_accepted),
		cmocka_unit_test(colours_of_vertices_are_read),
		cmocka_unit_test(nodes_scale_then_turn_then_move),
		cmocka_unit_test(mirroring_nodes_keep_fronts_in_front),
		cmocka_unit_test(sheared_normals_stay_perpendicular),
		cmocka_unit_test(flattened_normals_are_none),
		cmocka_unit_test(wrong_graphs_of_nodes_are_refused),
		cmocka_unit_test(a_root_and_child_is_drawn_once),
		cmocka_unit_test(only_perspective_cameras_are_read),
		cmocka_unit_test(names_of_nodes_come_parents_first),
		cmocka_unit_test(lights_have_their_cones_and_colours),
		cmocka_unit_test(materials_keep_what_is_drawn),
		cmocka_unit_test(a_texture_transform_turns_and_moves),
		cmocka_unit_test(wrong_materials_are_refused),
		cmocka_unit_test(reflectors_are_named_or_marked),
		cmocka_unit_test(only_required_extensions_are_refused),
		cmocka_unit_test(compressed_data_are_refused_by_name),
		cmocka_unit_test(a_refusal_leaves_the_next_file_loadable),
	};
	return cmocka_run_group_tests(tests, set_up, NULL);
}
