/* Linear, spherical and cubic interpolation, glTF 2.0 appendix C; METHODS 2. */
#include "scene/gltf/keyframe.h"
#include "kernels/base/num.h"

#define FRAMES_A_SECOND 30.0f
#define TURNS_A_RADIAN 0.15915494f
#define NEAR 0.0009765625f /* quaternions that are closer together are interpolated linearly */

u32 ts_keyframe_count(f32 seconds)
{
	i32 frames = ts_floor_i32(seconds * FRAMES_A_SECOND + 0.5f);
	return frames > 0 ? (u32)frames : 1;
}

f32 ts_keyframe_time(u32 frame) { return (f32)frame / FRAMES_A_SECOND; }

void ts_keyframe_line(f32 *to, const f32 *a, const f32 *b, u32 n, f32 s)
{
	for (u32 i = 0; i < n; i++) to[i] = ts_san((1.0f - s) * a[i] + s * b[i]);
}

static f32 length4(const f32 *a)
{
	f32 square = 0.0f;
	for (u32 i = 0; i < 4; i++) square += a[i] * a[i];
	return ts_sqrt(ts_flush(square));
}

static void unit(f32 to[4], const f32 *a)
{
	f32 length = length4(a);
	for (u32 i = 0; i < 4; i++) to[i] = length > 0.0f ? a[i] / length : 0.0f;
}

/* Uses the half angle, from the chord between the two and their sum: exact for small angles, too. */
void ts_keyframe_turn(f32 to[4], const f32 a[4], const f32 b[4], f32 s)
{
	f32 p[4], q[4], chord[4], sum[4], dot = 0.0f;
	unit(p, a);
	unit(q, b);
	for (u32 i = 0; i < 4; i++) dot += p[i] * q[i];
	for (u32 i = 0; i < 4; i++) {
		q[i] = dot < 0.0f ? -q[i] : q[i];
		chord[i] = q[i] - p[i];
		sum[i] = q[i] + p[i];
	}
	f32 apart = length4(chord), turns = ts_atan2(apart, length4(sum)) * (2.0f * TURNS_A_RADIAN);
	f32 sine = ts_sin_turn(turns);
	f32 of_a = apart < NEAR ? 1.0f - s : ts_sin_turn((1.0f - s) * turns) / sine;
	f32 of_b = apart < NEAR ? s : ts_sin_turn(s * turns) / sine;
	for (u32 i = 0; i < 4; i++) to[i] = ts_san(of_a * p[i] + of_b * q[i]);
}

void ts_keyframe_cubic(f32 *to, const f32 *a, const f32 *from, const f32 *into, const f32 *b, u32 n, f32 s, f32 seconds)
{
	f32 ss = s * s, sss = ss * s;
	f32 of_b = 3.0f * ss - 2.0f * sss, of_from = sss - 2.0f * ss + s, of_into = sss - ss;
	for (u32 i = 0; i < n; i++) {
		f32 values = (1.0f - of_b) * a[i] + of_b * b[i];
		to[i] = ts_san(values + seconds * (of_from * from[i] + of_into * into[i]));
	}
}
