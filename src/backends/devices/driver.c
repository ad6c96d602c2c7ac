/* Tells an absent driver from one that memory is too small for: a loader does not say why it found none. */
#include "backends/devices/driver.h"
#include "model/core.h"
#include "model/library.h"

static ts_status absent(const char *backend, const char *none)
{
	ts_fail("backend %s: %s", backend, none);
	return TS_SKIPPED;
}

ts_status ts_driver_none(const char *backend, const char *none)
{
	if (ts_library_has_room()) return absent(backend, none);
	return ts_fail_as(TS_KIND_MEMORY,
	                  "backend %s: no device, with too little memory for a driver, which may take %d MiB", backend,
	                  TS_LIBRARY_MIB);
}

ts_status ts_driver_open(void **library, const char *name, int how, const char *backend, const char *none)
{
	ts_status status = ts_library_open(library, name, how);
	if (status == TS_SKIPPED) return absent(backend, none);
	return status == TS_OK ? TS_OK : ts_fail("backend %s: %s", backend, ts_error_message());
}
