/* The eye's path: cubic Hermite curves through keyframes with the tangents of Catmull and Rom, by frames (METHODS 2).
 * All arithmetic is the kernels' (CONTRACT rule 4). */
#include <stdlib.h>
#include <string.h>
#include "model/core.h"
#include "model/decimal.h"
#include "model/input.h"
#include "scene/build_parts.h"
#include "scene/sources.h"
#include "scene/view.h"

#define PATH_NAME "--path"
#define LEAST_FOV 1.0f /* of the parameter eye.fov */
#define GREATEST_FOV 150.0f
#define DEGREES_A_TURN 360.0f

enum { EYE, TARGET = 3, FOV = 6, N_VALUES };

typedef struct {
	u32 frame;
	f32 value[N_VALUES]; /* eye, target, and degrees or 0 */
} key;

typedef struct {
	ts_build *build;
	const char *file;
	u32 line;
	key *keys;
	u32 n;
} reader;

static void refuse(const reader *r, const char *text) { ts_build_fail(r->build, "%s:%u: %s", r->file, r->line, text); }

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/* A number before `end`, followed by that character or, with 0, by a blank. */
static bool take(const char **at, const char *end, char behind, f32 *value)
{
	char *stop;
	while (*at < end && is_blank(**at)) ++*at;
	if (*at == end) return false;
	*value = ts_strtof(*at, &stop);
	bool good = ts_decimal_plain(*at, stop) && stop <= end;
	if (!good) return false;
	if (behind != 0) {
		*at = stop + 1;
		return stop < end && *stop == behind;
	}
	*at = stop;
	return stop == end || is_blank(*stop);
}

static bool take_point(const char **at, const char *end, f32 *p)
{
	return take(at, end, ',', p) && take(at, end, ',', p + 1) && take(at, end, 0, p + 2);
}

static bool take_frame(const char **at, const char *end, u32 *frame)
{
	u64 n = 0;
	const char *first = *at;
	for (; *at < end && **at >= '0' && **at <= '9'; ++*at) n = n < TS_PATH_MAX_FRAMES ? n * 10 + (u64)(**at - '0') : n;
	*frame = (u32)(n < TS_PATH_MAX_FRAMES ? n : TS_PATH_MAX_FRAMES);
	return *at != first && *at < end && is_blank(**at);
}

static void check_key(const reader *r, const key *k, bool has_fov)
{
	const key *before = r->n > 0 ? k - 1 : NULL;
	for (u32 i = 0; i < FOV; i++) {
		if (!(ts_abs(k->value[i]) <= TS_COORDINATE_LIMIT)) refuse(r, "a coordinate is not finite or beyond 16777216");
	}
	if (k->frame >= TS_PATH_MAX_FRAMES)
		ts_build_fail(r->build, "%s:%u: frame %d is the last that a path can have", r->file, r->line,
		              TS_PATH_MAX_FRAMES - 1);
	if (before != NULL && k->frame <= before->frame) refuse(r, "its frame must be greater than the line's before");
	if (memcmp(k->value + EYE, k->value + TARGET, 3 * sizeof(f32)) == 0)
		refuse(r, "the eye is its target; it must look at another point");
	if (has_fov && !(k->value[FOV] >= LEAST_FOV && k->value[FOV] <= GREATEST_FOV))
		refuse(r, "the field of view must be from 1 to 150 degrees");
	if (before != NULL && has_fov != (before->value[FOV] > 0.0f))
		refuse(r, "either all keyframes have a field of view or none has");
}

static void read_line(reader *r, const char *at, const char *end)
{
	while (at < end && is_blank(*at)) at++;
	if (at == end || r->build->failed) return;
	key *k = &r->keys[r->n];
	*k = (key){.frame = 0};
	bool good = take_frame(&at, end, &k->frame);
	good = good && take_point(&at, end, k->value + EYE) && take_point(&at, end, k->value + TARGET);
	while (good && at < end && is_blank(*at)) at++;
	bool has_fov = good && at < end;
	good = good && (!has_fov || take(&at, end, 0, k->value + FOV));
	while (good && at < end && is_blank(*at)) at++;
	if (!good || at < end) {
		refuse(r, "is not FRAME EX,EY,EZ TX,TY,TZ [FOV]");
		return;
	}
	for (u32 i = 0; i < FOV; i++) k->value[i] = (f32)((double)k->value[i] - r->build->scene->origin[i % 3]);
	check_key(r, k, has_fov);
	for (u32 i = 0; i < N_VALUES; i++) k->value[i] = ts_san(k->value[i]);
	r->n++;
}

static void read_lines(reader *r, const char *text, size_t bytes)
{
	for (const char *at = text, *end = text + bytes; at < end && !r->build->failed;) {
		const char *newline = memchr(at, '\n', (size_t)(end - at));
		const char *stop = newline != NULL ? newline : end;
		const char *hash = memchr(at, '#', (size_t)(stop - at));
		r->line++;
		read_line(r, at, hash != NULL ? hash : stop);
		at = stop + (newline != NULL);
	}
	if (r->n == 0) ts_build_fail(r->build, "%s: no keyframe; one line FRAME EX,EY,EZ TX,TY,TZ is needed", r->file);
}

