/* The traversal, which stages go through that keep the rendered pairs, map them at once, list them, or judge them
 * all. */
#ifndef TS_STAGES_TRAVERSE_H
#define TS_STAGES_TRAVERSE_H
#include "../../kernels/views/traverse.h"
#include "views.h"

/* Pairs of a step's queue that are decided: what is left of n pairs from args.queue on is rendered. */
typedef struct {
	ts_traverse_args args;
	u64 n;
	u64 n_children; /* in args.next, not decided yet */
	u64 n_waiting;  /* pairs that are in queues */
	u64 *sums;      /* work memory of prefix sums */
	u64 bytes;      /* of all work memory */
} ts_traverse_piece;

typedef ts_status ts_traverse_sink(ts_run *run, ts_traverse_piece *piece, void *user);

/* What a traversal launches, in every stage that has one. */
enum { TS_TRAVERSE_START, TS_TRAVERSE_COUNT, TS_TRAVERSE_SPLIT, TS_TRAVERSE_TALLY };
extern const ts_launch ts_traverse_launches[];
#define TS_TRAVERSE_LAUNCHES \
	&ts_traverse_launches[TS_TRAVERSE_START], &ts_traverse_launches[TS_TRAVERSE_COUNT], \
		&ts_traverse_launches[TS_TRAVERSE_SPLIT], &ts_traverse_launches[TS_TRAVERSE_TALLY]

/* Pairs of one step that queues have memory for. */
u64 ts_traverse_room(const ts_params *params);
/* Gives all pairs to the sink; in which order depends on queue_mb. `how`: as ts_traverse_arguments has it, or with
 * its own last, to_last, cutoff and apart. */
ts_status ts_traverse(ts_run *run, const ts_traverse_args *how, ts_traverse_sink *sink, void *user);
/* For sinks: adds a piece to the run's counters and says how many of its pairs are rendered. */
ts_status ts_traverse_tally(ts_run *run, ts_traverse_piece *piece, u64 *n_rendered);
/* Half the angle that a view sees; with TS_VIEW_FIELD_ALL nothing is culled. */
ts_aperture ts_view_aperture(u32 field);
/* Arguments of the kernels that decide pairs, without queues. */
ts_status ts_traverse_arguments(ts_run *run, ts_traverse_args *args);
/* Sets the pairs that a traversal for maps begins with, by traverse.hierarchies; without it those of both roots. Looks
 * at octree.level where the scene has no hierarchy. */
void ts_traverse_from(const ts_run *run, ts_traverse_args *args);
/* How many these are. */
u64 ts_traverse_starts(const ts_run *run, const ts_traverse_args *args);
/* Arguments for the lists of vpl_pairs, which are culled whatever traverse.cull says, from both roots on
 * (vpl_gather.c). */
ts_status ts_vpl_pairs_arguments(ts_run *run, ts_traverse_args *args);

#endif
