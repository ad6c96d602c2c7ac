/* The built-in scenes by name: reading "atrium:triangles=1.05M:texels=64", choosing the detail that gives the count,
 * building. The detail is found by bisection over the same code that builds, in counting mode; one part fills the
 * remainder. A scene of surfels is a grid, which counts itself. */
#include "scene/builtin/builtin.h"
#include <stdio.h>
#include "model/core.h"
#include "scene/sources.h"

enum { TRIANGLES, TEXELS, SURFELS, N_OPTIONS };

static const struct {
	const char *name;
	u32 least, most, usual;
	bool of_surfels; /* for scenes of surfels; otherwise for the others */
} options[N_OPTIONS] = {
	[TRIANGLES] = {"triangles", 10000, 16000000, 300000, false},
	[TEXELS] = {"texels", 16, 512, 512, false},
	[SURFELS] = {"surfels", 10000, 16000000, 300000, true},
};

static const ts_builtin *const scenes[] = {
#define SCENE(name) &ts_builtin_##name,
#include "scene/builtin/scenes.def"
#undef SCENE
};
enum { N_SCENES = sizeof scenes / sizeof *scenes };

const ts_builtin_info *ts_builtin_at(size_t i) { return i < N_SCENES ? &scenes[i]->info : NULL; }

void ts_builtin_names(char *text, size_t text_bytes)
{
	size_t used = 0;
	for (u32 i = 0; i < N_SCENES && used < text_bytes; i++) {
		const char *between = i == 0 ? "" : i + 1 < N_SCENES ? ", " : " and ";
		used += (size_t)snprintf(text + used, text_bytes - used, "%s%s", between, scenes[i]->info.name);
	}
}

static const ts_builtin *find(const char *spec)
{
	size_t length = strcspn(spec, ":");
	for (u32 i = 0; i < N_SCENES; i++) {
		const char *name = scenes[i]->info.name;
		if (strlen(name) == length && memcmp(name, spec, length) == 0) return scenes[i];
	}
	return NULL;
}

void ts_builtin_camera(ts_build *build, const char *name, ts_v3 eye, f32 down)
{
	char own[16];
	ts_camera camera = {.name = own, .right = {1.0f, 0.0f, 0.0f}, .yfov = 0.125f};
	ts_v3 back = ts_normalize(ts_v3_make(0.0f, down, 1.0f));
	snprintf(own, sizeof own, "%s", name);
	ts_store3(camera.eye, eye);
	ts_store3(camera.back, back);
	ts_store3(camera.up, ts_cross(back, ts_v3_make(1.0f, 0.0f, 0.0f)));
	ts_build_camera(build, &camera);
}

bool ts_builtin_is(const char *spec) { return find(spec) != NULL; }

/* Digits, optionally with a fraction and k or M; counted in integers. Returns the rest, or NULL if there are none or
 * more than ten digits. */
static const char *read_count(u64 *count, const char *text)
{
	u64 value = 0, scale = 1;
	u32 digits = 0;
	bool fraction = false;
	for (; (*text >= '0' && *text <= '9') || (*text == '.' && !fraction); text++) {
		if (*text == '.') {
			fraction = true;
			continue;
		}
		if (++digits > 10) return NULL;
		value = value * 10 + (u64)(*text - '0');
		if (fraction) scale *= 10;
	}
	if (*text == 'k') value *= 1000;
	if (*text == 'M') value *= 1000000;
	if (*text == 'k' || *text == 'M') text++;
	*count = value / scale;
	return digits > 0 ? text : NULL;
}

/* Reads one option; returns the rest, or NULL with the build failed. */
static const char *read_option(u32 *choice, ts_build *build, const char *spec, const char *text)
{
	size_t length = strcspn(text, "="), which = 0;
	bool of_surfels = find(spec)->surfels != NULL;
	while (which < N_OPTIONS && (options[which].of_surfels != of_surfels || strlen(options[which].name) != length ||
	                             memcmp(options[which].name, text, length) != 0))
		which++;
	if (which == N_OPTIONS) {
		ts_build_fail(build, "%s: unknown option \"%s\"; write NAME or NAME:%s", spec, text,
		              of_surfels ? "surfels=COUNT" : "triangles=COUNT:texels=SIDE");
		return NULL;
	}
	u64 count = 0;
	const char *value = text + length + 1, *rest = text[length] == '=' ? read_count(&count, value) : NULL;
	if (rest == NULL || (*rest != '\0' && *rest != ':')) {
		ts_build_fail(build, "%s: \"%s\" is no count; write digits, perhaps with k or M, as in %s=1.05M", spec,
		              text[length] == '=' ? value : "", of_surfels ? "surfels" : "triangles");
		return NULL;
	}
	if (count < options[which].least || count > options[which].most) {
		ts_build_fail(build, "%s: %llu %s are out of range; %u to %u", spec, (unsigned long long)count,
		              options[which].name, options[which].least, options[which].most);
		return NULL;
	}
	choice[which] = (u32)count;
	return rest;
}

