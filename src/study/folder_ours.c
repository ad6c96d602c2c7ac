/* What --force may replace. A report.json or vectors.json is untrusted: its names are only compared with those that
 * are in the folder. */
#include <dirent.h>
#include <errno.h>
#include <jansson.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include "../model/core.h"
#include "../model/json.h"
#include "folder_ours.h"

enum { MAX_REPORT_BYTES = 1 << 24, PATH_BYTES = 4096 + 300 };

static bool is_regular(const char *path, struct stat *info) { return lstat(path, info) == 0 && S_ISREG(info->st_mode); }

/* "name" or "sub/name", none of them hidden: no name leads out of the folder. */
static bool is_name(const char *name)
{
	const char *slash = name != NULL ? strchr(name, '/') : NULL;
	if (name == NULL || name[0] == 0 || name[0] == '.') return false;
	return slash == NULL || (slash > name && slash[1] != 0 && slash[1] != '.' && strchr(slash + 1, '/') == NULL);
}

static bool are_names(const json_t *files)
{
	bool all = json_is_array(files);
	for (size_t i = 0; i < json_array_size(files); i++) all &= is_name(json_string_value(json_array_get(files, i)));
	return all;
}

static json_t *read_list(const char *dir, const char *name, bool *no_memory)
{
	char path[PATH_BYTES];
	struct stat info;
	snprintf(path, sizeof path, "%s/%s", dir, name);
	if (!is_regular(path, &info) || info.st_size > MAX_REPORT_BYTES) return NULL;
	json_error_t error;
	errno = 0;
	json_t *root = json_load_file(path, 0, &error);
	*no_memory |= root == NULL && ts_json_no_memory(&error);
	const char *program = json_string_value(json_object_get(root, "program"));
	json_t *files = json_object_get(root, "files");
	bool ours = program != NULL && strcmp(program, "touchstone") == 0 && are_names(files);
	json_t *result = ours ? json_incref(files) : NULL;
	json_decref(root);
	return result;
}

static json_t *read_ours(const char *dir, bool *no_memory)
{
	json_t *files = read_list(dir, "report.json", no_memory);
	return files != NULL ? files : read_list(dir, "vectors.json", no_memory);
}

static bool has(const json_t *ours, const char *dir, const char *name)
{
	char path[PATH_BYTES];
	struct stat info;
	bool listed = ours != NULL && strcmp(name, "report.json") == 0;
	for (size_t i = 0; i < json_array_size(ours) && !listed; i++) {
		const char *file = json_string_value(json_array_get(ours, i));
		listed = file != NULL && strcmp(file, name) == 0;
	}
	snprintf(path, sizeof path, "%s/%s", dir, name);
	return listed && is_regular(path, &info);
}

static bool is_folder(const json_t *ours, const char *dir, const char *name)
{
	char path[PATH_BYTES];
	struct stat info;
	snprintf(path, sizeof path, "%s/%s", dir, name);
	if (ours == NULL || lstat(path, &info) != 0 || !S_ISDIR(info.st_mode)) return false;
	DIR *stream = opendir(path);
	bool all = stream != NULL, any = false;
	for (struct dirent *e; all && (e = readdir(stream)) != NULL;) {
		if (strcmp(e->d_name, ".") == 0 || strcmp(e->d_name, "..") == 0) continue;
		snprintf(path, sizeof path, "%s/%s", name, e->d_name);
		all = any = has(ours, dir, path);
	}
	if (stream != NULL) closedir(stream);
	return all && any;
}

static ts_status judge(const json_t *ours, const char *dir, DIR *stream)
{
	if (ours == NULL) {
		return ts_fail("%s: no report.json or vectors.json there lists what was written, so --force replaces "
		               "nothing; remove the folder if nothing in it is needed, or name another",
		               dir);
	}
	for (struct dirent *e; (e = readdir(stream)) != NULL;) {
		const char *name = e->d_name;
		if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0 || has(ours, dir, name)) continue;
		if (is_folder(ours, dir, name)) continue;
		return ts_fail("%s: holds %s, which no render wrote, so --force does not replace it; name another folder", dir,
		               name);
	}
	return TS_OK;
}

ts_status ts_ours_judge(const char *dir)
{
	DIR *stream = opendir(dir);
	if (stream == NULL) return ts_fail("%s: %s; name a folder that can be read and written", dir, strerror(errno));
	bool no_memory = false;
	json_t *ours = read_ours(dir, &no_memory);
	ts_status status = no_memory ? ts_fail("%s: what is listed there: out of memory", dir) : judge(ours, dir, stream);
	json_decref(ours);
	closedir(stream);
	return status;
}