static u32 count_lines(const char *text, size_t bytes)
{
	u32 n = 1;
	for (size_t i = 0; i < bytes; i++) n += text[i] == '\n';
	return n;
}

/* Slope of value i per frame at key k: 0 at both ends, beyond which the eye stands still. */
static f32 slope(const reader *r, u32 k, u32 i)
{
	if (k == 0 || k + 1 == r->n) return 0.0f;
	f32 change = r->keys[k + 1].value[i] - r->keys[k - 1].value[i];
	return change / (f32)(r->keys[k + 1].frame - r->keys[k - 1].frame);
}

/* Hermite's cubic from key k to the next, `s` of the way. */
static f32 between(const reader *r, u32 k, f32 s, u32 i)
{
	f32 a = r->keys[k].value[i], b = r->keys[k + 1].value[i];
	f32 frames = (f32)(r->keys[k + 1].frame - r->keys[k].frame);
	f32 from = slope(r, k, i) * frames, to = slope(r, k + 1, i) * frames, step = b - a;
	f32 square = from + to - (step + step);
	f32 linear = step + step + step - (from + from) - to;
	return a + s * (from + s * (linear + s * square));
}

static void pose_at(const reader *r, ts_path_eye *to, u32 frame, u32 k, bool own_fov)
{
	f32 value[N_VALUES];
	const key *from = &r->keys[k];
	bool on_way = frame > from->frame;
	f32 s = on_way ? (f32)(frame - from->frame) / (f32)(from[1].frame - from->frame) : 0.0f;
	for (u32 i = 0; i < N_VALUES; i++) value[i] = on_way ? between(r, k, s, i) : from->value[i];
	ts_v3 eye = ts_load3(value + EYE), target = ts_load3(value + TARGET);
	*to = (ts_path_eye){.pad0 = 0};
	ts_store3(to->eye, eye);
	ts_view_aim(to->right, to->up, to->back, eye, target);
	if (from->value[FOV] > 0.0f && !own_fov)
		to->yfov = ts_put(ts_max(ts_min(value[FOV], GREATEST_FOV), LEAST_FOV) / DEGREES_A_TURN);
	f32 farthest = ts_max(ts_max(ts_abs(eye.x), ts_abs(eye.y)), ts_abs(eye.z));
	if (!(farthest <= TS_COORDINATE_LIMIT))
		ts_build_fail(r->build, "%s: frame %u: the eye is beyond 16777216", r->file, frame);
	if (!(ts_dot(ts_load3(to->back), ts_load3(to->back)) > 0.0f))
		ts_build_fail(r->build, "%s: frame %u: the eye meets its target; move one of them", r->file, frame);
}

static void make_path(const reader *r, bool own_fov)
{
	ts_scene *scene = r->build->scene;
	u32 n = r->keys[r->n - 1].frame + 1;
	scene->path = ts_alloc(n, sizeof *scene->path, "the eye's path");
	if (scene->path == NULL) {
		ts_build_adopt(r->build);
		return;
	}
	scene->n_path = n;
	for (u32 frame = 0, k = 0; frame < n; frame++) {
		if (k + 1 < r->n && frame >= r->keys[k + 1].frame) k++;
		pose_at(r, &scene->path[frame], frame, k, own_fov);
	}
}

static void add_camera(ts_build *build)
{
	const ts_path_eye *first = build->scene->path;
	ts_camera camera = {.name = PATH_NAME, .yfov = first->yfov};
	memcpy(camera.eye, first->eye, sizeof camera.eye);
	memcpy(camera.right, first->right, sizeof camera.right);
	memcpy(camera.up, first->up, sizeof camera.up);
	memcpy(camera.back, first->back, sizeof camera.back);
	ts_build_camera(build, &camera);
}

const char *ts_path_add(ts_build *build, const char *file, bool own_fov)
{
	size_t bytes = 0;
	reader r = {.build = build, .file = file};
	if (build->failed) return NULL;
	const ts_kind before = ts_build_about(build, TS_KIND_FORMAT);
	char *text = ts_text_read(&bytes, file, TS_PATH_MAX_BYTES);
	if (text == NULL) {
		ts_build_adopt(build);
	} else {
		r.keys = ts_alloc(count_lines(text, bytes), sizeof *r.keys, "keyframes");
		if (r.keys == NULL) ts_build_adopt(build);
		if (r.keys != NULL) read_lines(&r, text, bytes);
		if (!build->failed) make_path(&r, own_fov);
		if (!build->failed) add_camera(build);
	}
	free(r.keys);
	free(text);
	ts_build_about(build, before);
	return build->failed ? NULL : PATH_NAME;
}
