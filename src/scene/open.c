/* Opening a scene: which source makes it, the reflectors that are added, the checks. */
#include "../core/core.h"
#include "sources.h"
#include <errno.h>
#include <sys/stat.h>

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

static ts_status file_check(const char *path)
{
	struct stat info;
	char names[128];
	bool is_gltf = has_suffix(path, ".gltf") || has_suffix(path, ".glb");
	ts_builtin_names(names, sizeof names);
	if (!is_gltf && !strchr(path, '/') && stat(path, &info) != 0)
		return ts_fail("%s: no such scene; built in are %s, files end in .gltf or .glb", path, names);
	if (stat(path, &info) != 0)
		return ts_fail("%s: %s; a .gltf or .glb file or a built-in scene is needed", path, strerror(errno));
	if (S_ISDIR(info.st_mode)) return ts_fail("%s: is a directory; name the .gltf or .glb file inside it", path);
	if (!S_ISREG(info.st_mode)) return ts_fail("%s: not a regular file; a .gltf or .glb file is needed", path);
	if (!is_gltf) return ts_fail("%s: the name of a scene's file must end in .gltf or .glb", path);
	return TS_OK;
}

ts_status ts_scene_open(ts_scene **scene, const char *spec, const ts_params *params, const ts_scene_options *options)
{
	const char *camera = options ? options->camera : NULL;
	const char *reflector = options ? options->reflector : NULL;
	bool builtin = ts_builtin_is(spec);
	*scene = NULL;
	if (builtin && reflector)
		return ts_fail("%s: reflector %s: built-in scenes have no named nodes; use a file", spec, reflector);
	if (builtin) return ts_builtin_open(scene, spec, params, camera);
	if (file_check(spec) != TS_OK) return TS_ERROR;
	ts_build *build = ts_build_new(spec);
	if (!build) return TS_ERROR;
	ts_gltf_load(build, spec, reflector, params->neighbours);
	ts_ground_add(build, params);
	ts_reflectors_add(build, params, camera);
	return ts_build_finish(build, params, camera, scene);
}
