/* The output folder. All that the signal handler touches is async-signal-safe: fixed arrays, unlink and rmdir. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "folder.h"
#include "folder_ours.h"

enum { MAX_FILES = 1024, MAX_SUBS = 64, MAX_PARENTS = 64, MAX_PATH = 4096, MAX_DIR = MAX_PATH - 300 };

static struct {
	char dir[MAX_PATH], partial[MAX_PATH], old[MAX_PATH];
	char *files[MAX_FILES];     /* each twice: as written, and as its writer's own .partial */
	char *subs[MAX_SUBS];       /* folders in DIR.partial */
	char *parents[MAX_PARENTS]; /* folders above DIR that were made for it, outermost first */
	json_t *ours;               /* what an earlier render wrote to DIR; NULL: nothing */
	volatile sig_atomic_t n_files, n_subs, n_parents, made;
	pthread_t owner;
} folder;

static const int fatal[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE};
enum { N_FATAL = sizeof fatal / sizeof fatal[0] };

static void remove_partial(void)
{
	if (folder.made) {
		for (int i = 0; i < folder.n_files; i++) unlink(folder.files[i]);
		for (int i = 0; i < folder.n_subs; i++) rmdir(folder.subs[i]);
		rmdir(folder.partial);
		folder.made = 0;
	}
	while (folder.n_parents > 0) {
		folder.n_parents = folder.n_parents - 1;
		rmdir(folder.parents[folder.n_parents]);
	}
}

/* The thread that writes must not go on while its files are removed, so it does that itself. */
static void on_signal(int number)
{
	if (!pthread_equal(pthread_self(), folder.owner)) {
		pthread_kill(folder.owner, number);
		return;
	}
	remove_partial();
	signal(number, SIG_DFL);
	raise(number);
}

static void catch_signals(bool on)
{
	struct sigaction action;
	memset(&action, 0, sizeof action);
	sigemptyset(&action.sa_mask);
	for (int i = 0; i < N_FATAL; i++) sigaddset(&action.sa_mask, fatal[i]);
	for (int i = 0; i < N_FATAL; i++) {
		struct sigaction now;
		sigaction(fatal[i], NULL, &now);
		if (now.sa_handler != SIG_IGN) {
			action.sa_handler = on ? on_signal : SIG_DFL;
			sigaction(fatal[i], &action, NULL);
		}
	}
}

static void hold_signals(int how)
{
	sigset_t set;
	sigemptyset(&set);
	for (int i = 0; i < N_FATAL; i++) sigaddset(&set, fatal[i]);
	pthread_sigmask(how, &set, NULL);
}

static bool is_dot(const char *name) { return strcmp(name, ".") == 0 || strcmp(name, "..") == 0; }

static ts_status check_contents(const char *dir, DIR *stream, bool force)
{
	for (struct dirent *e; (e = readdir(stream)) != NULL;) {
		if (is_dot(e->d_name) || ts_ours_is_folder(folder.ours, dir, e->d_name)) continue;
		if (!force) return ts_fail("%s: not empty; name another folder with -o, or replace it with --force", dir);
		if (folder.ours == NULL) {
			return ts_fail("%s: no report.json or vectors.json there lists what was written, so --force replaces "
			               "nothing; remove the folder if nothing in it is needed, or name another",
			               dir);
		}
		if (!ts_ours_has(folder.ours, dir, e->d_name)) {
			return ts_fail("%s: holds %s, which no render wrote, so --force does not replace it; name another folder",
			               dir, e->d_name);
		}
	}
	return TS_OK;
}

/* What is mounted cannot be renamed. */
static ts_status check_mount(const char *dir, const struct stat *info)
{
	char parent[MAX_PATH + 4];
	struct stat above;
	snprintf(parent, sizeof parent, "%s/..", dir);
	if (stat(parent, &above) == 0 && above.st_dev != info->st_dev) {
		return ts_fail("%s: a file system is mounted there, so it cannot be replaced; name a folder inside it", dir);
	}
	return TS_OK;
}

