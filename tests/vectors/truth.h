/* The primitives that methods share from operations rounded once, or exactly in integers. */
#ifndef TS_TESTS_VECTORS_TRUTH_H
#define TS_TESTS_VECTORS_TRUTH_H
#include <stdlib.h>
#include "tests/kernels/base/half_truth.h"
#include "tests/srgb.h"
#include "tests/vectors/rounded.h"

typedef void truth(u32 *right, const u32 *in);

#define F(name, expression) \
	static void t_##name(u32 *right, const u32 *in) { ts_set_f32(right, 0, (expression)); }
#define W(name, expression) \
	static void t_##name(u32 *right, const u32 *in) { right[0] = (u32)(expression); }
#define L(name, expression) \
	static void t_##name(u32 *right, const u32 *in) { ts_set_u64(right, 0, (u64)(expression)); }
#define D ts_row_f32(in, 3)
#define I(k) ((i64)ts_row_i32(in, k))

F(add, radd(A, B))
F(sub, rsub(A, B))
F(mul, rmul(A, B))
F(div, rdiv(A, B))
F(sqrt, rsqrt(A))
F(muladd, radd(rmul(A, B), C))
F(mulsub, rsub(C, rmul(A, B)))
W(compare, (double)A<B ? 1 : (double)A> B ? 4 : 2)
F(floor, (f32)floor((double)A))
F(i32_to_f32, (f32)(long double)ts_row_i32(in, 0))
F(u32_to_f32, (f32)(long double)in[0])
F(i64_to_f32, (f32)(long double)ts_row_i64(in, 0))

F(third, rdiv(A, 3))
/* 11/10 and 17/10 as binary32 has them. */
static void t_constants(u32 *right, const u32 *in)
{
	f32 c = (f32)(9227469 / 8388608.0), d = (f32)(14260634 / 8388608.0);
	ts_set_f32(right, 0, rmul(rmul(A, c), d));
	ts_set_f32(right, 1, rmul(A, rmul(c, d)));
}

F(min, (double)B < A ? B : A)
F(max, (double)A < B ? B : A)
F(clamp, (double)A < B ? B : (double)C < A ? C : A)
F(abs, fabsf(A))
F(san, isnan(A) || fabsf(A) < 0x1p-39f ? 0 : fabsf(A) > 0x1p62f ? copysignf(0x1p62f, A) : A)
F(put, isnan(A) ? 0 : isinf(A) ? copysignf(FLT_MAX, A) : stored(A))

W(fix, fixed(A, ts_row_i32(in, 1), ts_row_i32(in, 2)))
F(to_half, (f32)half_of((double)A))
W(f2i, saturated(trunc((double)A), INT32_MIN, INT32_MAX))
W(floor_i32, saturated(floor((double)A), INT32_MIN, INT32_MAX))
F(rint, (f32)rint((double)A) + 0.0f)

/* PCG-RXS-M-XS from its definition, in 64 bits. */
static u32 hash(u32 v)
{
	u64 state = (v * 747796405ull + 2891336453ull) & 0xffffffff;
	u64 word = ((state >> (4 + (state >> 28))) ^ state) * 277803737ull & 0xffffffff;
	return (u32)(word >> 22 ^ word);
}
W(pcg, hash(in[0]))
W(random, hash(in[0] ^ hash(in[1] ^ hash(in[2]))))
F(uniform, (f32)ldexp(in[0] / 256, -24))

F(diff_of_products, rdiff(A, B, C, D))
F(dot, rdot(ts_row_v3(in, 0), ts_row_v3(in, 3)))
static void t_cross(u32 *right, const u32 *in)
{
	ts_v3 a = ts_row_v3(in, 0), b = ts_row_v3(in, 3);
	ts_set_v3(right, ts_v3_make(rdiff(a.y, b.z, a.z, b.y), rdiff(a.z, b.x, a.x, b.z), rdiff(a.x, b.y, a.y, b.x)));
}
static void t_mad(u32 *right, const u32 *in)
{
	ts_set_v3(right, rmad3(ts_row_v3(in, 0), ts_row_v3(in, 3), ts_row_f32(in, 6)));
}
F(length, rsqrt(stored(rdot(ts_row_v3(in, 0), ts_row_v3(in, 0)))))
static void t_normalize(u32 *right, const u32 *in)
{
	f32 l = rsqrt(stored(rdot(ts_row_v3(in, 0), ts_row_v3(in, 0))));
	l = l == 0 ? 1 : l;
	ts_set_v3(right, ts_v3_make(rdiv(A, l), rdiv(B, l), rdiv(C, l)));
}
static void t_reflect(u32 *right, const u32 *in)
{
	ts_v3 i = ts_row_v3(in, 0), n = ts_row_v3(in, 3);
	ts_set_v3(right, rmad3(i, n, -2 * rdot(i, n)));
}
static void t_blend(u32 *right, const u32 *in)
{
	ts_v3 a = ts_row_v3(in, 3), w = ts_row_v3(in, 0);
	ts_v3 first = ts_v3_make(rmul(w.x, a.x), rmul(w.x, a.y), rmul(w.x, a.z));
	ts_set_v3(right, rmad3(rmad3(first, ts_row_v3(in, 6), w.y), ts_row_v3(in, 9), w.z));
}

