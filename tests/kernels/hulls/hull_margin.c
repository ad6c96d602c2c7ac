/* The margins of segments and of the choice of boxes against ports that round otherwise: every number that is compared
 * is off by up to 4 ulps, each its own way. Whatever that changes is undecided, and what hangs together with no tie is
 * decided. */
#include <string.h>
#include "kernels/hulls/hull_margin.h"
#include "tests/kernels/seeded.h"

enum { GRID = 64, SIDE = 32, TEXELS = GRID * GRID, BLOCKS = 4, PLACES = SIDE * SIDE, N_WORLDS = 300, MOST_BOXES = 512 };

static u32 port; /* which way its numbers are off */

/* The same number is off the same way. */
static double off(double x)
{
	f32 single = (f32)x;
	return x * (1 + (ts_uniform(ts_random(ts_f2u(single), 3, port)) * 2 - 1) / 2097152.0);
}

static u64 at(u32 block, u32 place) { return ts_k_block_texel(GRID, block, place % SIDE, place / SIDE); }

typedef struct {
	f32 depth[TEXELS], step;
} world;

/* Few depths, and steps that are powers of two: many tie, and a bit more or less nearly does. */
static void fill(world *w)
{
	f32 patch[64];
	w->step = 1.0f / (f32)(2u << below(4));
	for (u32 i = 0; i < 64; i++) {
		patch[i] = below(8) == 0 ? 1 : 0.5f + (f32)below(64) / 128;
		if (below(4) == 0 && patch[i] < 1) patch[i] = ts_u2f(ts_f2u(patch[i]) + below(3));
	}
	u32 wide = 1 + below(12);
	for (u32 i = 0; i < TEXELS; i++) w->depth[i] = patch[(i % GRID / wide * 7 + i / GRID / wide * 13) % 64];
}

static bool is_apart(const world *w, u32 block, u32 from, u32 to)
{
	double a = w->depth[at(block, from)], b = w->depth[at(block, to)];
	return fabs(a - b) > off(w->step * (1 - a));
}

/* Algorithm 1 in the port. */
static void sweep(const world *w, u32 block, u32 *label)
{
	for (u32 i = 0; i < PLACES; i++) label[i] = i;
	for (u32 k = 0; k < 4 * PLACES; k++) {
		u32 turn = k / PLACES, line = k / SIDE % SIDE, along = turn < 2 ? k % SIDE : SIDE - 1 - k % SIDE;
		u32 p = turn % 2 == 0 ? line * SIDE + along : along * SIDE + line, back = turn % 2 == 0 ? 1 : SIDE;
		u32 before = turn < 2 ? p - back : p + back;
		if (k % SIDE > 0 && !is_apart(w, block, before, p)) label[p] = label[before];
	}
}

/* Components in the port: the least place, spread until nothing changes. */
static void join(const world *w, u32 block, u32 *label)
{
	for (u32 i = 0; i < PLACES; i++) label[i] = i;
	for (bool changed = true; changed;) {
		changed = false;
		for (u32 k = 0; k < 2 * PLACES; k++) {
			u32 p = k / 2, q = k % 2 == 0 ? p + 1 : p + SIDE;
			if (q >= PLACES || (k % 2 == 0 && q % SIDE == 0) || label[p] == label[q]) continue;
			if (is_apart(w, block, p, q) && is_apart(w, block, q, p)) continue;
			label[p] = label[q] = label[p] < label[q] ? label[p] : label[q];
			changed = true;
		}
	}
}

/* Texels whose labels are others, all of which must be undecided. */
static u32 count_others(const world *w, const f32 *margin, const u32 *labels, u32 block,
                        void (*segment)(const world *w, u32 block, u32 *label))
{
	static u32 theirs[PLACES];
	u32 n = 0;
	segment(w, block, theirs);
	for (u32 p = 0; p < PLACES; p++) {
		if (labels[at(block, p)] == theirs[p]) continue;
		if (margin[at(block, p)] > 1) fail_msg("block %u, place %u: %g", block, p, (double)margin[at(block, p)]);
		n++;
	}
	return n;
}

static void segments_that_differ_are_undecided(void **state)
{
	(void)state;
	static world w;
	static u32 swept[TEXELS], exact[TEXELS];
	static f32 margin[TEXELS];
	u32 n_swept = 0, n_exact = 0, n_decided = 0;
	for (port = 0; port < N_WORLDS; port++) {
		fill(&w);
		ts_segment_args sweeps = {.depths = w.depth, .labels = swept, .grid = GRID, .step = w.step}, joins = sweeps;
		ts_segment_margin_args args = {.depths = w.depth, .margin = margin, .grid = GRID, .step = w.step};
		joins.labels = exact;
		for (; sweeps.sweep < 4; sweeps.sweep++) {
			for (u32 i = 0; i < BLOCKS * SIDE; i++) ts_k_segment_item(&sweeps, i);
		}
		for (u32 block = 0; block < BLOCKS; block++) {
			ts_k_segment_components_item(&joins, block);
			ts_k_segment_margin_item(&args, block);
			n_swept += count_others(&w, margin, swept, block, sweep);
			n_exact += count_others(&w, margin, exact, block, join);
		}
		for (u32 i = 0; i < TEXELS; i++) n_decided += margin[i] > 1;
	}
	bool enough = n_swept > 5000 && n_exact > 5000 && n_decided > N_WORLDS * TEXELS / 4;
	if (!enough) fail_msg("%u by sweeps, %u by components, %u decided", n_swept, n_exact, n_decided);
}

