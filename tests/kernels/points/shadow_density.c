/* The eye's rate through shadows: the distance from a shadow volume against its definition, the safe rate against what
 * receivers need, and the shares that the other readings of eq. 5 fall short in (FIGURES 6). */
#include "tests/kernels/points/views.h"

enum { N_DISTANCES = 600, N_VOLUMES = 1500, N_RATES = 3000, N_TRIANGLES = 4000, N_RECEIVERS = 40 };

/* A point of the shadow: corners' weights that are not negative and whose sum is from 1 to `times`. */
typedef struct {
	d3 light, corner[3];
	double times;
} volume;

static d3 in_volume(const volume *v, const double w[3])
{
	d3 p = v->light;
	for (u32 k = 0; k < 3; k++) p = d3_mad(p, d3_sub(v->corner[k], v->light), w[k]);
	return p;
}

static void into_range(const volume *v, double w[3])
{
	double sum = 0;
	for (u32 k = 0; k < 3; k++) sum += w[k] = fmax(w[k], 0);
	double scale = sum <= 0 ? 0 : sum < 1 ? 1 / sum : sum > v->times ? v->times / sum : 1;
	for (u32 k = 0; k < 3; k++) w[k] = scale > 0 ? w[k] * scale : 1.0 / 3;
}

static void random_weights(const volume *v, double w[3])
{
	double x = uniform(0, 1), y = uniform(0, 1), sum = exp2(uniform(0, (f32)log2(v->times)));
	if (x + y > 1) x = 1 - x, y = 1 - y;
	w[0] = x * sum;
	w[1] = y * sum;
	w[2] = (1 - x - y) * sum;
}

/* The volume is convex: from the best of many points random steps of falling length lead to the nearest. */
static double distance_by_search(const volume *v, d3 eye)
{
	double best[3] = {1, 0, 0}, least = INFINITY;
	for (u32 i = 0; i < 400; i++) {
		double w[3];
		random_weights(v, w);
		double d = d3_length(d3_sub(in_volume(v, w), eye));
		if (d < least) memcpy(best, w, sizeof best);
		least = fmin(least, d);
	}
	for (double reach = 1; reach > 1e-5; reach *= 0.996) {
		double w[3], sum = best[0] + best[1] + best[2];
		for (u32 k = 0; k < 3; k++) w[k] = best[k] + sum * reach * uniform(-1, 1);
		into_range(v, w);
		double d = d3_length(d3_sub(in_volume(v, w), eye));
		if (d < least) memcpy(best, w, sizeof best);
		least = fmin(least, d);
	}
	return least;
}

static void random_volume(volume *v, ts_v3 at[4])
{
	at[0] = uniform3(-3, 3);
	ts_v3 middle = ts_mad(at[0], unit3(), uniform(0.5f, 5));
	f32 size = uniform_power(-6, 1);
	for (u32 k = 1; k < 4; k++) at[k] = ts_mad(middle, uniform3(-1, 1), size);
	*v = (volume){.light = d3_of(at[0]), .times = uniform(2, 20)};
	for (u32 k = 0; k < 3; k++) v->corner[k] = d3_of(at[k + 1]);
}

static f32 shadow_distance(const volume *v, const ts_v3 at[4], ts_v3 eye)
{
	return ts_k_shadow_distance(eye, at[0], at[1], at[2], at[3], (f32)v->times);
}

/* Never beyond any point of the volume, and not far below the nearest that is found. */
static void distances_never_pass_the_shadow_volume(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_outside = 0;
	for (u32 i = 0; i < N_DISTANCES; i++) {
		volume v;
		ts_v3 at[4], eye = uniform3(-8, 8);
		random_volume(&v, at);
		double d = shadow_distance(&v, at, eye);
		if (d == 0) v.times = 1000; /* what lies behind the far end counts as in the shadow */
		double least = distance_by_search(&v, d3_of(eye));
		assert_true(d <= least * (1 + 1e-4) + 1e-4);
		assert_true(d >= least * 0.97 - 0.02);
		n_outside += d > 0;
	}
	assert_true(n_outside > N_DISTANCES / 2);
}