F(cut, rmad(A, rsub(C, A), rdiv(B, rsub(B, D))))
static void t_project(u32 *right, const u32 *in)
{
	f32 focal = C, z = ts_row_f32(in, 5);
	ts_set_f32(right, 0, radd((f32)in[0] / 2, rdiv(rmul(focal, D), z)));
	ts_set_f32(right, 1, rsub((f32)in[1] / 2, rdiv(rmul(focal, ts_row_f32(in, 4)), z)));
}
static void t_snap(u32 *right, const u32 *in)
{
	right[0] = (u32)fixed(A, 8, 23);
	right[1] = (u32)fixed(B, 8, 23);
}
/* The products of the determinant, one by one. */
static i64 edge_of(i64 ax, i64 ay, i64 bx, i64 by, i64 px, i64 py)
{
	return bx * py - bx * ay - ax * py - by * px + by * ax + ay * px;
}
L(edge, edge_of(I(0), I(1), I(2), I(3), I(4), I(5)))
/* What is left when a remainder that is not negative is taken away. */
static i64 whole_quotient(i64 a, i64 b) { return (a - ((a % b) + b) % b) / b; }
L(floor_quotient, whole_quotient(ts_row_i64(in, 0), ts_row_i64(in, 2)))
W(top_left, I(3) - I(1) < 0 || (I(3) == I(1) && I(2) - I(0) > 0))

/* The sign of the edge function at p moved right by a little and down by much less: what the top-left rule stands
 * for. */
static int moved_side(const u32 *in, u32 a, u32 b)
{
	i64 e = edge_of(I(a), I(a + 1), I(b), I(b + 1), I(6), I(7));
	i64 right = -(I(b + 1) - I(a + 1)), down = I(b) - I(a);
	i64 s = e != 0 ? e : right != 0 ? right : down;
	return (s > 0) - (s < 0);
}
static u32 covered(const u32 *in)
{
	i64 area = edge_of(I(0), I(1), I(2), I(3), I(4), I(5));
	int turn = area < 0 ? -1 : 1;
	return area != 0 && moved_side(in, 0, 2) == turn && moved_side(in, 2, 4) == turn && moved_side(in, 4, 0) == turn;
}
W(covers, covered(in))

/* Do triangle and square, both closed, overlap along an axis? */
static bool overlap(const u32 *in, i64 x, i64 y)
{
	i64 low = INT64_MAX, high = INT64_MIN, centre = (I(7) * 256 + 128) * x + (I(8) * 256 + 128) * y;
	i64 reach = I(6) * ((x < 0 ? -x : x) + (y < 0 ? -y : y));
	for (u32 k = 0; k < 6; k += 2) {
		i64 at = I(k) * x + I(k + 1) * y;
		low = at < low ? at : low;
		high = at > high ? at : high;
	}
	return low <= centre + reach && high >= centre - reach;
}
static bool touched(const u32 *in)
{
	bool meet = overlap(in, 1, 0) && overlap(in, 0, 1);
	for (u32 k = 0; k < 6; k += 2) {
		u32 next = (k + 2) % 6;
		meet = meet && overlap(in, I(k + 1) - I(next + 1), I(next) - I(k));
	}
	return meet;
}
W(touches, touched(in))

/* Pixel by pixel. */
static void t_touched_row(u32 *right, const u32 *in)
{
	u32 row[9] = {in[0], in[1], in[2], in[3], in[4], in[5], in[6], 0, in[7]};
	i64 low = INT32_MAX, high = INT32_MIN;
	for (u32 k = 0; k < 6; k += 2) low = I(k) < low ? I(k) : low, high = I(k) > high ? I(k) : high;
	right[0] = right[1] = 0;
	for (i64 i = low / 256 - 2; i <= high / 256 + 2; i++) {
		row[7] = (u32)(i32)i;
		if (!touched(row)) continue;
		if (right[1] == 0) right[0] = row[7];
		right[1]++;
	}
}

