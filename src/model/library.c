/* Calls of shared libraries. */
#include "model/library.h"
#include <dlfcn.h>
#include <string.h>

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
