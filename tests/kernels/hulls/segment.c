/* Segments of the depth grid and their boxes: algorithm 1 as it is printed, components by a flood fill, and boxes by
 * looking at every texel. */
#include <stdlib.h>
#include <string.h>
#include "kernels/hulls/segment_box.h"
#include "tests/kernels/seeded.h"

enum { GRID = 96, SIDE = 32, TEXELS = GRID * GRID, BLOCKS = 9, PLACES = SIDE * SIDE, N_WORLDS = 400 };

typedef struct {
	f32 depth[TEXELS];
	f32 step;
} world;

static u32 at(u32 block, u32 place)
{
	return (block / 3 * SIDE + place / SIDE) * GRID + block % 3 * SIDE + place % SIDE;
}

/* Depths of discs before a slope before the sky; the last kinds are noise, sky alone, and depths that tie with the
 * step. */
static void fill(world *w, u32 kind)
{
	f32 slope = uniform(-0.002f, 0.002f), aslant = uniform(-0.002f, 0.002f);
	w->step = kind % 8 == 6 ? 0.5f : uniform(0.001f, 0.05f);
	for (u32 i = 0; i < TEXELS; i++) {
		f32 x = (f32)(i % GRID), y = (f32)(i / GRID);
		w->depth[i] = ts_clamp(0.8f + slope * (x - 48) + aslant * (y - 48), 0, 1);
	}
	for (u32 k = below(40); kind % 8 < 5 && k > 0; k--) {
		f32 x = uniform(0, GRID), y = uniform(0, GRID), r = uniform(1, 12),
			depth = below(5) == 0 ? 1 : uniform(0.5f, 0.99f);
		for (u32 i = 0; i < TEXELS; i++) {
			f32 dx = (f32)(i % GRID) - x, dy = (f32)(i / GRID) - y;
			if (dx * dx + dy * dy < r * r) w->depth[i] = depth;
		}
	}
	for (u32 i = 0; kind % 8 >= 5 && i < TEXELS; i++) {
		static const f32 ties[] = {0, 0.5f, 0.75f, 1};
		w->depth[i] = kind % 8 == 5 ? uniform(0, 1) : kind % 8 == 6 ? ties[below(4)] : 1;
	}
}

static void sweeps(const world *w, u32 *labels)
{
	ts_segment_args args = {.depths = w->depth, .labels = labels, .grid = GRID, .step = w->step};
	for (; args.sweep < 4; args.sweep++) {
		for (u32 i = BLOCKS * SIDE; i-- > 0;) ts_k_segment_item(&args, i);
	}
}

/* Algorithm 1. */
typedef struct {
	const world *w;
	u32 block, label[PLACES], l;
	f32 dc;
} paper;

static void swap_label(paper *p, u32 x, u32 y)
{
	f32 dn = p->w->depth[at(p->block, y * SIDE + x)], room = p->w->step * (1 - p->dc);
	if (fabsf(p->dc - dn) > room)
		p->l = p->label[y * SIDE + x];
	else
		p->label[y * SIDE + x] = p->l;
	p->dc = dn;
}

static void propagate(paper *p, u32 xs, u32 ys, u32 xe, u32 ye)
{
	p->dc = p->w->depth[at(p->block, ys * SIDE + xs)];
	p->l = p->label[ys * SIDE + xs];
	i32 dx = (i32)(xe > xs) - (i32)(xe < xs), dy = (i32)(ye > ys) - (i32)(ye < ys);
	for (i32 k = 0; k < SIDE; k++) swap_label(p, (u32)((i32)xs + k * dx), (u32)((i32)ys + k * dy));
}