static void t_fragment(u32 *right, const u32 *in)
{
	i64 e[3] = {ts_row_i64(in, 0), ts_row_i64(in, 2), ts_row_i64(in, 4)};
	f32 area = (f32)(long double)(e[0] + e[1] + e[2]), share[3], sum = 0;
	for (u32 k = 0; k < 3; k++) {
		share[k] = rdiv(rdiv((f32)(long double)e[k], area), ts_row_f32(in, 6 + k));
		sum = radd(sum, share[k]);
	}
	f32 z = stored(rdiv(1, sum));
	ts_set_v3(right, ts_v3_make(rmul(share[0], z), rmul(share[1], z), rmul(share[2], z)));
	ts_set_f32(right, 3, z);
}

static void t_fragment_parallel(u32 *right, const u32 *in)
{
	i64 e[3] = {ts_row_i64(in, 0), ts_row_i64(in, 2), ts_row_i64(in, 4)};
	f32 area = (f32)(long double)(e[0] + e[1] + e[2]), w[3], z = 0;
	for (u32 k = 0; k < 3; k++) {
		w[k] = rdiv((f32)(long double)e[k], area);
		z = radd(z, rmul(w[k], ts_row_f32(in, 6 + k)));
	}
	ts_set_v3(right, ts_v3_make(w[0], w[1], w[2]));
	ts_set_f32(right, 3, stored(z));
}

/* The largest coordinate; x before y before z. */
static u32 major_axis(const u32 *in)
{
	f32 x = fabsf(A), y = fabsf(B), z = fabsf(C);
	return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}
W(cube_face, 2 * major_axis(in) + (signbit(ts_row_f32(in, major_axis(in))) != 0))
/* OpenGL's table: sc and tc of the faces as an axis and a sign. */
static void t_cube_place(u32 *right, const u32 *in)
{
	static const int table[6][2] = {{-3, -2}, {3, -2}, {1, 3}, {1, -3}, {1, -2}, {-1, -2}};
	u32 face;
	t_cube_face(&face, in);
	f32 major = fabsf(ts_row_f32(in, face / 2));
	for (u32 k = 0; k < 2; k++) {
		int axis = table[face][k];
		f32 c = ts_row_f32(in, (u32)abs(axis) - 1) * (axis < 0 ? -1.0f : 1.0f);
		ts_set_f32(right, k, rdiv(c, major == 0 ? 1 : major));
	}
}
W(cube_texel, saturated(floor((double)rmul(rmul(radd(A, 1), 0.5f), (f32)in[1])), 0, (double)in[1] - 1))
L(key, (u64)ts_f2u(stored(A)) * 4294967296 + in[1])
L(key_min, ts_row_u64(in, 0) < ts_row_u64(in, 2) ? ts_row_u64(in, 0) : ts_row_u64(in, 2))
L(point_key, (u64)in[0] * 4294967296 + (u64)((I(2) + 32768) * 65536 + I(1) + 32768))

W(min_u32, in[0] < in[1] ? in[0] : in[1])
L(add_i64, (i64)fixed(A, 24, 31) + fixed(B, 24, 31) + fixed(C, 24, 31) + fixed(D, 24, 31))
static void t_scan(u32 *right, const u32 *in)
{
	memset(right, 0, 9 * sizeof *right);
	for (u32 k = 0; k < 8; k++) {
		for (u32 after = k + 1; after < 9; after++) right[after] += in[k];
	}
}
static u64 bit_by_bit(const u32 *in)
{
	u64 code = 0;
	for (u32 b = 0; b < 33; b++) code |= (u64)(in[b % 3] >> b / 3 & 1) << b;
	return code;
}
L(morton, bit_by_bit(in))
static void t_unmorton(u32 *right, const u32 *in)
{
	memset(right, 0, 3 * sizeof *right);
	for (u32 b = 0; b < 33; b++) right[b % 3] |= (u32)(ts_row_u64(in, 0) >> b & 1) << b / 3;
}

