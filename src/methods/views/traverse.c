/* The traversal of two octrees at once: one queue of pairs per step, processed in pieces where it is longer than its
 * memory. */
#include "methods/views/traverse.h"
#include <stdlib.h>
#include "kernels/base/scan.h"
#include "methods/views/octree.h"

enum { SCAN_CHUNK = 2048, BYTES_A_PAIR = 8 * TS_STEPS + 4 + 1 };

u64 ts_traverse_room(const ts_params *params)
{
	return ((u64)TS_PARAM(params, traverse_queue_mb) << 20) / BYTES_A_PAIR;
}

typedef struct {
	ts_run *run;
	ts_traverse_sink *sink;
	void *user;
	ts_traverse_piece piece;
	u64 room;   /* pairs per step; at least the children of one */
	u64 *queue; /* room for each step */
	struct {
		u64 at, end;
	} waiting[TS_STEPS + 1]; /* per step; the last is always empty */
	u64 steps[TS_STEPS];     /* pairs per step, over all pieces of its queue */
} traversal;

const ts_launch ts_traverse_launches[] = {
	[TS_TRAVERSE_START] = TS_LAUNCH(traverse_start, TS_ALL),
	[TS_TRAVERSE_COUNT] = TS_LAUNCH(traverse_count, TS_ALL),
	[TS_TRAVERSE_SPLIT] = TS_LAUNCH(traverse, TS_ALL),
	[TS_TRAVERSE_TALLY] = TS_LAUNCH(traverse_tally, TS_WITH(tallies)),
};
static const ts_launch sum_chunks = TS_LAUNCH(scan_sum, TS_WORK(counts, counts));
static const ts_launch sum_sums = TS_LAUNCH(scan_chunks, TS_WORK(counts, counts));
static const ts_launch sum_all = TS_LAUNCH(scan, TS_WORK(counts, counts));
static const ts_launch count_kept = TS_LAUNCH(render_count, TS_ALL);
static const ts_launch keep = TS_LAUNCH(render, TS_ALL);

ts_aperture ts_view_aperture(u32 field)
{
	static const ts_aperture fields[] = {{.cosine = 0, .sine = 1}, {.cosine = -1, .sine = 0}};
	return fields[field];
}

ts_status ts_traverse_arguments(ts_run *run, ts_traverse_args *args)
{
	bool culls = TS_PARAM(&run->params, traverse_cull) != 0;
	if (ts_view_map_check(run) != TS_OK) return TS_ERROR;
	*args = (ts_traverse_args){
		.phi = ts_view_aperture(culls ? run->plan.views.field : TS_VIEW_FIELD_ALL),
		.n = run->plan.views.px,
		.apart = TS_PARAM(&run->params, view_map_apart),
		.last = TS_NONE,
		.n_nodes = 1,
	};
	return TS_FILL(run, &ts_traverse_launches[TS_TRAVERSE_COUNT], args);
}

void ts_traverse_from(const ts_run *run, ts_traverse_args *args)
{
	u32 levels = TS_PARAM(&run->params, octree_levels);
	if (TS_PARAM(&run->params, traverse_hierarchies) == TS_HIERARCHIES_BOTH) return;
	args->first_node = ts_octree_first(run, &ts_scene_octree, levels);
	args->n_nodes = ts_octree_first(run, &ts_scene_octree, levels + 1) - args->first_node;
}

u64 ts_traverse_starts(const ts_run *run, const ts_traverse_args *args)
{
	const u32 *before = ts_frame_data(&run->frame, TS_B_view_octree_level);
	return ts_run_size(run, TS_DIM_nodes) > 0 ? (u64)before[1] * args->n_nodes : 0;
}

/* Prefix sum of the piece's offsets. */
static ts_status scan(ts_run *run, ts_traverse_piece *piece, u64 *total)
{
	ts_scan_args args = {.counts = piece->args.offset, .sums = piece->sums, .n = piece->n, .chunk = SCAN_CHUNK};
	args.n_chunks = (args.n + SCAN_CHUNK - 1) / SCAN_CHUNK;
	ts_frame_lend(&run->frame, TS_WORK_other, args.sums, (args.n_chunks + 1) * sizeof *args.sums);
	if (ts_launch_items(run, &sum_chunks, &args, args.n_chunks) != TS_OK) return TS_ERROR;
	if (ts_launch_items(run, &sum_sums, &args, 1) != TS_OK) return TS_ERROR;
	if (ts_launch_items(run, &sum_all, &args, args.n_chunks) != TS_OK) return TS_ERROR;
	if (ts_frame_recall(&run->frame, TS_WORK_other) != TS_OK) return TS_ERROR;
	*total = args.sums[args.n_chunks];
	return TS_OK;
}

