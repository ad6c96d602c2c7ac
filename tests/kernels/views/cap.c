/* Texels of dual-paraboloid maps that balls cover, against the angle between a texel's middle and the ball in double
 * precision: far balls, near balls, and those that the view is in. A coarse texel is inside only if all finer ones are,
 * and nothing is inside that the box leaves out. */
#include "kernels/views/cap.h"
#include "tests/kernels/seeded.h"

enum { N_BALLS = 600, LEVELS = 5 };

static const u32 sides[] = {4, 16, 64, 1024};

typedef struct {
	ts_v3 vs;
	f32 radius;
	u32 n;
	ts_cap cap[2]; /* front, back */
} ball;

/* Some about an axis, so that one of the maps sees them from behind. */
static ball ball_of(u32 i)
{
	ball r = {.n = sides[i % 3]};
	ts_v3 way = direction();
	if (i % 4 == 0) way = ts_normalize(ts_v3_make(way.x < 0 ? -1 : 1, 0.1f * way.y, 0.1f * way.z));
	r.vs = ts_scale(way, uniform(0.01f, 100));
	r.radius = ts_length(r.vs) * (i % 5 == 0 ? uniform(0.8f, 1.4f) : uniform(0.005f, 0.6f));
	for (u32 k = 0; k < 2; k++) r.cap[k] = ts_k_cap(r.vs, r.radius, k == 1);
	return r;
}

/* The middle of a texel, ((1 - u^2 - v^2), 2 u, 2 v) by their length, the back's x turned. */
static double3 middle_of(u32 column, u32 row, u32 n, bool back)
{
	double u = (2.0 * column + 1) / n - 1, v = (2.0 * row + 1) / n - 1, s = u * u + v * v;
	return d3_scale((double3){back ? s - 1 : 1 - s, 2 * u, 2 * v}, 1 / (1 + s));
}

/* How far inside the ball's cap a direction is, in cosines; 1 where the view is in the ball. */
static double inside(const ball *b, double3 way)
{
	double3 vs = d3_of(b->vs);
	double d = d3_length(vs), sine = (double)b->radius / d;
	return sine < 1 ? d3_dot(way, vs) / d - sqrt(1 - sine * sine) : 1;
}

static void texels_inside_a_ball_match_angles(void **state)
{
	(void)state;
	u32 n_sure = 0, n_all = 0, n_inside = 0;
	for (u32 i = 0; i < N_BALLS; i++) {
		ball b = ball_of(i);
		for (u32 t = 0; t < 2 * b.n * b.n; t++) {
			u32 column = t % b.n, row = t / b.n % b.n, back = t / (b.n * b.n);
			double expected = inside(&b, middle_of(column, row, b.n, back == 1));
			f32 found = ts_k_cap_inside(&b.cap[back], b.n, 0, column, row);
			n_all++;
			n_inside += found >= 0;
			if (fabs(expected) < 1e-5) continue;
			n_sure++;
			assert_true((found >= 0) == (expected > 0));
		}
	}
	assert_true(n_sure > n_all / 1000 * 995 && n_inside > n_all / 20);
}

/* Of the texels below a coarse one. */
static bool are_inside(const ball *b, u32 back, u32 level, u32 column, u32 row)
{
	for (u32 j = 0; j < 1u << level; j++) {
		for (u32 i = 0; i < 1u << level; i++) {
			u32 x = (column << level) + i, y = (row << level) + j;
			if (!(ts_k_cap_inside(&b->cap[back], b->n, 0, x, y) >= 0)) return false;
		}
	}
	return true;
}

/* Hardly a coarse texel is missed: only where the cap has the map's pole in it, or rounding might decide. */
static void coarse_texels_need_all_finer_ones_inside(void **state)
{
	(void)state;
	u32 n_coarse = 0, n_missed = 0;
	for (u32 i = 0; i < N_BALLS; i++) {
		ball b = ball_of(i);
		for (u32 level = 1; level < LEVELS && b.n >> level > 0; level++) {
			for (u32 t = 0; t < 2 * (b.n >> level) * (b.n >> level); t++) {
				u32 side = b.n >> level, back = t / (side * side), column = t % side, row = t / side % side;
				bool found = ts_k_cap_inside(&b.cap[back], b.n, level, column, row) >= 0;
				bool expected = are_inside(&b, back, level, column, row);
				assert_true(expected || !found);
				n_coarse += expected && b.cap[back].b > 0;
				n_missed += expected && b.cap[back].b > 0 && !found;
			}
		}
	}
	assert_true(n_coarse > 10000 && n_missed < n_coarse / 100);
}

/* Boxes of circles are no wider than these, but for the texels at their ends. */
static void boxes_leave_out_nothing_inside(void **state)
{
	(void)state;
	u32 n_narrow = 0;
	for (u32 i = 0; i < N_BALLS; i++) {
		ball b = ball_of(i);
		for (u32 t = 0; t < 2 * b.n * b.n; t++) {
			u32 back = t / (b.n * b.n);
			i32 column = (i32)(t % b.n), row = (i32)(t / b.n % b.n);
			ts_cap_box box = ts_k_cap_box(&b.cap[back], b.n);
			bool there = column >= box.x.from && column < box.x.to && row >= box.y.from && row < box.y.to;
			if (!there) assert_true(ts_k_cap_inside(&b.cap[back], b.n, 0, (u32)column, (u32)row) < 0);
		}
		bool back = b.vs.x < 0;
		ts_cap_box own = ts_k_cap_box(&b.cap[back], b.n), other = ts_k_cap_box(&b.cap[!back], b.n);
		double wide = (double)b.n * (double)b.radius / (double)b.cap[back].b;
		if (b.cap[back].b > 0) assert_true(own.x.to - own.x.from <= wide + 2 && own.y.to - own.y.from <= wide + 2);
		n_narrow += other.x.to <= other.x.from || other.y.to <= other.y.from;
	}
	assert_true(n_narrow > N_BALLS / 4);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(texels_inside_a_ball_match_angles),
	                                   seeded_test(coarse_texels_need_all_finer_ones_inside),
	                                   seeded_test(boxes_leave_out_nothing_inside)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
