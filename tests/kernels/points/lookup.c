/* Deferred shading: directions to texels to points, the queues of later bounces, and the means of samples. */
#include "kernels/points/lookup.h"
#include "tests/kernels/points/mesh.h"

enum { SIDE = 8, TEXELS = 6 * SIDE * SIDE, N_POINTS = 40 };

/* Two cubes of one size. Triangle t is one of N_POINTS in a row, unlit, of colour colour[t], with one point in its
 * middle; of triangles 8 to 11 the object is reflector 0, of 12 to 15 reflector 1. */
typedef struct {
	mesh mesh;
	f32 colour[N_POINTS];
	u64 texels[2 * TEXELS];
	ts_lookup_args args;
} world;

static void world_begin(world *w)
{
	memset(w, 0, sizeof *w);
	mesh *m = &w->mesh;
	mesh_begin(m);
	mesh_cube(m, ts_v3_make(1, 2, 3), 0.5f, SIDE);
	mesh_cube(m, ts_v3_make(-5, 0, 2), 1, SIDE);
	m->materials[0].flags = TS_UNLIT | TS_DOUBLE_SIDED;
	for (u32 t = 0; t < N_POINTS; t++) {
		ts_v3 a = uniform3(-20, 20);
		u32 object = t >= 8 && t < 16 ? t / 4 - 1 : 0;
		mesh_triangle(m, a, ts_add(a, uniform3(-1, 1)), ts_add(a, uniform3(-1, 1)), 0, object);
		for (u32 k = 0; k < 3; k++) {
			for (u32 c = 0; c < 3; c++) m->vertices[t * 3 + k].colour[c] = (f32)t;
		}
		w->colour[t] = (f32)t;
	}
	mesh_whole(m, 0.001f);
	mesh_points(m, 129, 0);
	assert_int_equal(m->n_points, N_POINTS);
	memset(w->texels, 0xff, sizeof w->texels);
	w->args = (ts_lookup_args){.from = {.scene = mesh_arrays(m),
	                                    .pieces = m->pieces,
	                                    .frames = m->frames,
	                                    .keys = m->keys,
	                                    .points = m->points},
	                           .view = &m->view,
	                           .cubes = m->cubes,
	                           .texels = w->texels,
	                           .n_samples = TS_N_SAMPLES,
	                           .first = 1};
}

static void world_end(world *w) { mesh_clear(&w->mesh); }

/* The texel of a direction, from CONTRACT's table in double precision. */
static u32 texel_of(d3 d)
{
	double x = fabs(d.x), y = fabs(d.y), z = fabs(d.z), ma, sc, tc;
	u32 face;
	if (x >= y && x >= z) {
		face = d.x < 0;
		ma = x;
		sc = d.x < 0 ? d.z : -d.z;
		tc = -d.y;
	} else if (y >= z) {
		face = 2 + (d.y < 0);
		ma = y;
		sc = d.x;
		tc = d.y < 0 ? -d.z : d.z;
	} else {
		face = 4 + (d.z < 0);
		ma = z;
		sc = d.z < 0 ? -d.x : d.x;
		tc = -d.y;
	}
	u32 i = (u32)fmin(SIDE - 1, floor((sc / ma + 1) / 2 * SIDE)),
		j = (u32)fmin(SIDE - 1, floor((tc / ma + 1) / 2 * SIDE));
	return (face * SIDE + j) * SIDE + i;
}

/* Far enough from every border between texels for rounding not to matter. */
static bool is_clear(d3 d)
{
	u32 texel = texel_of(d);
	d = d3_unit(d);
	for (u32 k = 0; k < 12; k++) {
		d3 e = {k / 2 == 0 ? 1 : k / 2 == 3, k / 2 == 1 ? 1 : k / 2 == 4, k / 2 == 2 ? 1 : k / 2 == 5};
		if (texel_of(d3_mad(d, e, k % 2 == 0 ? 1e-5 : -1e-5)) != texel) return false;
	}
	return true;
}

