/* A cube that may still lower a triangle's shortest way by one rounding, or raise its densest need by one, is listed.
 * Of others few are. */
#include "backends/c/points/density_bound.h"
#include "tests/kernels/points/views.h"

enum { PARTS = 4000 };

/* A way from the middle of the cube; often that to the eye, where bounds are tight. */
static ts_v3 random_way(const ts_density_cube *r)
{
	ts_v3 to_eye = ts_normalize(ts_sub(r->eye, r->centre));
	u32 sort = random_bits() % 4;
	if (sort == 0) return to_eye;
	if (sort == 1) return ts_scale(to_eye, -1);
	return sort == 2 ? ts_normalize(ts_mad(to_eye, unit3(), uniform_power(-12, 0))) : unit3();
}

/* Small and large triangles near the cube and far from it, and slivers. */
static void random_part(ts_density_part *p, const ts_density_cube *r, f32 scale)
{
	p->n = 1 + random_bits() % TS_PART;
	for (u32 i = 0; i < p->n; i++) {
		ts_v3 a = ts_mad(r->centre, random_way(r), scale * uniform_power(-8, 2)), along = unit3();
		f32 size = scale * uniform_power(-30, 0), thin = random_bits() % 2 == 0 ? 1 : uniform_power(-16, 0);
		ts_v3 b = ts_mad(a, along, size), c = ts_mad(ts_mad(a, along, size * uniform(0, 1)), unit3(), size * thin);
		ts_v3 corner[3] = {a, b, c};
		for (u32 k = 0; k < 3; k++) {
			p->corner[3 * k][i] = corner[k].x;
			p->corner[3 * k + 1][i] = corner[k].y;
			p->corner[3 * k + 2][i] = corner[k].z;
		}
	}
}

static ts_density_cube random_cube(f32 scale)
{
	ts_density_cube r = {.half_size = 0.5f * (f32)(1 + random_bits() % 512)};
	r.centre = uniform3(-scale, scale);
	r.radius = random_bits() % 8 == 0 ? 0 : scale * uniform_power(-8, 0);
	r.eye = ts_mad(r.centre, unit3(), r.radius + scale * uniform_power(-8, 2));
	r.least = ts_flush(r.radius * 0.0009765625f);
	return r;
}

/* What the kernel finds. */
static void measure(const ts_density_part *p, u32 i, const ts_density_cube *r, f32 *way, f32 *need)
{
	ts_v3 a = ts_part_corner(p, 0, i), b = ts_part_corner(p, 1, i), c = ts_part_corner(p, 2, i);
	f32 distance = ts_length(ts_sub(ts_k_closest_on_triangle(r->centre, a, b, c), r->centre));
	*way = ts_max(ts_k_path_length(r->eye, r->centre, r->radius, a, b, c, false), r->least);
	*need = r->half_size / ts_max(distance, r->least);
}

/* What others told, so that the cube may just change the shortest way alone, the densest need alone, or neither. */
enum { WAY, NEED, NEITHER };

static u32 listed(ts_density_part *p, const ts_density_cube *r, u32 what)
{
	u32 list[TS_PART];
	for (u32 i = 0; i < p->n; i++) {
		f32 way, need;
		measure(p, i, r, &way, &need);
		p->shortest[i] = what == WAY ? nextafterf(way, INFINITY) : what == NEED ? -1 : way / 2;
		p->densest[i] = what == NEED ? nextafterf(need, 0) : what == WAY ? INFINITY : 2 * need;
	}
	return ts_density_may_count(list, p, r);
}

static void cubes_that_may_still_count_are_listed(void **state)
{
	(void)state;
	n_random = 0;
	u64 n_all = 0, n_listed = 0;
	for (u32 k = 0; k < PARTS; k++) {
		ts_density_part p;
		u32 start = n_random;
		f32 scale = random_bits() % 8 == 0 ? uniform_power(-76, -20) : uniform_power(-20, 16);
		ts_density_cube r = random_cube(scale);
		random_part(&p, &r, scale);
		ts_density_begin(&p);
		if (listed(&p, &r, WAY) != p.n) fail_msg("random %u: a shorter way is not listed", start);
		if (listed(&p, &r, NEED) != p.n) fail_msg("random %u: a denser need is not listed", start);
		n_all += p.n;
		n_listed += listed(&p, &r, NEITHER);
	}
	print_message("%.3f listed where others are twice as good\n", (double)n_listed / (double)n_all);
	assert_true((double)n_listed < 0.5 * (double)n_all);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(cubes_that_may_still_count_are_listed)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
