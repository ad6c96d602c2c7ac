/* Reflective shadow maps against rays in double precision: what the views of lights see, and the places, normals,
 * exitances and areas of their texels as patches; a wall's areas add up to the part of it in the view; grazing light;
 * the view of a texel. */
#include "kernels/raster/rsm.h"
#include "tests/kernels/raster/sight.h"

enum {
	SIZE = 32,
	N_TEXELS = SIZE * SIZE * 3 / 4,
	N_LIGHTS = 3,
	N_VIEWS = 5,
	WITHOUT_SIZE = 3,
	N_SOUPS = 24,
	N_TRIANGLES = 24
};

static const ts_patch dark;
static small_scene scene;
static ts_light lamps[N_LIGHTS];
static ts_offscreen views[N_VIEWS];
static u64 keys[N_VIEWS * N_TEXELS];
static ts_patch patches[N_VIEWS * N_TEXELS];

/* A view from a light, which is its kind's: of the directional one orthographic, along its rays. */
static ts_offscreen view_of_light(u32 light)
{
	ts_light *lamp = &lamps[light];
	ts_offscreen r = random_view(SIZE, light == TS_LIGHT_KIND_DIRECTIONAL);
	*lamp = (ts_light){.kind = light, .spot_offset = 1, .intensity = {uniform(1, 2), uniform(1, 2), uniform(1, 2)}};
	memcpy(lamp->position, r.eye, sizeof r.eye);
	ts_store3(lamp->direction, ts_neg(ts_load3(r.back)));
	r.light = light;
	return r;
}

/* Views of a directional, a point and a spot light, of which one leaves out an object, one without size, and another of
 * the point light, rolled by half a turn. */
static void make_views(void)
{
	u64 offset = 0;
	for (u32 v = 0; v < N_VIEWS; v++) {
		if (v < N_LIGHTS) views[v] = view_of_light(v);
		if (v == WITHOUT_SIZE) views[v] = (ts_offscreen){.object = TS_NONE};
		if (v > WITHOUT_SIZE) views[v] = views[TS_LIGHT_KIND_POINT];
		views[v].offset = offset;
		offset += views[v].width * views[v].height;
	}
	ts_store3(views[N_VIEWS - 1].right, ts_neg(ts_load3(views[TS_LIGHT_KIND_POINT].right)));
	ts_store3(views[N_VIEWS - 1].up, ts_neg(ts_load3(views[TS_LIGHT_KIND_POINT].up)));
	views[TS_LIGHT_KIND_SPOT].object = 1;
	lamps[TS_LIGHT_KIND_POINT].range = 3;
	lamps[TS_LIGHT_KIND_SPOT].spot_scale = 8;
	lamps[TS_LIGHT_KIND_SPOT].spot_offset = -7;
}

static void draw(u32 n_views)
{
	ts_rsm_args args = {.scene = small_arrays(&scene),
	                    .views = views,
	                    .lamps = lamps,
	                    .depth_triangle = keys,
	                    .patches = patches,
	                    .n_views = n_views};
	u64 n_texels = views[n_views - 1].offset + views[n_views - 1].width * views[n_views - 1].height;
	memset(keys, 0xff, sizeof keys);
	memset(patches, 0xff, sizeof patches);
	for (u32 t = 0; t < scene.n_triangles; t++) ts_k_rsm_item(&args, t);
	for (u64 i = 0; i < n_texels; i++) ts_k_rsm_patch_item(&args, i);
}

static double3 corner(const f32 *p) { return d3_of(ts_load3(p)); }

/* Along the normal of its corners' order. */
static double3 patch_area(const ts_patch *patch)
{
	return area_of(corner(patch->a), corner(patch->b), corner(patch->c));
}

/* What arrives of a lamp, and the way to it. */
static double light_at(const ts_light *lamp, double3 p, double3 *way)
{
	*way = d3_scale(d3_of(ts_load3(lamp->direction)), -1);
	if (lamp->kind == TS_LIGHT_KIND_DIRECTIONAL) return 1;
	double3 d = d3_sub(d3_of(ts_load3(lamp->position)), p);
	double cosine = d3_dot(*way, d3_unit(d)), r = d3_length(d), range = lamp->range;
	double within = range > 0 ? fmax(1 - pow(r / range, 4), 0) : 1;
	double cone = cosine * (double)lamp->spot_scale + (double)lamp->spot_offset;
	*way = d3_unit(d);
	return within / (r * r) * (lamp->kind == TS_LIGHT_KIND_SPOT ? pow(fmin(fmax(cone, 0), 1), 2) : 1);
}

