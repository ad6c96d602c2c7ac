/* Lights (KHR_lights_punctual) and cameras (glTF 2.0 section 3.10) where nodes put them. */
#include "kernels/base/shade.h"
#include "scene/gltf/gltf.h"

namespace gltf {

/* The guard lets no other types through. */
static u32 kind_of(const std::string &type)
{
	if (type == "directional") return TS_LIGHT_KIND_DIRECTIONAL;
	return type == "point" ? TS_LIGHT_KIND_POINT : TS_LIGHT_KIND_SPOT;
}

static void take_cone(loader &in, ts_light &to, const tinygltf::Light &from, int index)
{
	f32 inner = ts_number(from.spot.innerConeAngle), outer = ts_number(from.spot.outerConeAngle);
	if (!(inner <= outer * (1.0f + 0x1p-22f))) /* a rounding above is as good as equal */
		fail("lights/%d/spot: inner cone %g, outer cone %g; the inner one must be smaller", index,
		     from.spot.innerConeAngle, from.spot.outerConeAngle);
	if (inner >= outer)
		in.notes.insert("lights/" + std::to_string(index) + ": inner and outer cone are equal: its edge is hard");
	ts_number_cone(&to.spot_scale, &to.spot_offset, inner, outer);
}

void light_build(loader &in, int index, const ts_place &place)
{
	const tinygltf::Light &from = in.model.lights.at((size_t)index);
	ts_light to = {};
	f32 colour[3] = {1.0f, 1.0f, 1.0f};
	for (size_t i = 0; i < from.color.size() && i < 3; i++) colour[i] = ts_number(from.color[i]);
	ts_number_scale3(to.intensity, colour, ts_number(from.intensity));
	to.range = ts_number(from.range);
	to.kind = kind_of(from.type);
	if (to.kind == TS_LIGHT_KIND_SPOT) take_cone(in, to, from, index);
	ts_place_aim(&place, to.position, to.direction);
	if (to.kind != TS_LIGHT_KIND_POINT && place.side == 0.0f) {
		in.notes.insert("the light " + quoted(from.name) + " is ignored: its node's scale is 0");
		return;
	}
	ts_build_light(in.build, &to);
}

/* Whether the node has a size at every frame. Out: of one that moves its path. */
static bool take_path(std::vector<ts_path_eye> &path, const std::vector<ts_place> &places)
{
	for (const ts_place &place : places) {
		ts_camera at = {};
		ts_path_eye eye = {};
		if (!ts_place_camera(&place, &at)) return false;
		memcpy(eye.eye, at.eye, sizeof eye.eye);
		memcpy(eye.right, at.right, sizeof eye.right);
		memcpy(eye.up, at.up, sizeof eye.up);
		memcpy(eye.back, at.back, sizeof eye.back);
		if (places.size() > 1) path.push_back(eye);
	}
	return true;
}

void camera_build(loader &in, const tinygltf::Node &node, const std::vector<ts_place> &places)
{
	std::vector<ts_path_eye> path;
	const tinygltf::Camera &from = in.model.cameras.at((size_t)node.camera);
	std::string name = !node.name.empty() ? node.name : from.name;
	if (name.empty()) name = "camera-" + std::to_string(node.camera);
	ts_camera to = {};
	to.name = name.data();
	f32 yfov = ts_number(from.perspective.yfov);
	to.yfov = ts_number_turns(yfov);
	if (from.type != "perspective") {
		in.notes.insert("the camera " + quoted(name) + " is ignored: it is not a perspective one");
	} else if (!(yfov > 0.0f && to.yfov < 0.5f)) {
		in.notes.insert("the camera " + quoted(name) + " is ignored: its yfov is not between 0 and pi");
	} else if (!ts_place_camera(&places.front(), &to) || !take_path(path, places)) {
		in.notes.insert("the camera " + quoted(name) + " is ignored: its node's scale is 0");
	} else {
		to.path = path.data();
		to.n_path = (u32)path.size();
		ts_build_camera(in.build, &to);
	}
}

} // namespace gltf