static void directions_lead_to_their_texels(void **state)
{
	(void)state;
	n_random = 0;
	world w;
	world_begin(&w);
	for (u32 i = 0; i < TEXELS; i++) w.texels[TEXELS + i] = (u64)ts_f2u(uniform(0, 9)) << 32 | i;
	u32 n = 0;
	for (u32 i = 0; i < 100000; i++) {
		ts_v3 d = uniform3(-1, 1);
		if (!is_clear(d3_of(d))) continue;
		n++;
		assert_int_equal(ts_k_lookup(&w.args, 1, d), texel_of(d3_of(d)));
		assert_int_equal(ts_k_lookup(&w.args, 0, d), TS_NONE);
	}
	assert_true(n > 90000);
	w.mesh.cubes[1].n = 0;
	assert_int_equal(ts_k_lookup(&w.args, 1, ts_v3_make(1, 0, 0)), TS_NONE);
	world_end(&w);
}

static ts_pixel random_pixel(f32 change)
{
	ts_pixel p = {.reflector = random_bits() % 2, .tint_r = uniform(0, 1), .tint_g = 0.5f, .tint_b = 0.25f};
	ts_store3(p.position, uniform3(-3, 3));
	ts_store3(p.normal, ts_normalize(uniform3(-1, 1)));
	ts_store3(p.position_dx, uniform3(-change, change));
	ts_store3(p.position_dy, uniform3(-change, change));
	ts_store3(p.normal_dx, uniform3(-change, change));
	ts_store3(p.normal_dy, uniform3(-change, change));
	return p;
}

/* Sample k reflects at the position and normal moved by its offset (METHODS 2). */
static void samples_reflect_at_their_own_offset(void **state)
{
	(void)state;
	n_random = 0;
	world w;
	world_begin(&w);
	ts_store3(w.mesh.view.eye, ts_v3_make(0.5f, 6, -2));
	for (u32 i = 0; i < 2 * TEXELS; i++) w.texels[i] = i;
	u32 found[TS_N_SAMPLES], n = 0, n_spread = 0;
	w.args.found = found;
	for (u32 i = 0; i < 4000; i++) {
		ts_pixel p = random_pixel(uniform_power(-10, -1));
		w.args.pixels = &p;
		ts_k_lookup_item(&w.args, 0);
		for (u32 k = 0; k < TS_N_SAMPLES; k++) {
			double x = (ts_sample_offset[k][0] + 0.5) / 128, y = (ts_sample_offset[k][1] + 0.5) / 128;
			d3 at = d3_mad(d3_mad(d3_load(p.position), d3_load(p.position_dx), x), d3_load(p.position_dy), y);
			d3 normal = d3_unit(d3_mad(d3_mad(d3_load(p.normal), d3_load(p.normal_dx), x), d3_load(p.normal_dy), y));
			d3 in = d3_unit(d3_sub(at, d3_load(w.mesh.view.eye)));
			d3 out = d3_mad(in, normal, -2 * d3_dot(in, normal));
			n_spread += found[k] != found[0];
			if (!is_clear(out)) continue;
			n++;
			assert_int_equal(found[k], p.reflector * TEXELS + texel_of(out));
		}
	}
	assert_true(n > 90000 && n_spread > 5000);
	world_end(&w);
}

/* A sample goes on where its point lies on a mirror; the queue holds those, in order, and whose cubes they read and
 * ask. */
static void samples_on_mirrors_queue_in_order(void **state)
{
	(void)state;
	enum { ENTRIES = 50, SAMPLES = ENTRIES * TS_N_SAMPLES };
	n_random = 0;
	world w;
	world_begin(&w);
	static u32 found[SAMPLES], offset[SAMPLES + 1];
	static ts_bounce queue[SAMPLES], before[ENTRIES];
	ts_pixel pixels[ENTRIES];
	for (u32 i = 0; i < SAMPLES; i++) found[i] = random_bits() % 6 == 0 ? TS_NONE : random_bits() % N_POINTS;
	for (u32 i = 0; i < ENTRIES; i++) {
		pixels[i] = random_pixel(0);
		before[i].reflector = 1 - pixels[i].reflector;
	}
	for (u32 first = 0; first < 2; first++) {
		w.args.first = first;
		w.args.pixels = pixels;
		w.args.queue = before;
		w.args.found = found;
		w.args.offset = offset;
		w.args.next_queue = queue;
		for (u32 i = 0; i < SAMPLES; i++) ts_k_bounce_count_item(&w.args, i);
		u32 total = mesh_scan(offset, SAMPLES), n = 0;
		for (u32 i = 0; i < SAMPLES; i++) ts_k_bounce_queue_item(&w.args, i);
		for (u32 i = 0; i < SAMPLES; i++) {
			if (found[i] == TS_NONE || found[i] < 8 || found[i] >= 16) continue;
			u32 pixel = i / TS_N_SAMPLES, read = first != 0 ? pixels[pixel].reflector : before[pixel].reflector;
			assert_int_equal(queue[n].parent, i);
			assert_int_equal(queue[n].point, found[i]);
			assert_int_equal(queue[n].reflector, found[i] / 4 - 2);
			assert_int_equal(queue[n].from, read);
			n++;
		}
		assert_int_equal(total, n);
	}
	world_end(&w);
}

