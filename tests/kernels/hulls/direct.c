/* Light that pixels gather from triangles: against form factors in double precision, all of it in a room of light, none
 * in the sky or from behind, and sums in the order of the triangles. */
#include "kernels/hulls/direct.h"
#include "kernels/raster/patch.h"
#include "tests/kernels/hulls/form_factor_truth.h"
#include "tests/kernels/hulls/room.h"

enum { N_PATCHES = 9, PIXELS = 16, N_WORLDS = 1000, PARTS = 3 };

/* Before a kernel writes. */
#define UNWRITTEN (-7.0f)

static ts_gpixel pixel_of(ts_v3 p, ts_v3 n, f32 depth)
{
	ts_gpixel pixel;
	ts_k_gpixel_store(&pixel, p, depth, n, ts_v3_make(1, 1, 1));
	return pixel;
}

static ts_v3 gather(const ts_patch *patches, u64 n_patches, ts_gpixel pixel)
{
	f32 e[6] = {UNWRITTEN, UNWRITTEN, UNWRITTEN, UNWRITTEN, UNWRITTEN, UNWRITTEN};
	ts_gpixel pixels[2] = {pixel_of(ts_v3_make(0, 0, 0), ts_v3_make(0, 0, 1), 0), pixel};
	ts_direct_args args = {.pixels = pixels, .patches = patches, .irradiance = e, .n_patches = n_patches};
	ts_k_direct_item(&args, 1);
	for (u32 k = 0; k < 3; k++) assert_true(e[k] == UNWRITTEN);
	return ts_load3(e + 3);
}

/* Of the last the exitance is 0, and of the one before everything. */
static void random_patches(ts_patch *patches)
{
	for (u32 k = 0; k < N_PATCHES; k++) {
		patches[k] = (ts_patch){.pad = 0};
		if (k == N_PATCHES - 2) continue;
		ts_v3 p = uniform3(-3, 3), n = direction();
		ts_k_patch_corners(&patches[k], p, n, uniform(0.01f, 4));
		if (k < N_PATCHES - 2) ts_store3(patches[k].exitance, uniform3(0, 2));
	}
}

/* What a surface at p gets of what a triangle sends out, if it is not behind the triangle; and what rounding may do to
 * it, the more the more the triangle is turned away. */
typedef struct {
	double factor, rounding;
} share;

static share share_of(const ts_patch *patch, double3 p, double3 n)
{
	double3 corner[3] = {d3_sub(d3_of(ts_load3(patch->a)), p), d3_sub(d3_of(ts_load3(patch->b)), p),
	                     d3_sub(d3_of(ts_load3(patch->c)), p)};
	double front = -d3_dot(d3_of(ts_load3(patch->normal)), corner[0]);
	if (front == 0) return (share){0, 0};
	return (share){front < 0 ? 0 : ff_factor(n, corner), 1e-7 * d3_length(corner[0]) / fabs(front)};
}

static void light_follows_the_form_factors(void **state)
{
	(void)state;
	double worst = 0;
	u32 n_lit = 0, n_dark = 0;
	for (u32 i = 0; i < N_WORLDS * PIXELS; i++) {
		static ts_patch patches[N_PATCHES];
		ts_v3 p = uniform3(-3, 3), n = direction();
		double right[3] = {0}, factors = 0, rounding = 0;
		if (i % PIXELS == 0) random_patches(patches);
		for (u32 k = 0; k < N_PATCHES; k++) {
			share of = share_of(&patches[k], d3_of(p), d3_of(n));
			for (u32 c = 0; c < 3; c++) right[c] += of.factor * patches[k].exitance[c];
			factors += of.factor;
			rounding += of.rounding;
		}
		ts_v3 e = gather(patches, N_PATCHES, pixel_of(p, n, uniform(0, 0.99f)));
		const double off[3] = {e.x - right[0], e.y - right[1], e.z - right[2]};
		for (u32 c = 0; c < 3; c++) worst = fmax(worst, fabs(off[c]) / rounding);
		n_lit += right[0] > 0.01;
		n_dark += factors == 0;
		if (factors == 0) assert_true(e.x == 0 && e.y == 0 && e.z == 0);
	}
	print_message("# %u lit, %u dark; irradiance within %.2g of what rounding may do\n", n_lit, n_dark, worst);
	assert_true(n_lit > N_WORLDS && n_dark > 0 && worst < 1);
}

