/* Nearest neighbours against all distances, on clouds with many equal distances and equal points. */
#include <omp.h>
#include <unistd.h>
#include "scene/neighbours.h"
#include "tests/model/test.h"

static f32 coordinate(u32 i, u32 axis, u32 steps)
{
	u32 h = ts_random(i, axis, 7);
	return steps == 0 ? ts_uniform(h) : (f32)(h % steps);
}

/* steps: places an axis has, so that few of them make many equal points; 0: any */
static ts_v3 *cloud(u32 n, u32 steps)
{
	ts_v3 *p = malloc((n + 1) * sizeof *p);
	assert_non_null(p);
	for (u32 i = 0; i < n; i++)
		p[i] = ts_v3_make(coordinate(i, 0, steps), coordinate(i, 1, steps), coordinate(i, 2, steps));
	return p;
}

static int compare(const void *a, const void *b)
{
	const ts_neighbour *x = a, *y = b;
	if (x->square != y->square) return x->square < y->square ? -1 : 1;
	return x->index < y->index ? -1 : x->index > y->index;
}

static u32 all_distances(const ts_v3 *p, u32 n, u32 i, ts_neighbour *found)
{
	u32 m = 0;
	for (u32 j = 0; j < n; j++) {
		ts_v3 d = ts_sub(p[j], p[i]);
		if (j != i) found[m++] = (ts_neighbour){ts_dot(d, d), j};
	}
	qsort(found, m, sizeof *found, compare);
	return m;
}

static void the_nearest_are_found(void **state)
{
	(void)state;
	static const u32 sizes[] = {1, 2, 8, 9, 17, 200, 1000}, steps[] = {0, 1, 2, 5, 30}, ks[] = {1, 2, 8, 64};
	static ts_neighbour expected[1000];
	for (u32 s = 0; s < sizeof sizes / sizeof *sizes; s++) {
		for (u32 c = 0; c < sizeof steps / sizeof *steps; c++) {
			ts_v3 *p = cloud(sizes[s], steps[c]);
			ts_neighbours *tree = ts_neighbours_new(p, sizes[s]);
			assert_non_null(tree);
			for (u32 i = 0; i < sizes[s]; i++) {
				u32 m = all_distances(p, sizes[s], i, expected), k = ks[i % 4];
				ts_neighbour found[TS_MAX_NEIGHBOURS];
				assert_int_equal(ts_neighbours_find(tree, i, k, found), m < k ? m : k);
				if (memcmp(found, expected, (m < k ? m : k) * sizeof *found) != 0)
					fail_msg("%u points, %u places an axis, point %u: not its %u nearest", sizes[s], steps[c], i, k);
			}
			ts_neighbours_free(tree);
			free(p);
		}
	}
}

static void the_distance_is_the_mean_and_needs_no_thread(void **state)
{
	(void)state;
	enum { N = 500, K = 6 };
	static f32 one[N], four[N];
	static ts_neighbour all[N];
	ts_v3 *p = cloud(N, 0);
	omp_set_num_threads(1);
	assert_int_equal(ts_neighbours_distance(one, p, N, K), TS_OK);
	omp_set_num_threads(4);
	assert_int_equal(ts_neighbours_distance(four, p, N, K), TS_OK);
	assert_memory_equal(one, four, sizeof one);
	for (u32 i = 0; i < N; i++) {
		f32 sum = 0.0f;
		all_distances(p, N, i, all);
		for (u32 k = 0; k < K; k++) sum += ts_sqrt(all[k].square);
		assert_true(one[i] == sum / 6.0f);
	}
	free(p);
}

static void points_alone_or_in_one_place_have_no_distance(void **state)
{
	(void)state;
	f32 distance[3] = {9.0f, 9.0f, 9.0f};
	ts_v3 p[3] = {{1.0f, 2.0f, 3.0f}, {1.0f, 2.0f, 3.0f}, {1.0f, 2.0f, 3.0f}};
	assert_int_equal(ts_neighbours_distance(distance, p, 1, 8), TS_OK);
	assert_true(distance[0] == 0.0f);
	assert_int_equal(ts_neighbours_distance(distance, p, 3, 8), TS_OK);
	assert_true(distance[2] == 0.0f);
	assert_int_equal(ts_neighbours_distance(distance, p, 0, 8), TS_OK);
}

/* What a file of nothing but zeros would ask for. */
static void a_heap_of_equal_points_takes_no_time(void **state)
{
	(void)state;
	enum { N = 200000 };
	ts_v3 *p = cloud(N, 1);
	f32 *distance = malloc(N * sizeof *distance);
	alarm(60);
	assert_int_equal(ts_neighbours_distance(distance, p, N, 64), TS_OK);
	alarm(0);
	assert_true(distance[N - 1] == 0.0f);
	free(distance);
	free(p);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_nearest_are_found),
		cmocka_unit_test(the_distance_is_the_mean_and_needs_no_thread),
		cmocka_unit_test(points_alone_or_in_one_place_have_no_distance),
		cmocka_unit_test(a_heap_of_equal_points_takes_no_time),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
