// Stages `points.count` and `points`, an item per piece: the samples that the piece touches, row by row. Without `key`
// they are counted; otherwise they are written from offset[piece] on.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "stage.glsl"

layout(push_constant, scalar) uniform arguments
{
	uint64_t n_items;
	ts_piece_ref piece;
	ts_align_ref frame;
	u32_ref offset;
	u64_ref key;
	ts_point_ref point;
};

const uint TINY = 1;

float area(ts_piece p)
{
	ts_v3 a = load(p.a);
	return 0.5 * ts_length(ts_cross(ts_sub(load(p.b), a), ts_sub(load(p.c), a)));
}

// Centre c + (x/s) u + (y/s) v, length 1/s.
ts_point made(uint i, uint flags, int x, int y)
{
	ts_align f = frame[i].v;
	ts_v3 along = ts_mad(load(f.c), load(f.u), float(x) / f.s);
	return ts_point(stored(ts_mad(along, load(f.v), float(y) / f.s)), ts_put(1.0 / f.s), i, flags, uint[2](0, 0));
}

void main()
{
	uint i = item();
	if (i >= n_items) return;
	ts_align f = frame[i].v;
	ts_cover cover;
	cover.n = 3;
	for (uint k = 0; k < 3; k++) cover.v[k] = ts_snapped(f.q[2 * k], f.q[2 * k + 1]);
	ts_k_cover_finish(cover, HALF_SIZE);
	uint flags = (area(piece[i].v) * f.s) * f.s < 1.0 ? TINY : 0;

	bool counting = uint64_t(key) == 0;
	uint at = counting ? 0 : offset[i].v;
	for (int y = cover.touched.y0; y <= cover.touched.y1 && f.s > 0.0; y++) {
		for (int x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_touches(cover, x, y)) continue;
			if (!counting) {
				key[at].v = uint64_t(i) << 32 | uint64_t(uint(y + 32768)) << 16 | uint64_t(uint(x + 32768));
				point[at].v = made(i, flags, x, y);
			}
			at++;
		}
	}
	if (counting) offset[i].v = at;
}
