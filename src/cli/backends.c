/* What backends there are. */
#include "backends.h"
#include <stdio.h>
#include <string.h>
#include "../trace/vectors.h"
#include "cli.h"

ts_status ts_backend_open(ts_cli *cli)
{
	const ts_backend_kind *kind = cli->backend;
	if (kind->open == NULL || ts_cli_given(cli, TS_OPT_HELP)) return TS_OK;
	double begin = ts_seconds();
	ts_status status = kind->open(&cli->how.backend, &cli->device);
	if (status == TS_OK) status = ts_vectors_verify(cli->how.backend, cli->device.inexact);
	cli->open_s = ts_seconds() - begin;
	return status == TS_SKIPPED && ts_cli_given(cli, TS_OPT_REQUIRE) ? TS_ERROR : status;
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
