/* Views from the middles of cubes: where they are, and their maps as cubes: the colour of each texel against the
 * direction of OpenGL's table and the stereographic map, in double precision. */
#include <string.h>
#include "kernels/raster/mip.h"
#include "kernels/views/cube_view.h"
#include "tests/kernels/seeded.h"

enum { N_CUBES = 3, SIDE = 32, MAP = 2 * SIDE * SIDE };

static const u32 sides[N_CUBES] = {16, 0, 48};

static void make_cubes(ts_face *cubes)
{
	u64 offset = 0;
	memset(cubes, 0, N_CUBES * sizeof *cubes);
	for (u32 i = 0; i < N_CUBES; i++) {
		ts_store3(cubes[i].centre, uniform3(-5, 5));
		cubes[i].n = sides[i];
		cubes[i].offset = offset;
		offset += 6u * sides[i] * sides[i];
	}
}

static void views_stand_in_the_middles_of_cubes(void **state)
{
	(void)state;
	ts_face cubes[N_CUBES];
	ts_vpl views[N_CUBES];
	make_cubes(cubes);
	memset(views, 0xff, sizeof views);
	const ts_cube_view_args args = {.cubes = cubes, .views = views};
	for (u32 i = 0; i < N_CUBES; i++) ts_k_cube_view_item(&args, i);
	for (u32 i = 0; i < N_CUBES; i++) {
		ts_vpl expected = {.bounce = 0};
		memcpy(expected.position, cubes[i].centre, sizeof expected.position);
		assert_memory_equal(&views[i], &expected, sizeof expected);
	}
}

/* Of (s, t) in [-1, 1] of a face: major axis, and where s and t point. */
static void direction_of(u32 face, double s, double t, double d[3])
{
	double sign = face % 2 == 0 ? 1 : -1;
	d[face / 2] = sign;
	if (face / 2 == 0) d[2] = -sign * s, d[1] = -t;
	if (face / 2 == 1) d[0] = s, d[2] = sign * t;
	if (face / 2 == 2) d[0] = sign * s, d[1] = -t;
}

/* The texel of a direction; false: too near to another. */
static bool texel_of(const double d[3], u32 *texel)
{
	double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), divisor = length + fabs(d[0]);
	double x = (d[1] / divisor + 1) / 2 * SIDE, y = (d[2] / divisor + 1) / 2 * SIDE;
	if (fabs(x - round(x)) < 1e-4 || fabs(y - round(y)) < 1e-4 || fabs(d[0]) < 1e-6) return false;
	*texel = ((d[0] < 0 ? SIDE : 0) + (u32)y) * SIDE + (u32)x;
	return true;
}

/* The texels of a batch of cubes; the element of each colour tells its place. */
static u32 check(const ts_face *cubes, u32 first, u32 n_cubes)
{
	static f32 colours[N_CUBES * MAP * 3], mip[4 * 6 * 48 * 48 * 3];
	u32 n_decided = 0;
	for (u32 i = 0; i < N_CUBES * MAP * 3; i++) colours[i] = (f32)i;
	memset(mip, 0, sizeof mip);
	const ts_cube_view_mip_args args = {
		.to = {.cubes = cubes, .mip = mip, .first_cube = first, .n_cubes = n_cubes}, .colours = colours, .n = SIDE};
	for (u32 r = first; r < first + n_cubes; r++) {
		u32 n = cubes[r].n, texel;
		for (u32 i = 0; i < 6 * n * n; i++) {
			double d[3], s = (2.0 * (i % n) + 1) / n - 1, t = (2.0 * (i / n % n) + 1) / n - 1;
			ts_k_cube_view_mip_item(&args, cubes[r].offset - cubes[first].offset + i);
			const f32 *found = mip + 4 * (ts_k_mip_first(cubes, first, r) + i);
			direction_of(i / (n * n), s, t, d);
			assert_true(found[3] == 1);
			if (!texel_of(d, &texel)) continue;
			for (u32 c = 0; c < 3; c++) assert_true(found[c] == (f32)(((u64)r * MAP + texel) * 3 + c));
			n_decided++;
		}
	}
	return n_decided;
}

static void each_texel_shows_its_direction(void **state)
{
	(void)state;
	ts_face cubes[N_CUBES];
	make_cubes(cubes);
	assert_true(check(cubes, 0, N_CUBES) > 6 * (16 * 16 + 48 * 48) * 9 / 10);
	assert_true(check(cubes, 2, 1) > 6 * 48 * 48 * 9 / 10);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(views_stand_in_the_middles_of_cubes),
	                                   cmocka_unit_test(each_texel_shows_its_direction)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
