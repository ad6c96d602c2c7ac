// Stage `splat`, an item per point: its square into each face of a cube that may see its triangle. The nearest point
// keeps a texel; of equally near ones the one of the lowest index.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "stage.glsl"

layout(push_constant, scalar) uniform arguments
{
	uint64_t n_items, n_cubes, n_words;
	ts_face_ref cube;
	u64_ref bits;
	ts_piece_ref piece;
	ts_align_ref frame;
	ts_point_ref point;
	u64_ref texel;
};

// Step 1: a corner of the point's square in the view of a face.
ts_corner corner(ts_camera_k view, ts_point p, float a, float b)
{
	float half_length = p.length_ * 0.5;
	ts_v3 along = ts_mad(load(p.centre), load(frame[p.piece].v.u), a * half_length);
	return ts_k_to_view(view, ts_mad(along, load(frame[p.piece].v.v), b * half_length));
}

// Step 2: 2^-19 of the greatest coordinate of a piece.
float slack(ts_piece p)
{
	ts_v3 most = load(p.a), b = load(p.b), c = load(p.c);
	most = ts_v3(ts_max(ts_abs(most.x), ts_abs(b.x)), ts_max(ts_abs(most.y), ts_abs(b.y)), ts_max(ts_abs(most.z), ts_abs(b.z)));
	return ts_max(ts_max(ts_max(most.x, ts_abs(c.x)), ts_max(most.y, ts_abs(c.y))), ts_max(most.z, ts_abs(c.z))) * 0.0000019073486328125;
}

// Steps 1 and 2: the texels whose centres the box of the projected square has; none where nothing is before the near
// plane.
ts_box square_box(ts_camera_k view, ts_point p)
{
	ts_polygon square;
	square.n = 4;
	square.corner[0] = corner(view, p, -1.0, -1.0);
	square.corner[1] = corner(view, p, 1.0, -1.0);
	square.corner[2] = corner(view, p, 1.0, 1.0);
	square.corner[3] = corner(view, p, -1.0, 1.0);
	ts_k_clip_behind(view, square, ts_k_near_plane(view));
	if (square.n == 0) return ts_box(0, 0, -1, -1);
	ts_v2 low = ts_k_project(view, square.corner[0]), high = low;
	float z = square.corner[0].z;
	for (uint k = 1; k < square.n; k++) {
		ts_v2 q = ts_k_project(view, square.corner[k]);
		low = ts_v2(ts_min(low.x, q.x), ts_min(low.y, q.y));
		high = ts_v2(ts_max(high.x, q.x), ts_max(high.y, q.y));
		z = ts_min(z, square.corner[k].z);
	}
	float inset = ts_max(127.0 / 256.0 - (view.focal * slack(piece[p.piece].v)) / z, 0.0);
	return ts_box(ts_floor_i32(low.x + inset), ts_floor_i32(low.y + inset), ts_floor_i32(high.x - inset),
	              ts_floor_i32(high.y - inset));
}

// Step 3: the piece, clipped and projected; of no corners where the face does not see it.
ts_cover outline(ts_camera_k view, ts_piece p)
{
	ts_polygon clipped = ts_k_polygon(view, load(p.a), load(p.b), load(p.c));
	ts_k_clip_to_range(view, clipped);
	ts_cover cover;
	cover.n = clipped.n;
	for (uint k = 0; k < clipped.n; k++) cover.v[k] = ts_k_snap(ts_k_project(view, clipped.corner[k]));
	if (cover.n != 0) ts_k_cover_finish(cover, HALF_SIZE);
	return cover;
}

void splat(ts_camera_k view, uint i, uint64_t first)
{
	ts_point p = point[i].v;
	ts_cover cover = outline(view, piece[p.piece].v);
	if (cover.n == 0) return;
	ts_box box = ts_k_box_meet(square_box(view, p), ts_k_box_meet(ts_k_view_box(view), cover.touched));
	float distance = ts_put(ts_length(ts_sub(load(p.centre), view.eye)));
	uint64_t mine = uint64_t(floatBitsToUint(distance)) << 32 | i;
	for (int y = box.y0; y <= box.y1; y++) {
		for (int x = box.x0; x <= box.x1; x++) {
			if (ts_k_touches(cover, x, y)) atomicMin((texel + (first + uint(y * view.width + x))).v, mine);
		}
	}
}

void main()
{
	uint i = item();
	if (i >= n_items) return;
	uint triangle = piece[point[i].v.piece].v.triangle;
	for (uint bit = 0; bit < 6 * uint(n_cubes); bit++) {
		if (((bits + (triangle * n_words + bit / 64)).v >> (bit % 64) & 1) == 0) continue;
		ts_face_ref of = cube + bit / 6;
		uint64_t a_face = uint64_t(of.v.n) * of.v.n;
		splat(ts_k_cube_view(of, bit % 6), i, of.v.offset + bit % 6 * a_face);
	}
}