/* The face normal on the side of the light. */
static double3 lit_normal(const hit *h, double3 way)
{
	double3 n = d3_unit(normal_of(&scene, h->triangle));
	return d3_dot(n, way) < 0 ? d3_scale(n, -1) : n;
}

/* Equilateral about the place that is seen, in the plane of the face, turned to the light, as large as what the texel
 * sees: 64 times what an eighth of it does in its middle, along rows and columns. */
static void check_shape(const ts_camera_k *camera, const ts_patch *patch, const sight *s, u32 texel, double3 n)
{
	double3 a = corner(patch->a), b = corner(patch->b), c = corner(patch->c);
	double3 middle = d3_scale(d3_add(d3_add(a, b), c), 1.0 / 3);
	double x = texel % SIZE + 0.5, y = texel / SIZE + 0.5, side = d3_distance(a, b), slack = 1e-3 * side + 1e-6;
	double low[2] = {x - 0.0625, y - 0.0625}, high[2] = {x + 0.0625, y + 0.0625};
	for (u32 i = 0; i < 3; i++) {
		double p[4];
		for (u32 k = 0; k < 4; k++) p[k] = (&s->around[k].p.x)[i];
		assert_among((&middle.x)[i], p, 1e-5);
	}
	assert_near(d3_distance(b, c), side, slack);
	assert_near(d3_distance(c, a), side, slack);
	assert_true(d3_distance(corner(patch->normal), n) < 1e-5);
	double area = 64 * seen_area(camera, low, high, s->at.p, n);
	assert_near(d3_dot(patch_area(patch), n), area, 0.01 * area);
}

/* Whether the texel could be compared: all of the sight is lit, or dark. */
static bool check_patch(const ts_camera_k *camera, const ts_light *lamp, const ts_patch *patch, u32 texel,
                        const sight *s)
{
	double exitance[3][4], least = INFINITY, most = 0;
	double3 way;
	light_at(lamp, s->at.p, &way);
	double3 n = lit_normal(&s->at, way);
	if (d3_dot(n, way) < 0.2) return false;
	for (u32 k = 0; k < 4; k++) {
		double arrives = light_at(lamp, s->around[k].p, &way), e = arrives * d3_dot(n, way);
		least = fmin(least, arrives);
		most = fmax(most, arrives);
		for (u32 i = 0; i < 3; i++) {
			exitance[i][k] = albedo_at(&scene, &s->around[k], i) * (double)lamp->intensity[i] * e;
		}
	}
	if (most == 0) assert_memory_equal(patch, &dark, sizeof dark);
	if (least == 0) return most == 0;
	for (u32 i = 0; i < 3; i++) assert_among((double)patch->exitance[i], exitance[i], 1e-3 * exitance[i][0]);
	assert_true(patch->pad == 0);
	check_shape(camera, patch, s, texel, n);
	return true;
}

/* Returns how many texels were compared. */
static u32 check_view(const ts_offscreen *view)
{
	ts_camera_k camera = ts_k_offscreen(view);
	u32 n_checked = 0;
	for (u32 k = 0; k < view->width * view->height; k++) {
		u64 i = view->offset + k;
		sight s;
		if (keys[i] == TS_EMPTY) assert_memory_equal(&patches[i], &dark, sizeof dark);
		if (!is_decided(&scene, &camera, view->object, k, &s)) continue;
		assert_int_equal((u32)keys[i], s.at.triangle);
		if (s.at.triangle == TS_NONE) continue;
		assert_depth(ts_u2f((u32)(keys[i] >> 32)), &s);
		n_checked += check_patch(&camera, &lamps[view->light], &patches[i], k, &s);
	}
	return n_checked;
}

static void patches_are_what_the_light_sees(void **state)
{
	(void)state;
	u32 n_checked[N_VIEWS] = {0};
	for (u32 n = 0; n < N_SOUPS; n++) {
		small_soup(&scene, N_TRIANGLES);
		make_views();
		draw(N_VIEWS);
		for (u32 v = 0; v < N_VIEWS; v++) n_checked[v] += check_view(&views[v]);
	}
	for (u32 v = 0; v < N_VIEWS; v++) assert_true(v == WITHOUT_SIZE || n_checked[v] > N_SOUPS * N_TEXELS / 2);
}

