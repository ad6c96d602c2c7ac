/* Shared libraries and their calls. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "model/library.h"
#include <dlfcn.h>
#include <errno.h>
#include <string.h>
#include <sys/mman.h>
#include "model/core.h"

bool ts_library_has_room(void)
{
	const size_t bytes = (size_t)TS_LIBRARY_MIB << 20;
	void *room = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
	return room != MAP_FAILED && munmap(room, bytes) == 0;
}

ts_status ts_library_open(void **library, const char *name, int how)
{
	errno = 0;
	*library = dlopen(name, how);
	if (*library != NULL) return TS_OK;
	bool lacks_memory = errno == ENOMEM;
	const char *why = dlerror();
	if (why == NULL) why = name;
	if (strstr(why, strerror(ENOENT)) != NULL) {
		ts_fail_as(TS_KIND_LIBRARY, "%s", why);
		return TS_SKIPPED;
	}
	/* The system names the error with some of its reasons only. */
	lacks_memory |= strstr(why, strerror(ENOMEM)) != NULL || !ts_library_has_room();
	return lacks_memory ? ts_fail_as(TS_KIND_MEMORY, "out of memory: %s", why) : ts_fail_as(TS_KIND_LIBRARY, "%s", why);
}

bool ts_library_find(void *calls, const char *const *names, size_t n, void *library)
{
	for (size_t i = 0; i < n; i++) {
		if (dlsym(library, names[i]) == NULL) return false;
	}
	for (size_t i = 0; i < n; i++) {
		void *symbol = dlsym(library, names[i]);
		memcpy((char *)calls + i * sizeof(ts_call), &symbol, sizeof(ts_call));
	}
	return true;
}
