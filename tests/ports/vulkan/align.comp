// Stage `align`, an item per piece: the lattice in the piece's plane, its longest edge along u, its centroid on a sample.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "stage.glsl"

layout(push_constant, scalar) uniform arguments
{
	uint64_t n_items;
	ts_piece_ref piece;
	f32_ref density;
	u32_ref keep;
	ts_align_ref frame;
};

void main()
{
	uint i = item();
	if (i >= n_items) return;
	ts_v3 corner[3] = ts_v3[3](load(piece[i].v.a), load(piece[i].v.b), load(piece[i].v.c));

	uint longest = 0;
	float length_of[3];
	for (uint k = 0; k < 3; k++) {
		length_of[k] = ts_length(ts_sub(corner[(k + 1) % 3], corner[k]));
		if (length_of[k] > length_of[longest]) longest = k;
	}
	ts_v3 u = ts_normalize(ts_sub(corner[(longest + 1) % 3], corner[longest]));
	ts_v3 n = ts_normalize(ts_cross(ts_sub(corner[1], corner[0]), ts_sub(corner[2], corner[0])));
	ts_v3 v = ts_normalize(ts_cross(n, u));
	ts_v3 c = ts_scale(ts_add(ts_add(corner[0], corner[1]), corner[2]), uintBitsToFloat(0x3eaaaaab)); // 0x1.555556p-2
	float s = keep[i].v != 0 ? density[i].v : 0.0;

	ts_align made;
	made.c = stored(c);
	made.s = s;
	made.u = stored(u);
	made.v = stored(v);
	for (uint k = 0; k < 3; k++) {
		ts_v3 d = ts_sub(corner[k], c);
		made.q[2 * k] = ts_fix(s * ts_dot(u, d) + 0.5, 8, 23);
		made.q[2 * k + 1] = ts_fix(s * ts_dot(v, d) + 0.5, 8, 23);
	}
	made.pad0 = made.pad1 = made.pad2[0] = made.pad2[1] = 0;
	frame[i].v = made;
}
