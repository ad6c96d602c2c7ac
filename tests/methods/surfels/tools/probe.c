/* What the probe says of surfels, against rays and the buffers of the run that wrote the trace. */
#include "kernels/surfels/surfel_blend_order.h"
#include "kernels/surfels/surfel_setup.h"
#include "tests/probe/probed.h"
#include "tests/whole.h"

static u32 n_tries(void) { return whole_or(50, 30); }

static const struct {
	const char *method;
	u32 filter, shader, accumulation;
	f32 sigma, eps;
} surfel_methods[] = {
	{"deferred", TS_FILTER_MIN, TS_SHADER_PHONG_SHADOW, TS_ACCUMULATION_FIXED, 1, 0},
	{"deferred", TS_FILTER_OBJECT, TS_SHADER_NPR_SHADOW, TS_ACCUMULATION_FLOAT32, 1, 0.05f},
	{"deferred", TS_FILTER_SCREEN, TS_SHADER_NPR, TS_ACCUMULATION_HALF, 2, 0.5f},
	{"ewa", TS_FILTER_MIN, TS_SHADER_PHONG, TS_ACCUMULATION_FIXED, 1, 0.25f},
};
enum { N_SURFELS = sizeof surfel_methods / sizeof *surfel_methods };
static traced surfels[N_SURFELS];

static int make_all(void **state)
{
	(void)state;
	ts_params params = small_params(64, 40);
	params.reflectors_count = 0;
	params.surfels_from_mesh = 6000;
	params.depth_map_px = 64;
	for (u32 i = 0; i < N_SURFELS; i++) {
		params.ewa_filter = surfel_methods[i].filter;
		params.deferred_shader = surfel_methods[i].shader;
		params.surfel_blend_accumulation = surfel_methods[i].accumulation;
		params.ewa_screen_radius = surfel_methods[i].sigma;
		params.surfel_depth_epsilon = surfel_methods[i].eps;
		make(&surfels[i], "surfels", surfel_methods[i].method, &params);
	}
	return 0;
}

static int drop_all(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_SURFELS; i++) drop(&surfels[i]);
	return 0;
}

