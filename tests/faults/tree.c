/* Folders as a whole. What cannot be copied is a fault of the test, and ends it. */
#define _GNU_SOURCE
#include "tests/faults/tree.h"
#include <ctype.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void stop(const char *path)
{
	perror(path);
	exit(3);
}

static bool is_folder(const char *path)
{
	struct stat info;
	return lstat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

static int is_name(const struct dirent *e) { return strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0; }

static int is_seen(const struct dirent *e) { return e->d_name[0] != '.'; }

static int list(const char *path, int (*is_one)(const struct dirent *), struct dirent ***names)
{
	int n = scandir(path, names, is_one, alphasort);
	if (n < 0) stop(path);
	return n;
}

static void free_list(struct dirent **names, int n)
{
	for (int i = 0; i < n; i++) free(names[i]);
	free(names);
}

static void join(char *path, const char *folder, const char *name)
{
	if (snprintf(path, TS_MAX_PATH, "%s/%s", folder, name) >= TS_MAX_PATH) stop(folder);
}

char *ts_tree_read(const char *path, size_t *bytes)
{
	FILE *file = fopen(path, "rb");
	struct stat info;
	if (file == NULL || fstat(fileno(file), &info) != 0) return NULL;
	char *text = malloc((size_t)info.st_size + 1);
	*bytes = text != NULL ? fread(text, 1, (size_t)info.st_size, file) : 0;
	fclose(file);
	if (text == NULL || *bytes != (size_t)info.st_size) stop(path);
	text[*bytes] = 0;
	return text;
}

void ts_tree_remove(const char *path)
{
	struct dirent **names;
	char inner[TS_MAX_PATH];
	if (!is_folder(path)) {
		unlink(path);
		return;
	}
	int n = list(path, is_name, &names);
	for (int i = 0; i < n; i++) {
		join(inner, path, names[i]->d_name);
		ts_tree_remove(inner);
	}
	free_list(names, n);
	rmdir(path);
}

static void copy_file(const char *from, const char *to)
{
	size_t bytes;
	char *data = ts_tree_read(from, &bytes);
	FILE *file = data != NULL ? fopen(to, "wb") : NULL;
	if (file == NULL || fwrite(data, 1, bytes, file) != bytes || fclose(file) != 0) stop(to);
	free(data);
}

void ts_tree_copy(const char *from, const char *to)
{
	struct dirent **names;
	char source[TS_MAX_PATH], target[TS_MAX_PATH];
	if (!is_folder(from)) {
		copy_file(from, to);
		return;
	}
	if (mkdir(to, 0777) != 0) stop(to);
	int n = list(from, is_name, &names);
	for (int i = 0; i < n; i++) {
		join(source, from, names[i]->d_name);
		join(target, to, names[i]->d_name);
		ts_tree_copy(source, target);
	}
	free_list(names, n);
}

/* Behind a number, or behind blanks; a number has no sign of its own, and may have an exponent. */
static const char *skip(const char *text)
{
	if (isspace((unsigned char)*text)) return text + strspn(text, " \t");
	text += strspn(text, "0123456789.");
	size_t sign = *text == 'e' ? 1 + strspn(text + 1, "+-") : 0;
	return sign > 0 && isdigit((unsigned char)text[sign]) ? text + sign + strspn(text + sign, "0123456789") : text;
}

bool ts_tree_same_words(const char *a, const char *b)
{
	while (*a != 0 && *b != 0) {
		bool blanks = (*a == ' ' || *a == '\t') && (*b == ' ' || *b == '\t');
		if (blanks || (isdigit((unsigned char)*a) && isdigit((unsigned char)*b))) {
			a = skip(a);
			b = skip(b);
		} else if (*a++ != *b++) {
			return false;
		}
	}
	return *a == *b;
}

/* Of a list of digests that of the times, which differ. */
static void forget_times(char *sums)
{
	enum { HEX = 64 };
	char *name = sums != NULL ? strstr(sums, "  times.json\n") : NULL;
	if (name != NULL && name - sums >= HEX) memset(name - HEX, '0', HEX);
}

static bool same_file(const char *a, const char *b, char *where)
{
	size_t n = 0, m = 0;
	const char *name = strrchr(a, '/');
	char *one = ts_tree_read(a, &n), *other = ts_tree_read(b, &m);
	if (name != NULL && strcmp(name, "/SHA256SUMS") == 0) {
		forget_times(one);
		forget_times(other);
	}
	bool same = one != NULL && other != NULL && n == m && memcmp(one, other, n) == 0;
	if (!same && one != NULL && other != NULL && name != NULL && strcmp(name, "/times.json") == 0) {
		same = ts_tree_same_words(one, other);
	}
	free(one);
	free(other);
	if (!same) snprintf(where, TS_MAX_PATH, "%s: other bytes", b);
	return same;
}

static const char *told;

void ts_tree_told(const char *text) { told = text; }

static bool same_folder(const char *a, const char *b, char *where)
{
	struct dirent **names, **others;
	char left[TS_MAX_PATH], right[TS_MAX_PATH];
	int n = list(a, is_seen, &names), m = list(b, is_seen, &others);
	bool same = true;
	for (int i = 0, k = 0; same && (i < n || k < m); k++) {
		int order = i >= n ? 1 : k >= m ? -1 : strcmp(names[i]->d_name, others[k]->d_name);
		if (order > 0 && told != NULL && strstr(told, others[k]->d_name) != NULL) continue;
		join(left, a, i < n ? names[i]->d_name : "");
		join(right, b, k < m ? others[k]->d_name : "");
		same = order == 0 && ts_tree_same(left, right, where);
		i++;
		if (order != 0)
			snprintf(where, TS_MAX_PATH, order < 0 ? "%s: is gone" : "%s: is left", order < 0 ? left : right);
	}
	free_list(names, n);
	free_list(others, m);
	return same;
}

bool ts_tree_same(const char *a, const char *b, char *where)
{
	if (is_folder(a) && is_folder(b)) return same_folder(a, b, where);
	if (!is_folder(a) && !is_folder(b)) return same_file(a, b, where);
	snprintf(where, TS_MAX_PATH, "%s: a folder or a file", b);
	return false;
}
