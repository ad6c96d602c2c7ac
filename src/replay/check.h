/* Checks of loaded buffers before a stage runs on them. A port's files are untrusted and kernels trust their
 * inputs, so whatever could make a stage read or write elsewhere, never end, or do what C leaves undefined is
 * refused first:
 *
 * - sizes: every buffer has the shape of records.def. Fixed and counted sizes are the first dimensions of the loaded
 *   buffers, else what loaded sums end at; the number of reflectors stands in scene.info; other sizes are computed as
 *   in a run (methods/sizes.c). So an index below its size is an element of its array.
 * - indices: every INDEX row of records.def. A key is all ones or its low half is an index: kernels ask for the
 *   former. An index of a size that is not known has no array that is loaded, and no stage follows it.
 * - floats are finite. No kernel turns a float into an integer but by ts_f2i and ts_fix, which take any float, so
 *   that overflow on the way, even to NaN, leads to wrong numbers only.
 * - prefix sums begin at 0, never fall and end at what they count: emit kernels, shading and the picture read
 *   where they say.
 * - scene.image: whole mip chains inside scene.texel, sides below 2^22, so that 24.8 fixed point names every
 *   texel; scene.slot: uv_set and wrap; scene.object: ranges one after the other inside scene.vertex, and for each
 *   reflector just one object, with vertices; scene.light: kind; scene.info: at most 2^20 reflectors.
 * - what each family says of its own buffers, by rules.
 *
 * What remains: time. Views of absurd sharpness ask for 4096 pieces of every triangle. Splats and triangles may cover
 * every texel of every face, so that damaged files can make a stage as slow as its elements times its texels, but not
 * endless. A replayed stage never takes the fast path of splats, which relies on the points of a piece standing
 * together (ts_replay_stage).
 *
 * Every refusal is one line: file, element, field, value, and what would be right. */
#ifndef TS_REPLAY_CHECK_H
#define TS_REPLAY_CHECK_H
#include "trace/load.h"

/* Checks all that was loaded for `stage`, and sets the sizes, the run's plan and scene.info.n_reflectors. */
ts_status ts_check(ts_load *load, const ts_stage *stage);

typedef enum {
	TS_CHECK_PARAMS, /* first, for methods that make the buffer, whether it is loaded or not */
	TS_CHECK_SIZES,  /* before sizes are computed from the buffer */
	TS_CHECK_VALUES, /* after shapes, indices and sums: values that kernels loop over or address by */
	TS_CHECK_SUMS,   /* with the values, instead of the check of prefix sums */
} ts_check_time;

/* A check of a family for a loaded buffer. */
typedef struct {
	ts_buffer_id buffer;
	ts_check_time time;
	ts_status (*check)(const ts_load *load, const ts_stage *stage, ts_buffer_id buffer);
} ts_check_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `check`. They must stay, and are
 * applied in this order. */
void ts_check_use(const ts_check_rule *const *rules);

/* The rules of the scene's buffers (check_scene.c), which come first. */
extern const ts_check_rule ts_check_scene[];

/* For rules: the elements of a loaded buffer; NULL, and *n 0, if the buffer was not loaded. */
const void *ts_check_elements(const ts_load *load, ts_buffer_id id, u64 *n);
/* A rule's check of the kinds of lights. */
ts_status ts_check_kinds(const ts_load *load, const ts_stage *stage, ts_buffer_id id);
/* Checks that the loaded outputs of stage `maker` are what that stage makes of the other loaded buffers, which `from`
 * names in messages. */
ts_status ts_check_again(const ts_load *load, const char *maker, const char *from);
/* Fails with one line about a loaded buffer: its file, the place, the value, and "RIGHT would be right". */
ts_status ts_check_refuse(const ts_load *load, ts_buffer_id id, u64 element, const char *field, u32 component,
                          const char *right, ...) __attribute__((format(printf, 6, 7)));

#endif
