/* What backends there are. */
#include "backends.h"
#include <stdio.h>
#include <string.h>
#include "../core/core.h"

const ts_backend ts_backend_table[] = {
	{ "c", "map emit scatter", "the reference: C11, threaded by OpenMP" },
	{ 0 }
};

ts_status ts_backend_find(const ts_backend **backend, const char *name)
{
	char names[128] = "";
	for (const ts_backend *b = ts_backend_table; b->name != NULL; b++) {
		size_t used = strlen(names);
		snprintf(names + used, sizeof names - used, "%s%s", used > 0 ? ", " : "", b->name);
		*backend = b;
		if (strcmp(b->name, name) == 0) return TS_OK;
	}
	return ts_fail("--backend: no backend \"%s\"; there is: %s", name, names);
}
