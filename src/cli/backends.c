/* What backends there are. */
#include "backends.h"
#include <stdio.h>
#include <string.h>
#include "../vectors/vectors.h"

ts_status ts_backend_open(ts_job *job)
{
	const ts_backend_kind *kind = job->backend;
	if (kind->open == NULL) return TS_OK;
	double begin = ts_seconds();
	ts_status status = kind->open(&job->how.backend, &job->device);
	if (status == TS_OK) status = ts_vectors_verify(job->how.backend, job->device.inexact);
	job->open_s = ts_seconds() - begin;
	return status == TS_SKIPPED && job->require ? TS_ERROR : status;
}

ts_status ts_backend_find(const ts_backend_kind **kind, const char *name)
{
	char names[128] = "";
	for (u32 i = 0; ts_backend_kinds[i] != NULL; i++) {
		size_t used = strlen(names);
		*kind = ts_backend_kinds[i];
		snprintf(names + used, sizeof names - used, "%s%s", used > 0 ? ", " : "", (*kind)->name);
		if (strcmp((*kind)->name, name) == 0) return TS_OK;
	}
	return ts_fail("--backend: no backend \"%s\"; there is: %s", name, names);
}
