/* Shared libraries that are opened when they are first needed. They stay open as long as the process: some drivers
 * crash when they are unloaded, and leak checkers could not name what they leak. */
#ifndef TS_MODEL_LIBRARY_H
#define TS_MODEL_LIBRARY_H
#include <stdbool.h>
#include <stddef.h>
#include <touchstone/status.h>

/* Whether this process can still map what the largest of them take with theirs: drivers. */
enum { TS_LIBRARY_MIB = 512 };
bool ts_library_has_room(void);
/* Opens a library, as dlopen does. The message of a failure is the system's reason. TS_SKIPPED: it, or one that it
 * needs, is absent. TS_ERROR: it is there and does not open, as where memory ends. */
ts_status ts_library_open(void **library, const char *name, int how);

/* A function pointer of a table of calls. */
typedef void (*ts_call)(void);
/* Sets `calls`, a table of n function pointers, to the functions `names` of a library that dlopen returned, or of
 * RTLD_DEFAULT. False if one is missing; then the table is unchanged. */
bool ts_library_find(void *calls, const char *const *names, size_t n, void *library);

#endif
