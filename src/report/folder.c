/* A folder written by render or compare. Its report.json is untrusted: no name leads out of the folder, and every
 * picture is checked. */
#include <fnmatch.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include <unistd.h>
#include "image/png.h"
#include "model/input.h"
#include "output/json/text.h"
#include "report/page.h"

enum { PATH_BYTES = 4608, NAME_BYTES = 256, MOST_BYTES = 1 << 30 };

/* A PNG file of a folder. */
typedef struct {
	const char *dir, *file;
	char path[PATH_BYTES], group[NAME_BYTES], stem[NAME_BYTES];
	bool method, truth;
} found;

static bool lists(const json_t *report, const char *key, const char *name)
{
	const json_t *list = json_object_get(report, key);
	for (size_t i = 0; i < json_array_size(list); i++) {
		const char *text = json_string_value(json_array_get(list, i));
		if (text != NULL && strcmp(text, name) == 0) return true;
	}
	return false;
}

/* Parts "group/stem.png", or without a group; false for other files, and pictures of differences. */
static bool take_apart(found *f, const char *dir, const json_t *report, const char *file)
{
	const char *slash = file != NULL ? strchr(file, '/') : NULL, *name = slash != NULL ? slash + 1 : file;
	size_t n = name != NULL ? strlen(name) : 0;
	if (n < 5 || n >= NAME_BYTES || strcmp(name + n - 4, ".png") != 0) return false;
	if (name[0] == '.' || file[0] == '.' || file[0] == '/' || strchr(name, '/') != NULL) return false;
	if (name - file >= NAME_BYTES || strncmp(name, "difference-", 11) == 0) return false;
	*f = (found){.dir = dir, .file = file};
	snprintf(f->path, sizeof f->path, "%s/%s", dir, file);
	memcpy(f->group, file, slash != NULL ? (size_t)(slash - file) : 0);
	memcpy(f->stem, name, n - 4);
	f->method = lists(report, "methods", f->stem);
	f->truth = strncmp(f->stem, "truth-", 6) == 0;
	return true;
}

/* The report's description of the file; NULL: none. A series has descriptions like those of a single render. */
static const char *words_of(const json_t *report, const char *file)
{
	const json_t *list = json_object_get(report, "pictures");
	const char *slash = strrchr(file, '/');
	for (size_t i = 0; i < json_array_size(list); i++) {
		const json_t *row = json_array_get(list, i);
		const char *name = json_string_value(json_object_get(row, "name"));
		char pattern[NAME_BYTES];
		if (name == NULL) continue;
		if (slash == NULL && strncmp(name, "../", 3) == 0) name += 3;
		snprintf(pattern, sizeof pattern, "%.*s", (int)strcspn(name, " "), name);
		if (fnmatch(pattern, slash != NULL ? slash + 1 : file, 0) != 0) continue;
		return json_string_value(json_object_get(row, "shows"));
	}
	return NULL;
}

static void drop_alpha(u8 *rgba, size_t n)
{
	for (size_t i = 0; i < n; i++) memmove(rgba + 3 * i, rgba + 4 * i, 3);
}

static u32 big_endian(const u8 *p) { return (u32)p[0] << 24 | (u32)p[1] << 16 | (u32)p[2] << 8 | p[3]; }

/* *png, to be released by free(): a PNG with nothing but pixels, of the size in its header. */
static ts_status read_png(u8 **png, size_t *bytes, ts_page_picture *picture, const found *f)
{
	static const u8 signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
	size_t file_bytes;
	const char *path = f->path;
	*png = NULL;
	u8 *file = (u8 *)ts_input_read_in(&file_bytes, f->dir, f->file, MOST_BYTES);
	if (file == NULL) return TS_ERROR;
	bool is = file_bytes > sizeof signature && memcmp(file, signature, sizeof signature) == 0;
	ts_status status = is ? ts_png_clean(png, bytes, file, file_bytes, path) : ts_fail("%s: no PNG", path);
	free(file);
	if (status != TS_OK) return status;
	picture->width = big_endian(*png + 16);
	picture->height = big_endian(*png + 20);
	if (picture->width <= TS_PAGE_SIDE && picture->height <= TS_PAGE_SIDE) return TS_OK;
	free(*png);
	return ts_fail("%s: %u x %u pixels; at most %d a side are shown", path, (unsigned)picture->width,
	               (unsigned)picture->height, TS_PAGE_SIDE);
}

