/* Drivers: which may be absent, or be there and fail. */
#ifndef TS_BACKENDS_DEVICES_DRIVER_H
#define TS_BACKENDS_DEVICES_DRIVER_H
#include <touchstone/status.h>

/* No device was found: TS_SKIPPED, the message ending with `none`; TS_ERROR where this process has so little memory
 * left that a driver may be there and could not load. */
ts_status ts_driver_none(const char *backend, const char *none);
/* Opens a driver, or its loader, as dlopen does. TS_SKIPPED, the message ending with `none`, if it is absent; TS_ERROR
 * if it is there and does not open. */
ts_status ts_driver_open(void **library, const char *name, int how, const char *backend, const char *none);

#endif
