/* Shared libraries that are opened when they are first needed. They stay open as long as the process: some drivers
 * crash when they are unloaded, and leak checkers could not name what they leak. */
#ifndef TS_MODEL_LIBRARY_H
#define TS_MODEL_LIBRARY_H
#include <stdbool.h>
#include <stddef.h>

/* A function pointer of a table of calls. */
typedef void (*ts_call)(void);
/* Sets `calls`, a table of n function pointers, to the functions `names` of a library that dlopen returned, or of
 * RTLD_DEFAULT. False if one is missing; then the table is unchanged. */
bool ts_library_find(void *calls, const char *const *names, size_t n, void *library);

#endif
