/* The traversal, for stages that keep the rendered pairs, draw them into maps at once, list them, or judge all
 * pairs. */
#ifndef TS_METHODS_VIEWS_TRAVERSE_H
#define TS_METHODS_VIEWS_TRAVERSE_H
#include "kernels/views/traverse.h"
#include "methods/views/views.h"

/* Decided pairs of a step's queue: of the n pairs from args.queue on those that are left are rendered. */
typedef struct {
	ts_traverse_args args;
	u64 n;
	u64 n_children; /* in args.next, not decided yet */
	u64 longest;    /* pairs of the longest step until now */
	u64 *sums;      /* work memory of prefix sums */
} ts_traverse_piece;

typedef ts_status ts_traverse_sink(ts_run *run, ts_traverse_piece *piece, void *user);

/* The launches of a traversal, in every stage that has one. */
enum { TS_TRAVERSE_START, TS_TRAVERSE_COUNT, TS_TRAVERSE_SPLIT, TS_TRAVERSE_TALLY };
extern const ts_launch ts_traverse_launches[];
#define TS_TRAVERSE_LAUNCHES \
	&ts_traverse_launches[TS_TRAVERSE_START], &ts_traverse_launches[TS_TRAVERSE_COUNT], \
		&ts_traverse_launches[TS_TRAVERSE_SPLIT], &ts_traverse_launches[TS_TRAVERSE_TALLY]

/* Number of pairs of one step for which queues have memory. */
u64 ts_traverse_room(const ts_params *params);
/* Gives all pairs to the sink; their order depends on traverse.queue_mb. how: that of ts_traverse_arguments, perhaps
 * with its own last, to_last, cutoff and apart. */
ts_status ts_traverse(ts_run *run, const ts_traverse_args *how, ts_traverse_sink *sink, void *user);
/* For sinks: adds a piece to the run's counters. *n_rendered: number of its rendered pairs. */
ts_status ts_traverse_tally(ts_run *run, ts_traverse_piece *piece, u64 *n_rendered);
/* Adds tallies to the run's counters, those of ts_k_traverse_tally_item; all pairs; and those of the longest step. */
void ts_traverse_count(ts_run *run, const i64 tallies[TS_TALLIES_AT_ONCE]);
/* Half the angle that a view sees; with TS_VIEW_FIELD_ALL nothing is culled. */
ts_aperture ts_view_aperture(u32 field);
/* Arguments of the kernels that decide pairs, without queues. */
ts_status ts_traverse_arguments(ts_run *run, ts_traverse_args *args);
/* Sets the pairs with which a traversal for maps begins, by traverse.hierarchies; without this call those of both
 * roots. Reads octree.level if the scene has no hierarchy. */
void ts_traverse_from(const ts_run *run, ts_traverse_args *args);
/* The number of these pairs. */
u64 ts_traverse_starts(const ts_run *run, const ts_traverse_args *args);
/* Arguments for the lists of vpl_gather.pairs, which are culled whatever traverse.cull says, from both roots on
 * (vpl_gather.c). */
ts_status ts_vpl_pairs_arguments(ts_run *run, ts_traverse_args *args);

#endif
