/* Numbers of a glTF file: KHR_texture_transform, KHR_lights_punctual and the normalized integers of glTF 2.0. */
#include "scene/gltf/numbers.h"
#include "kernels/base/vec.h"

#define TURNS_A_RADIAN 0.15915493667125701904296875f
#define LEAST_CONE 0.001000000047497451305389404296875f

f32 ts_number(double x)
{
	if (!(x <= (double)FLT_MAX)) return x == x ? TS_MOST_INPUT : 0.0f;
	if (x < -(double)FLT_MAX) return -TS_MOST_INPUT;
	return ts_san((f32)x);
}

f32 ts_number_unorm8(u32 x) { return (f32)x / 255.0f; }
f32 ts_number_unorm16(u32 x) { return (f32)x / 65535.0f; }
f32 ts_number_snorm8(i32 x) { return ts_max((f32)x / 127.0f, -1.0f); }
f32 ts_number_snorm16(i32 x) { return ts_max((f32)x / 32767.0f, -1.0f); }
f32 ts_number_turns(f32 radians) { return ts_put(radians * TURNS_A_RADIAN); }

void ts_number_uv_transform(f32 transform[6], const f32 offset[2], f32 rotation, const f32 scale[2])
{
	f32 turns = ts_number_turns(rotation);
	f32 s = ts_sin_turn(turns), c = ts_cos_turn(turns);
	transform[0] = ts_put(c * scale[0]);
	transform[1] = ts_put(s * scale[1]);
	transform[2] = offset[0];
	transform[3] = ts_put(-s * scale[0]);
	transform[4] = ts_put(c * scale[1]);
	transform[5] = offset[1];
}

void ts_number_cone(f32 *spot_scale, f32 *spot_offset, f32 inner, f32 outer)
{
	f32 cos_inner = ts_cos_turn(ts_number_turns(inner));
	f32 cos_outer = ts_cos_turn(ts_number_turns(outer));
	f32 width = ts_max(LEAST_CONE, cos_inner - cos_outer);
	f32 scale = 1.0f / width;
	*spot_scale = ts_put(scale);
	*spot_offset = ts_put(-cos_outer * scale);
}

void ts_number_scale3(f32 to[3], const f32 factor[3], f32 strength)
{
	ts_store3(to, ts_scale(ts_load3(factor), strength));
}