/* 0 in the shadow; between light and triangle, and beside, not. */
static void inside_the_shadow_the_distance_is_zero(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < N_VOLUMES; i++) {
		volume v;
		ts_v3 at[4];
		double w[3], sum;
		random_volume(&v, at);
		d3 n = d3_cross(d3_sub(v.corner[1], v.corner[0]), d3_sub(v.corner[2], v.corner[0]));
		double thick = fabs(d3_dot(n, d3_sub(v.corner[0], v.light)));
		if (thick < 1e-3 * d3_length(n)) continue;
		random_weights(&v, w);
		sum = w[0] + w[1] + w[2];
		bool well_in = fmin(w[0], fmin(w[1], w[2])) > sum * 1e-2 && sum > 1.02;
		d3 in = in_volume(&v, w), out = v.light;
		for (u32 k = 0; k < 3; k++) out = d3_mad(out, d3_sub(v.corner[k], v.light), w[k] / sum * 0.9);
		if (well_in) assert_true(shadow_distance(&v, at, ts_v3_make((f32)in.x, (f32)in.y, (f32)in.z)) == 0);
		assert_true(shadow_distance(&v, at, ts_v3_make((f32)out.x, (f32)out.y, (f32)out.z)) > 0);
	}
}

/* A view from a light straight at a point, with a focal length of 512: there iVIR's exact rate is 512 / distance where
 * the triangle faces it. */
static void aim(ts_offscreen views[6], ts_v3 light, ts_v3 at)
{
	for (u32 k = 0; k < 6; k++) {
		views[k] = view_from(light, ts_normalize(ts_sub(light, at)), 1, 1024, 20 / TS_FAR_OF_NEAR, 0);
	}
}

static ts_density_args arguments(const ts_offscreen *views, u32 n_lights, const ts_view *eye, u32 rate, u32 shadow)
{
	return (ts_density_args){
		.view = eye, .views = views, .n_views = 6 * n_lights, .n_words = 2, .rate = rate, .shadow = shadow};
}

/* The greatest need of any receiver behind a small occluder, up to 20 from the light. */
static double need_behind(d3 light, d3 occluder, d3 eye, double focal)
{
	d3 way = d3_sub(occluder, light);
	double to = d3_length(way), most = 0;
	for (u32 i = 0; i < 400; i++) {
		double along = to * pow(20 / to, i / 399.0);
		double from_eye = d3_length(d3_sub(d3_mad(light, way, along / to), eye));
		most = fmax(most, focal / from_eye * along / to);
	}
	return most;
}

/* FIGURES 6: of 3000 set-ups the paper's rate is below the need in 85.8 %, on average 0.56 of iVIR's; the one in pixels
 * in 53.6 %, 0.80 of it; the safe one never. */
static void rates_fall_short_as_figured(void **state)
{
	(void)state;
	n_random = 0;
	u32 below[4] = {0};
	double share[4] = {0};
	const u64 words[2] = {1, 0};
	for (u32 i = 0; i < N_RATES; i++) {
		ts_offscreen views[6];
		ts_view eye = {.focal = 935.3074f};
		ts_v3 way = unit3(), middle = ts_scale(way, uniform(0.5f, 5)), e = ts_scale(unit3(), uniform(1, 8));
		aim(views, ts_v3_make(0, 0, 0), middle);
		ts_store3(eye.eye, e);
		ts_v3 u = ts_normalize(ts_cross(way, unit3())), v = ts_cross(way, u);
		ts_v3 b = ts_mad(middle, u, 0.0009765625f), c = ts_mad(middle, v, 0.0009765625f);
		double cap = 512 / ts_length(middle);
		double need = need_behind((d3){0, 0, 0}, d3_of(middle), d3_of(e), eye.focal);
		for (u32 shadow = TS_SHADOW_SAFE; shadow <= TS_SHADOW_PAPER; shadow++) {
			ts_density_args args = arguments(views, 1, &eye, RATE_IS_EXACT, shadow);
			double s = ts_k_shadow_density(&args, words, middle, b, c).s;
			assert_true(s <= cap * 1.001);
			below[shadow] += s < fmin(need, cap) * 0.999;
			share[shadow] += s / cap / N_RATES;
		}
	}
	assert_int_equal(below[TS_SHADOW_SAFE], 0);
	assert_true(fabs(below[TS_SHADOW_PAPER] / (double)N_RATES - 0.858) < 0.02);
	assert_true(fabs(below[TS_SHADOW_UNIT] / (double)N_RATES - 0.536) < 0.03);
	assert_true(fabs(share[TS_SHADOW_PAPER] - 0.559) < 0.02 && fabs(share[TS_SHADOW_UNIT] - 0.795) < 0.02);
}