static double dot3(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* Where the ray of a pixel meets the plane of a surfel, r3D and how deep, and how far the pixel is from its centre,
 * r2D. */
typedef struct {
	double r3, r2, z;
} met;

static met meet(const traced *t, u32 surfel, u32 x, u32 y)
{
	const ts_surfel *s = (const ts_surfel *)data(t, TS_B_scene_surfel) + surfel;
	const ts_view *view = data(t, TS_B_eye_view);
	double px = x + 0.5 - view->width / 2.0, py = view->height / 2.0 - y - 0.5, f = view->focal, z;
	double way[3], to[3], u[3], v[3], n[3], d[3], cx, cy;
	for (u32 k = 0; k < 3; k++) {
		way[k] = px / f * (double)view->right[k] + py / f * (double)view->up[k] - (double)view->back[k];
		to[k] = (double)s->centre[k] - (double)view->eye[k];
		u[k] = s->u[k];
		v[k] = s->v[k];
	}
	for (u32 k = 0; k < 3; k++) n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
	z = dot3(to, n) / dot3(way, n);
	for (u32 k = 0; k < 3; k++) d[k] = way[k] * z - to[k];
	cx = cy = 0;
	double deep = 0;
	for (u32 k = 0; k < 3; k++) {
		cx += to[k] * (double)view->right[k];
		cy += to[k] * (double)view->up[k];
		deep -= to[k] * (double)view->back[k];
	}
	double a = dot3(d, u) / dot3(u, u), b = dot3(d, v) / dot3(v, v);
	return (met){hypot(a, b), hypot(f * cx / deep - px, f * cy / deep - py) / (double)t->run.params.ewa_screen_radius,
	             z};
}

/* A fragment against that ray. Returns its weight. */
static double try_fragment(const traced *t, const json_t *fragment, u32 x, u32 y)
{
	u32 surfel = (u32)figure(fragment, "surfel"), filter = t->run.params.ewa_filter;
	met is = meet(t, surfel, x, y);
	double weight = (double)shown(fragment, "weight", 0), k = (double)t->run.params.ewa_sigma_k;
	const json_t *r3 = json_object_get(fragment, "r3D"), *r2 = json_object_get(fragment, "r2D");
	bool centre = json_object_get(fragment, "depth_of") != NULL;
	if (r3 != NULL) assert_true(fabs(json_real_value(r3) / is.r3 - 1) < 0.02);
	if (r2 != NULL) assert_true(fabs(json_real_value(r2) / is.r2 - 1) < 0.02);
	if (!centre) assert_true(fabs((double)shown(fragment, "depth", 0) / is.z - 1) < 1e-4);
	if (json_object_get(fragment, "peak") != NULL) return weight;
	double r = filter == TS_FILTER_OBJECT ? is.r3 : filter == TS_FILTER_SCREEN || centre ? is.r2 : fmin(is.r3, is.r2);
	assert_true(fabs(weight - exp(-0.5 * r * r / (k * k))) < 0.01);
	return weight;
}

/* No surfel that is inside its ellipse is nearer. */
static void try_nearest(const traced *t, const json_t *visibility, u32 x, u32 y)
{
	const json_t *found = json_object_get(visibility, "nearest");
	const ts_disc *discs = data(t, TS_B_surfel_setup_disc);
	double least = found != NULL ? (double)shown(visibility, "depth", 0) : 1e30;
	for (u32 i = 0; i < count(t, TS_B_scene_surfel); i++) {
		if (discs[i].high[0] < 0 || (discs[i].flags & TS_DISC_FLAT) != 0) continue;
		met is = meet(t, i, x, y);
		assert_false(is.r3 < 0.999 && is.z > 0.011 && is.z < least * 0.9999);
	}
}

/* Every light is told, and has its share of what there is beside the ambient light. */
static void try_shading(const traced *t, const json_t *shading)
{
	const json_t *lights = json_object_get(shading, "lights");
	if (json_is_string(shading)) return; /* nothing is there */
	assert_int_equal(json_array_size(lights), count(t, TS_B_scene_light));
	for (size_t i = 0; i < json_array_size(lights); i++) {
		assert_int_equal(figure(json_array_get(lights, i), "light"), i);
		assert_true(shown(json_array_get(lights, i), "radiance", 0) >= 0);
	}
}

/* Every fragment where rays say; listed ones and the others make up the sum of weights; what hides is nearer than
 * what is hidden. Returns how many are hidden. */
static u64 try_surfels(const traced *t, u32 x, u32 y)
{
	json_t *answer, *fragment;
	size_t i;
	double sum = 0;
	require(ask_pixel(t, x, y, &answer));
	const json_t *blended = json_object_get(answer, "blended"), *hidden = json_object_get(answer, "hidden_by_epsilon");
	json_array_foreach (json_object_get(blended, "heaviest"), i, fragment) {
		double weight = try_fragment(t, fragment, x, y);
		assert_true(json_object_get(fragment, "behind") == NULL);
		if (i == 0) assert_int_equal(figure(fragment, "surfel"), figure(json_object_get(answer, "heaviest"), "surfel"));
		sum += weight;
	}
	json_array_foreach (json_object_get(hidden, "heaviest"), i, fragment) {
		try_fragment(t, fragment, x, y);
		assert_true(json_real_value(json_object_get(fragment, "behind")) > 0);
	}
	const json_t *others = json_object_get(blended, "others");
	if (others != NULL) sum += json_real_value(json_object_get(others, "weight"));
	double told = json_real_value(get(answer, "sums", "weight"));
	bool halves = t->run.params.surfel_blend_accumulation == TS_ACCUMULATION_HALF;
	assert_true(fabs(sum - told) < (halves ? 0.01 * (1 + sum) : 1e-4));
	assert_int_equal(figure(json_object_get(answer, "sums"), "fragments"), figure(blended, "fragments"));
	const json_t *epsilon = json_object_get(json_object_get(answer, "visibility"), "epsilon");
	const f32 *used = data(t, TS_B_surfel_setup_epsilon);
	if (json_object_get(json_object_get(answer, "visibility"), "nearest") != NULL)
		assert_true(json_real_value(epsilon) == (double)used[0]);
	if (x % 4 == 0) try_nearest(t, json_object_get(answer, "visibility"), x, y);
	if (strcmp(t->run.pipeline->name, "deferred") == 0) try_shading(t, json_object_get(answer, "shading"));
	u64 n = figure(hidden, "fragments");
	json_decref(answer);
	return n;
}

static void the_probe_tells_what_rays_say(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_SURFELS; i++) {
		const traced *t = &surfels[i];
		u64 n_hidden = 0;
		json_t *answer;
		for (u32 k = 0; k < n_tries(); k++) {
			u32 x = below(t->run.params.width), y = below(t->run.params.height);
			try_pixel(t, y * t->run.params.width + x);
			n_hidden += try_surfels(t, x, y);
		}
		assert_true(n_hidden > n_tries());
		assert_int_equal(ask_texel(t, "0.+X", 0, 0, &answer), TS_ERROR);
		assert_int_equal(ask_triangle(t, 0, &answer), TS_ERROR);
		assert_int_equal(ask_point(t, 0, &answer), TS_ERROR);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_probe_tells_what_rays_say),
	};
	return cmocka_run_group_tests(tests, make_all, drop_all);
}
