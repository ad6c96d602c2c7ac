/* Which backend a name means. */
#include <stdio.h>
#include <string.h>
#include "backends/backend.h"

ts_status ts_backend_find(const ts_backend_kind **kind, const ts_backend_kind *const *kinds, const char *name)
{
	char names[128] = "";
	for (u32 i = 0; kinds[i] != NULL; i++) {
		size_t used = strlen(names);
		*kind = kinds[i];
		snprintf(names + used, sizeof names - used, "%s%s", used > 0 ? ", " : "", (*kind)->name);
		if (strcmp((*kind)->name, name) == 0) return TS_OK;
	}
	return ts_fail("no backend \"%.40s\"; there is: %s", name, names);
}
