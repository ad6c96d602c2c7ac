/* Skins, glTF 2.0 section 3.7.3: the matrix of a joint is that of its node, times its inverse bind matrix; a vertex
 * goes where the sum of its joints' matrices by its weights takes it, whatever its mesh's node says. Joints stand as
 * at frame 0. */
#include "scene/gltf/gltf.h"

namespace gltf {

static ts_place bind_of(const view &list, size_t joint)
{
	f32 matrix[16];
	for (int k = 0; k < 16; k++) matrix[k] = list.number(joint, k);
	return place_of_matrix(matrix, "accessors/" + std::to_string(list.id) + " (inverseBindMatrices): item " +
	                                   std::to_string(joint));
}

static std::vector<ts_place> read_pose(loader &in, int index)
{
	const tinygltf::Skin &skin = in.model.skins.at((size_t)index);
	std::vector<ts_place> pose;
	view binds{};
	bool bound = skin.inverseBindMatrices >= 0;
	if (bound)
		binds = view_open(in, skin.inverseBindMatrices, TINYGLTF_TYPE_MAT4, TINYGLTF_TYPE_MAT4, AS_FLOAT,
		                  "inverseBindMatrices");
	if (bound && binds.count < skin.joints.size())
		fail("skins/%d: %zu inverse bind matrices for %zu joints", index, binds.count, skin.joints.size());
	for (size_t i = 0; i < skin.joints.size(); i++) {
		ts_place joint = node_place(in, skin.joints[i]);
		if (bound) {
			ts_place bind = bind_of(binds, i);
			joint = ts_place_compose(&joint, &bind);
		}
		pose.push_back(joint);
	}
	return pose;
}

std::vector<ts_place> skin_pose(loader &in, int index)
{
	try {
		return read_pose(in, index);
	} catch (const error &e) {
		if (e.kind != TS_KIND_FORMAT) throw;
		in.notes.insert(e.line + ": the skin is ignored");
		return {};
	}
}

/* Whether one of the four joints counts. */
static bool is_held(const influence &by, size_t k, size_t n_joints)
{
	return by.weight[k] > 0.0f && by.joint[k] < (f32)n_joints;
}

/* The blended matrix; without a weight that of nothing: the vertex stands as modelled. */
static ts_place blend(const std::vector<ts_place> &pose, const influence &by)
{
	f32 sum = 0.0f, matrix[16] = {0.0f};
	for (size_t k = 0; k < 4; k++) sum += is_held(by, k, pose.size()) ? by.weight[k] : 0.0f;
	if (!(sum > 0.0f)) return ts_place_identity();
	for (size_t k = 0; k < 4; k++) {
		if (!is_held(by, k, pose.size())) continue;
		const ts_place &joint = pose[(size_t)by.joint[k]];
		f32 weight = by.weight[k] / sum;
		for (size_t row = 0; row < 3; row++) {
			for (size_t column = 0; column < 3; column++)
				matrix[4 * column + row] += weight * joint.linear[3 * row + column];
			matrix[12 + row] += weight * joint.origin[row];
		}
	}
	matrix[15] = 1.0f;
	return ts_place_from_matrix(matrix);
}

static constexpr f32 near_1 = 0x1p-7f; /* of weights of bytes, each of which is rounded */

void skin_note(loader &in, const piece &piece, size_t n_joints)
{
	for (const influence &by : piece.influences) {
		f32 sum = 0.0f;
		for (size_t k = 0; k < 4; k++) {
			sum += is_held(by, k, n_joints) ? by.weight[k] : 0.0f;
			if (by.weight[k] != 0.0f && !is_held(by, k, n_joints))
				in.notes.insert("weights below 0, and joints that a skin does not have, are ignored");
		}
		if (ts_abs(sum - 1.0f) > near_1)
			in.notes.insert("weights of joints that do not add up to 1 are divided by their sum");
	}
}

void skin_place(ts_build *build, const piece &piece, const std::vector<ts_place> &pose)
{
	u32 first = 0;
	std::vector<bool> mirrored;
	for (size_t i = 0; i < piece.vertices.size() && !ts_build_failed(build); i++) {
		ts_place place = blend(pose, piece.influences[i]);
		ts_vertex vertex = ts_place_vertex(&place, &piece.vertices[i]);
		u32 index = ts_build_vertex(build, &vertex);
		if (i == 0) first = index;
		mirrored.push_back(place.side < 0.0f);
	}
	for (size_t i = 0; i < piece.corners.size() && !ts_build_failed(build); i += 3) {
		u32 b = piece.corners[i + 1], c = piece.corners[i + 2];
		if (mirrored[piece.corners[i]]) std::swap(b, c);
		ts_build_triangle(build, first + piece.corners[i], first + b, first + c, piece.material);
	}
}

} // namespace gltf