static void segment(paper *p, const world *w, u32 block)
{
	p->w = w;
	p->block = block;
	for (u32 i = 0; i < PLACES; i++) p->label[i] = i;
	for (u32 y = 0; y < SIDE; y++) propagate(p, 0, y, SIDE - 1, y);
	for (u32 x = 0; x < SIDE; x++) propagate(p, x, 0, x, SIDE - 1);
	for (u32 y = 0; y < SIDE; y++) propagate(p, SIDE - 1, y, 0, y);
	for (u32 x = 0; x < SIDE; x++) propagate(p, x, SIDE - 1, x, 0);
}

/* A flood fill with a stack: each component named by its least place. */
static bool joins(f32 a, f32 b, f32 step)
{
	f32 of_a = step * (1 - a), of_b = step * (1 - b);
	return fabsf(a - b) <= of_a || fabsf(a - b) <= of_b;
}

static void flood(const world *w, u32 block, u32 *component)
{
	u32 stack[PLACES], n = 0;
	for (u32 i = 0; i < PLACES; i++) component[i] = TS_NONE;
	for (u32 first = 0; first < PLACES; first++) {
		if (component[first] != TS_NONE) continue;
		component[first] = first;
		stack[n++] = first;
		while (n > 0) {
			u32 p = stack[--n], x = p % SIDE, y = p / SIDE;
			u32 next[4] = {x > 0 ? p - 1 : p, x < SIDE - 1 ? p + 1 : p, y > 0 ? p - SIDE : p,
			               y < SIDE - 1 ? p + SIDE : p};
			for (u32 k = 0; k < 4; k++) {
				f32 here = w->depth[at(block, p)], there = w->depth[at(block, next[k])];
				if (component[next[k]] != TS_NONE || !joins(here, there, w->step)) continue;
				component[next[k]] = first;
				stack[n++] = next[k];
			}
		}
	}
}

static u32 count_labels(const u32 *labels, u32 block)
{
	bool used[PLACES] = {false};
	u32 n = 0;
	for (u32 i = 0; i < PLACES; i++) {
		u32 label = labels[at(block, i)];
		n += !used[label];
		used[label] = true;
	}
	return n;
}

/* The labels are the paper's, and none spans two components. */
static void check_block(const world *w, const u32 *swept, const u32 *exact, u32 block)
{
	static paper p;
	u32 component[PLACES];
	segment(&p, w, block);
	flood(w, block, component);
	for (u32 i = 0; i < PLACES; i++) {
		assert_int_equal(swept[at(block, i)], p.label[i]);
		assert_int_equal(exact[at(block, i)], component[i]);
		assert_int_equal(component[swept[at(block, i)]], component[i]);
	}
	assert_true(count_labels(swept, block) >= count_labels(exact, block));
}

static void segments_are_those_of_the_paper(void **state)
{
	(void)state;
	static world w;
	static u32 swept[TEXELS], exact[TEXELS];
	u32 n_more = 0, n_noise = 0;
	for (u32 i = 0; i < N_WORLDS; i++) {
		fill(&w, i);
		sweeps(&w, swept);
		ts_segment_args args = {.depths = w.depth, .labels = exact, .grid = GRID, .step = w.step};
		for (u32 block = 0; block < BLOCKS; block++) ts_k_segment_components_item(&args, block);
		for (u32 block = 0; block < BLOCKS; block++) {
			check_block(&w, swept, exact, block);
			n_more += count_labels(swept, block) > count_labels(exact, block);
			n_noise += count_labels(exact, block) > 700;
			if (i % 8 == 7) assert_int_equal(count_labels(swept, block), 1);
		}
	}
	assert_true(n_more > 100 && n_noise > 100);
}

/* Every depth its own segment: no list of labels is longer. */
static void every_depth_may_be_its_own_segment(void **state)
{
	(void)state;
	static world w = {.step = 0.01f};
	static u32 labels[TEXELS];
	for (u32 i = 0; i < TEXELS; i++) w.depth[i] = (i % GRID + i / GRID) % 2 == 0 ? 0.25f : 0.75f;
	sweeps(&w, labels);
	for (u32 block = 0; block < BLOCKS; block++) assert_int_equal(count_labels(labels, block), PLACES);
}

