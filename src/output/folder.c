/* The output folder. */
#define _DEFAULT_SOURCE
#include "output/folder.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "output/file.h"
#include "output/left.h"
#include "output/lock.h"
#include "output/tree.h"

enum { MAX_DIR = TS_FOLDER_PATH - 300, NOTE_BYTES = 32 };

/* Thousands of paths stay while large buffers come and go: paths with memory of their own would fragment it. */
struct room {
	struct room *next;
	size_t used, bytes;
	char text[];
};
enum { ROOM_BYTES = 1 << 16 };

static _Thread_local struct {
	char dir[TS_FOLDER_PATH], partial[TS_FOLDER_PATH], old[TS_FOLDER_PATH], lock_path[TS_FOLDER_PATH];
	ts_place place; /* of these paths */
	ts_lock lock;
	ts_folder_judge *judge;
	uint32_t n_parents; /* folders above DIR that were created for it */
	char **paths;       /* of its files */
	size_t n_paths, capacity;
	struct room *rooms; /* memory of the paths */
} folder = {.lock = {.descriptor = -1}};

/* States in the lock, after the process's number. The lock is empty before DIR.partial is made; DIR.old is ours only
 * while the state is `moving`. */
static const char writing[] = "writing", moving[] = "moving";

static ts_status note(const char *state)
{
	char text[NOTE_BYTES];
	ts_file file;
	snprintf(text, sizeof text, "%-10ld %-8s\n", (long)getpid(), state);
	int again = fcntl(folder.lock.descriptor, F_DUPFD_CLOEXEC, 0);
	if (again >= 0) lseek(again, 0, SEEK_SET);
	if (ts_file_adopt(&file, again, folder.lock_path) != TS_OK) return TS_ERROR;
	if (ts_file_put(&file, text, strlen(text)) == TS_OK) return ts_file_end(&file);
	ts_file_drop(&file);
	return TS_ERROR;
}

/* Recovers from a killed process: the old folder is there, or the new. *found: there was anything to recover. */
static ts_status recover(bool *found)
{
	char text[NOTE_BYTES] = "";
	*found = false;
	if (!folder.lock.found || pread(folder.lock.descriptor, text, sizeof text - 1, 0) <= 0) return TS_OK;
	bool moved = strstr(text, moving) != NULL && ts_place_has(folder.old);
	bool made = ts_place_has(folder.partial);
	if (moved && !ts_place_has(folder.dir)) {
		if (rename(folder.old, folder.dir) != 0) return ts_fail_as(TS_KIND_FILE, "%s: %s", folder.old, strerror(errno));
	} else if (moved && ts_tree_remove(folder.old) != TS_OK) {
		return TS_ERROR;
	}
	*found = moved || made;
	return made ? ts_tree_remove(folder.partial) : TS_OK;
}

static bool is_dot(const char *name) { return strcmp(name, ".") == 0 || strcmp(name, "..") == 0; }

static ts_status set_names(const char *dir)
{
	size_t n = strlen(dir);
	while (n > 1 && dir[n - 1] == '/') n--;
	if (n == 0 || n > MAX_DIR) {
		return ts_fail("a folder's name has 1 to %d characters, this one has %zu", MAX_DIR, n);
	}
	snprintf(folder.dir, sizeof folder.dir, "%.*s", (int)n, dir);
	const char *slash = strrchr(folder.dir, '/');
	const char *last = slash != NULL ? slash + 1 : folder.dir;
	if (*last == 0 || is_dot(last)) return ts_fail("%s: cannot be replaced as a whole; name a folder inside it", dir);
	snprintf(folder.partial, sizeof folder.partial, "%.*s.partial", MAX_DIR, folder.dir);
	snprintf(folder.old, sizeof folder.old, "%.*s.old", MAX_DIR, folder.dir);
	snprintf(folder.lock_path, sizeof folder.lock_path, "%.*s.lock", MAX_DIR, folder.dir);
	folder.place = (ts_place){folder.dir, folder.partial, folder.old};
	return TS_OK;
}

/* Creates missing folders above DIR; failures show when the lock is made. */
static void make_parents(void)
{
	char path[TS_FOLDER_PATH];
	snprintf(path, sizeof path, "%s", folder.dir);
	folder.n_parents = 0;
	ts_left_folder(folder.dir, 0);
	for (char *slash = strchr(path + 1, '/'); slash != NULL; slash = strchr(slash + 1, '/')) {
		*slash = 0;
		if (mkdir(path, 0777) == 0) ts_left_folder(folder.dir, ++folder.n_parents);
		*slash = '/';
	}
}

