/* The folder of results: what it may replace, and what report.json records about it. A report.json or vectors.json is
 * untrusted: its names are only compared with those in the folder. */
#include "study/results/folder.h"
#include <dirent.h>
#include <errno.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "model/core.h"
#include "model/input.h"
#include "model/json/read.h"
#include "output/file.h"

enum { MAX_REPORT_BYTES = 1 << 24, PATH_BYTES = 4096 + 300 };

static bool is_regular(const char *path, struct stat *info) { return lstat(path, info) == 0 && S_ISREG(info->st_mode); }

bool ts_ours_is_name(const char *name)
{
	const char *slash = name != NULL ? strchr(name, '/') : NULL;
	if (name == NULL || name[0] == 0 || name[0] == '.') return false;
	return slash == NULL || (slash > name && slash[1] != 0 && slash[1] != '.' && strchr(slash + 1, '/') == NULL);
}

static bool are_names(const json_t *files)
{
	bool all = json_is_array(files);
	for (size_t i = 0; i < json_array_size(files); i++)
		all &= ts_ours_is_name(json_string_value(json_array_get(files, i)));
	return all;
}

/* NULL in *files: no list by this program. */
static ts_status read_list(json_t **files, const char *dir, const char *name)
{
	char path[PATH_BYTES];
	struct stat info;
	size_t bytes;
	*files = NULL;
	snprintf(path, sizeof path, "%s/%s", dir, name);
	if (!is_regular(path, &info) || info.st_size > MAX_REPORT_BYTES) return TS_OK;
	char *text = ts_text_read(&bytes, path, MAX_REPORT_BYTES);
	if (text == NULL) return TS_ERROR;
	json_t *root = ts_json_read(text, bytes, false, path);
	free(text);
	if (root == NULL && ts_error_kind() == TS_KIND_MEMORY) return TS_ERROR;
	const char *program = json_string_value(json_object_get(root, "program"));
	json_t *listed = json_object_get(root, "files");
	bool ours = program != NULL && strncmp(program, "touchstone", strlen("touchstone")) == 0;
	if (ours && are_names(listed)) *files = json_incref(listed);
	json_decref(root);
	return TS_OK;
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

/* Calls `each` with the entries of a folder until it fails. */
static ts_status walk(const char *path, ts_status (*each)(void *user, const char *name), void *user)
{
	DIR *stream = opendir(path);
	if (stream == NULL) return ts_fail("%s: %s; name a folder that can be read and written", path, strerror(errno));
	ts_status status = TS_OK;
	for (struct dirent *e; status == TS_OK && (e = readdir(stream)) != NULL;) {
		if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0) status = each(user, e->d_name);
	}
	closedir(stream);
	return status;
}

typedef struct {
	const json_t *ours;
	const char *dir, *sub; /* NULL: entries of DIR itself */
	size_t n;              /* entries so far */
} judging;

static ts_status refuse(const char *dir, const char *name)
{
	return ts_fail("%s: holds %s, which no render wrote, so --force does not replace it; name another folder", dir,
	               name);
}

static ts_status judge_inner(void *user, const char *name)
{
	judging *j = user;
	char path[PATH_BYTES];
	j->n++;
	snprintf(path, sizeof path, "%s/%s", j->sub, name);
	return has(j->ours, j->dir, path) ? TS_OK : refuse(j->dir, j->sub);
}

static ts_status judge_entry(void *user, const char *name)
{
	const judging *j = user;
	judging inner = {.ours = j->ours, .dir = j->dir, .sub = name};
	char path[PATH_BYTES];
	struct stat info;
	if (has(j->ours, j->dir, name)) return TS_OK;
	snprintf(path, sizeof path, "%s/%s", j->dir, name);
	if (lstat(path, &info) != 0 || !S_ISDIR(info.st_mode)) return refuse(j->dir, name);
	ts_status status = walk(path, judge_inner, &inner);
	return status == TS_OK && inner.n == 0 ? refuse(j->dir, name) : status;
}

ts_status ts_ours_judge(const char *dir)
{
	judging j = {.dir = dir};
	json_t *files;
	ts_status status = read_list(&files, dir, "report.json");
	if (status == TS_OK && files == NULL) status = read_list(&files, dir, "vectors.json");
	if (status == TS_OK && files == NULL) {
		status = ts_fail("%s: no report.json or vectors.json there lists what was written, so --force replaces "
		                 "nothing; remove the folder if nothing in it is needed, or name another",
		                 dir);
	}
	j.ours = files;
	if (status == TS_OK) status = walk(dir, judge_entry, &j);
	json_decref(files);
	return status;
}

static ts_status keep(const char *dir)
{
	return ts_fail("%s: not empty; name another folder with -o, or replace it with --force", dir);
}

ts_status ts_results_begin(const char *dir, bool force) { return ts_folder_begin(dir, force ? ts_ours_judge : keep); }

json_t *ts_results_list(void)
{
	json_t *list = json_array();
	int failed = list == NULL;
	const char *name;
	for (size_t i = 0; (name = ts_folder_name(i)) != NULL && !failed; i++) {
		failed = json_array_append_new(list, json_string(name));
	}
	if (!failed) return list;
	json_decref(list);
	ts_fail("the list of files: out of memory");
	return NULL;
}

static ts_status write_json(const char *name, const json_t *root)
{
	ts_file_text text;
	const char *path = ts_folder_file(name);
	if (path == NULL || ts_file_text_begin(&text, name) != TS_OK) return TS_ERROR;
	ts_report_write(root, text.out);
	return ts_file_text_write(&text, path);
}

/* The values of the report that are timed, or that are not; NULL: out of memory. */
static json_t *part(const ts_report *report, bool timed)
{
	const char *key;
	json_t *value, *part = json_object();
	int failed = part == NULL;
	json_object_foreach (report->root, key, value) {
		if (!failed && ts_report_is_timed(report, key) == timed) failed = json_object_set(part, key, value);
	}
	if (!failed) return part;
	json_decref(part);
	ts_fail("the report: out of memory");
	return NULL;
}

ts_status ts_results_report(ts_report *report)
{
	ts_status status = ts_report_check(report);
	json_t *times = status == TS_OK ? part(report, true) : NULL;
	status = times != NULL ? TS_OK : TS_ERROR;
	if (json_object_size(times) > 0) status = write_json("times.json", times);
	json_decref(times);
	json_t *files = status == TS_OK ? ts_results_list() : NULL;
	if (files == NULL) return TS_ERROR;
	ts_report_value(report, "files", files);
	json_t *rest = ts_report_check(report) == TS_OK ? part(report, false) : NULL;
	status = rest != NULL ? write_json("report.json", rest) : TS_ERROR;
	json_decref(rest);
	return status;
}
