/* The scene graph, glTF 2.0 section 3.5: walked from its roots without recursion, parents before children, children in
 * order. Every instance of a mesh becomes triangles of its own in world space. */
#include <algorithm>
#include "model/core.h"
#include "scene/gltf/gltf.h"

namespace gltf {

static constexpr uint64_t most_items = 1u << 28; /* triangles or vertices of a scene */

/* A node that the file moves, and what stands still below it. */
struct mover {
	std::vector<ts_place> places; /* in the world, by frame */
	u32 object;                   /* of the scene; 0: nothing is drawn yet */
};

struct visit {
	int node;
	ts_place parent; /* in the world, or in the space of the mover */
	int mover;       /* -1: none */
	bool leave;      /* all below the node was visited */
};

/* A node whose end matters: it has a name, or a reflector begins at it. */
struct opened {
	int node;
	uint64_t n_before; /* triangles */
	bool is_reflector;
	size_t named; /* of the walker */
};

struct named {
	int node;
	uint64_t n_triangles; /* at or below it */
};

struct walker {
	loader &in;
	std::vector<unsigned> uses; /* of each mesh by nodes still to come */
	std::map<int, std::vector<piece>> pieces;
	std::map<int, std::vector<ts_place>> poses; /* of skins */
	std::vector<visit> stack;
	std::vector<mover> movers;
	std::vector<opened> open;
	std::vector<named> names;
	uint64_t n_triangles = 0, n_vertices = 0, n_surfels = 0;
	bool in_reflector = false;
	unsigned n_reflectors = 0;
	void enter(const visit &from);
	void leave();
	visit arrive(const visit &from);
	ts_place place_at(const visit &at, u32 frame) const;
	spot spot_of(const visit &at) const;
	int add_mover(const visit &from);
	void select_object(const visit &at);
	void draw_mesh(const tinygltf::Node &node, const visit &at);
	void draw(int mesh, const visit &at, const std::vector<ts_place> *pose);
	const std::vector<ts_place> *pose_of(int skin);
	void place_camera(const visit &at);
	void begin_reflector(const visit &at);
	void end_reflector(const opened &from);
};

static std::string where_of(int node) { return "nodes/" + std::to_string(node); }

/* Whose child each node is; -1: nobody's. */
static std::vector<int> parents_of(const loader &in)
{
	std::vector<int> parents(in.model.nodes.size(), -1);
	for (size_t i = 0; i < parents.size(); i++)
		for (int child : in.model.nodes[i].children) {
			int &parent = parents.at((size_t)child);
			if (parent >= 0)
				fail("%s is a child of nodes/%d and of nodes/%zu; one parent is expected", where_of(child).c_str(),
				     parent, i);
			parent = (int)i;
		}
	return parents;
}

/* Which nodes stand below a root. Nodes that nothing without a parent leads to stand in a circle or below one. */
static std::vector<bool> below_roots(const loader &in, const std::vector<int> &parents,
                                     const std::vector<bool> &is_root)
{
	std::vector<bool> below(parents.size()), reached(parents.size());
	std::vector<size_t> order;
	for (size_t i = 0; i < parents.size(); i++)
		if (parents[i] < 0) order.push_back(i);
	for (size_t i = 0; i < order.size(); i++) {
		size_t node = order[i];
		reached[node] = true;
		for (int child : in.model.nodes[node].children) {
			below[(size_t)child] = below[node] || is_root[node];
			order.push_back((size_t)child);
		}
	}
	size_t lost = (size_t)(std::find(reached.begin(), reached.end(), false) - reached.begin());
	if (lost == parents.size()) return below;
	for (size_t i = 0; i < parents.size(); i++) lost = (size_t)parents[lost];
	fail("%s is its own ancestor", where_of((int)lost).c_str());
}

/* What the scene draws: its roots, each once, and not those that it draws as children already. */
static std::vector<int> roots_of(loader &in)
{
	std::vector<int> roots;
	const std::vector<int> &parents = in.parents = parents_of(in);
	if (in.model.scenes.empty()) return roots;
	const tinygltf::Scene &scene = in.model.scenes.at(in.model.defaultScene < 0 ? 0 : (size_t)in.model.defaultScene);
	std::vector<bool> is_root(parents.size()), drawn;
	for (int node : scene.nodes) is_root.at((size_t)node) = true;
	drawn = below_roots(in, parents, is_root);
	for (int node : scene.nodes) {
		if (drawn[(size_t)node])
			in.notes.insert(where_of(node) + " is listed again as a root of the scene: it is drawn once");
		else
			roots.push_back(node);
		if (!drawn[(size_t)node] && parents[(size_t)node] >= 0)
			in.notes.insert(where_of(node) + " is a root of the scene and a child of " +
			                where_of(parents[(size_t)node]) +
			                ", which is not drawn: it stands without its parent's place");
		drawn[(size_t)node] = true;
	}
	return roots;
}

static trs trs_of(const tinygltf::Node &node)
{
	trs local = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
	for (size_t i = 0; i < node.translation.size(); i++) local.translation[i] = ts_number(node.translation[i]);
	for (size_t i = 0; i < node.rotation.size(); i++) local.rotation[i] = ts_number(node.rotation[i]);
	for (size_t i = 0; i < node.scale.size(); i++) local.scale[i] = ts_number(node.scale[i]);
	return local;
}

ts_place place_of_trs(const trs &local, const std::string &where)
{
	const f32 *r = local.rotation;
	if (r[0] == 0.0f && r[1] == 0.0f && r[2] == 0.0f && r[3] == 0.0f)
		fail("%s/rotation is a quaternion of length 0; 0 0 0 1 stands for no rotation", where.c_str());
	return ts_place_from_trs(local.translation, local.rotation, local.scale);
}

ts_place place_of_matrix(const f32 matrix[16], const std::string &where)
{
	for (size_t k = 0; k < 4; k++) /* a rounding away is near enough */
		if (!(ts_abs(matrix[4 * k + 3] - (k < 3 ? 0.0f : 1.0f)) <= 0x1p-20f))
			fail("%s: the last row must be 0 0 0 1", where.c_str());
	return ts_place_from_matrix(matrix);
}

static ts_place place_of(const tinygltf::Node &node, int index)
{
	f32 matrix[16];
	if (node.matrix.empty()) return place_of_trs(trs_of(node), where_of(index));
	for (size_t i = 0; i < node.matrix.size(); i++) matrix[i] = ts_number(node.matrix[i]);
	return place_of_matrix(matrix, where_of(index) + "/matrix");
}

/* As at frame 0. */
static ts_place local_at_begin(const loader &in, int node)
{
	if (!animation_moves(in, node)) return place_of(in.model.nodes.at((size_t)node), node);
	trs local = trs_of(in.model.nodes.at((size_t)node));
	animation_set(in, node, 0, local);
	return place_of_trs(local, where_of(node));
}

static void check_place(const ts_place &place, int node)
{
	if (!ts_place_is_sane(&place)) fail("%s: a number of its world matrix is beyond 16777216", where_of(node).c_str());
}

ts_place node_place(loader &in, int node)
{
	std::vector<int> above;
	for (int at = node; at >= 0; at = in.parents.at((size_t)at)) above.push_back(at);
	ts_place place = ts_place_identity();
	for (size_t i = above.size(); i-- > 0;) {
		ts_place local = local_at_begin(in, above[i]);
		place = ts_place_compose(&place, &local);
		check_place(place, above[i]);
		if (animation_moves(in, above[i])) in.notes.insert("joints that move stand as at frame 0");
	}
	return place;
}

/* In the world. */
ts_place walker::place_at(const visit &at, u32 frame) const
{
	return at.mover < 0 ? at.parent : ts_place_compose(&movers[(size_t)at.mover].places[frame], &at.parent);
}

int walker::add_mover(const visit &from)
{
	mover m = {{}, 0};
	trs local = trs_of(in.model.nodes.at((size_t)from.node));
	if ((movers.size() + 1) * in.animated.n_frames > TS_MOTION_MAX_PLACES)
		fail("%zu nodes that move through %u frames are more than %u places", movers.size() + 1, in.animated.n_frames,
		     TS_MOTION_MAX_PLACES);
	for (u32 frame = 0; frame < in.animated.n_frames; frame++) {
		animation_set(in, from.node, frame, local);
		ts_place below = place_of_trs(local, where_of(from.node)), parent = place_at(from, frame);
		m.places.push_back(ts_place_compose(&parent, &below));
		check_place(m.places.back(), from.node);
	}
	movers.push_back(m);
	return (int)movers.size() - 1;
}

/* From the parent to the node: where it stands is in `parent`. */
visit walker::arrive(const visit &from)
{
	visit at = from;
	bool moves = animation_moves(in, from.node);
	if (moves && in_reflector)
		in.notes.insert("animations inside a reflector are ignored: a reflector moves as a whole");
	if (moves && !in_reflector) {
		at.mover = add_mover(from);
		at.parent = ts_place_identity();
	} else {
		ts_place local = place_of(in.model.nodes.at((size_t)from.node), from.node);
		at.parent = ts_place_compose(&from.parent, &local);
	}
	check_place(place_at(at, 0), from.node);
	return at;
}

spot walker::spot_of(const visit &at) const
{
	spot s = {place_at(at, 0), at.mover >= 0, at.parent, false};
	f32 side = s.world.side;
	for (u32 frame = 1; s.moves && side == 0.0f && frame < in.animated.n_frames; frame++)
		side = place_at(at, frame).side;
	s.mirrored = side < 0.0f;
	return s;
}

static void give_motion(ts_build *build, const mover &m)
{
	std::vector<ts_motion> frames;
	for (const ts_place &place : m.places) frames.push_back(ts_place_motion(&place));
	ts_build_motion(build, frames.data(), (u32)frames.size());
}

/* The object that triangles of the node belong to. */
void walker::select_object(const visit &at)
{
	if (in_reflector) return;
	if (at.mover < 0) return ts_build_select(in.build, 0);
	mover &m = movers[(size_t)at.mover];
	if (m.object != 0) return ts_build_select(in.build, m.object);
	ts_object object = {};
	m.object = ts_build_object(in.build, &object, false);
	give_motion(in.build, m);
}

const std::vector<ts_place> *walker::pose_of(int skin)
{
	if (skin < 0) return nullptr;
	auto found = poses.find(skin);
	if (found == poses.end()) found = poses.emplace(skin, skin_pose(in, skin)).first;
	return found->second.empty() ? nullptr : &found->second;
}

/* A skin moves its mesh, not the node. */
void walker::draw_mesh(const tinygltf::Node &node, const visit &at)
{
	const std::vector<ts_place> *pose = pose_of(node.skin);
	bool copied = pose == nullptr && node.extensions.count("EXT_mesh_gpu_instancing") != 0;
	if (!copied) draw(node.mesh, at, pose);
	for (const ts_place &place : copied ? instances_open(in, node, where_of(at.node)) : std::vector<ts_place>()) {
		visit copy = at;
		copy.parent = ts_place_compose(&at.parent, &place);
		check_place(place_at(copy, 0), at.node);
		draw(node.mesh, copy, pose);
	}
	if (--uses.at((size_t)node.mesh) == 0) pieces.erase(node.mesh);
}

void walker::draw(int mesh, const visit &at, const std::vector<ts_place> *pose)
{
	const tinygltf::Mesh &from = in.model.meshes.at((size_t)mesh);
	std::string where = "meshes/" + std::to_string(mesh) + "/primitives/";
	auto entry = pieces.emplace(mesh, std::vector<piece>());
	std::vector<piece> &list = entry.first->second;
	for (size_t i = 0; entry.second && i < from.primitives.size(); i++)
		list.push_back(piece_decode(in, from.primitives[i], where + std::to_string(i)));
	for (const piece &p : list) {
		n_triangles += p.corners.size() / 3;
		n_vertices += p.vertices.size();
		n_surfels += p.surfels.size();
	}
	uint64_t size = n_triangles * sizeof(ts_triangle) + n_vertices * sizeof(ts_vertex) + n_surfels * sizeof(ts_surfel);
	if (n_triangles > most_items || n_vertices > most_items || n_surfels > most_items || size > ts_memory_total() / 3)
		fail("%s: more than %llu triangles or points or a third of this machine's memory, instances counted",
		     ("meshes/" + std::to_string(mesh)).c_str(), (unsigned long long)most_items);
	for (size_t i = 0; i < list.size(); i++) {
		const piece &p = list[i];
		visit still = at;
		bool skinned = pose != nullptr && !p.influences.empty();
		if (skinned) skin_note(in, p, pose->size());
		if (skinned) still.mover = -1;
		if (pose != nullptr && !skinned && !p.corners.empty())
			in.notes.insert("primitives of skinned meshes without JOINTS_0 and WEIGHTS_0 stand at their node");
		if (!p.corners.empty()) select_object(still);
		if (!p.surfels.empty() && at.mover >= 0) in.notes.insert("points below a node that moves stand as at frame 0");
		if (skinned)
			skin_place(in.build, p, *pose);
		else
			piece_place(in.build, p, spot_of(at));
	}
}

static bool is_marked(const loader &in, const tinygltf::Node &node)
{
	if (in.reflector) return node.name == in.reflector;
	return node.extras.IsObject() && node.extras.Has("reflector") && node.extras.Get("reflector").Get<bool>();
}

void walker::begin_reflector(const visit &at)
{
	ts_object object = {};
	ts_build_object(in.build, &object, true);
	if (at.mover >= 0) give_motion(in.build, movers[(size_t)at.mover]);
	in_reflector = true;
	n_reflectors++;
}

void walker::end_reflector(const opened &from)
{
	if (n_triangles == from.n_before)
		fail("%s: the reflector %s has no triangles", where_of(from.node).c_str(),
		     quoted(in.model.nodes.at((size_t)from.node).name).c_str());
	ts_build_object(in.build, nullptr, false);
	in_reflector = false;
}

void walker::place_camera(const visit &at)
{
	std::vector<ts_place> places;
	for (u32 frame = 0; frame < (at.mover >= 0 ? in.animated.n_frames : 1); frame++) {
		places.push_back(place_at(at, frame));
		check_place(places.back(), at.node);
	}
	camera_build(in, in.model.nodes.at((size_t)at.node), places);
}

void walker::enter(const visit &from)
{
	const tinygltf::Node &node = in.model.nodes.at((size_t)from.node);
	visit at = arrive(from);
	const bool marked = !in_reflector && is_marked(in, node);
	if (marked || !node.name.empty()) {
		open.push_back({from.node, n_triangles, marked, names.size()});
		names.push_back({from.node, 0});
		stack.push_back({from.node, at.parent, at.mover, true});
	}
	if (marked) begin_reflector(at);
	if (node.mesh >= 0) draw_mesh(node, at);
	if (node.camera >= 0) place_camera(at);
	auto light = node.extensions.find("KHR_lights_punctual");
	if (light != node.extensions.end()) {
		light_build(in, light->second.Get("light").GetNumberAsInt(), place_at(at, 0));
		if (at.mover >= 0) in.notes.insert("lights below a node that moves stand as at frame 0");
	}
	for (size_t i = node.children.size(); i-- > 0;) stack.push_back({node.children[i], at.parent, at.mover, false});
}

void walker::leave()
{
	const opened from = open.back();
	open.pop_back();
	names[from.named].n_triangles = n_triangles - from.n_before;
	if (from.is_reflector) end_reflector(from);
}

static void add_names(const walker &walk)
{
	for (const named &n : walk.names) {
		const std::string &name = walk.in.model.nodes.at((size_t)n.node).name;
		if (!name.empty() && n.n_triangles > 0) ts_build_node(walk.in.build, name.c_str(), n.n_triangles);
	}
}

static void fail_unknown_reflector(const loader &in)
{
	std::string names;
	unsigned n = 0;
	for (const tinygltf::Node &node : in.model.nodes)
		if (!node.name.empty() && n++ < 5) names += (n > 1 ? ", " : "") + quoted(node.name);
	fail_as(TS_KIND_ARGUMENT,
	        "no node of the scene is named %s; there are %u names%s%s%s; its description lists those with triangles",
	        quoted(in.reflector).c_str(), n, n ? ": " : "", names.c_str(), n > 5 ? ", ..." : "");
}

void nodes_walk(loader &in)
{
	walker walk{in, std::vector<unsigned>(in.model.meshes.size()), {}, {}, {}, {}, {}, {}};
	std::vector<int> roots = roots_of(in);
	if (roots.empty())
		in.notes.insert(in.model.scenes.empty() ? "the file has no scene: nothing is drawn"
		                                        : "the scene has no nodes: nothing is drawn");
	for (const tinygltf::Node &node : in.model.nodes)
		if (node.mesh >= 0) walk.uses.at((size_t)node.mesh)++;
	for (size_t i = roots.size(); i-- > 0;) walk.stack.push_back({roots[i], ts_place_identity(), -1, false});
	while (!walk.stack.empty() && !ts_build_failed(in.build)) {
		visit next = walk.stack.back();
		walk.stack.pop_back();
		if (next.leave)
			walk.leave();
		else
			walk.enter(next);
	}
	if (in.reflector && walk.n_reflectors == 0) fail_unknown_reflector(in);
	add_names(walk);
}

} // namespace gltf