static ts_status check_dir(const char *dir, bool force)
{
	struct stat info;
	if (lstat(dir, &info) != 0) {
		return errno == ENOENT ? TS_OK : ts_fail("%s: %s; name a folder that can be written", dir, strerror(errno));
	}
	if (!S_ISDIR(info.st_mode)) return ts_fail("%s: exists and is not a folder; name another with -o", dir);
	if (check_mount(dir, &info) != TS_OK) return TS_ERROR;
	DIR *stream = opendir(dir);
	if (stream == NULL) return ts_fail("%s: %s; name a folder that can be read and written", dir, strerror(errno));
	folder.ours = force ? ts_ours_read(dir) : NULL;
	ts_status status = check_contents(dir, stream, force);
	closedir(stream);
	return status;
}

static ts_status set_names(const char *dir)
{
	size_t n = strlen(dir);
	while (n > 1 && dir[n - 1] == '/') n--;
	if (n == 0 || n > MAX_DIR) {
		return ts_fail("-o: a folder's name has 1 to %d characters, this one has %zu", MAX_DIR, n);
	}
	snprintf(folder.dir, sizeof folder.dir, "%.*s", (int)n, dir);
	const char *slash = strrchr(folder.dir, '/');
	const char *last = slash != NULL ? slash + 1 : folder.dir;
	if (*last == 0 || is_dot(last)) return ts_fail("%s: cannot be replaced as a whole; name a folder inside it", dir);
	snprintf(folder.partial, sizeof folder.partial, "%.*s.partial", MAX_DIR, folder.dir);
	snprintf(folder.old, sizeof folder.old, "%.*s.old", MAX_DIR, folder.dir);
	return TS_OK;
}

/* Makes the folders above DIR.partial that are missing; mkdir of the last one reports what is wrong. */
static void make_parents(void)
{
	for (char *slash = strchr(folder.partial + 1, '/'); slash != NULL; slash = strchr(slash + 1, '/')) {
		*slash = 0;
		char *copy = folder.n_parents < MAX_PARENTS ? strdup(folder.partial) : NULL;
		if (copy != NULL && mkdir(folder.partial, 0777) == 0) {
			folder.parents[folder.n_parents] = copy;
			folder.n_parents = folder.n_parents + 1;
		} else {
			free(copy);
		}
		*slash = '/';
	}
}

static ts_status begin(const char *dir, bool force)
{
	ts_status status = set_names(dir);
	if (status != TS_OK || (status = check_dir(folder.dir, force)) != TS_OK) return status;
	struct stat info;
	if (force && lstat(folder.old, &info) == 0) return ts_fail("%s: is in the way of --force; remove it", folder.old);
	folder.owner = pthread_self();
	folder.n_files = 0;
	hold_signals(SIG_BLOCK);
	make_parents();
	int made = mkdir(folder.partial, 0777);
	int error = errno;
	folder.made = made == 0;
	if (made != 0) remove_partial();
	catch_signals(made == 0);
	hold_signals(SIG_UNBLOCK);
	if (made != 0 && error == EEXIST) {
		return ts_fail("%s: exists, from another run or one that was killed; remove it, or name another folder",
		               folder.partial);
	}
	return made == 0 ? TS_OK : ts_fail("%s: %s; name a folder that can be written", folder.partial, strerror(error));
}

ts_status ts_folder_begin(const char *dir, bool force)
{
	ts_status status = begin(dir, force);
	if (status != TS_OK) {
		json_decref(folder.ours);
		folder.ours = NULL;
	}
	return status;
}

static const char *remember(const char *name, const char *suffix)
{
	size_t bytes = strlen(folder.partial) + strlen(name) + strlen(suffix) + 2;
	char *path = folder.n_files < MAX_FILES ? ts_alloc(bytes, 1, "a path") : NULL;
	if (path == NULL) {
		ts_fail("%s: cannot hold another file, %s", folder.partial, name);
		return NULL;
	}
	snprintf(path, bytes, "%s/%s%s", folder.partial, name, suffix);
	folder.files[folder.n_files] = path;
	folder.n_files = folder.n_files + 1;
	return path;
}

