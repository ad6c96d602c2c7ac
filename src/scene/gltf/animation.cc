/* Animations, glTF 2.0 section 3.11: one of the file moves nodes by keyframes of their translation, rotation and scale.
 * METHODS 2 says at which times, and what follows its end. */
#include <algorithm>
#include <cstring>
#include "scene/gltf/gltf.h"
#include "scene/gltf/keyframe.h"

namespace gltf {

static constexpr f32 longest = 2184.0f; /* seconds: TS_MOTION_MAX_FRAMES */

static const struct {
	const char *name;
	int type;
	u32 n;
	unsigned forms;
} paths[N_PATHS] = {
	{"translation", TINYGLTF_TYPE_VEC3, 3, AS_FLOAT},
	{"rotation", TINYGLTF_TYPE_VEC4, 4, AS_FLOAT | AS_NORM},
	{"scale", TINYGLTF_TYPE_VEC3, 3, AS_FLOAT},
};

static const view *open_shared(loader &in, int accessor, int type, unsigned forms, const std::string &what)
{
	auto key = std::make_pair(accessor, type);
	auto found = in.animated.views.find(key);
	if (found == in.animated.views.end())
		found = in.animated.views.emplace(key, view_open(in, accessor, type, type, forms, what)).first;
	return &found->second;
}

static const view *open_times(loader &in, int accessor)
{
	bool is_new = in.animated.views.count({accessor, TINYGLTF_TYPE_SCALAR}) == 0;
	const view *times = open_shared(in, accessor, TINYGLTF_TYPE_SCALAR, AS_FLOAT, "times");
	for (size_t i = 0; i < times->count && is_new; i++) {
		f32 time = times->number(i, 0), before = i > 0 ? times->number(i - 1, 0) : -1.0f;
		if (i == 0 && time < 0.0f)
			fail("accessors/%d (times): item 0 is %g; a time from 0 is expected", accessor, (double)time);
		if (i > 0 && time <= before)
			fail("accessors/%d (times): item %zu is %g; a time after %g is expected", accessor, i, (double)time,
			     (double)before);
	}
	return times;
}

static track open_track(loader &in, const recorded &from, const channel &c, unsigned path, const std::string &where)
{
	if (c.sampler >= from.samplers.size())
		fail("%s/sampler is %zu; the animation has %zu samplers", where.c_str(), c.sampler, from.samplers.size());
	const sampler &s = from.samplers[c.sampler];
	track t = {open_times(in, s.input), nullptr, s.mode};
	t.values = open_shared(in, s.output, paths[path].type, paths[path].forms, paths[path].name);
	size_t wanted = t.times->count * (t.mode == "CUBICSPLINE" ? 3 : 1);
	if (t.values->count != wanted)
		fail("accessors/%d (%s): %zu items for %zu times; %zu are expected", s.output, paths[path].name,
		     t.values->count, t.times->count, wanted);
	return t;
}

static void take_channel(loader &in, const recorded &from, const channel &c, const std::string &where)
{
	unsigned path = 0;
	while (path < N_PATHS && c.path != paths[path].name) path++;
	if (path == N_PATHS || c.node < 0) {
		in.notes.insert(c.node < 0            ? "channels of animations without a node are ignored"
		                : c.path == "weights" ? "animations of morph targets are ignored: they do not move"
		                                      : "animations of other than translation, rotation and scale are ignored");
		return;
	}
	if (!in.model.nodes.at((size_t)c.node).matrix.empty())
		fail("%s: nodes/%d has a matrix; translation, rotation and scale are expected of a node that moves",
		     where.c_str(), c.node);
	track &to = in.animated.tracks[c.node][path];
	if (to.times) fail("%s: the %s of nodes/%d is animated already", where.c_str(), paths[path].name, c.node);
	to = open_track(in, from, c, path, where);
	f32 end = to.times->number(to.times->count - 1, 0);
	in.animated.n_frames = std::max(in.animated.n_frames, ts_keyframe_count(std::min(end, longest)));
	in.animated.seconds = std::max(in.animated.seconds, end);
}

/* The index of the animation that is asked for. */
static size_t choose(const loader &in)
{
	std::string names;
	if (!in.animation) return 0;
	for (size_t i = 0; i < in.doc.animations.size(); i++) {
		if (in.doc.animations[i].name == in.animation) return i;
		if (i < 5) names += (i > 0 ? ", " : "") + quoted(in.doc.animations[i].name);
	}
	fail_as(TS_KIND_ARGUMENT, "no animation is named %s; there are %zu%s%s%s", quoted(in.animation).c_str(),
	        in.doc.animations.size(), names.empty() ? "" : ": ", names.c_str(),
	        in.doc.animations.size() > 5 ? ", ..." : "");
}

static constexpr u32 other_objects = 32; /* that stand still, or circle */

/* As many frames as there is room for of all objects; what is longer is cut. */
static void cut(loader &in)
{
	if (in.animated.tracks.empty()) return;
	u32 most = TS_MOTION_MAX_PLACES / (u32)(in.animated.tracks.size() + other_objects);
	in.animated.n_frames = std::min(in.animated.n_frames, most);
	u32 wanted = ts_keyframe_count(std::min(in.animated.seconds, longest));
	if (in.animated.n_frames == wanted && in.animated.seconds <= longest) return;
	char line[96];
	snprintf(line, sizeof line, "the animation lasts %g seconds: the first %u frames are played",
	         (double)in.animated.seconds, in.animated.n_frames);
	in.notes.insert(line);
}

void animation_open(loader &in)
{
	bool rests = in.animation && strcmp(in.animation, TS_ANIMATION_NONE) == 0;
	if (rests || (in.doc.animations.empty() && !in.animation)) return;
	size_t index = choose(in);
	const recorded &from = in.doc.animations[index];
	std::string where = "animations/" + std::to_string(index);
	for (size_t i = 0; i < from.channels.size(); i++)
		take_channel(in, from, from.channels[i], where + "/channels/" + std::to_string(i));
	cut(in);
	if (in.doc.animations.size() > 1)
		in.notes.insert("of " + std::to_string(in.doc.animations.size()) + " animations " + quoted(from.name) +
		                " is played");
}

bool animation_moves(const loader &in, int node) { return in.animated.tracks.count(node) != 0; }

static void read(f32 *to, const view &from, size_t item, u32 n)
{
	for (u32 i = 0; i < n; i++) to[i] = from.number(item, (int)i);
}

/* The last keyframe that is not after the time, or the first. */
static size_t key_at(const view &times, f32 time)
{
	size_t low = 0, high = times.count;
	while (high - low > 1) {
		size_t middle = low + (high - low) / 2;
		(times.number(middle, 0) <= time ? low : high) = middle;
	}
	return low;
}

static void sample(f32 *to, const track &t, unsigned path, f32 time)
{
	f32 a[4], b[4], from[4], into[4];
	u32 n = paths[path].n;
	bool cubic = t.mode == "CUBICSPLINE";
	size_t k = key_at(*t.times, time), stride = cubic ? 3 : 1;
	f32 begin = t.times->number(k, 0);
	read(a, *t.values, stride * k + cubic, n);
	if (time <= begin || k + 1 == t.times->count || t.mode == "STEP") {
		memcpy(to, a, n * sizeof *a);
		return;
	}
	f32 seconds = t.times->number(k + 1, 0) - begin, s = (time - begin) / seconds;
	read(b, *t.values, stride * (k + 1) + cubic, n);
	if (!cubic) {
		if (path == ROTATION)
			ts_keyframe_turn(to, a, b, s);
		else
			ts_keyframe_line(to, a, b, n, s);
		return;
	}
	read(from, *t.values, stride * k + 2, n);
	read(into, *t.values, stride * (k + 1), n);
	ts_keyframe_cubic(to, a, from, into, b, n, s, seconds);
}

void animation_set(const loader &in, int node, u32 frame, trs &local)
{
	f32 *to[N_PATHS] = {local.translation, local.rotation, local.scale};
	const std::array<track, N_PATHS> &tracks = in.animated.tracks.at(node);
	for (unsigned path = 0; path < N_PATHS; path++)
		if (tracks[path].times) sample(to[path], tracks[path], path, ts_keyframe_time(frame));
}

} // namespace gltf
