// Stage `lookup`, an item per sample of a reflective pixel: the point in the texel that the mirrored ray meets.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "stage.glsl"
#include "points/samples.glsl"

layout(push_constant, scalar) uniform arguments
{
	uint64_t n_items;
	ts_view_ref eye;
	ts_face_ref cube;
	ts_pixel_ref pixel;
	u64_ref texel;
	u32_ref found;
};

const uint NONE = 0xffffffffu;

// A value o pixels away, by its changes to the right and down.
ts_v3 beside(float at[3], float right[3], float down[3], ts_v2 o)
{
	return ts_mad(ts_mad(load(at), load(right), o.x), load(down), o.y);
}

void main()
{
	uint i = item();
	if (i >= n_items) return;
	ts_pixel m = pixel[i / 25].v;
	ts_v2 o = ts_k_sample_offset(i % 25);
	ts_v3 p = beside(m.position, m.position_dx, m.position_dy, o);
	ts_v3 n = ts_normalize(beside(m.normal, m.normal_dx, m.normal_dy, o));
	ts_v3 towards = ts_normalize(ts_sub(p, load(eye.v.eye)));
	ts_v3 mirrored = ts_normalize(ts_mad(towards, n, -2.0 * ts_dot(towards, n)));
	ts_face_ref of = cube + m.reflector;
	u64_ref seen = texel + (of.v.offset + ts_k_cube_index(ts_k_cube_place(mirrored), of.v.n));
	found[i].v = of.v.n != 0 ? uint(seen.v) : NONE; // the lower half of an empty texel is NONE
}
