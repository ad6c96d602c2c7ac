/* Leftovers of a killed process: a file and a folder at most. Until ts_left_share each thread has its own. */
#define _DEFAULT_SOURCE
#include "output/left.h"
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
#include "output/folder.h"

typedef struct {
	char file[TS_FOLDER_PATH], folder[TS_FOLDER_PATH];
	uint32_t n_parents;
} record;

static record *shared;

static record *now(void)
{
	static _Thread_local record own;
	return shared != NULL ? shared : &own;
}

ts_status ts_left_share(void)
{
	record *made = mmap(NULL, sizeof *made, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	if (made == MAP_FAILED) return ts_fail("no memory for what two processes share");
	shared = made;
	return TS_OK;
}

void ts_left_file(const char *partial) { snprintf(now()->file, sizeof now()->file, "%s", partial); }

void ts_left_folder(const char *dir, uint32_t n_parents)
{
	now()->n_parents = n_parents;
	snprintf(now()->folder, sizeof now()->folder, "%s", dir);
}

void ts_left_clear(void)
{
	if (now()->file[0] != 0) unlink(now()->file);
	if (now()->folder[0] != 0) ts_folder_clear(now()->folder, now()->n_parents);
	ts_left_file("");
	ts_left_folder("", 0);
}