static void remove_parents(uint32_t n)
{
	char path[TS_FOLDER_PATH];
	snprintf(path, sizeof path, "%s", folder.dir);
	for (char *slash; n > 0 && (slash = strrchr(path, '/')) != NULL; *slash = 0) {
		if (slash[1] == 0) continue;
		*slash = 0;
		rmdir(path);
		n--;
	}
}

/* A mount point cannot be renamed. */
static ts_status check_mount(const struct stat *info)
{
	char parent[TS_FOLDER_PATH + 4];
	struct stat above;
	snprintf(parent, sizeof parent, "%s/..", folder.dir);
	if (stat(parent, &above) != 0 || above.st_dev == info->st_dev) return TS_OK;
	return ts_fail("%s: a file system is mounted there, so it cannot be replaced; name a folder inside it", folder.dir);
}

/* Whether DIR may be replaced. */
static ts_status check_dir(void)
{
	struct stat info;
	const char *dir = folder.dir;
	if (lstat(dir, &info) != 0) {
		return errno == ENOENT
		           ? TS_OK
		           : ts_fail_as(TS_KIND_FILE, "%s: %s; name a folder that can be written", dir, strerror(errno));
	}
	if (!S_ISDIR(info.st_mode)) return ts_fail("%s: exists and is not a folder; name another", dir);
	if (check_mount(&info) != TS_OK) return TS_ERROR;
	DIR *stream = opendir(dir);
	if (stream == NULL)
		return ts_fail_as(TS_KIND_FILE, "%s: %s; name a folder that can be read and written", dir, strerror(errno));
	struct dirent *entry;
	while ((entry = readdir(stream)) != NULL && is_dot(entry->d_name)) {
	}
	closedir(stream);
	return entry == NULL ? TS_OK : folder.judge(dir);
}

static ts_status make_partial(void)
{
	if (ts_place_has(folder.partial)) {
		return ts_fail("%s: exists, and no run that was killed has left it; move it away, or name another folder",
		               folder.partial);
	}
	if (note(writing) != TS_OK) return TS_ERROR;
	return mkdir(folder.partial, 0777) == 0
	           ? TS_OK
	           : ts_fail_as(TS_KIND_FILE, "%s: %s; name a folder that can be written", folder.partial, strerror(errno));
}

/* `clean`: nothing is left beside DIR that the lock must record. */
static void release(bool clean)
{
	for (struct room *room = folder.rooms, *next; room != NULL; room = next) {
		next = room->next;
		free(room);
	}
	folder.rooms = NULL;
	free(folder.paths);
	folder.paths = NULL;
	folder.n_paths = folder.capacity = 0;
	if (folder.lock.descriptor >= 0) {
		if (clean && unlink(folder.lock_path) != 0) {
			ts_say("%s: cannot be removed: %s; the next run that writes %s removes it", folder.lock_path,
			       strerror(errno), folder.dir);
		}
		close(folder.lock.descriptor);
	}
	folder.lock.descriptor = -1;
	if (clean) ts_left_folder("", 0);
}

ts_status ts_folder_begin(const char *dir, ts_folder_judge *judge)
{
	ts_status status = set_names(dir);
	if (status != TS_OK) return status;
	folder.judge = judge;
	bool found = false;
	make_parents();
	status = ts_lock_take(&folder.lock, folder.lock_path, folder.dir);
	if (status == TS_OK) status = recover(&found);
	if (found && status == TS_OK) ts_say("%s: removed what a run that was killed had left there", folder.dir);
	bool clean = status == TS_OK;
	if (status == TS_OK) status = check_dir();
	if (status == TS_OK) status = make_partial();
	if (status == TS_OK) return TS_OK;
	release(clean);
	remove_parents(folder.n_parents);
	return status;
}

/* Makes the folder in DIR.partial that `name` lies in. */
static ts_status make_sub(const char *name)
{
	char path[TS_FOLDER_PATH + 300];
	const char *slash = strchr(name, '/');
	if (slash == NULL) return TS_OK;
	snprintf(path, sizeof path, "%s/%.*s", folder.partial, (int)(slash - name), name);
	return mkdir(path, 0777) == 0 || errno == EEXIST ? TS_OK
	                                                 : ts_fail_as(TS_KIND_FILE, "%s: %s", path, strerror(errno));
}

