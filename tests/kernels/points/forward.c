/* Forward shading: colours with a shared exponent against their definition in double precision, and whom a point is lit
 * for. */
#include "kernels/points/forward.h"
#include "tests/kernels/points/mesh.h"

/* EXT_texture_shared_exponent, section 3.8.x: B = 15, N = 9. */
static u32 defined_code(const double c[3])
{
	double most = fmax(c[0], fmax(c[1], c[2]));
	int e = (int)fmax(-16, most > 0 ? floor(log2(most)) : -16) + 16;
	if (floor(most / exp2(e - 24) + 0.5) == 512) e++;
	u32 code = (u32)e << 27;
	for (u32 k = 0; k < 3; k++) code |= (u32)floor(c[k] / exp2(e - 24) + 0.5) << (9 * k);
	return code;
}

static double clamped(f32 x) { return fmin(fmax((double)x, 0), (double)TS_MOST_SHARED); }

static void shared_codes_follow_their_definition(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < 200000; i++) {
		f32 size = uniform_power(-30, 20);
		ts_v3 v = ts_scale(uniform3(-0.1f, 1), size);
		if (i % 7 == 0) v.y = (f32)exp2((double)(random_bits() % 40) - 24);
		const double c[3] = {clamped(v.x), clamped(v.y), clamped(v.z)};
		u32 code = ts_k_shared_code(v);
		if (code != defined_code(c)) fail_msg("random %u: %a %a %a is %08x", n_random, v.x, v.y, v.z, code);
		assert_true(code != TS_NONE);
		f32 back[3];
		ts_store3(back, ts_k_shared_radiance(code));
		double most = fmax(c[0], fmax(c[1], c[2])),
			   unit = fmax(most / 256 * 1.002, exp2(-24)); /* of 511.5 and more the next exponent's */
		for (u32 k = 0; k < 3; k++) assert_true(fabs((double)back[k] - c[k]) <= unit / 2 + 1e-12);
		assert_int_equal(ts_k_shared_code(ts_load3(back)), code);
	}
}

static void black_and_the_most_have_their_codes(void **state)
{
	(void)state;
	assert_int_equal(ts_k_shared_code(ts_v3_make(0, 0, 0)), 0);
	assert_int_equal(ts_k_shared_code(ts_v3_make(-1, 0, 0)), 0);
	assert_int_equal(ts_k_shared_code(ts_v3_make(1, 1, 1)), 16u << 27 | 256u << 18 | 256u << 9 | 256u);
	u32 most = 31u << 27 | 510u << 18 | 510u << 9 | 510u;
	assert_int_equal(ts_k_shared_code(ts_v3_make(1e30f, 1e30f, 1e30f)), most);
	assert_true(ts_k_shared_radiance(most).x == TS_MOST_SHARED);
}

/* Points of unlit and of lit triangles, seen by two mirrors, by one, and by none. */
typedef struct {
	mesh mesh;
	ts_light light;
	u32 *colours;
	ts_forward_args args;
} world;

static void world_begin(world *w)
{
	memset(w, 0, sizeof *w);
	mesh *m = &w->mesh;
	mesh_begin(m);
	mesh_cube(m, ts_v3_make(9, 0, 0), 1, 8);
	mesh_cube(m, ts_v3_make(-9, 1, 2), 1, 8);
	for (u32 t = 0; t < 40; t++) {
		ts_v3 a = uniform3(-8, 8);
		mesh_triangle(m, a, ts_add(a, uniform3(-1, 1)), ts_add(a, uniform3(-1, 1)), t % 2, 0);
		u64 *words = m->bits + (u64)t * 2;
		words[0] &= t % 4 == 0 ? 0xfff : t % 4 == 1 ? 0x3f : t % 4 == 2 ? 0xfc0 : 0;
	}
	for (u32 i = 0; i < 2; i++) m->materials[i].roughness = 0.3f;
	mesh_whole(m, 2);
	mesh_points(m, 129, 0);
	w->light = (ts_light){.kind = TS_LIGHT_KIND_POINT, .position = {0, 3, 1}, .intensity = {30, 20, 10}};
	w->colours = mesh_alloc(m->n_points, sizeof *w->colours);
	ts_arrays scene = mesh_arrays(m);
	scene.lights = &w->light;
	scene.n_lights = 1;
	w->args = (ts_forward_args){
		.from = {.scene = scene, .pieces = m->pieces, .frames = m->frames, .keys = m->keys, .points = m->points},
		.view = &m->view,
		.cubes = m->cubes,
		.bits = m->bits,
		.colours = w->colours,
		.n_cubes = 2,
		.n_words = 2};
}

static void world_end(world *w)
{
	free(w->colours);
	mesh_clear(&w->mesh);
}

/* By the lengths of both ways in double precision. */
static ts_v3 viewer_of(const world *w, const ts_point *point)
{
	const mesh *m = &w->mesh;
	u64 word = m->bits[(u64)m->pieces[point->piece].triangle * 2];
	d3 p = d3_load(point->centre), eye = d3_load(m->view.eye);
	double least = INFINITY;
	ts_v3 best = ts_load3(m->view.eye);
	for (u32 r = 0; r < 2 && w->args.for_eye == 0; r++) {
		d3 c = d3_load(m->cubes[r].centre);
		double way = d3_length(d3_sub(c, eye)) + d3_length(d3_sub(p, c));
		if ((word >> (6 * r) & 63) == 0 || way >= least) continue;
		least = way;
		best = ts_load3(m->cubes[r].centre);
	}
	return best;
}

static void points_are_lit_for_their_viewer(void **state)
{
	(void)state;
	n_random = 0;
	world w;
	world_begin(&w);
	u32 n_apart = 0, n_lit = 0, *before = mesh_alloc(w.mesh.n_points, sizeof *before);
	for (w.args.for_eye = 0; w.args.for_eye < 2; w.args.for_eye++) {
		for (u32 i = 0; i < w.mesh.n_points; i++) {
			ts_k_forward_item(&w.args, i);
			ts_flight point = ts_k_flight_stored(&w.args.from, i);
			ts_surface s = ts_k_flight_surface(&w.args.from, &point);
			ts_v3 v = ts_normalize(ts_sub(viewer_of(&w, &w.mesh.points[i]), s.p));
			ts_v3 radiance = ts_k_shade(&w.args.from.scene, &s, v);
			assert_int_equal(w.colours[i], ts_k_shared_code(radiance));
			n_lit += radiance.x > 0.01f;
			n_apart += w.args.for_eye != 0 && before[i] != w.colours[i];
			before[i] = w.colours[i];
		}
	}
	assert_true(w.mesh.n_points > 100 && n_lit > w.mesh.n_points / 4 && n_apart > w.mesh.n_points / 8);
	free(before);
	world_end(&w);
}

int main(void)
{
	const struct CMUnitTest forward[] = {
		cmocka_unit_test(shared_codes_follow_their_definition),
		cmocka_unit_test(black_and_the_most_have_their_codes),
		cmocka_unit_test(points_are_lit_for_their_viewer),
	};
	return cmocka_run_group_tests(forward, NULL, NULL);
}
