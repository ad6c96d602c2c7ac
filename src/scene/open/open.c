/* Opening a scene: the source that makes it, added reflectors, the checks. */
#include <errno.h>
#include <sys/stat.h>
#include "model/input.h"
#include "scene/sources.h"

static bool has_suffix(const char *text, const char *suffix)
{
	size_t n = strlen(text), m = strlen(suffix);
	if (n <= m) return false;
	for (size_t i = 0; i < m; i++) {
		char c = text[n - m + i];
		if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != suffix[i]) return false;
	}
	return true;
}

static void file_load(ts_build *build, const ts_scene_file *file, bool is_ply, const ts_params *params,
                      const ts_scene_options *o)
{
	if (!is_ply)
		ts_gltf_load(build, file, o ? o->reflector : NULL, o ? o->animation : NULL,
		             TS_PARAM(params, surfels_neighbours));
	else if (o && o->reflector)
		ts_build_fail(build, "%s: reflector %s: .ply files have no named nodes", file->name, o->reflector);
	else if (o && o->animation)
		ts_build_fail(build, "%s: animation %s: .ply files have no animations", file->name, o->animation);
	else
		ts_ply_load(build, file, TS_PARAM(params, surfels_neighbours));
}

static ts_status file_check(const char *path)
{
	struct stat info;
	char names[128];
	bool is_known = has_suffix(path, ".gltf") || has_suffix(path, ".glb") || has_suffix(path, ".ply");
	ts_builtin_names(names, sizeof names);
	if (!is_known && !strchr(path, '/') && stat(path, &info) != 0)
		return ts_fail_as(TS_KIND_FILE, "%s: no such scene; built in are %s, files end in .gltf, .glb or .ply", path,
		                  names);
	if (stat(path, &info) != 0)
		return ts_fail_as(TS_KIND_FILE, "%s: %s; a .gltf, .glb or .ply file or a built-in scene is needed", path,
		                  strerror(errno));
	if (S_ISDIR(info.st_mode))
		return ts_fail_as(TS_KIND_FILE, "%s: is a directory; name the .gltf, .glb or .ply file inside it", path);
	if (!S_ISREG(info.st_mode))
		return ts_fail_as(TS_KIND_FILE, "%s: not a regular file; a .gltf, .glb or .ply file is needed", path);
	if (!is_known) return ts_fail("%s: the name of a scene's file must end in .gltf, .glb or .ply", path);
	return TS_OK;
}

static ts_status make_scene(ts_scene **scene, ts_build *build, const ts_scene_file *file, bool is_ply,
                            const ts_params *params, const ts_scene_options *options)
{
	file_load(build, file, is_ply, params, options);
	const char *camera = ts_arrange(build, params, options, true);
	return ts_build_finish(build, params, camera, scene);
}

static ts_status of_file(ts_scene **scene, const ts_scene_file *file, bool is_ply, const ts_params *params,
                         const ts_scene_options *options)
{
	ts_status status;
	ts_build *build = ts_build_new(file->name);
	if (!build) return TS_ERROR;
	TS_PARAM_READER("scene", "file", status = make_scene(scene, build, file, is_ply, params, options));
	return status;
}

ts_status ts_scene_of_bytes(ts_scene **scene, const ts_scene_file *file, const ts_params *params,
                            const ts_scene_options *options)
{
	const char *text = file->bytes, *blanks = " \t\r\n";
	size_t n = file->n_bytes, first = ts_text_mark(text, n);
	while (first < n && memchr(blanks, text[first], 4) != NULL) first++;
	size_t begin = ts_text_mark(text, n);
	bool is_ply = n - begin >= 4 && memcmp(text + begin, "ply", 3) == 0 && memchr(blanks, text[begin + 3], 4) != NULL;
	bool is_gltf = (n >= 4 && memcmp(text, "glTF", 4) == 0) || (first < n && text[first] == '{');
	*scene = NULL;
	if (is_ply || is_gltf) return of_file(scene, file, is_ply, params, options);
	return ts_fail_as(TS_KIND_FORMAT, "%s: its first bytes are those of no .glb, .gltf or .ply file", file->name);
}

ts_status ts_scene_load(ts_scene **scene, const char *spec, const ts_params *params, const ts_scene_options *options)
{
	const char *reflector = options ? options->reflector : NULL;
	bool builtin = ts_builtin_is(spec);
	*scene = NULL;
	if (builtin && reflector)
		return ts_fail("%s: reflector %s: built-in scenes have no named nodes; use a file", spec, reflector);
	if (builtin && options && options->animation)
		return ts_fail("%s: animation %s: built-in scenes have no animations; use a file", spec, options->animation);
	if (builtin) return ts_builtin_open(scene, spec, params, options);
	if (file_check(spec) != TS_OK) return TS_ERROR;
	return of_file(scene, &(ts_scene_file){.name = spec}, has_suffix(spec, ".ply"), params, options);
}