/* Memory for a path, until the folder is released. */
static char *take_room(size_t bytes)
{
	if (folder.rooms == NULL || folder.rooms->bytes - folder.rooms->used < bytes) {
		size_t whole = bytes > ROOM_BYTES ? bytes : ROOM_BYTES;
		struct room *room = ts_alloc(sizeof *room + whole, 1, "paths of files");
		if (room == NULL) return NULL;
		*room = (struct room){.next = folder.rooms, .bytes = whole};
		folder.rooms = room;
	}
	char *text = folder.rooms->text + folder.rooms->used;
	folder.rooms->used += bytes;
	return text;
}

const char *ts_folder_file(const char *name)
{
	void *paths = folder.paths;
	size_t bytes = strlen(folder.partial) + strlen(name) + 2;
	if (make_sub(name) != TS_OK ||
	    ts_grow(&paths, &folder.capacity, folder.n_paths + 1, sizeof *folder.paths, "paths of files") != TS_OK)
		return NULL;
	folder.paths = paths;
	char *path = take_room(bytes);
	if (path == NULL) return NULL;
	snprintf(path, bytes, "%s/%s", folder.partial, name);
	folder.paths[folder.n_paths++] = path;
	return path;
}

const char *ts_folder_path(void) { return folder.partial; }

const char *ts_folder_name(size_t i)
{
	return i < folder.n_paths ? folder.paths[i] + strlen(folder.partial) + 1 : NULL;
}

/* Removes DIR.partial or DIR.old; the lock stays where that fails. */
static bool clear(const char *path)
{
	if (!ts_place_has(path) || ts_tree_remove(path) == TS_OK) return true;
	ts_say("%s; the next run that writes %s removes it, and %s", ts_error_message(), folder.dir, folder.lock_path);
	return false;
}

static ts_status put_in_place(ts_placed *placed)
{
	*placed = TS_PLACE_FREE;
	ts_status status = ts_place_take(&folder.place);
	if (status != TS_DIFFERENT) return status;
	if (check_dir() != TS_OK) return TS_ERROR;
	*placed = TS_PLACE_EXCHANGED;
	status = ts_place_exchange(&folder.place);
	if (status != TS_DIFFERENT) return status;
	*placed = TS_PLACE_MOVED;
	if (ts_place_has(folder.old)) return ts_fail("%s: is in the way; move it away", folder.old);
	status = note(moving);
	return status == TS_OK ? ts_place_move(&folder.place) : status;
}

ts_status ts_folder_commit(void)
{
	ts_placed placed;
	ts_status status = ts_tree_sync(folder.partial);
	if (status == TS_OK) status = put_in_place(&placed);
	if (status != TS_OK) return status;
	const char *old = placed == TS_PLACE_MOVED ? folder.old : folder.partial;
	status = ts_parent_sync(folder.dir);
	/* Keep files that came into DIR at the last moment. */
	if (status == TS_OK && placed != TS_PLACE_FREE) status = folder.judge(old);
	if (status == TS_OK) {
		release(placed == TS_PLACE_FREE || clear(old));
		return TS_OK;
	}
	ts_place_undo(&folder.place, placed);
	return status;
}

void ts_folder_discard(void)
{
	if (folder.lock.descriptor < 0) return;
	char *why = strdup(ts_error_message());
	release(clear(folder.partial));
	remove_parents(folder.n_parents);
	ts_fail("%s", why != NULL ? why : "out of memory");
	free(why);
}

ts_status ts_folder_remove(const char *dir)
{
	bool found;
	ts_status status = set_names(dir);
	if (status == TS_OK) status = ts_lock_take(&folder.lock, folder.lock_path, dir);
	if (status != TS_OK) return status;
	ts_left_folder(folder.dir, 0);
	status = recover(&found);
	bool clean = status == TS_OK;
	if (status == TS_OK) status = note(writing);
	if (status == TS_OK && rename(folder.dir, folder.partial) != 0) {
		status = ts_fail_as(TS_KIND_FILE, "%s: cannot be removed: %s", dir, strerror(errno));
	}
	release(clean && (status != TS_OK || clear(folder.partial)));
	return status;
}

void ts_folder_clear(const char *dir, uint32_t n_parents)
{
	bool found;
	if (set_names(dir) != TS_OK) return;
	if (ts_lock_take(&folder.lock, folder.lock_path, dir) == TS_OK) {
		bool clean = recover(&found) == TS_OK;
		if (!clean)
			ts_say("%s; the next run that writes %s removes it, and %s", ts_error_message(), dir, folder.lock_path);
		release(clean);
	}
	remove_parents(n_parents);
}
