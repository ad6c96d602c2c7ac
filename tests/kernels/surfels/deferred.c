/* The margins of deferred shading against ports that round otherwise: outlines and tones in double precision, of
 * numbers that are off by up to 4 ulps, each its own way, on a G-buffer whose steps, drops and cosines nearly tie.
 * Whatever that changes is undecided, most is decided, and a port of other thresholds differs where it is. */
#include <string.h>
#include "backends/args.h"
#include "kernels/surfels/deferred_margin.h"
#include "kernels/surfels/surfel_shade.h"
#include "tests/kernels/seeded.h"

enum { SIDE = 48, N = SIDE * SIDE, N_WORLDS = 40 };

typedef struct {
	double step, drop, tone;
} faults; /* of its thresholds */
static const faults none = {1, 1, 1};
static ts_gpixel pixels[N];
static const ts_view view = {.width = SIDE, .height = SIDE};
static const ts_light sun = {.direction = {0, 0, -1}, .intensity = {3, 3, 3}};
static u32 port; /* which way its numbers are off */

static double off_of(double x, double of)
{
	return x + of * (ts_uniform(ts_random(ts_f2u((f32)x), 3, port)) * 2 - 1) / 2097152;
}

static f32 nearly(f32 x)
{
	i32 ulps = (i32)below(5) - 2;
	return x != 0 ? ts_u2f(ts_f2u(x) + (u32)ulps) : (f32)ulps / 8388608;
}

/* The eye is in the origin; each is as deep as another by the step, and as far below it as the drop, or nearly; and
 * some are less near to that. */
static void fill(void)
{
	for (u32 i = 0; i < N; i++) {
		f32 far = 0.25f + 0.125f * (f32)below(4), depth = 1 - far;
		f32 cosine = nearly((f32)below(4) / 3) * (below(4) == 0 ? 0.98f : 1);
		for (u32 k = below(4); k > 0; k--) far = far * (below(4) == 0 ? 0.9675f : 0.96875f);
		if (below(2) == 0) depth = nearly(1 - far);
		ts_v3 n = ts_v3_make(ts_sqrt(ts_max(1 - cosine * cosine, 0)), 0, cosine);
		ts_v3 p = ts_v3_make(0, 0, nearly(-1 - (below(4) == 0 ? 0.008f : 0.0078125f) * (f32)below(4)));
		pixels[i] = (ts_gpixel){.depth = below(8) == 0 ? 1 : depth};
		if (below(3) == 0) n = ts_v3_make(0, 0, 1);
		ts_store3(pixels[i].position, p);
		ts_store3(pixels[i].normal, n);
		ts_store3(pixels[i].albedo, ts_v3_make(1, 1, 1));
	}
}

static bool ends(const ts_gpixel *at, i32 x, i32 y, const faults *how)
{
	if (x < 0 || y < 0 || x >= SIDE || y >= SIDE) return false;
	const ts_gpixel *next = &pixels[y * SIDE + x];
	double near = 1 - (double)at->depth, z = at->position[2];
	double farther = off_of(near - (1 - (double)next->depth), near);
	double lower = off_of((z - (double)next->position[2]) * (double)at->normal[2], -z);
	return farther > how->step * near / 32 && (next->depth == 1 || lower > how->drop * -z / 128);
}

/* Red, of white. */
static double paint(u32 i, bool npr, const faults *how)
{
	const ts_gpixel *at = &pixels[i];
	i32 x = (i32)(i % SIDE), y = (i32)(i / SIDE);
	double cosine = off_of(at->normal[2], 1), p = 0.31830988618379067,
		   shine = pow(fmax(2 * cosine * cosine - 1, 0), 32) / 4;
	bool outline =
		ends(at, x - 1, y, how) || ends(at, x + 1, y, how) || ends(at, x, y - 1, how) || ends(at, x, y + 1, how);
	if (npr && outline) return 0;
	if (cosine <= 0) return 0.25;
	return 0.25 + 3 * p * (npr ? fmin(floor(cosine * 3 * how->tone + 1), 3) / 3 : cosine + shine);
}

typedef struct {
	u32 n, undecided, differ, wrong;
} sums;

static void check(sums *r, bool npr, const faults *how)
{
	static f32 radiance[3 * N], margin[N];
	static u8 srgb[3 * N];
	i64 tally = 0;
	ts_deferred_args args = {.view = &view,
	                         .pixels = pixels,
	                         .lights = &sun,
	                         .radiance = radiance,
	                         .srgb = srgb,
	                         .tally = &tally,
	                         .n_lights = 1,
	                         .npr = npr,
	                         .ambient = 0.25f,
	                         .exposure = 1};
	ts_deferred_margin_args margins = {.of = args, .margin = margin};
	fill();
	for (u32 i = 0; i < N; i++) {
		ts_k_deferred_item(&args, i);
		ts_k_deferred_margin_item(&margins, i);
		if (pixels[i].depth == 1) continue;
		bool differs = fabs(paint(i, npr, how) - (double)radiance[3 * i]) > 1e-3, undecided = margin[i] <= 1;
		r->n++;
		r->undecided += undecided;
		r->differ += differs;
		r->wrong += differs && !undecided;
	}
}