static ts_status launch(traversal *t, u32 which, u64 n)
{
	return ts_launch_items(t->run, &ts_traverse_launches[which], &t->piece.args, n);
}

/* Decides the piece, or the part of it whose children have room. */
static ts_status decide(traversal *t, u64 *children)
{
	ts_traverse_piece *piece = &t->piece;
	for (;;) {
		if (launch(t, TS_TRAVERSE_COUNT, piece->n) != TS_OK) return TS_ERROR;
		if (scan(t->run, piece, children) != TS_OK) return TS_ERROR;
		if (*children <= t->room) return TS_OK;
		piece->n = (piece->n + 1) / 2;
	}
}

/* A piece of a step's queue: its children are the queue of the next step. */
static ts_status take_piece(traversal *t, u32 step)
{
	ts_traverse_piece *piece = &t->piece;
	u64 at = t->waiting[step].at, children;
	piece->n = t->waiting[step].end - at;
	piece->args.queue = t->queue + step * t->room + at;
	piece->args.next = step + 1 < TS_STEPS ? t->queue + (step + 1) * t->room : NULL;
	if (decide(t, &children) != TS_OK) return TS_ERROR;
	if (children > 0 && piece->args.next == NULL) return ts_fail("the octrees have more than %u steps", TS_STEPS);
	if (launch(t, TS_TRAVERSE_SPLIT, piece->n) != TS_OK) return TS_ERROR;
	t->waiting[step].at += piece->n;
	t->waiting[step + 1].at = 0;
	t->waiting[step + 1].end = piece->n_children = children;
	t->steps[step] += piece->n;
	if (t->steps[step] > piece->longest) piece->longest = t->steps[step];
	return t->sink(t->run, piece, t->user);
}

/* Takes waiting pieces, later steps first: a queue is empty when the next piece of the one before it is taken. */
static ts_status carry(traversal *t)
{
	for (u32 step = 0;;) {
		if (t->waiting[step].at < t->waiting[step].end) {
			if (take_piece(t, step++) != TS_OK) return TS_ERROR;
		} else if (step-- == 0) {
			return TS_OK;
		}
	}
}

