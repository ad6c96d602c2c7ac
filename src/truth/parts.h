/* Inside a truth: the scene's triangles of Embree's primitives, and the filters that let rays pass them. */
#ifndef TS_TRUTH_PARTS_H
#define TS_TRUTH_PARTS_H
#include "truth/tree.h"
#include "truth/truth.h"

/* The facing of a triangle: n and a of ts_corners. */
typedef struct {
	f32 normal[3], corner[3];
	u32 reflector;
	u32 kind; /* TS_DOUBLE_SIDED, TS_MASKED, TS_OF_REFLECTOR */
} ts_truth_facet;

enum { TS_OF_REFLECTOR = 128, TS_MIXED = 256 };

/* A geometry of Embree, and the scene's triangle of each of its primitives. A long run of triangles of one kind is a
 * part of its own, so that filters know the kind of most triangles without a look-up. */
typedef struct {
	const ts_truth *truth;
	const u32 *triangle;
	const ts_truth_facet *facet; /* NULL: no ray passes them */
	u32 n;
	u32 kind; /* of all of them, or TS_MIXED */
} ts_truth_part;

enum { TS_MOST_PARTS = 1024 };
enum { TS_TRUTH_PACKET = 16 };

/* The number of rays that all threads have cast so far, and the time that took. */
typedef struct {
	u64 rays, nanoseconds;
} ts_truth_costs;

struct ts_truth {
	ts_arrays scene; /* the run's pose.vertex among them */
	u32 n_vertices;
	ts_tree tree;
	ts_truth_costs *cost;
	f32 *position;         /* xyz of every vertex, then the 4 bytes that Embree may read beyond them */
	u32 *triangle;         /* those that no ray passes, then the others; none without an area */
	ts_truth_facet *facet; /* of the others */
	ts_truth_part *parts;
	u32 n_parts;
};

/* The context of rays in filters: Embree passes on the address of `base`. */
typedef struct {
	ts_tree_context base;
	const ts_truth_query *queries; /* by the rays' ids */
	void *packet;                  /* packet.c's; NULL: a single ray, and the geometries' own filter decides */
} ts_truth_request;

/* Divides the triangles into parts, to be released by ts_truth_parts_free, also on failure: no memory. */
ts_status ts_truth_parts_make(ts_truth *truth);
void ts_truth_parts_free(ts_truth *truth);

/* Whether alpha cuts out the point at which the ray meets a masked triangle with this normal. */
bool ts_truth_is_cut(const ts_truth *truth, const ts_truth_query *query, u32 triangle, ts_v3 normal);
/* The nearest triangle that no filter rejects, or TS_NONE. */
u32 ts_truth_find(const ts_truth *truth, const ts_truth_query *query);
/* As ts_truth_find, for n queries, at most TS_TRUTH_PACKET; `triangle` must have room for a whole packet (packet.c). */
void ts_truth_find_all(u32 *triangle, const ts_truth *truth, const ts_truth_query *queries, u32 n);

#endif