/* In a room that shines on all sides every surface gets what a wall sends out, wherever it faces. */
static void a_lit_room_lights_every_side_alike(void **state)
{
	(void)state;
	ts_patch walls[12 * PARTS * PARTS];
	const ts_v3 exitance = ts_v3_make(3, 1, 0.25f);
	room_make(walls, PARTS, exitance);
	for (u32 i = 0; i < 400; i++) {
		ts_v3 p = uniform3(-0.99f, 0.99f), n = direction();
		ts_v3 e = gather(walls, sizeof walls / sizeof *walls, pixel_of(p, n, 0.5f));
		assert_near(e.x, 3, 3e-5);
		assert_near(e.y, 1, 1e-5);
		assert_near(e.z, 0.25, 1e-5);
	}
}

/* None in the sky, wherever it is said to be; there is no other depth that is the sky's. */
static void the_sky_gathers_no_light(void **state)
{
	(void)state;
	ts_patch walls[12];
	const ts_v3 up = ts_v3_make(0, 1, 0);
	room_make(walls, 1, ts_v3_make(1, 1, 1));
	const f32 nearly = ts_u2f(ts_f2u(1) - 1);
	for (u32 i = 0; i < 100; i++) {
		ts_v3 p = i == 0 ? ts_v3_make(0, 0, 0) : uniform3(-0.9f, 0.9f);
		ts_v3 sky = gather(walls, 12, pixel_of(p, i % 2 == 0 ? up : ts_v3_make(0, 0, 0), 1));
		assert_true(same_bits3(sky, ts_v3_make(0, 0, 0)));
		assert_true(gather(walls, 12, pixel_of(p, up, nearly)).x > 0.9f);
		assert_true(gather(walls, 12, pixel_of(p, up, 0)).x > 0.9f);
	}
}

/* Below the pixel's horizon, or turned away from it, a triangle gives nothing at all; and no triangles give nothing. */
static void light_from_behind_gives_nothing(void **state)
{
	(void)state;
	for (u32 i = 0; i < 4000; i++) {
		ts_patch patch = {.pad = 0};
		ts_v3 p = uniform3(-1, 1), n = direction(), aside = ts_cross(n, direction());
		ts_v3 across = ts_mad(p, aside, uniform(-2, 2)), at = ts_mad(across, n, -uniform(0.6f, 2));
		f32 area = uniform(0.01f, 0.4f); /* circumradius below 0.56 */
		ts_k_patch_corners(&patch, at, direction(), area);
		ts_store3(patch.exitance, ts_v3_make(1, 2, 3));
		assert_true(same_bits3(gather(&patch, 1, pixel_of(p, n, 0.5f)), ts_v3_make(0, 0, 0)));
		ts_v3 above = ts_mad(p, n, uniform(0.6f, 2));
		ts_k_patch_corners(&patch, above, n, area);
		assert_true(same_bits3(gather(&patch, 1, pixel_of(p, n, 0.5f)), ts_v3_make(0, 0, 0)));
		ts_k_patch_corners(&patch, above, ts_neg(n), area);
		assert_true(gather(&patch, 1, pixel_of(p, n, 0.5f)).z > 0);
		assert_true(same_bits3(gather(&patch, 0, pixel_of(p, n, 0.5f)), ts_v3_make(0, 0, 0)));
	}
}

/* The sum is that of what each triangle gives alone, in their order and in no other. */
static void light_adds_in_order_of_the_triangles(void **state)
{
	(void)state;
	u32 n_others = 0;
	for (u32 i = 0; i < N_WORLDS; i++) {
		ts_patch patches[N_PATCHES];
		ts_v3 p = uniform3(-3, 3), n = direction(), sum = ts_v3_make(0, 0, 0), back = sum;
		ts_gpixel pixel = pixel_of(p, n, 0.5f);
		random_patches(patches);
		for (u32 k = 0; k < N_PATCHES; k++) {
			sum = ts_add(sum, gather(&patches[k], 1, pixel));
			back = ts_add(back, gather(&patches[N_PATCHES - 1 - k], 1, pixel));
		}
		assert_true(same_bits3(gather(patches, N_PATCHES, pixel), sum));
		n_others += !same_bits3(sum, back);
	}
	assert_true(n_others > N_WORLDS / 8);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(light_follows_the_form_factors),
		seeded_test(a_lit_room_lights_every_side_alike),
		seeded_test(the_sky_gathers_no_light),
		seeded_test(light_from_behind_gives_nothing),
		seeded_test(light_adds_in_order_of_the_triangles),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
