/* Closest points without branches are on the triangle, whatever numbers its sides and the point gave. */
#include "backends/c/points/closest_lanes.h"
#include "tests/kernels/points/mesh.h"

enum { SMALL = 7, N = 3000000 };

/* Of corners (0, 0), (1, 0) and (0, 1). */
static void check(ts_side_dots d)
{
	ts_v3 a = ts_v3_make(0, 0, 0), b = ts_v3_make(1, 0, 0), c = ts_v3_make(0, 1, 0);
	ts_v3 p = ts_closest_by_dots(d, a, b, c, b, c);
	if (!(p.x >= 0 && p.y >= 0 && p.x + p.y <= 1.0000005f)) {
		fail_msg("%a, %a, %a, %a, %a, %a: (%a, %a)", (double)d.d1, (double)d.d2, (double)d.d3, (double)d.d4,
		         (double)d.d5, (double)d.d6, (double)p.x, (double)p.y);
	}
}

static void small_numbers_stay_on_the_triangle(void **state)
{
	(void)state;
	u32 n = 1;
	for (u32 k = 0; k < 6; k++) n *= SMALL;
	for (u32 i = 0; i < n; i++) {
		f32 of[6];
		u32 rest = i;
		for (u32 k = 0; k < 6; k++) {
			of[k] = (f32)(rest % SMALL) - SMALL / 2;
			rest /= SMALL;
		}
		check((ts_side_dots){of[0], of[1], of[2], of[3], of[4], of[5]});
	}
}

/* Half of the numbers have any magnitude. The others differ from `beside` by a few roundings, as those of a far point
 * do. */
static f32 random_number(f32 beside)
{
	u32 sort = random_bits() % 4;
	f32 size = sort == 0 ? uniform_power(-70, 52) : uniform_power(-24, 0);
	f32 x = random_bits() % 2 == 0 ? size : -size;
	return sort < 2 ? x : beside + x * 0.00000095367431640625f;
}

static void random_numbers_stay_on_the_triangle(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < N; i++) {
		f32 of[6], beside = uniform(-1, 1);
		for (u32 k = 0; k < 6; k++) of[k] = random_number(random_bits() % 2 == 0 ? beside : -beside);
		check((ts_side_dots){of[0], of[1], of[2], of[3], of[4], of[5]});
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(small_numbers_stay_on_the_triangle),
	                                   cmocka_unit_test(random_numbers_stay_on_the_triangle)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