static ts_status start(traversal *t)
{
	u64 n = ts_traverse_starts(t->run, &t->piece.args);
	for (u64 first = 0; first < n; first += t->room) {
		u64 n_pairs = n - first < t->room ? n - first : t->room;
		t->piece.args.queue = t->queue;
		t->piece.args.first = first;
		if (launch(t, TS_TRAVERSE_START, n_pairs) != TS_OK) return TS_ERROR;
		t->waiting[0].at = 0;
		t->waiting[0].end = n_pairs;
		if (carry(t) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static ts_status with_memory(traversal *t)
{
	u64 chunks = (t->room + SCAN_CHUNK - 1) / SCAN_CHUNK, n_pairs = TS_STEPS * t->room;
	t->queue = ts_alloc(n_pairs, sizeof *t->queue, "queues of pairs");
	t->piece.args.offset = ts_alloc(t->room + 1, sizeof(u32), "children of pairs");
	t->piece.sums = ts_alloc(chunks + 1, sizeof(u64), "sums of children");
	if (t->queue == NULL || t->piece.args.offset == NULL || t->piece.sums == NULL) return TS_ERROR;
	ts_frame_lend(&t->run->frame, TS_WORK_queue, t->queue, n_pairs * sizeof *t->queue);
	ts_frame_lend(&t->run->frame, TS_WORK_counts, t->piece.args.offset, (t->room + 1) * sizeof(u32));
	return start(t);
}

ts_status ts_traverse(ts_run *run, const ts_traverse_args *how, ts_traverse_sink *sink, void *user)
{
	traversal t = {.run = run, .sink = sink, .user = user, .piece.args = *how};
	t.room = ts_traverse_room(&run->params);
	ts_status status = with_memory(&t);
	for (u32 slot = TS_WORK_other; slot <= TS_WORK_counts; slot++) ts_frame_lend(&run->frame, slot, NULL, 0);
	free(t.queue);
	free(t.piece.args.offset);
	free(t.piece.sums);
	return status;
}

void ts_traverse_count(ts_run *run, const i64 tallies[TS_TALLIES_AT_ONCE])
{
	static const char *const names[] = {
		"pairs culled", "pairs too near", "pairs rendered", "pairs wider than a texel", "of these of several views",
		"views served", "pairs"};
	for (u32 i = 0; i < sizeof names / sizeof *names; i++) ts_run_count(run, names[i], tallies[i]);
	i64 before = ts_run_counter(run, "longest queue"), longest = tallies[TS_TALLY_LONGEST];
	ts_run_count(run, "longest queue", longest > before ? longest - before : 0);
}

ts_status ts_traverse_tally(ts_run *run, ts_traverse_piece *piece, u64 *n_rendered)
{
	i64 tallies[TS_TALLIES_AT_ONCE];
	u64 lots = (piece->n + TS_TALLY_PAIRS - 1) / TS_TALLY_PAIRS;
	piece->args.n_pairs = piece->n;
	if (TS_RUN(run, &ts_traverse_launches[TS_TRAVERSE_TALLY], &piece->args, lots) != TS_OK) return TS_ERROR;
	for (u32 i = 0; i < TS_TALLY_ALL; i++) tallies[i] = ts_frame_tally(&run->frame, i);
	tallies[TS_TALLY_ALL] = (i64)piece->n;
	tallies[TS_TALLY_LONGEST] = (i64)piece->longest;
	ts_traverse_count(run, tallies);
	*n_rendered = (u64)tallies[2];
	return TS_OK;
}

static ts_status count_rendered(ts_run *run, ts_traverse_piece *piece, void *user)
{
	u64 n;
	if (ts_traverse_tally(run, piece, &n) != TS_OK) return TS_ERROR;
	*(u64 *)user += n;
	return TS_OK;
}

static ts_status keep_rendered(ts_run *run, ts_traverse_piece *piece, void *user)
{
	u64 **next = user, n;
	if (ts_launch_items(run, &count_kept, &piece->args, piece->n) != TS_OK) return TS_ERROR;
	if (scan(run, piece, &n) != TS_OK) return TS_ERROR;
	piece->args.rendered = *next;
	*next += n;
	return n > 0 ? ts_launch_items(run, &keep, &piece->args, piece->n) : TS_OK;
}

static int ascending(const void *a, const void *b)
{
	u64 x = *(const u64 *)a, y = *(const u64 *)b;
	return x < y ? -1 : x > y;
}

/* Queues with less memory have their pieces in another order. */
static ts_status keep_sorted(ts_run *run, const ts_traverse_args *how, u64 *pairs, u64 n)
{
	u64 *next = pairs;
	ts_frame_lend(&run->frame, TS_WORK_kept, pairs, n * sizeof *pairs);
	ts_status status = ts_traverse(run, how, keep_rendered, &next);
	if (ts_frame_recall(&run->frame, TS_WORK_kept) != TS_OK || status != TS_OK) return TS_ERROR;
	qsort(pairs, n, sizeof *pairs, ascending);
	ts_run_set_size(run, TS_DIM_rendered_pairs, n);
	u64 *rendered = ts_run_make(run, TS_B_traverse_rendered);
	if (rendered == NULL) return TS_ERROR;
	memcpy(rendered, pairs, n * sizeof *pairs);
	return TS_OK;
}

static ts_status traverse(ts_run *run)
{
	u64 n = 0;
	ts_traverse_args how;
	if (ts_traverse_arguments(run, &how) != TS_OK) return TS_ERROR;
	ts_traverse_from(run, &how);
	if (ts_traverse(run, &how, count_rendered, &n) != TS_OK) return TS_ERROR;
	u64 *pairs = ts_alloc(n, sizeof *pairs, "rendered pairs");
	ts_status status = pairs != NULL ? keep_sorted(run, &how, pairs, n) : TS_ERROR;
	free(pairs);
	return status;
}

const ts_stage ts_stage_traverse = {
	.name = "traverse",
	.kind = "emit",
	.paper = "MegaViews 3.2, figures 4, 6 and 8",
	.doc = "the pairs of a node of the scene and a node of views to render",
	.run = traverse,
	.launches = TS_LAUNCHES(TS_TRAVERSE_LAUNCHES, &count_kept, &keep),
	.looks_at = TS_BUFFERS(TS_B_octree_level, TS_B_view_octree_level),
	.makes = TS_BUFFERS(TS_B_traverse_rendered),
};