/* A later bounce reflects the ray from the cube just read at the normal, spread by the tile's width over the radius. */
static void later_bounces_reflect_the_ray_just_read(void **state)
{
	(void)state;
	n_random = 0;
	u32 n = 0;
	for (u32 i = 0; i < 100; i++) {
		world w;
		world_begin(&w);
		for (u32 k = 0; k < 2 * TEXELS; k++) w.texels[k] = k;
		u32 found[TS_N_BOUNCE_SAMPLES];
		w.args.found = found;
		w.args.first = 0;
		w.args.n_samples = TS_N_BOUNCE_SAMPLES;
		for (u32 t = 0; t < N_POINTS; t++) {
			w.mesh.points[t].length = uniform(0, 0.5f);
			ts_bounce entry = {.point = t, .reflector = t % 2, .from = 1 - t % 2};
			w.args.queue = &entry;
			ts_k_bounce_item(&w.args, 0);
			d3 p = d3_load(w.mesh.points[t].centre), from = d3_load(w.mesh.cubes[entry.from].centre);
			d3 u = d3_load(w.mesh.frames[t].u), v = d3_load(w.mesh.frames[t].v), face = d3_cross(u, v);
			if (fabs(d3_dot(face, d3_unit(d3_sub(from, p)))) < 1e-3) continue;
			face = d3_dot(face, d3_sub(from, p)) < 0 ? d3_scale(face, -1) : face;
			double spread = w.mesh.points[t].length / w.mesh.cubes[entry.reflector].radius;
			for (u32 k = 0; k < TS_N_BOUNCE_SAMPLES; k++) {
				double x = (ts_sample_offset[k][0] + 0.5) / 128 * spread,
					   y = (ts_sample_offset[k][1] + 0.5) / 128 * spread;
				d3 normal = d3_unit(d3_mad(d3_mad(face, u, x), v, y)), in = d3_unit(d3_sub(p, from));
				d3 out = d3_mad(in, normal, -2 * d3_dot(in, normal));
				if (!is_clear(out)) continue;
				n++;
				assert_int_equal(found[k], entry.reflector * TEXELS + texel_of(out));
			}
		}
		world_end(&w);
	}
	assert_true(n > 10000);
}

/* What a sample shows: red is the triangle's number, the background's, or what the next bounce found. */
static double colour_of(const world *w, u32 sample)
{
	u32 point = w->args.found[sample];
	if (point == TS_NONE) return 0.2f;
	if (w->args.follow != 0 && point >= 8 && point < 16) return w->args.next_radiance[w->args.offset[sample] * 3];
	return w->colour[point];
}

/* The mean of all samples, tinted; mirrors show the next bounce only if there is one. */
static void the_mean_is_of_all_samples_tinted(void **state)
{
	(void)state;
	enum { ENTRIES = 60, SAMPLES = ENTRIES * TS_N_SAMPLES };
	n_random = 0;
	static u32 found[SAMPLES], offset[SAMPLES + 1], used[ENTRIES];
	static f32 radiance[ENTRIES * 3], next[SAMPLES * 3];
	ts_pixel pixels[ENTRIES];
	world w;
	world_begin(&w);
	w.args.found = found;
	w.args.offset = offset;
	w.args.used = used;
	w.args.radiance = radiance;
	w.args.next_radiance = next;
	w.args.pixels = pixels;
	for (u32 i = 0; i < SAMPLES; i++) found[i] = random_bits() % 5 == 0 ? TS_NONE : random_bits() % N_POINTS;
	for (u32 i = 0; i < SAMPLES * 3; i++) next[i] = uniform(0, 50);
	for (u32 i = 0; i < ENTRIES; i++) pixels[i] = random_pixel(0);
	for (u32 i = 0; i < SAMPLES; i++) ts_k_bounce_count_item(&w.args, i);
	mesh_scan(offset, SAMPLES);
	for (w.args.follow = 0; w.args.follow < 2; w.args.follow++) {
		for (u32 i = 0; i < ENTRIES; i++) {
			ts_k_shade_item(&w.args, i);
			double sum = 0;
			for (u32 k = 0; k < TS_N_SAMPLES; k++) sum += colour_of(&w, i * TS_N_SAMPLES + k);
			double expected = sum / TS_N_SAMPLES * pixels[i].tint_r;
			assert_true(fabs(radiance[i * 3] - expected) <= 1e-5 * (1 + expected));
			assert_int_equal(used[i], TS_N_SAMPLES);
		}
	}
	world_end(&w);
}

