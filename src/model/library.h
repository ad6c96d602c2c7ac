/* Shared libraries that are opened when they are first needed. They stay as long as the process: drivers do not take it
 * well to be unloaded, and what they leak would have no name. */
#ifndef TS_MODEL_LIBRARY_H
#define TS_MODEL_LIBRARY_H
#include <stdbool.h>
#include <stddef.h>

/* A table of calls: n function pointers, of the functions so named. */
typedef void (*ts_call)(void);
/* Finds them in what dlopen returned, or in RTLD_DEFAULT; false if one is missing, and the table is as it was. */
bool ts_library_find(void *calls, const char *const *names, size_t n, void *library);

#endif
