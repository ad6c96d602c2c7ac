/* Views whose pyramid a plane parts from a box by more than rounding are left out; views that have a point of the box
 * in their image never are. */
#include "backends/c/points/view_planes.h"
#include "tests/kernels/seeded.h"

enum { ROUNDS = 400, POINTS = 20 };

static ts_camera_k random_view(void)
{
	ts_camera_k v = {.eye = uniform3(-4, 4), .orthographic = below(2)};
	v.back = direction();
	v.right = ts_normalize(ts_cross(direction(), v.back));
	v.up = ts_cross(v.back, v.right);
	v.width = (i32)(1 + below(512));
	v.height = (i32)(1 + below(512));
	v.focal = v.orthographic != 0 ? uniform(10, 100) : uniform(0.3f, 2) * (f32)v.width;
	v.near = uniform(0.001f, 1);
	return v;
}

static double along(ts_v3 axis, const double p[3])
{
	return (double)axis.x * p[0] + (double)axis.y * p[1] + (double)axis.z * p[2];
}

/* How far a point is inside each of the planes, in pixels but for the last; below 0: outside. */
static void measure(double inside[TS_PLANES], const ts_camera_k *v, const double point[3])
{
	double p[3] = {point[0] - (double)v->eye.x, point[1] - (double)v->eye.y, point[2] - (double)v->eye.z};
	double ahead = -along(v->back, p), share = v->orthographic != 0 ? 1 : ahead;
	for (u32 k = 0; k < 2; k++) {
		double aside = (double)v->focal * along(k == 0 ? v->right : v->up, p);
		double half = 0.5 * (k == 0 ? v->width : v->height) * share;
		inside[2 * k] = half + aside;
		inside[2 * k + 1] = half - aside;
	}
	inside[4] = ahead - (double)v->near;
}

/* Any point of the box, or one of its corners. */
static void point_of(double p[3], const ts_bounds *box, u32 corner)
{
	for (u32 k = 0; k < 3; k++) {
		double at = corner < 8 ? (double)(corner >> k & 1) * 2 - 1 : (double)uniform(-1, 1);
		p[k] = (double)box->middle[k] + at * (double)box->half[k];
	}
}

/* Whether a point tried is in the image, and the plane that parts the box from it; TS_PLANES: none does by far. */
static bool judge(u32 *parted, const ts_camera_k *v, const ts_bounds *box)
{
	double most[TS_PLANES], inside[TS_PLANES], p[3];
	bool seen = false;
	for (u32 k = 0; k < TS_PLANES; k++) most[k] = -INFINITY;
	for (u32 i = 0; i < 8 + POINTS; i++) {
		bool in = true;
		point_of(p, box, i);
		measure(inside, v, p);
		for (u32 k = 0; k < TS_PLANES; k++) {
			most[k] = fmax(most[k], inside[k]);
			in &= inside[k] >= 0;
		}
		seen |= in;
	}
	for (*parted = 0; *parted < TS_PLANES && most[*parted] > (*parted < 4 ? -1 : -0.01); ++*parted) continue;
	return seen;
}

static void boxes_are_parted_from_views_that_miss_them(void **state)
{
	(void)state;
	u32 n_seen = 0, n_parted[TS_PLANES] = {0};
	for (u32 round = 0; round < ROUNDS; round++) {
		ts_view_planes planes = {.views = 0};
		ts_camera_k views[TS_GROUP];
		ts_bounds box;
		for (u32 i = 0; i < TS_GROUP; i++) {
			views[i] = random_view();
			ts_view_planes_set(&planes, i, &views[i]);
		}
		for (u32 k = 0; k < 3; k++) {
			box.middle[k] = uniform(-6, 6);
			box.half[k] = below(4) == 0 ? 0 : uniform(0, 1);
		}
		assert_int_equal(planes.views, UINT32_MAX);
		u32 met = ts_view_planes_meet(&planes, &box);
		for (u32 i = 0; i < TS_GROUP; i++) {
			u32 parted;
			bool seen = judge(&parted, &views[i], &box), meets = (met >> i & 1) != 0;
			if (seen) assert_true(meets);
			if (parted < TS_PLANES) assert_false(meets);
			if (parted < TS_PLANES) n_parted[parted]++;
			n_seen += seen;
		}
	}
	assert_true(n_seen > 500);
	for (u32 k = 0; k < TS_PLANES; k++) assert_true(n_parted[k] > 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(boxes_are_parted_from_views_that_miss_them)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