static bool read_spec(u32 choice[N_OPTIONS], ts_build *build, const char *spec)
{
	const char *text = spec + strcspn(spec, ":");
	for (u32 i = 0; i < N_OPTIONS; i++) choice[i] = options[i].usual;
	while (text != NULL && *text != '\0') text = read_option(choice, build, spec, text + 1);
	if (text == NULL) return false;
	u32 side = choice[TEXELS];
	if ((side & (side - 1)) != 0) ts_build_fail(build, "%s: %u texels a side; write a power of two", spec, side);
	return (side & (side - 1)) == 0;
}

static u64 count_at(const ts_builtin *scene, const u32 *material, f32 detail, u32 seed)
{
	ts_mesh mesh = {.seed = seed, .detail = detail, .place = ts_place_world()};
	scene->shape(&mesh, material);
	return mesh.n;
}

/* The greatest detail whose shapes leave a part in 32 of the count to the filler. */
static f32 find_detail(const ts_builtin *scene, const u32 *material, u32 count, u32 seed)
{
	u64 limit = count - count / 32u;
	f32 low = 0.0f, high = 16.0f;
	for (u32 k = 0; k < 20; k++) {
		f32 middle = (low + high) * 0.5f;
		if (count_at(scene, material, middle, seed) <= limit)
			low = middle;
		else
			high = middle;
	}
	return low;
}

static void make_mesh(ts_build *build, const ts_builtin *scene, const u32 choice[N_OPTIONS], u32 seed)
{
	u32 material[TS_MAX_PAINTS] = {0}, count = choice[TRIANGLES];
	for (u32 i = 0; i < scene->n_paints; i++) {
		ts_paint paint = scene->paints[i];
		if (paint.size > choice[TEXELS]) paint.size = choice[TEXELS];
		material[i] = ts_paint_add(build, &paint, seed + 1000u * i);
	}
	ts_mesh mesh = {
		.build = build, .seed = seed, .detail = find_detail(scene, material, count, seed), .place = ts_place_world()};
	scene->shape(&mesh, material);
	mesh.place = ts_place_world();
	mesh.material = material[scene->rug.material];
	ts_part_rug(&mesh, &scene->rug, (u32)(count - mesh.n));
	ts_reflectors_stand(build, scene->mirrors, scene->n_mirrors);
}

void ts_builtin_make(ts_build *build, const char *spec, const ts_params *params)
{
	const ts_builtin *scene = find(spec);
	u32 choice[N_OPTIONS];
	if (!read_spec(choice, build, spec)) return;
	if (scene->surfels != NULL)
		scene->surfels(build, choice[SURFELS], TS_PARAM(params, surfels_radius));
	else
		make_mesh(build, scene, choice, TS_PARAM(params, seed));
}

static ts_status make_scene(ts_scene **scene, ts_build *build, const char *spec, const ts_params *params,
                            const ts_scene_options *wanted)
{
	ts_scene_options own = wanted != NULL ? *wanted : (ts_scene_options){0};
	ts_builtin_make(build, spec, params);
	bool named = own.camera != NULL && strcmp(own.camera, TS_CAMERA_CIRCLE) != 0;
	if (!named && own.eye == NULL && own.path == NULL) own.camera = find(spec)->camera;
	const char *camera = ts_arrange(build, params, &own, false);
	if (find(spec)->beyond != NULL) find(spec)->beyond(build);
	return ts_build_finish(build, params, camera, scene);
}

ts_status ts_builtin_open(ts_scene **scene, const char *spec, const ts_params *params, const ts_scene_options *wanted)
{
	char names[128];
	ts_status status;
	*scene = NULL;
	ts_builtin_names(names, sizeof names);
	if (!ts_builtin_is(spec)) return ts_fail("\"%s\" is no built-in scene; there are %s", spec, names);
	ts_build *build = ts_build_new(spec);
	if (build == NULL) return TS_ERROR;
	TS_PARAM_READER("scene", "built-in", status = make_scene(scene, build, spec, params, wanted));
	return status;
}