/* Makes the folder of DIR.partial that `name` lies in, unless it was made before. */
static ts_status make_sub(const char *name)
{
	const char *slash = strchr(name, '/');
	char path[MAX_PATH + 300];
	if (slash == NULL) return TS_OK;
	snprintf(path, sizeof path, "%s/%.*s", folder.partial, (int)(slash - name), name);
	for (int i = 0; i < folder.n_subs; i++) {
		if (strcmp(folder.subs[i], path) == 0) return TS_OK;
	}
	char *copy = folder.n_subs < MAX_SUBS ? strdup(path) : NULL;
	if (copy == NULL) return ts_fail("%s: cannot hold another folder", folder.partial);
	folder.subs[folder.n_subs] = copy;
	folder.n_subs = folder.n_subs + 1;
	return mkdir(path, 0777) == 0 ? TS_OK : ts_fail("%s: %s", path, strerror(errno));
}

const char *ts_folder_file(const char *name)
{
	if (make_sub(name) != TS_OK) return NULL;
	return remember(name, ".partial") != NULL ? remember(name, "") : NULL;
}

json_t *ts_folder_list(void)
{
	json_t *list = json_array();
	int failed = list == NULL;
	for (int i = 1; i < folder.n_files; i += 2) {
		failed |= json_array_append_new(list, json_string(folder.files[i] + strlen(folder.partial) + 1));
	}
	if (failed) {
		json_decref(list);
		ts_fail("%s: the list of its files: out of memory", folder.partial);
		return NULL;
	}
	return list;
}

/* Removes the files that are ours, and the folders that they leave empty. */
static void remove_old(void)
{
	char path[MAX_PATH + 300];
	json_t *name;
	size_t i;
	json_array_foreach (folder.ours, i, name) {
		snprintf(path, sizeof path, "%s/%s", folder.old, json_string_value(name));
		unlink(path);
		*strrchr(path, '/') = 0;
		if (strcmp(path, folder.old) != 0) rmdir(path);
	}
	snprintf(path, sizeof path, "%s/report.json", folder.old);
	unlink(path);
	rmdir(folder.old);
}

static void forget(void)
{
	catch_signals(false);
	for (int i = 0; i < folder.n_files; i++) free(folder.files[i]);
	for (int i = 0; i < folder.n_subs; i++) free(folder.subs[i]);
	folder.n_files = 0;
	folder.n_subs = 0;
	folder.n_parents = 0;
	folder.made = 0;
	json_decref(folder.ours);
	folder.ours = NULL;
}

/* What power failure may not take: files, then the folders that name them. */
static ts_status give_to_disk(void)
{
	for (int i = 0; i < folder.n_files + folder.n_subs + 1; i++) {
		const char *path = i < folder.n_files                   ? folder.files[i]
		                   : i < folder.n_files + folder.n_subs ? folder.subs[i - folder.n_files]
		                                                        : folder.partial;
		int file = open(path, O_RDONLY);
		if (file < 0 && errno == ENOENT) continue;
		int bad = file < 0 || fsync(file) != 0;
		int error = errno;
		if (file >= 0) close(file);
		if (bad) return ts_fail("%s: cannot be given to the disk: %s", path, strerror(error));
	}
	return TS_OK;
}

static ts_status swap(void)
{
	if (rename(folder.partial, folder.dir) == 0) return TS_OK;
	if ((errno != EEXIST && errno != ENOTEMPTY) || rename(folder.dir, folder.old) != 0) {
		return ts_fail("%s: cannot rename to %s: %s", folder.partial, folder.dir, strerror(errno));
	}
	if (rename(folder.partial, folder.dir) != 0) {
		int error = errno;
		rename(folder.old, folder.dir);
		return ts_fail("%s: cannot rename to %s: %s", folder.partial, folder.dir, strerror(error));
	}
	remove_old();
	return TS_OK;
}

ts_status ts_folder_commit(void)
{
	if (give_to_disk() != TS_OK) return TS_ERROR;
	hold_signals(SIG_BLOCK);
	ts_status status = swap();
	if (status == TS_OK) forget();
	hold_signals(SIG_UNBLOCK);
	return status;
}

void ts_folder_discard(void)
{
	hold_signals(SIG_BLOCK);
	remove_partial();
	forget();
	hold_signals(SIG_UNBLOCK);
}