static void rounding_differs_only_where_undecided(void **state)
{
	(void)state;
	sums r = {0, 0, 0, 0}, phong = {0, 0, 0, 0};
	for (port = 0; port < N_WORLDS; port++) check(&r, true, &none);
	for (port = 0; port < N_WORLDS; port++) check(&phong, false, &none);
	print_message("# of %u pixels %u undecided, %u differ, %u of these decided\n", r.n, r.undecided, r.differ, r.wrong);
	assert_true(r.wrong == 0 && r.differ > 1000 && r.undecided < r.n / 2);
	assert_true(phong.wrong == 0);
}

static void wrong_thresholds_differ_where_decided(void **state)
{
	(void)state;
	static const faults all[] = {{1.05, 1, 1}, {1, 1.05, 1}, {1, 1, 1.05}};
	for (u32 i = 0; i < sizeof all / sizeof *all; i++) {
		sums r = {0, 0, 0, 0};
		for (port = 0; port < 4; port++) check(&r, true, &all[i]);
		if (r.wrong == 0) fail_msg("fault %u is not found", (unsigned)i);
	}
}

/* Each light alone, without ambient light, gives what it adds. Three of them and the ambient light add from the left,
 * which no other order does everywhere with the same bits (CONTRACT rule 39). */
enum { LIGHTS = 3 };
static ts_light lights[LIGHTS];

static void fill_lights(void)
{
	for (u32 k = 0; k < LIGHTS; k++) {
		ts_v3 d = ts_normalize(ts_v3_make(uniform(-1, 1), uniform(-1, 1), -2));
		lights[k] = (ts_light){.kind = TS_LIGHT_KIND_DIRECTIONAL};
		ts_store3(lights[k].direction, d);
		ts_store3(lights[k].intensity, uniform3(0.01f, 0.1f));
	}
}

static ts_v3 lit_by(const ts_light *light, u32 n, f32 ambient, u32 i)
{
	static f32 radiance[3 * N];
	static u8 srgb[3 * N];
	i64 tally = 0;
	ts_deferred_args args = {.view = &view,
	                         .pixels = pixels,
	                         .lights = light,
	                         .radiance = radiance,
	                         .srgb = srgb,
	                         .tally = &tally,
	                         .n_lights = n,
	                         .ambient = ambient,
	                         .exposure = 1};
	ts_k_deferred_item(&args, i);
	return ts_load3(radiance + 3 * i);
}

static ts_v3 surfel_lit_by(const ts_light *light, u32 n, f32 ambient, u32 i)
{
	ts_surfel surfel = {.colour = {1, 1, 1}};
	ts_surfel_shade_args args = {
		.of = {.surfels = &surfel}, .lights = light, .n_lights = n, .ambient = ambient, .exposure = 1};
	const ts_camera_k at_origin = ts_k_view(&view);
	ts_shading_place at = {ts_load3(pixels[i].position), ts_load3(pixels[i].normal)};
	ts_attributes r = ts_k_shaded_colour(&args, &at_origin, 0, &at);
	return ts_v3_make(r.value[0], r.value[1], r.value[2]);
}

static void check_order(ts_v3 (*by)(const ts_light *light, u32 n, f32 ambient, u32 i))
{
	u32 n_telling = 0;
	for (u32 run = 0; run < 20; run++) {
		fill();
		fill_lights();
		for (u32 i = 0; i < N; i++) {
			if (pixels[i].depth == 1) continue;
			f32 ambient = by(lights, 0, 0.1f, i).x, own[LIGHTS];
			for (u32 k = 0; k < LIGHTS; k++) own[k] = by(&lights[k], 1, 0, i).x;
			f32 sum = by(lights, LIGHTS, 0.1f, i).x;
			assert_true(sum == ((ambient + own[0]) + own[1]) + own[2]);
			n_telling += sum != ((ambient + own[2]) + own[1]) + own[0];
		}
	}
	assert_true(n_telling > 1000);
}

static void lights_add_in_their_own_order(void **state)
{
	(void)state;
	check_order(lit_by);
	check_order(surfel_lit_by);
}

static void pointers_inside_structs_are_found_by_path(void **state)
{
	(void)state;
	const ts_pointers *p = ts_kernel_pointers(TS_KERNEL_deferred_lit_margin);
	u32 i = 0;
	while (i < p->n && strcmp(p->pointer[i].name, "of.of.scene.vertices") != 0) i++;
	assert_true(i < p->n);
	assert_true(p->pointer[i].offset == offsetof(ts_deferred_lit_margin_args, of.of.scene.vertices));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(rounding_differs_only_where_undecided), seeded_test(wrong_thresholds_differ_where_decided),
		seeded_test(lights_add_in_their_own_order), seeded_test(pointers_inside_structs_are_found_by_path)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
