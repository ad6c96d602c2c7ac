/* Who took which texels: keys offered to a buffer of depths, nearer and farther than what it holds by known steps,
 * against counts of their own. */
#include "methods/points/tools/probe.h"
#include "tests/probe/probed.h"

#define FACE TS_B_cube_face_depth_triangle
enum { MOST_RIVALS = 8 };

static traced mvr;

static int begin(void **state)
{
	(void)state;
	ts_params params = small_params(96, 64);
	params.reflectors_count = 1;
	params.reflectors_px = 40;
	make(&mvr, "reflections", "mvr", &params);
	return 0;
}

static int finish(void **state)
{
	(void)state;
	drop(&mvr);
	return 0;
}

/* What each triangle of the scene took, by its number. */
static ts_rival *count_rivals(const u64 *held, const u64 *alone, u64 n)
{
	ts_rival *rivals = calloc(mvr.scene->n_triangles, sizeof *rivals);
	assert_non_null(rivals);
	for (u64 i = 0; i < n; i++) {
		u32 ours = (u32)(alone[i] >> 32), theirs = (u32)(held[i] >> 32);
		if (alone[i] == TS_EMPTY || ours < theirs) continue;
		ts_rival *r = &rivals[(u32)held[i]];
		f32 gap = ts_u2f(ours) - ts_u2f(theirs);
		if (r->texels == 0 || gap < r->least) r->least = gap;
		if (r->texels == 0 || ours - theirs < r->least_ulps) r->least_ulps = ours - theirs;
		r->texels++;
		r->ties += ours == theirs;
	}
	return rivals;
}

/* A triangle of number n_triangles, which the scene does not have, 3 ulps nearer to 6 ulps behind what is held. */
static void offer(u64 *alone, const u64 *held, u64 n, u32 triangle)
{
	for (u64 i = 0; i < n; i++) {
		u64 depth = (held[i] >> 32) + below(10) - 3;
		alone[i] = held[i] == TS_EMPTY || below(4) == 0 ? TS_EMPTY : depth << 32 | triangle;
	}
}

static void assert_spread(const ts_spread *s, const u64 *held, const u64 *alone, u64 n)
{
	u64 offered = 0, odd = 0, lost = 0, ties = 0;
	for (u64 i = 0; i < n; i++) {
		offered += alone[i] != TS_EMPTY;
		odd += alone[i] != TS_EMPTY && alone[i] >> 32 < held[i] >> 32;
	}
	ts_rival *rivals = count_rivals(held, alone, n);
	for (size_t i = 0; i < s->n_rivals; i++) {
		ts_rival *r = &rivals[s->rival[i].triangle];
		assert_int_equal(s->rival[i].texels, r->texels);
		assert_int_equal(s->rival[i].ties, r->ties);
		assert_int_equal(s->rival[i].least_ulps, r->least_ulps);
		assert_true(s->rival[i].least == r->least);
		lost += r->texels;
		ties += r->ties;
		r->texels = 0; /* each is listed once */
	}
	free(rivals);
	assert_int_equal(s->offered, offered);
	assert_int_equal(s->odd, odd);
	assert_int_equal(s->lost, lost);
	assert_int_equal(s->ties, ties);
	assert_int_equal(s->offered, s->won + s->lost + s->odd);
	assert_int_equal(s->lost_to_own, 0);
}

/* What is put: the eight that took most, in order, the lower triangle first. */
static void assert_put(ts_spread *s)
{
	json_t *o = json_object();
	ts_probe_put_spread(mvr.probe, o, s);
	assert_int_equal(figure(o, "texels_offered"), s->offered);
	assert_int_equal(figure(o, "texels_won"), s->won);
	assert_int_equal(figure(o, "texels_lost"), s->lost);
	assert_int_equal(figure(o, "lost_by_ties"), s->ties);
	assert_int_equal(figure(o, "texels_that_hold_what_is_farther"), s->odd);
	assert_int_equal(figure(o, "rivals"), s->n_rivals);
	const json_t *list = json_object_get(o, "lost_to");
	assert_int_equal(json_array_size(list), MOST_RIVALS);
	for (size_t i = 0; i < s->n_rivals; i++) {
		const ts_rival *r = &s->rival[i];
		if (i > 0) assert_true(r[-1].texels > r->texels || (r[-1].texels == r->texels && r[-1].triangle < r->triangle));
		if (i >= MOST_RIVALS) continue;
		const json_t *row = json_array_get(list, i);
		assert_int_equal(figure(row, "triangle"), r->triangle);
		assert_int_equal(figure(row, "texels"), r->texels);
		assert_int_equal(figure(row, "ties"), r->ties);
		assert_int_equal(figure(row, "least_margin_ulps"), r->least_ulps);
		assert_true(json_number_value(json_object_get(row, "least_margin")) == (double)r->least);
	}
	json_decref(o);
}

static void lost_texels_are_counted_by_their_winners(void **state)
{
	(void)state;
	const u64 *held = data(&mvr, FACE);
	u64 n = count(&mvr, FACE), *alone = calloc(n, sizeof *alone);
	ts_spread spread = {.rival = NULL};
	assert_non_null(alone);
	offer(alone, held, n, mvr.scene->n_triangles);
	require(ts_probe_spread_add(mvr.probe, &spread, alone, n, FACE, 0, mvr.scene->n_triangles, NULL, 0, NULL));
	assert_true(spread.n_rivals > MOST_RIVALS && spread.ties > 0 && spread.odd > 0);
	assert_int_equal(spread.won, 0);
	assert_spread(&spread, held, alone, n);
	assert_put(&spread);
	ts_probe_spread_free(&spread);
	assert_null(spread.rival);
	free(alone);
}

/* A buffer that holds every value that was offered: all are won, from any element on. */
static void texels_that_hold_the_offer_are_won(void **state)
{
	(void)state;
	const u64 *held = data(&mvr, FACE);
	u64 n = count(&mvr, FACE), first = 0;
	while (first < n && held[first] == TS_EMPTY) first++;
	ts_spread spread = {.rival = NULL};
	require(ts_probe_spread_add(mvr.probe, &spread, held + first, 1, FACE, first, (u32)held[first], NULL, 0, NULL));
	assert_int_equal(spread.offered, 1);
	assert_int_equal(spread.won, 1);
	assert_int_equal(spread.lost + spread.odd, 0);
	ts_probe_spread_free(&spread);
}

/* Of a list every member is found, and nothing between. */
static void members_of_a_list_are_found(void **state)
{
	(void)state;
	enum { N = 37 };
	u32 index[N];
	for (u32 i = 0; i < N; i++) index[i] = 3 * i + 1;
	for (u32 n = 0; n <= N; n++)
		for (u32 point = 0; point < 3 * N + 3; point++)
			assert_int_equal(ts_probe_place(index, n, point), point % 3 == 1 && point / 3 < n ? point / 3 : n);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(lost_texels_are_counted_by_their_winners),
		cmocka_unit_test(texels_that_hold_the_offer_are_won),
		cmocka_unit_test(members_of_a_list_are_found),
	};
	return cmocka_run_group_tests(tests, begin, finish);
}