/* The wall in the middle of view 0, its normal at this cosine from the axis. Returns the sum of its patches' areas. */
static double draw_wall(f32 cosine, f32 distance, double3 *p, double3 *n)
{
	ts_v3 back = ts_load3(views[0].back), v = ts_normalize(ts_cross(back, direction()));
	ts_v3 front = ts_mad(ts_scale(back, cosine), ts_cross(v, back), sqrtf(1 - cosine * cosine)), u = ts_cross(v, front);
	ts_v3 middle = ts_mad(ts_load3(views[0].eye), back, -distance), aside = ts_mad(middle, u, -0.75f * distance);
	small_clear(&scene);
	small_add(&scene, ts_mad(aside, v, -4 * distance), ts_mad(middle, u, 8 * distance), ts_mad(aside, v, 4 * distance),
	          0, 0);
	draw(1);
	*p = d3_of(middle);
	*n = d3_of(front);
	double sum = 0;
	for (u32 i = 0; i < N_TEXELS; i++) sum += keys[i] != TS_EMPTY ? d3_length(patch_area(&patches[i])) : 0;
	return sum;
}

/* Of any normal, the axes among them, the triangle is as large, and its first corner is on the way of pole x normal. */
static void patches_of_every_normal_are_as_large(void **state)
{
	(void)state;
	for (u32 i = 0; i < 2000; i++) {
		ts_v3 axis = {.x = 0}, n = direction();
		(&axis.x)[i % 3] = i & 1 ? 1 : -1;
		if (i < 6) n = axis;
		if (i >= 1000) n = ts_normalize(ts_mad(axis, n, uniform(0, 1)));
		double3 pole = fabs((double)n.y) < 0.75 ? (double3){0, 1, 0} : (double3){1, 0, 0};
		double3 p = {1, 2, 3}, u = d3_unit(d3_cross(pole, d3_of(n)));
		f32 area = uniform(0.5f, 2);
		ts_patch patch;
		ts_k_patch_corners(&patch, ts_v3_make(1, 2, 3), n, area);
		assert_true(d3_distance(patch_area(&patch), d3_scale(d3_of(n), (double)area)) < 1e-5);
		assert_true(d3_distance(d3_unit(d3_sub(corner(patch.a), p)), u) < 1e-5);
	}
}

/* The areas of a wall that fills a view add up to what the view's four corners cut out of it. */
static void areas_of_a_wall_add_up(void **state)
{
	(void)state;
	const double low[2] = {0, 0}, high[2] = {SIZE, SIZE * 3 / 4};
	for (u32 i = 0; i < 200; i++) {
		double3 p, n;
		views[0] = view_of_light(i % N_LIGHTS);
		views[0].focal = fmaxf(views[0].focal, SIZE);
		double sum = draw_wall(uniform(0.8f, 1), 3, &p, &n);
		ts_camera_k camera = ts_k_offscreen(&views[0]);
		double area = seen_area(&camera, low, high, p, n);
		assert_near(sum, area, (camera.orthographic != 0 ? 1e-5 : 1e-3) * area);
	}
}

/* A wall at ever more grazing light: the area grows by 1 / cos theta, and no more beyond 2^6. */
static void areas_grow_with_grazing_light(void **state)
{
	(void)state;
	u32 n_seen = 0, n_clamped = 0;
	for (u32 i = 0; i < 80; i++) {
		double3 p, n;
		views[0] = view_of_light(TS_LIGHT_KIND_DIRECTIONAL);
		f32 cosine = (f32)exp2(-(double)i / 10);
		draw_wall(cosine, 400, &p, &n);
		double area = 1 / ((double)views[0].focal * (double)views[0].focal * fmax((double)cosine, 0x1p-6));
		for (u32 k = 0; k < N_TEXELS; k++) {
			if (keys[k] == TS_EMPTY) continue;
			n_seen++;
			n_clamped += cosine < 0x1p-6f;
			assert_near(d3_length(patch_area(&patches[k])), area, 1e-4 * area);
		}
	}
	assert_true(n_seen > 40 * N_TEXELS && n_clamped > 10 * N_TEXELS);
}

/* All sizes up to two texels of four views, against the range that each texel is in. */
static void each_texel_finds_its_view(void **state)
{
	(void)state;
	for (u32 sizes = 0; sizes < 81; sizes++) {
		const u32 size[4] = {sizes % 3, sizes / 3 % 3, sizes / 9 % 3, sizes / 27};
		ts_offscreen of[4] = {{.offset = 0}};
		for (u32 v = 1; v < 4; v++) of[v].offset = of[v - 1].offset + size[v - 1];
		for (u32 v = 0; v < 4; v++) {
			for (u32 k = 0; k < size[v]; k++) assert_int_equal(ts_k_view_of_texel(of, 4, of[v].offset + k), v);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(patches_are_what_the_light_sees), seeded_test(patches_of_every_normal_are_as_large),
		seeded_test(areas_of_a_wall_add_up),          seeded_test(areas_grow_with_grazing_light),
		seeded_test(each_texel_finds_its_view),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
