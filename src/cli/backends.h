/* What --backend names. */
#ifndef TS_CLI_BACKENDS_H
#define TS_CLI_BACKENDS_H
#include <touchstone/status.h>

typedef struct {
	const char *name;
	const char *kinds;   /* of the stages that it runs */
	const char *doc;
} ts_backend;

/* All backends, the default first, ended by a row without a name. */
extern const ts_backend ts_backend_table[];

/* The backend of that name; TS_ERROR, with a message that names those there are. */
ts_status ts_backend_find(const ts_backend **backend, const char *name);

#endif