/* Batches of four until the variance of the luma does not fall; the number by definition, where rounding cannot
 * decide. */
static u32 batches(const world *w, double *mean)
{
	double sum = 0, squares = 0, red = 0, before = 0;
	for (u32 n = 1; n <= TS_N_SAMPLES; n++) {
		u32 point = w->args.found[n - 1];
		double luma = point == TS_NONE ? 1 : 3 * colour_of(w, n - 1);
		red += colour_of(w, n - 1);
		sum += luma;
		squares += luma * luma;
		*mean = red / n;
		if (n % 4 != 0) continue;
		double variance = squares / n - sum / n * (sum / n);
		if (n > 4 && fabs(variance - before) < 1e-3) return 0;
		if (n > 4 && variance > before) return n;
		before = variance;
	}
	return TS_N_SAMPLES;
}

static void sampling_stops_when_the_variance_stays(void **state)
{
	(void)state;
	n_random = 0;
	u32 found[TS_N_SAMPLES], used, n_judged = 0, count[TS_N_SAMPLES + 1] = {0};
	f32 radiance[3];
	world w;
	world_begin(&w);
	ts_pixel pixel = random_pixel(0);
	pixel.tint_r = 1;
	w.args.adaptive = 1;
	w.args.found = found;
	w.args.used = &used;
	w.args.radiance = radiance;
	w.args.pixels = &pixel;
	for (u32 i = 0; i < 20000; i++) {
		u32 range = 1 + random_bits() % N_POINTS, fewer = random_bits() % 25;
		for (u32 k = 0; k < TS_N_SAMPLES; k++) found[k] = random_bits() % (k > fewer ? 1 + range / 8 : range);
		if (i % 8 == 0) found[random_bits() % TS_N_SAMPLES] = TS_NONE;
		ts_k_shade_item(&w.args, 0);
		assert_true(used == TS_N_SAMPLES || (used % 4 == 0 && used >= 8 && used < TS_N_SAMPLES));
		double mean;
		u32 expected = batches(&w, &mean);
		if (expected == 0) continue;
		n_judged++;
		count[used]++;
		assert_int_equal(used, expected);
		assert_true(fabs(radiance[0] - mean) <= 1e-4);
	}
	assert_true(n_judged > 10000 && count[8] > 100 && count[12] > 100 && count[TS_N_SAMPLES] > 100);
	for (u32 k = 0; k < TS_N_SAMPLES; k++) found[k] = 4;
	ts_k_shade_item(&w.args, 0);
	assert_int_equal(used, 8);
	world_end(&w);
}

static void the_mirror_left_tints_a_later_bounce(void **state)
{
	(void)state;
	n_random = 0;
	u32 found[TS_N_BOUNCE_SAMPLES] = {1, 2, TS_NONE, 5};
	f32 radiance[3];
	world w;
	world_begin(&w);
	ts_bounce entry = {.point = 9, .reflector = 1, .from = 0};
	w.args.queue = &entry;
	w.args.found = found;
	w.args.radiance = radiance;
	w.args.first = 0;
	w.args.n_samples = TS_N_BOUNCE_SAMPLES;
	ts_k_shade_item(&w.args, 0);
	assert_true(fabs(radiance[0] - (1 + 2 + 0.2 + 5) / 4 * 9) <= 1e-4);
	assert_true(fabs(radiance[2] - (1 + 2 + 0.5 + 5) / 4 * 9) <= 1e-4);
	world_end(&w);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(directions_lead_to_their_texels),
		cmocka_unit_test(samples_reflect_at_their_own_offset),
		cmocka_unit_test(samples_on_mirrors_queue_in_order),
		cmocka_unit_test(later_bounces_reflect_the_ray_just_read),
		cmocka_unit_test(the_mean_is_of_all_samples_tinted),
		cmocka_unit_test(sampling_stops_when_the_variance_stays),
		cmocka_unit_test(the_mirror_left_tints_a_later_bounce),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
