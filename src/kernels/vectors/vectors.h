/* The primitives that all methods share. */
#ifndef TS_KERNELS_VECTORS_VECTORS_H
#define TS_KERNELS_VECTORS_VECTORS_H
#include "kernels/vectors/vectors_args.h"
#include "kernels/vectors/vectors_memory.h"
#include "kernels/vectors/vectors_number.h"
#include "kernels/vectors/vectors_raster.h"
#include "kernels/vectors/vectors_texture.h"

/* In the order in which a porter needs them. The primitives of families follow: kernels/<family>/vectors.h. */
#define TS_LIST_vectors(VECTOR) \
	VECTOR(add) \
	VECTOR(sub) \
	VECTOR(mul) \
	VECTOR(div) \
	VECTOR(sqrt) \
	VECTOR(muladd) \
	VECTOR(mulsub) \
	VECTOR(compare) \
	VECTOR(floor) \
	VECTOR(i32_to_f32) \
	VECTOR(u32_to_f32) \
	VECTOR(i64_to_f32) \
	VECTOR(third) \
	VECTOR(constants) \
	VECTOR(min) \
	VECTOR(max) \
	VECTOR(clamp) \
	VECTOR(abs) \
	VECTOR(san) \
	VECTOR(put) \
	VECTOR(fix) \
	VECTOR(to_half) \
	VECTOR(f2i) \
	VECTOR(floor_i32) \
	VECTOR(rint) \
	VECTOR(pcg) \
	VECTOR(random) \
	VECTOR(uniform) \
	VECTOR(log2) \
	VECTOR(exp) \
	VECTOR(sin_turn) \
	VECTOR(cos_turn) \
	VECTOR(atan2) \
	VECTOR(diff_of_products) \
	VECTOR(dot) \
	VECTOR(cross) \
	VECTOR(mad) \
	VECTOR(length) \
	VECTOR(normalize) \
	VECTOR(reflect) \
	VECTOR(blend) \
	VECTOR(cut) \
	VECTOR(project) \
	VECTOR(snap) \
	VECTOR(edge) \
	VECTOR(floor_quotient) \
	VECTOR(top_left) \
	VECTOR(covers) \
	VECTOR(touches) \
	VECTOR(touched_row) \
	VECTOR(fragment) \
	VECTOR(fragment_parallel) \
	VECTOR(cube_face) \
	VECTOR(cube_place) \
	VECTOR(cube_texel) \
	VECTOR(key) \
	VECTOR(key_min) \
	VECTOR(point_key) \
	VECTOR(min_u32) \
	VECTOR(add_i64) \
	VECTOR(scan) \
	VECTOR(morton) \
	VECTOR(unmorton) \
	VECTOR(texture_wrap) \
	VECTOR(texture_neighbour) \
	VECTOR(texture_mix4) \
	VECTOR(texture_mix2) \
	VECTOR(texture_blend) \
	VECTOR(texture_bilinear) \
	VECTOR(texture_lod) \
	VECTOR(srgb)
/* map over rows */
TS_VECTORS(vectors)

#endif
