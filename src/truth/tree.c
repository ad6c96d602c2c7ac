/* A tree of Embree: the library, opened; the first of its failures; the tree. */
#include "truth/tree.h"
#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include "model/core.h"
#include "model/library.h"

#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)
#define LIBRARY "libembree" TEXT(TS_EMBREE) ".so." TEXT(TS_EMBREE)
#define PACKAGE "libembree" TEXT(TS_EMBREE) "-" TEXT(TS_EMBREE)
#define NAME(name) "rtc" #name,

ts_rtc_calls ts_rtc;

static ts_status find(void)
{
	static const char *const names[] = {TS_RTC_CALLS(NAME)};
	void *library;
	ts_status status = ts_library_open(&library, LIBRARY, RTLD_NOW | RTLD_LOCAL);
	if (status == TS_SKIPPED) {
		return ts_fail("truth: rays need Embree, in Debian the package " PACKAGE ": %s", ts_error_message());
	}
	if (status != TS_OK) return ts_fail("truth: Embree does not open: %s", ts_error_message());
	if (ts_library_find(&ts_rtc, names, sizeof names / sizeof *names, library)) return TS_OK;
	return ts_fail_as(TS_KIND_LIBRARY, "truth: " LIBRARY ": not as it was built for");
}

ts_status ts_rtc_open(void)
{
	static pthread_mutex_t one = PTHREAD_MUTEX_INITIALIZER;
	static bool found;
	pthread_mutex_lock(&one);
	ts_status status = found ? TS_OK : find();
	found = status == TS_OK;
	pthread_mutex_unlock(&one);
	return status;
}

void ts_first_error_begin(ts_first_error *error)
{
	pthread_mutex_init(&error->lock, NULL);
	error->text[0] = 0;
}

void ts_first_error_end(ts_first_error *error) { pthread_mutex_destroy(&error->lock); }

void ts_first_error_keep(ts_first_error *error, int code, const char *text)
{
	pthread_mutex_lock(&error->lock);
	if (error->text[0] == 0)
		snprintf(error->text, sizeof error->text, "error %d, %s", code, text != NULL ? text : "no text");
	pthread_mutex_unlock(&error->lock);
}

const char *ts_first_error_text(ts_first_error *error)
{
	pthread_mutex_lock(&error->lock);
	const char *text = error->text[0] != 0 ? error->text : NULL;
	pthread_mutex_unlock(&error->lock);
	return text;
}

#if TS_EMBREE == 4
#define FILTER_OF_QUERY RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS
#else
#define FILTER_OF_QUERY RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION
#endif

/* Embree calls this from the thread that failed, and ts_tree_check reports it from ours. */
static void on_error(void *user, enum RTCError code, const char *text)
{
	ts_tree *tree = user;
	ts_first_error_keep(&tree->error, (int)code, text);
}

/* Refuses memory beyond Embree's share of the machine. */
static bool on_memory(void *user, ssize_t bytes, bool post)
{
	ts_tree *tree = user;
	i64 left = __atomic_sub_fetch(&tree->bytes_left, (i64)bytes, __ATOMIC_RELAXED);
	return post || bytes <= 0 || left >= 0;
}

static ts_status fail(ts_tree *tree, enum RTCError code, const char *doing)
{
	const char *error = ts_first_error_text(&tree->error);
	if (error == NULL) error = code == RTC_ERROR_OUT_OF_MEMORY ? "out of memory" : "no reason given";
	return ts_fail_as(code == RTC_ERROR_OUT_OF_MEMORY ? TS_KIND_MEMORY : TS_KIND_LIBRARY,
	                  "truth: Embree failed while %s: %s; it may take %llu MiB", doing, error,
	                  (unsigned long long)(ts_memory_limit() >> 20));
}

ts_status ts_tree_fail(ts_tree *tree, const char *doing)
{
	return fail(tree, ts_rtc.GetDeviceError(tree->device), doing);
}

ts_status ts_tree_check(ts_tree *tree, const char *doing)
{
	enum RTCError code = ts_rtc.GetDeviceError(tree->device);
	bool good = code == RTC_ERROR_NONE && ts_first_error_text(&tree->error) == NULL;
	return good ? TS_OK : fail(tree, code, doing);
}

ts_status ts_tree_begin(ts_tree *tree, u32 threads)
{
	char options[32];
	snprintf(options, sizeof(options), "threads=%u", threads > 0 ? threads : 1);
	*tree = (ts_tree){.device = NULL};
	ts_first_error_begin(&tree->error);
	__atomic_store_n(&tree->bytes_left, (i64)ts_memory_limit(), __ATOMIC_RELEASE);
	if (ts_rtc_open() != TS_OK) return TS_ERROR;
	tree->device = ts_rtc.NewDevice(options);
	if (tree->device == NULL) return ts_tree_fail(tree, "starting");
	ts_rtc.SetDeviceErrorFunction(tree->device, on_error, tree);
	ts_rtc.SetDeviceMemoryMonitorFunction(tree->device, on_memory, tree);
	tree->scene = ts_rtc.NewScene(tree->device);
	if (tree->scene == NULL) return ts_tree_fail(tree, "making a scene");
	ts_rtc.SetSceneFlags(tree->scene, RTC_SCENE_FLAG_ROBUST | FILTER_OF_QUERY);
	return TS_OK;
}

static bool goes_on(void *stop, double share)
{
	(void)share;
	return !ts_stopped(stop);
}

ts_status ts_tree_build(ts_tree *tree)
{
	ts_rtc.SetSceneProgressMonitorFunction(tree->scene, goes_on, ts_stop_here());
	ts_rtc.CommitScene(tree->scene);
	if (ts_go_on() != TS_OK) return TS_ERROR;
	return ts_tree_check(tree, "building its tree") == TS_OK ? ts_selftest_require() : TS_ERROR;
}

void ts_tree_end(ts_tree *tree)
{
	if (tree->scene != NULL) ts_rtc.ReleaseScene(tree->scene);
	if (tree->device != NULL) ts_rtc.ReleaseDevice(tree->device);
	ts_first_error_end(&tree->error);
}

void ts_tree_cast(const ts_tree *tree, struct RTCRayHit *ray, ts_tree_context *context)
{
#if TS_EMBREE == 4
	struct RTCIntersectArguments arguments;
	rtcInitIntersectArguments(&arguments);
	rtcInitRayQueryContext(context);
	arguments.context = context;
	ts_rtc.Intersect1(tree->scene, ray, &arguments);
#else
	rtcInitIntersectContext(context);
	ts_rtc.Intersect1(tree->scene, context, ray);
#endif
}

void ts_tree_cast_16(const ts_tree *tree, const int *valid, struct RTCRayHit16 *rays, ts_tree_context *context,
                     RTCFilterFunctionN filter)
{
#if TS_EMBREE == 4
	struct RTCIntersectArguments arguments;
	rtcInitIntersectArguments(&arguments);
	rtcInitRayQueryContext(context);
	arguments.context = context;
	arguments.filter = filter;
	arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
	if (filter != NULL) arguments.flags |= RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
	ts_rtc.Intersect16(valid, tree->scene, rays, &arguments);
#else
	rtcInitIntersectContext(context);
	context->flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
	context->filter = filter;
	ts_rtc.Intersect16(valid, tree->scene, context, rays);
#endif
}
