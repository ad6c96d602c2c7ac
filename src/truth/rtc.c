/* Opening Embree: see rtc.h. */
#include "truth/rtc.h"
#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include "model/core.h"
#include "model/library.h"

#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)
#define LIBRARY "libembree" TEXT(TS_EMBREE) ".so." TEXT(TS_EMBREE)
#define NAME(name) "rtc" #name,

ts_rtc_calls ts_rtc;
static bool found;
static char missing[512];

static void find(void)
{
	static const char *const names[] = {TS_RTC_CALLS(NAME)};
	void *library = dlopen(LIBRARY, RTLD_NOW | RTLD_LOCAL);
	found = library != NULL && ts_library_find(&ts_rtc, names, sizeof names / sizeof *names, library);
	const char *why = found ? NULL : dlerror();
	snprintf(missing, sizeof missing, "%s", why != NULL ? why : LIBRARY ": not as it was built for");
}

ts_status ts_rtc_open(void)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, find);
	if (found) return TS_OK;
	return ts_fail_as(
		TS_KIND_LIBRARY,
		"truth: rays need Embree, in Debian the package libembree" TEXT(TS_EMBREE) "-" TEXT(TS_EMBREE) ": %s", missing);
}
