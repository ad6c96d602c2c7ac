/* The reflector to which each node of the scene's octree belongs, so that the view from the reflector's middle leaves
 * the node out, as EPR's cubes do (METHODS 14). A leaf has the reflector to which all its triangles belong, an inner
 * node that of all its children; if there are several, or other triangles, it is TS_NONE. */
#ifndef TS_KERNELS_VIEWS_OCTREE_REFLECTOR_H
#define TS_KERNELS_VIEWS_OCTREE_REFLECTOR_H
#include "kernels/base/args.h"
#include "kernels/base/morton.h"
#include "kernels/base/scene.h"

#define TS_ROWS_ts_octree_reflector_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_node, nodes, octree_node) \
	ARG(IN, u32, offset, octree_offset) \
	ARG(IN, u32, triangles, octree_triangle) \
	ARG(OUT, u32, reflectors, octree_reflector) \
	ARG(VALUE, u32, first, none) /* node of item 0 */
TS_ARGS(ts_octree_reflector_args);

/* map over leaves */
TS_FN void ts_k_leaf_reflector_item(const ts_octree_reflector_args *args, u64 i)
{
	u32 from = args->offset[i];
	u32 to = args->offset[i + 1u];
	u32 one = from < to ? ts_k_reflector_of(&args->scene, args->triangles[from]) : TS_NONE;
	for (u32 k = from; k < to; k++) {
		one = ts_k_reflector_of(&args->scene, args->triangles[k]) == one ? one : TS_NONE;
	}
	args->reflectors[args->first + i] = one;
}

/* map over nodes of a level whose children are done */
TS_FN void ts_k_inner_reflector_item(const ts_octree_reflector_args *args, u64 i)
{
	TS_GLOBAL const ts_node *node = &args->nodes[args->first + i];
	u32 one = args->reflectors[node->child];
	for (u32 k = 1u; k < ts_k_count_bits(node->children); k++) {
		one = args->reflectors[node->child + k] == one ? one : TS_NONE;
	}
	args->reflectors[args->first + i] = one;
}

#endif