/* Of triangles of any size and two lights, of whose views they see any: no detail of an occluder that a receiver shows
 * the eye needs more than the safe rate, but for what iVIR gives at most; and none of the rates is more than that. */
static void no_detail_exceeds_the_safe_rate(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_less = 0;
	for (u32 i = 0; i < N_TRIANGLES; i++) {
		ts_offscreen views[12];
		ts_view eye = {.focal = uniform_power(4, 10)};
		ts_v3 light[2] = {uniform3(-2, 2), uniform3(-2, 2)}, corner[3], e = uniform3(-6, 6);
		for (u32 l = 0; l < 2; l++) aim(views + 6 * l, light[l], uniform3(-4, 4));
		ts_store3(eye.eye, e);
		random_corners(corner, 4, 0.01f, 2);
		u64 words[2] = {0};
		words[0] = i % 3 == 0 ? 1 : i % 3 == 1 ? 1 << 6 : 65;
		ts_density_args args = arguments(views, 2, &eye, TS_RATE_WATERTIGHT, TS_SHADOW_SAFE);
		double most = ts_k_view_density(&args, words, corner[0], corner[1], corner[2]).s;
		double s = ts_k_shadow_density(&args, words, corner[0], corner[1], corner[2]).s;
		for (u32 k = 0; k < N_RECEIVERS; k++) {
			u32 l = words[0] == 65 ? k % 2 : words[0] == 1 ? 0 : 1;
			const u64 own[2] = {1UL << (6 * l), 0};
			double cap = ts_k_view_density(&args, own, corner[0], corner[1], corner[2]).s;
			volume v = {d3_of(light[l]), {d3_of(corner[0]), d3_of(corner[1]), d3_of(corner[2])}, 3};
			double w[3];
			random_weights(&v, w);
			double times = w[0] + w[1] + w[2];
			d3 receiver = in_volume(&v, w), detail = d3_mad(v.light, d3_sub(receiver, v.light), 1 / times);
			double to = d3_length(d3_sub(detail, v.light)), from = d3_length(d3_sub(receiver, d3_of(e)));
			assert_true(s >= fmin(eye.focal * times / fmax(from, 1e-3 * to), cap) * 0.999);
		}
		assert_true(s <= most);
		n_less += s < most * 0.999;
		args.shadow = TS_SHADOW_PAPER;
		assert_true(ts_k_shadow_density(&args, words, corner[0], corner[1], corner[2]).s <= most);
	}
	assert_true(n_less > N_TRIANGLES / 20);
}

/* Who is seen by nobody needs nothing; a sharp eye needs what iVIR gives, to the bit, and through the dispatch. */
static void a_sharp_eye_needs_what_ivir_gives(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < N_VOLUMES; i++) {
		ts_offscreen views[6];
		ts_view eye = {.focal = 1e6f};
		ts_v3 corner[3];
		random_corners(corner, 4, 0.01f, 2);
		aim(views, uniform3(-2, 2), corner[0]);
		ts_store3(eye.eye, uniform3(-6, 6));
		const u64 words[2] = {077, 0}, none[2] = {0, 0};
		ts_density_args args = arguments(views, 1, &eye, TS_RATE_WATERTIGHT, TS_SHADOW_NONE);
		f32 ivir = ts_k_need(&args, words, corner[0], corner[1], corner[2]).s;
		args.shadow = TS_SHADOW_SAFE;
		assert_true(ts_k_need(&args, words, corner[0], corner[1], corner[2]).s == ivir);
		for (; args.shadow <= TS_SHADOW_PAPER; args.shadow++) {
			assert_true(ts_k_need(&args, none, corner[0], corner[1], corner[2]).s == 0);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(distances_never_pass_the_shadow_volume),
		cmocka_unit_test(inside_the_shadow_the_distance_is_zero),
		cmocka_unit_test(rates_fall_short_as_figured),
		cmocka_unit_test(no_detail_exceeds_the_safe_rate),
		cmocka_unit_test(a_sharp_eye_needs_what_ivir_gives),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
