/* Shared by the .cc files of this folder. Internal C++17: every function may throw gltf::error (or std::exception), and
 * only ts_gltf_load in gltf.cc, the one entry from C, catches. */
#ifndef TS_SCENE_GLTF_GLTF_H
#define TS_SCENE_GLTF_GLTF_H
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tiny_gltf.h>
#include <utility>
#include <vector>
#include "kernels/base/num.h"
#include "scene/gltf/numbers.h"
#include "scene/place.h"
#include "scene/sources.h"
#include "scene/surfel.h"

namespace gltf {

using bytes = std::vector<unsigned char>;

/* One line: what, where, what would be right; without the file's name. */
struct error {
	std::string line;
	ts_kind kind;
};
/* Fails by TS_KIND_FORMAT. */
[[noreturn]] void fail(const char *format, ...) __attribute__((format(printf, 1, 2)));
[[noreturn]] void fail_as(ts_kind kind, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A name from the file, for a message: in quotes, NULs replaced, cut to 48 bytes. What prints it cleans the rest. */
std::string quoted(const std::string &name);

/* file.cc: files. Refuses what is not a regular file, and what is longer than `limit` bytes or this process's
 * memory. */
struct extent {
	uint64_t limit;
	uint64_t most; /* bytes that are read of a longer file */
	/* May be null. If it is false for the first bytes, up to 4096, only these are read, and show what is wrong. */
	bool (*is_worth)(const bytes &head);
};
bytes file_read(const std::string &path, const extent &wanted);
/* Reads `relative`, a path from path_from_uri, in the folder of the scene's file; nothing outside that folder, by name
 * or by link, is opened. */
struct loader;
bytes file_read_beside(const loader &in, const std::string &relative, const extent &wanted);
/* The relative path that a URI names; absolute ones, schemes, backslashes, NULs and ways out of the folder are refused.
 */
std::string path_from_uri(const std::string &uri, const std::string &where);
/* A data URI (RFC 2397), in base64 or percent-encoded: its media type without parameters, and its data, which is not
 * empty. */
struct data_uri {
	std::string type;
	bytes data;
};
bool is_data_uri(const std::string &uri);
data_uri data_uri_decode(const std::string &uri, const std::string &where);

/* file.cc: the parts of a .glb, as ranges of the file; a .gltf is JSON as a whole. */
struct container {
	size_t json_begin = 0, json_bytes = 0;
	size_t bin_begin = 0, bin_bytes = 0;
	bool has_bin = false;
	size_t trailing_bytes = 0;
};
container container_split(const bytes &file, bool expect_glb);
/* Whether a file with these first bytes may be a .glb or a .gltf. */
bool container_is_worth(const bytes &head);

/* guard.cc: the JSON after strict checks, with only the properties that the loader knows: every index is in range,
 * every type and length is right, every buffer view lies inside its buffer. URIs of buffers are replaced by keys of
 * `buffers`; images and animations are in `images` and `animations` alone. */
struct source {
	std::string path; /* of a file */
	bytes data;       /* of a data URI; without path and data: the BIN chunk, or for an image a buffer view */
	uint64_t byte_length;
};
struct picture {
	source from;
	int view;         /* -1: none */
	std::string type; /* the media type that the file says; may be empty */
};
/* An animation as the file has it. */
struct channel {
	size_t sampler;
	int node; /* -1: none */
	std::string path;
};
struct sampler {
	int input, output; /* accessors */
	std::string mode;
};
struct recorded {
	std::string name;
	std::vector<channel> channels;
	std::vector<sampler> samplers;
};
struct document {
	std::string json;
	std::map<std::string, source> buffers;
	std::vector<picture> images;
	std::vector<recorded> animations;
	std::set<std::string> notes;
	bool is_quantized = false;  /* by KHR_mesh_quantization */
	std::string compression;    /* the extension that some of the data may be compressed by, or "" */
	std::vector<bool> unbacked; /* by accessor: the file gives it no buffer view, whatever `json` says */
};
document guard(const char *text, size_t n, const container &parts);
[[noreturn]] void fail_compressed(const std::string &where, const std::string &extension);

/* accessor.cc: typed, bounds-checked reading. */
struct view {
	const unsigned char *data; /* null: zeros */
	size_t count, stride, item_bytes;
	int component_type, components;
	bool normalized;
	std::vector<uint32_t> sparse_index; /* increasing */
	const unsigned char *sparse_data;
	int id; /* for messages */
	const unsigned char *item(size_t i) const;
	f32 number(size_t i, int component) const;
	uint32_t index(size_t i) const;
};
/* animation.cc: the animation that moves nodes. */
enum : unsigned { TRANSLATION, ROTATION, SCALE, N_PATHS };
struct track {
	const view *times, *values; /* null: the node's own value stays */
	std::string mode;
};
struct playing {
	u32 n_frames = 0;                                 /* 0: nothing is animated */
	f32 seconds = 0;                                  /* that the file's keyframes last */
	std::map<int, std::array<track, N_PATHS>> tracks; /* by node */
	std::map<std::pair<int, int>, view> views;        /* by accessor and type, shared by tracks */
};

/* One file being loaded. */
struct loader {
	ts_build *build;
	std::string path;      /* or the name */
	bool in_memory;        /* the file, which has no folder */
	const char *reflector; /* may be NULL */
	const char *animation; /* may be NULL: the first one */
	u32 neighbours;        /* nearest neighbours by whose distance points without a size get one */
	bytes file;
	container parts;
	document doc;
	playing animated;
	tinygltf::Model model;
	std::set<std::string> notes;
	uint64_t held_bytes = 0;                    /* of the file and its buffers */
	uint64_t texel_budget = 0;                  /* texels that the bytes read so far may still decode to */
	std::vector<int> parents;                   /* of nodes; -1: none */
	std::vector<u32> materials;                 /* of the scene, TS_NONE until used */
	u32 default_material = TS_NONE;             /* the same, of primitives without one */
	std::map<std::pair<int, bool>, u32> images; /* (image, sRGB) to index in the scene */
};

/* Ends a long loop once the build has failed, as it does where the work is cancelled. */
inline void go_on(loader &in)
{
	if (ts_build_failed(in.build)) throw error{"", TS_KIND_NONE};
}

/* What KHR_mesh_quantization adds: AS_SNORM signed bytes and shorts, normalized; AS_SMALL all bytes and shorts.
 * AS_NORM: all bytes and shorts, normalized, whatever the file requires. AS_JOINT: unsigned bytes and shorts. */
enum : unsigned { AS_FLOAT = 1, AS_UNORM = 2, AS_INDEX = 4, AS_SNORM = 8, AS_SMALL = 16, AS_NORM = 32, AS_JOINT = 64 };
/* type: TINYGLTF_TYPE_*, or two of them as alternatives; forms: which component types are allowed. */
view view_open(const loader &in, int accessor, int type, int other_type, unsigned forms, const std::string &what);

/* accessor.cc: which attributes of a primitive are read, and where they go. */
struct form {
	std::string name;
	int type, other_type;
	unsigned forms;
	size_t offset; /* in floats of a record */
	bool spared;   /* one that is not as it should be is noted and ignored */
};
#define AT(record, field) (offsetof(record, field) / sizeof(f32))
struct attributes {
	std::vector<form> forms;
	std::map<std::string, view> views;
	size_t count = 0;
	template <size_t n> explicit attributes(const form (&list)[n]) : forms(list, list + n) {}
	void open(loader &in, const tinygltf::Primitive &primitive, const std::string &where);
	void take(const loader &in, int accessor, const form &as, const std::string &where);
	bool has(const std::string &name) const { return views.count(name) != 0; }
	/* Writes the fields of item i that the file has. */
	void read(size_t i, f32 *field) const;
};

/* points.cc: a primitive of points as surfels in the mesh's own space. */
std::vector<ts_surfel> points_decode(loader &in, const tinygltf::Primitive &primitive, const std::string &where);

/* The joints that move a vertex, by their number in the skin. */
struct influence {
	f32 joint[4], weight[4];
};

/* mesh.cc: one primitive as triangles or surfels in the mesh's own space, and its copies in the world. */
struct piece {
	std::vector<ts_surfel> surfels;
	std::vector<ts_vertex> vertices;
	std::vector<influence> influences; /* of each vertex, or of none */
	std::vector<u32> corners;          /* three a triangle */
	u32 material;
};
piece piece_decode(loader &in, const tinygltf::Primitive &primitive, const std::string &where);
/* The place of a node: in the world at frame 0, and, below a moving node, also in that node's space. */
struct spot {
	ts_place world;
	bool moves;
	ts_place own;
	bool mirrored; /* at frame 0, or at the first frame at which it is not flattened */
};
void piece_place(ts_build *build, const piece &piece, const spot &at);

/* skin.cc: the matrices of a skin's joints; none of a skin that is not as it should be, which is noted. */
std::vector<ts_place> skin_pose(loader &in, int index);
/* Notes influences that are ignored or changed. */
void skin_note(loader &in, const piece &piece, size_t n_joints);
/* A copy of a piece with influences, in the world. */
void skin_place(ts_build *build, const piece &piece, const std::vector<ts_place> &pose);

/* material.cc: the index in the scene of material `index` (-1: none). */
u32 material_build(loader &in, int index);
/* The most texels that a file of so many bytes may decode to. */
uint64_t texel_budget(uint64_t file_bytes);
/* The sets of texture coordinates, TEXCOORD_n, that a vertex of the material has: 0 and 1, or, if its textures use
 * other sets, the first two that they name (if they name one, the second is 0); and whether textures use each. */
struct uv_sets {
	int set[2];
	bool used[2];
};
uv_sets material_uv_sets(const loader &in, int index);

/* animation.cc: checks and keeps the animation that is asked for, or the first one. */
void animation_open(loader &in);
bool animation_moves(const loader &in, int node);
struct trs {
	f32 translation[3], rotation[4], scale[3];
};
/* Sets the animated parts of a moving node's transform to those of a frame. */
void animation_set(const loader &in, int node, u32 frame, trs &local);

/* node.cc: walks the scene and builds what it draws. */
void nodes_walk(loader &in);
/* Where a node stands at frame 0. */
ts_place node_place(loader &in, int node);
ts_place place_of_trs(const trs &local, const std::string &where);
/* Of column by column; fails unless the last row is 0 0 0 1. */
ts_place place_of_matrix(const f32 matrix[16], const std::string &where);

/* instances.cc: where a node draws its mesh, in the node's own space. */
std::vector<ts_place> instances_open(loader &in, const tinygltf::Node &node, const std::string &where);

/* light.cc: lights and cameras at nodes. */
void light_build(loader &in, int light, const ts_place &place);
/* places: one a frame for a camera that moves, otherwise one. */
void camera_build(loader &in, const tinygltf::Node &node, const std::vector<ts_place> &places);

} // namespace gltf

#endif