/* Columns of a tie with the step, and of one 64 ulps from it: what hangs together has the least of its tests. */
static void segments_have_their_least_margin(void **state)
{
	(void)state;
	static f32 depth[TEXELS], margin[TEXELS];
	const f32 step = 0.25f, columns[4] = {0.5f, 0.625f, 0.75f, 1};
	for (u32 i = 0; i < TEXELS; i++) depth[i] = columns[i % GRID / 8 % 4];
	ts_segment_margin_args args = {.depths = depth, .margin = margin, .grid = GRID, .step = step};
	ts_k_segment_margin_item(&args, 0);
	for (u32 x = 0; x < SIDE; x++) {
		/* 0.625 - 0.5 = 0.25 (1 - 0.5); 0.125 is a quarter more than 0.25 (1 - 0.625); 0.25 than 0.25 (1 - 0.75)
		 * 3/4. */
		assert_true(x >= 16 || margin[x] == 0);
		assert_true(x < 16 || x >= 24 || fabs(margin[x] / 1048576.0 - 0.25) < 1e-6);
		assert_true(x < 24 || margin[x] == 0.75f * 1048576);
	}
	for (u32 i = 0; i < TEXELS; i++) depth[i] = i % GRID < 8 ? 0.5f : ts_u2f(ts_f2u(0.625f) + 1);
	ts_k_segment_margin_item(&args, 0);
	for (u32 x = 0; x < SIDE; x++) assert_true(margin[x] > 0 && margin[x] < 1);
	for (u32 i = 0; i < TEXELS; i++) depth[i] = i % GRID < 8 ? 0.5f : ts_u2f(ts_f2u(0.625f) + 64);
	ts_k_segment_margin_item(&args, 0);
	for (u32 x = 0; x < SIDE; x++) assert_true(margin[x] > 1 && margin[x] < 64);
	for (u32 i = 0; i < TEXELS; i++) depth[i] = 1;
	ts_k_segment_margin_item(&args, 0);
	for (u32 x = 0; x < SIDE; x++) assert_true(margin[x] == TS_MARGIN_FAR);
}

/* Boxes of blocks. */
typedef struct {
	ts_segment boxes[MOST_BOXES];
	u32 offset[TEXELS + 1], n;
} hulls;

static void random_hulls(hulls *h, u32 most)
{
	h->n = 0;
	for (u32 label = 0; label < TEXELS; label++) {
		h->offset[label] = h->n;
		if (label % PLACES >= most || label / PLACES == most % 7 || h->n == MOST_BOXES) continue;
		ts_segment *box = &h->boxes[h->n++];
		*box = (ts_segment){.label = label};
		for (u32 k = 0; k < 2; k++) {
			u32 first = (k == 0 ? label / PLACES % 2 : label / PLACES / 2) * SIDE;
			box->low[k] = first + below(8);
			box->high[k] = first + 24 + below(8);
		}
		box->nearest = 0.5f + (f32)below(16) / 64;
		box->farthest = box->nearest + (f32)below(16) / 64;
		if (below(2) == 0) box->farthest = ts_u2f(ts_f2u(box->farthest) + below(4));
	}
	h->offset[TEXELS] = h->n;
}

/* METHODS 11 in the port. */
static u32 choose(const hulls *h, ts_grid_place at, bool robust, f32 step)
{
	u32 best = TS_NONE, best_class = 0;
	double best_measure = 0, slack = off(step * (1 - (double)at.depth));
	for (u32 b = 0; b < h->n; b++) {
		const ts_segment *box = &h->boxes[b];
		u32 block = box->label / PLACES;
		bool near = block % 2 == at.x / SIDE && block / 2 == at.y / SIDE;
		bool covers = at.x >= box->low[0] && at.x <= box->high[0] && at.y >= box->low[1] && at.y <= box->high[1];
		bool holds = at.depth >= box->nearest && at.depth <= box->farthest;
		double gap = holds ? 0 : at.depth < box->nearest ? box->nearest - at.depth : at.depth - box->farthest;
		u32 class = covers && holds ? 0 : covers && gap <= slack ? 1 : covers ? 2 : near ? 3 : 4;
		double measure = off(class < 2 ? box->farthest - box->nearest : gap);
		bool better = best == TS_NONE || class < best_class || (class == best_class && measure < best_measure);
		if (!better || (!robust && class != 0)) continue;
		best = b;
		best_class = class;
		best_measure = measure;
	}
	return best;
}

static void choices_that_differ_are_undecided(void **state)
{
	(void)state;
	static hulls h;
	u32 n_others = 0, n_decided = 0, n = 0;
	for (port = 0; port < N_WORLDS; port++) {
		random_hulls(&h, port % 12);
		for (u32 k = 0; k < 400; k++) {
			bool robust = k % 4 != 0;
			ts_choice_args args = {.offset = h.offset, .boxes = h.boxes, .grid = GRID, .robust = robust};
			args.step = ts_u2f(ts_f2u(0.25f) - below(3));
			u32 x = below(GRID), y = below(GRID), parts = k % 8 < 4 ? 64 : 2048;
			ts_grid_place place = {x, y, 0.5f + (f32)below(parts / 2) / (f32)parts};
			u32 box = ts_k_choose_box(&args, place), theirs = choose(&h, place, robust, args.step);
			f32 margin = box == TS_NONE ? TS_MARGIN_FAR : ts_k_choice_margin(&args, place, box);
			if (box != theirs && margin > 1) fail_msg("box %u, theirs %u: %g", box, theirs, (double)margin);
			n++;
			n_others += box != theirs;
			n_decided += margin > 1;
		}
	}
	if (!(n_others > 100 && n_decided > n / 2)) fail_msg("%u, %u of %u", n_others, n_decided, n);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(segments_that_differ_are_undecided),
	                                   seeded_test(segments_have_their_least_margin),
	                                   seeded_test(choices_that_differ_are_undecided)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
