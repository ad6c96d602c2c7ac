/* Contexts. */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "api/api.h"
#include "families/families.h"
#include "tools/tools.h"

const ts_backend_kind *const ts_backend_kinds[] = {&ts_c_kind, &ts_opencl_kind, &ts_vulkan_kind, &ts_cuda_kind, NULL};

static void begin(void)
{
	ts_families_begin();
	ts_tools_begin();
}

void ts_api_ready(void)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, begin);
}

/* Whether this thread works for a context, and whom it told and how many threads it had before. */
static _Thread_local bool inside;
static _Thread_local ts_listener before;
static _Thread_local uint32_t threads_before;

static ts_status enter(const ts_context *context, u32 threads)
{
	if (inside) {
		return ts_fail("called within a function of a context's options, or after one that did not return; such a "
		               "function must return, and call nothing of the library");
	}
	if (context->process != getpid()) {
		return ts_fail("the context is of process %ld, of which this is a fork; a context of its own would be right",
		               (long)context->process);
	}
	inside = true;
	before = ts_listen(&context->listener);
	const u32 there = ts_floats_hold(threads);
	threads_before = ts_threads_limit(there);
	ts_status status = ts_selftest_require_on(there);
	if (status != TS_OK) ts_api_leave();
	return status;
}

ts_status ts_api_enter(const ts_context *context) { return enter(context, context->how.threads); }

ts_status ts_api_enter_alone(const ts_context *context) { return enter(context, 1); }

void ts_api_leave(void)
{
	ts_floats_give();
	ts_threads_limit(threads_before);
	ts_listen(&before);
	inside = false;
}

static bool is_zero(const char *bytes, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		if (bytes[i] != 0) return false;
	}
	return true;
}

/* No struct of a caller is as large. */
enum { MOST_BYTES = 4096 };

ts_status ts_api_room(size_t bytes, size_t least_bytes, size_t our_bytes, const char *type)
{
	if (bytes >= least_bytes && bytes <= MOST_BYTES) return TS_OK;
	return ts_fail("%s: its member `bytes` is %zu; the size of the struct, %zu, would be right", type, bytes,
	               our_bytes);
}

ts_status ts_api_options(void *ours, size_t our_bytes, const void *options, const char *type)
{
	size_t bytes;
	if (options == NULL) return TS_OK;
	memcpy(&bytes, options, sizeof bytes);
	if (ts_api_room(bytes, our_bytes, our_bytes, type) != TS_OK) return TS_ERROR;
	if (!is_zero((const char *)options + our_bytes, bytes - our_bytes)) {
		return ts_fail("%s: sets what this library, touchstone %s, does not know", type, TS_VERSION);
	}
	memcpy(ours, options, our_bytes);
	return TS_OK;
}

/* Drivers are queried and opened one at a time; meanwhile nobody is called back. */
static pthread_mutex_t drivers = PTHREAD_MUTEX_INITIALIZER;

static ts_status open_backend(ts_how *how, const ts_backend_kind *kind, u32 device)
{
	const ts_backend_options wanted = {.device = device, .build = ""};
	if (kind->open == NULL) return TS_OK;
	pthread_mutex_lock(&drivers);
	ts_status status = kind->open(&how->backend, &wanted);
	pthread_mutex_unlock(&drivers);
	if (status == TS_OK) status = ts_vectors_verify(how->backend, false);
	return ts_blame(status, TS_KIND_DEVICE);
}

static ts_status open_context(ts_context *context, const ts_context_options *options)
{
	const char *name = options->backend != NULL ? options->backend : ts_backend_kinds[0]->name;
	context->listener = (ts_listener){options->say, options->progress, options->cancelled, options->user};
	if (ts_backend_find(&context->kind, ts_backend_kinds, name) != TS_OK) return TS_ERROR;
	if (options->threads > TS_MOST_THREADS) {
		return ts_fail("%lu threads; 0 to %d are right", (unsigned long)options->threads, TS_MOST_THREADS);
	}
	context->process = getpid();
	context->how.threads = options->threads > 0 ? options->threads : ts_processors();
	if (ts_api_enter(context) != TS_OK) return TS_ERROR;
	context->how.threads = ts_threads_all();
	context->how.no_fast_paths = options->no_fast_paths != 0;
	ts_status status = open_backend(&context->how, context->kind, options->device);
	ts_api_leave();
	return status;
}

ts_status ts_context_open(ts_context **context, const ts_context_options *options)
{
	ts_context_options ours = {0};
	if (TS_LACKS(context)) return TS_ERROR;
	*context = NULL;
	if (ts_api_options(&ours, sizeof ours, options, "ts_context_options") != TS_OK) return TS_ERROR;
	ts_api_ready();
	ts_context *made = ts_alloc_zero(1, sizeof *made, "a context");
	if (made == NULL) return TS_ERROR;
	ts_status status = open_context(made, &ours);
	if (status == TS_OK) {
		*context = made;
	} else {
		ts_context_close(made);
	}
	return status;
}

void ts_context_close(ts_context *context)
{
	if (context == NULL) return;
	ts_floats_hold(1);
	const bool own = context->process == getpid(); /* a driver knows nothing of a fork */
	if (context->how.backend != NULL && own) context->how.backend->close(context->how.backend);
	ts_floats_give();
	free(context->words.in);
	free(context);
}

const char *ts_backend_at(size_t i)
{
	for (size_t k = 0; ts_backend_kinds[k] != NULL; k++) {
		if (k == i) return ts_backend_kinds[k]->name;
	}
	return NULL;
}

ts_status ts_device_at(ts_device_info *device, const char *backend, uint32_t i)
{
	const ts_backend_kind *kind;
	ts_device devices[TS_MAX_DEVICES];
	if (TS_LACKS(device) || TS_LACKS(backend)) return TS_ERROR;
	ts_device_info info;
	if (ts_api_room(device->bytes, sizeof info, sizeof info, "ts_device_info") != TS_OK) return TS_ERROR;
	if (ts_backend_find(&kind, ts_backend_kinds, backend) != TS_OK) return TS_ERROR;
	ts_floats_hold(1);
	pthread_mutex_lock(&drivers);
	u32 n;
	const ts_status status = kind->devices(devices, &n);
	pthread_mutex_unlock(&drivers);
	ts_floats_give();
	if (status == TS_ERROR) return ts_blame(status, TS_KIND_DEVICE);
	if (i >= n) {
		ts_fail_as(TS_KIND_DEVICE, "%s: has no device %lu", backend, (unsigned long)i);
		return TS_SKIPPED;
	}
	const ts_device *d = &devices[i];
	info = (ts_device_info){device->bytes, "", d->rounded, d->denormals, d->atomics, d->memory, d->most};
	memcpy(info.name, d->name, sizeof info.name);
	*device = info;
	return TS_OK;
}

const char *ts_version(void) { return TS_VERSION; }