/* |d_c - d_n| = t (1 - d_c) joins, the next float does not; and only this way round. */
static void depths_join_up_to_the_step(void **state)
{
	(void)state;
	f32 more = ts_u2f(ts_f2u(0.75f) + 1);
	assert_false(ts_k_is_apart(0.5f, 0.75f, 0.5f));
	assert_true(ts_k_is_apart(0.5f, more, 0.5f) && ts_k_is_apart(0.75f, 0.5f, 0.5f));
	for (u32 i = 0; i < 10000; i++) {
		f32 depth = ts_min(uniform(0, 1), ts_u2f(0x3f7fffff)), step = uniform(0, 0.5f);
		assert_true(ts_k_is_apart(depth, 1, step) && ts_k_is_apart(1, depth, step));
		assert_false(ts_k_is_apart(depth, depth, step));
	}
	assert_false(ts_k_is_apart(1, 1, 0));
}

/* The boxes of arbitrary labels, made in any order, against all texels. */
static void check_boxes(const world *w, const u32 *labels)
{
	static u32 least[TEXELS * 6], offset[TEXELS + 1];
	static ts_segment boxes[TEXELS];
	i64 n_labels = 0;
	memset(least, 0xff, sizeof least);
	ts_segment_extent_args range = {.depths = w->depth, .labels = labels, .least = least, .grid = GRID};
	u32 start = below(TEXELS);
	for (u32 i = 0; i < TEXELS; i++)
		ts_k_segment_extent_item(&range, (start + i * 5) % TEXELS); /* 5 and TEXELS: no common factor */
	ts_segment_box_args args = {.least = least, .offset = offset, .boxes = boxes, .n_labels = &n_labels};
	u32 n = 0, n_used = 0;
	for (u32 i = 0; i < TEXELS; i++) ts_k_segment_box_count_item(&args, i);
	for (u32 i = 0; i <= TEXELS; i++) {
		u32 count = i < TEXELS ? offset[i] : 0;
		offset[i] = n;
		n += count;
	}
	for (u32 i = 0; i < TEXELS; i++) ts_k_segment_box_item(&args, i);
	u32 next = 0;
	for (u32 label = 0; label < TEXELS; label++) {
		ts_segment right = {.low = {GRID, GRID}, .nearest = 2, .farthest = -1, .label = label};
		for (u32 i = 0; i < PLACES; i++) {
			u32 texel = at(label / PLACES, i), x = texel % GRID, y = texel / GRID;
			if (labels[texel] != label % PLACES) continue;
			right.low[0] = x < right.low[0] ? x : right.low[0];
			right.low[1] = y < right.low[1] ? y : right.low[1];
			right.high[0] = x > right.high[0] ? x : right.high[0];
			right.high[1] = y > right.high[1] ? y : right.high[1];
			right.nearest = fminf(right.nearest, w->depth[texel]);
			right.farthest = fmaxf(right.farthest, w->depth[texel]);
		}
		n_used += right.nearest <= 1;
		if (right.nearest < 1) assert_memory_equal(&boxes[next++], &right, sizeof right);
	}
	assert_int_equal(next, n);
	assert_int_equal(n_labels, n_used);
}

static void boxes_hold_all_texels_of_their_label(void **state)
{
	(void)state;
	static world w;
	static u32 labels[TEXELS];
	for (u32 i = 0; i < 24; i++) {
		fill(&w, i);
		if (i % 3 == 0)
			sweeps(&w, labels);
		else
			for (u32 k = 0; k < TEXELS; k++) labels[k] = below(i % 3 == 1 ? 6 : PLACES);
		check_boxes(&w, labels);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(segments_are_those_of_the_paper),
		seeded_test(every_depth_may_be_its_own_segment),
		seeded_test(depths_join_up_to_the_step),
		seeded_test(boxes_hold_all_texels_of_their_label),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