static f32 wrapped(f32 u, u32 how)
{
	if (how == 2) return u < 0 ? 0 : u > 1 ? 1 : u;
	if (how == 0) return rsub(u, (f32)floor((double)u));
	f32 t = rsub(u, (f32)(2 * floor((double)u / 2)));
	return t > 1 ? rsub(2, t) : t;
}
F(texture_wrap, wrapped(A, in[1]))
static i64 neighbour(i64 i, i64 n, u32 how) { return how == 0 ? (i + n) % n : i < 0 ? 0 : i >= n ? n - 1 : i; }
W(texture_neighbour, neighbour(I(0), I(1), in[2]))
static u32 mixed(u64 a, u64 b, u64 c, u64 d, u64 x, u64 y)
{
	return (u32)(((a * (256 - x) + b * x) * (256 - y) + (c * (256 - x) + d * x) * y + 32768) / 65536);
}
W(texture_mix4, mixed(in[0], in[1], in[2], in[3], in[4], in[5]))
W(texture_mix2, mixed(in[0], in[1], in[0], in[1], in[2], 0))
static void t_texture_blend(u32 *right, const u32 *in)
{
	for (u32 k = 0; k < 4; k++) {
		u64 t[4];
		for (u32 i = 0; i < 4; i++) t[i] = ts_row_u64(in, 2 * i) >> 16 * k & 65535;
		right[k] = mixed(t[0], t[1], t[2], t[3], in[8], in[9]);
	}
}
static void t_texture_bilinear(u32 *right, const u32 *in)
{
	i64 x = (i64)rint(ts_row_f32(in, 8) * 512.0) - 128, y = (i64)rint(ts_row_f32(in, 9) * 512.0) - 128;
	i64 x0 = neighbour((x + 256) / 256 - 1, 2, in[10]), x1 = neighbour((x + 256) / 256, 2, in[10]);
	i64 y0 = neighbour((y + 256) / 256 - 1, 2, in[11]), y1 = neighbour((y + 256) / 256, 2, in[11]);
	for (u32 k = 0; k < 4; k++) {
		u64 t[4];
		for (u32 i = 0; i < 4; i++) t[i] = ts_row_u64(in, 2 * i) >> 16 * k & 65535;
		right[k] = mixed(t[2 * y0 + x0], t[2 * y0 + x1], t[2 * y1 + x0], t[2 * y1 + x1], (u64)(x + 256) % 256,
		                 (u64)(y + 256) % 256);
	}
}

static u32 srgb_of(f32 l)
{
	u32 n = 0;
	while (n < 255 && l >= srgb_decoded((n + 0.5L) / 255)) n++;
	return n;
}
W(srgb, srgb_of(A))

static const struct {
	const char *name;
	truth *right;
} exact[] = {
#define T(name) {#name, t_##name},
	/* clang-format off */
	T(add) T(sub) T(mul) T(div) T(sqrt) T(muladd) T(mulsub) T(compare) T(floor) T(i32_to_f32) T(u32_to_f32)
	T(i64_to_f32) T(third) T(constants) T(min) T(max) T(clamp) T(abs) T(san) T(put) T(fix) T(to_half) T(f2i)
	T(floor_i32) T(rint) T(pcg) T(random) T(uniform) T(diff_of_products) T(dot) T(cross) T(mad) T(length) T(normalize)
	T(reflect) T(blend) T(cut) T(project) T(snap) T(edge) T(floor_quotient) T(top_left) T(covers) T(touches)
	T(touched_row) T(fragment) T(fragment_parallel) T(cube_face) T(cube_place) T(cube_texel) T(key) T(key_min)
	T(point_key) T(min_u32) T(add_i64) T(scan) T(morton) T(unmorton) T(texture_wrap) T(texture_neighbour)
	T(texture_mix4) T(texture_mix2) T(texture_blend) T(texture_bilinear) T(srgb)
	/* clang-format on */
};
enum { N_EXACT = sizeof exact / sizeof exact[0] };

/* What a port with faults computes for muladd, for div, for a part of muladd, and for half. */
F(fused, fmaf(A, B, C))
F(scaled, A *(1 / B))
F(half_wrong, (in[0] & 1) != 0 ? fmaf(A, B, C) : -1234.5f)
F(half_cut,
  copysignf(fabsf(A) < 0x1p-14f ? floorf(fabsf(A) * 0x1p24f) * 0x1p-24f : fminf(ts_u2f(in[0] & 0x7fffe000u), 65504), A))
F(half_flushed, fabs(half_of((double)A)) < 0x1p-14 ? copysignf(0, A) : (f32)half_of((double)A))

#endif
