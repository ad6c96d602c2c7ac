/* Explanations made by hand: places in a text that no kernel has, a frame of one buffer, and what is told there. */
#ifndef TS_TESTS_EXPLAIN_HAND_H
#define TS_TESTS_EXPLAIN_HAND_H
#include "explain/explain.h"
#include "tests/model/test.h"

enum { HAND_KEYS = 5 };

/* A number of each kind. */
typedef struct {
	f32 length;
	i32 step;
	u32 flags;
	i64 sum;
	u64 key;
	u8 level;
	bool on;
	const void *to;
} hand_record;

#define HAND_LEAF(name, kind) \
	{ \
		"." #name, offsetof(hand_record, name), TS_TOLD_##kind \
	}
static const ts_told_leaf hand_leaves[] = {
	HAND_LEAF(length, f32), HAND_LEAF(step, i32), HAND_LEAF(flags, u32), HAND_LEAF(sum, i64),
	HAND_LEAF(key, u64),    HAND_LEAF(level, u8), HAND_LEAF(on, bool),   HAND_LEAF(to, pointer),
};
static const ts_told_leaf hand_pair[] = {{".x", 0, TS_TOLD_u32}, {".y", 4, TS_TOLD_u32}};
static const ts_told_leaf hand_one[] = {{"", 0, TS_TOLD_u32}}, hand_wide[] = {{"", 0, TS_TOLD_u64}};
static const ts_told_leaf hand_at[] = {{"", 0, TS_TOLD_pointer}};
static const ts_told_type hand_u32 = {"u32", 4, 1, hand_one}, hand_u64 = {"u64", 8, 1, hand_wide};
static const ts_told_type hand_xy = {"ts_xy", 8, 2, hand_pair}, hand_pointer = {"pointer", sizeof(void *), 1, hand_at};
static const ts_told_type hand_all = {"hand_record", sizeof(hand_record), 8, hand_leaves};

#define HAND_SITE(name, how, line, text, type) \
	static const ts_told_site name = {TS_TOLD_##how, "points/hand.h", line, false, text, type}
#define HAND_LEFT(name, line, text) \
	static const ts_told_site name = {TS_TOLD_VALUE, "points/hand.h", line, true, text, &hand_u32}
HAND_SITE(hand_item, CALL, 10, "ts_k_hand_item", NULL);
HAND_SITE(hand_helper, CALL, 20, "ts_dot", NULL);
HAND_SITE(hand_n, VALUE, 11, "n", &hand_u32);
HAND_SITE(hand_test, TEST, 12, "n > 3", NULL);
HAND_SITE(hand_c, VALUE, 13, "c", &hand_xy);
HAND_SITE(hand_r, VALUE, 14, "r", &hand_all);
HAND_SITE(hand_p, VALUE, 15, "p", &hand_pointer);
HAND_SITE(hand_store, STORE, 16, "at[i]", &hand_u64);
HAND_SITE(hand_count, STORE, 17, "*n_writes", &hand_u64);
HAND_SITE(hand_result, RESULT, 18, "return", &hand_u32);
HAND_SITE(hand_bound, TITLE, 21, "Bound it.", NULL);
HAND_SITE(hand_offer, TITLE, 22, "Offer it.", NULL);
HAND_SITE(hand_find, TITLE, 23, "Find it.", NULL);
HAND_LEFT(hand_width, 24, "width");
HAND_LEFT(hand_width_again, 25, "width");
HAND_LEFT(hand_to, 26, "to->height");

static u64 hand_keys[HAND_KEYS] = {10, 11, 12, 13, 14};
static ts_load hand_load;

/* One that listens, and is told to. Released by hand_end. */
static inline void hand_begin(ts_explanation *e)
{
	hand_load.run.frame.buffer[TS_B_points_key] =
		(ts_buffer){.data = hand_keys, .n = HAND_KEYS, .bytes = sizeof hand_keys, .made = true};
	*e = (ts_explanation){.load = &hand_load,
	                      .telling = {.listens = true, .primitives = true, .most = UINT64_MAX, .from = NULL}};
	ts_told_to(&e->telling);
}

static inline void hand_end(ts_explanation *e)
{
	free(e->telling.lines);
	free(e->telling.bytes);
}

static inline void hand_tell(const ts_told_site *site, u32 value) { ts_told(site, &value); }

/* The line of that number is of this place, so deep. */
static inline void hand_is(const ts_explanation *e, size_t number, const ts_told_site *site, u32 depth)
{
	assert_true(number < e->telling.n_lines);
	assert_ptr_equal(e->telling.lines[number].site, site);
	assert_int_equal(e->telling.lines[number].depth, depth);
}

#endif