/* Its pixels can be probed if the folder holds the trace. */
static void put_trace(ts_page *page, json_t *o, const found *f)
{
	char trace[PATH_BYTES], file[PATH_BYTES + NAME_BYTES];
	snprintf(trace, sizeof trace, "%s/%s%strace-%s", f->dir, f->group, f->group[0] != 0 ? "/" : "", f->stem);
	snprintf(file, sizeof file, "%s/trace.json", trace);
	if (access(file, F_OK) == 0) ts_page_put(page, o, "trace", ts_text_json(trace));
}

static ts_status add_picture(ts_page *page, const found *f, const json_t *report)
{
	ts_page_picture p = {.name = (char *)f->stem, .group = (char *)f->group, .truth = f->truth};
	u8 *png;
	size_t bytes;
	char from[PATH_BYTES];
	p.folder = page->n_folders;
	if (read_png(&png, &bytes, &p, f) != TS_OK) return TS_ERROR;
	ts_status status = TS_OK;
	if (f->method || f->truth) {
		status = ts_image_decode(&p.rgb, &p.width, &p.height, png, bytes, (u64)TS_PAGE_SIDE * TS_PAGE_SIDE, f->path);
	}
	if (status == TS_OK && p.rgb != NULL) drop_alpha(p.rgb, (size_t)p.width * p.height);
	snprintf(from, sizeof from, "%s%s%s", f->dir, f->group[0] != 0 ? "/" : "", f->group);
	json_t *o = status == TS_OK ? ts_page_take(page, &p, from, ts_page_base64(png, bytes, f->path)) : NULL;
	free(png);
	if (o == NULL) return TS_ERROR;
	const char *words = words_of(report, f->file);
	if (words != NULL) ts_page_put(page, o, "shows", json_string(words));
	if (f->method) put_trace(page, o, f);
	return ts_page_check(page);
}

/* A plot or a video of a series, which the browser can show. Others are left out. */
static ts_status add_media(ts_page *page, const char *dir, const json_t *report, const char *file)
{
	static const char *const types[][2] = {{"*.svg", "image/svg+xml"}, {"*.mp4", "video/mp4"}};
	for (u32 i = 0; i < 2; i++) {
		char path[PATH_BYTES];
		size_t bytes;
		if (file == NULL || file[0] == '.' || strchr(file, '/') != NULL || fnmatch(types[i][0], file, 0) != 0) continue;
		snprintf(path, sizeof path, "%s/%s", dir, file);
		char *content = ts_input_read_in(&bytes, dir, file, MOST_BYTES);
		json_t *coded = content != NULL ? ts_page_base64(content, bytes, path) : NULL;
		free(content);
		if (coded == NULL) return TS_ERROR;
		const char *words = words_of(report, file);
		json_t *o = json_object();
		ts_page_put(page, o, "name", ts_text_json(file));
		ts_page_put(page, o, "type", json_string(types[i][1]));
		ts_page_put(page, o, "content", coded);
		if (words != NULL) ts_page_put(page, o, "shows", json_string(words));
		ts_page_append(page, page->media, o);
	}
	return ts_page_check(page);
}

/* The parts of the report that become tables. */
static void put_report(ts_page *page, const char *dir, json_t *report, json_t *times)
{
	json_t *o = json_object();
	json_object_del(report, "files");
	ts_page_put(page, o, "dir", ts_text_json(dir));
	ts_page_put(page, o, "report", json_incref(report));
	if (times != NULL) ts_page_put(page, o, "times", json_incref(times));
	ts_page_append(page, page->folders, o);
}

ts_status ts_page_add_folder(ts_page *page, const char *dir)
{
	json_t *report, *times = NULL;
	found f;
	if (ts_page_read(&report, dir, "report.json", false) != TS_OK) return TS_ERROR;
	const char *program = json_string_value(json_object_get(report, "program"));
	ts_status status = program != NULL && strcmp(program, "touchstone") == 0
	                       ? ts_page_read(&times, dir, "times.json", true)
	                       : ts_fail("%s/report.json: of no touchstone; a folder that render or compare wrote would be "
	                                 "right",
	                                 dir);
	const json_t *files = json_object_get(report, "files");
	for (size_t i = 0; i < json_array_size(files) && status == TS_OK; i++) {
		const char *file = json_string_value(json_array_get(files, i));
		bool picture = take_apart(&f, dir, report, file);
		status = picture ? add_picture(page, &f, report) : add_media(page, dir, report, file);
	}
	if (status == TS_OK) {
		put_report(page, dir, report, times);
		page->n_folders++;
		status = ts_page_check(page);
	}
	json_decref(report);
	json_decref(times);
	return status;
}
