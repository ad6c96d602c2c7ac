/* Contexts: what they refuse, whom they tell, how a host ends what takes long; and that the library keeps to itself. */
#include <fcntl.h>
#include <locale.h>
#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>
#include "api/api.h"
#include "tests/api/api.h"

static void wrong_options_of_a_context_are_refused(void **state)
{
	(void)state;
	ts_context *context = NULL;
	struct {
		ts_context_options options;
		char newer[8];
	} wide = {.options = {.bytes = sizeof wide}};
	done(ts_context_open(&context, NULL));
	assert_int_equal(context->how.threads, ts_threads_all());
	ts_context_close(context);
	done(ts_context_open(&context, &wide.options)); /* of a newer header, and says nothing new */
	ts_context_close(context);
	wide.newer[3] = 1;
	refused(ts_context_open(&context, &wide.options), "does not know");
	assert_null(context);
	ts_context_options options = {.bytes = 12};
	refused(ts_context_open(&context, &options), "bytes"); /* half a pointer */
	options.bytes = SIZE_MAX;
	refused(ts_context_open(&context, &options), "bytes");
	options = (ts_context_options){.bytes = sizeof options, .threads = 5000};
	refused(ts_context_open(&context, &options), "5000 threads");
	options = (ts_context_options){.backend = "c"};
	refused(ts_context_open(&context, &options), "bytes");
	options = (ts_context_options){.bytes = sizeof options, .backend = "metal"};
	refused(ts_context_open(&context, &options), "metal");
	assert_non_null(strstr(ts_error_message(), "opencl"));
	ts_context_close(NULL);
	assert_string_equal(ts_backend_at(0), "c");
	assert_string_equal(ts_backend_at(1), "opencl");
	assert_null(ts_backend_at(100));
	assert_int_equal(strspn(ts_version(), "0123456789."), strlen(ts_version()));
}

typedef struct {
	int asked, end_at; /* cancelled is asked; at which time it says yes, 0: never */
	int n_progress;
	uint64_t last_done, last_total;
} host;

static void progress(void *user, const char *label, uint64_t done, uint64_t total)
{
	host *h = user;
	assert_true(label[0] != 0 && done <= total);
	h->n_progress++;
	h->last_done = done;
	h->last_total = total;
}

static int cancelled(void *user)
{
	host *h = user;
	return ++h->asked == h->end_at;
}

/* At whatever stage a host ends a run, the run fails, and the next one is whole. */
static void a_run_ends_at_any_stage(void **state)
{
	(void)state;
	host h = {.end_at = 0};
	ts_context *context;
	ts_context_options options = {
		.bytes = sizeof options, .threads = 2, .user = &h, .progress = progress, .cancelled = cancelled};
	done(ts_context_open(&context, &options));
	ts_params *params = small_params();
	ts_scene *scene = small_scene(context, params);
	ts_trace *trace = small_trace(context, scene, params, "mvr");
	char hex[65], again[65];
	done(ts_trace_digest(trace, "image.srgb", hex));
	ts_trace_close(trace);
	assert_true(h.n_progress > 0);
	assert_int_equal(h.last_done, h.last_total);
	ts_status status = TS_ERROR;
	for (int end = 1; status != TS_OK; end++) {
		h = (host){.end_at = end};
		status = ts_trace_run(context, &trace, scene, params, "reflections", "mvr", NULL);
		if (status == TS_OK) break;
		refused(status, "cancelled");
		assert_null(trace);
		assert_int_equal(h.asked, end);
	}
	assert_true(h.asked > 5);
	done(ts_trace_digest(trace, "image.srgb", again));
	assert_string_equal(hex, again);
	ts_trace_close(trace);
	ts_scene_free(scene);
	ts_params_free(params);
	ts_context_close(context);
}

static int n_stages(const char *effect, const char *method)
{
	int n = 0;
	while (ts_method_stage(effect, method, (size_t)n) != NULL) n++;
	return n;
}

/* A host is asked within stages too, and ends the run at once. */
static void a_run_ends_within_a_stage(void **state)
{
	(void)state;
	static const struct {
		const char *effect, *method;
		int no_fast_paths;
	} runs[] = {{"soft-shadows", "ivir", 0}, {"reflections", "mvr", 1}};
	static const char *const size[][2] = {
		{"width", "160"}, {"height", "90"}, {"lamp.views", "128"}, {"depth_map.px", "128"}, {"reflectors.count", "3"}};
	for (size_t i = 0; i < sizeof runs / sizeof *runs; i++) {
		host h = {.end_at = 0};
		ts_context *context;
		ts_scene *scene;
		ts_params *params;
		ts_trace *trace;
		const ts_run_options picture = {.bytes = sizeof picture, .buffers = "image.srgb"};
		const ts_context_options options = {.bytes = sizeof options,
		                                    .threads = 2,
		                                    .no_fast_paths = runs[i].no_fast_paths,
		                                    .user = &h,
		                                    .cancelled = cancelled};
		done(ts_context_open(&context, &options));
		done(ts_params_make(&params));
		for (size_t k = 0; k < sizeof size / sizeof *size; k++) done(ts_params_set(params, size[k][0], size[k][1]));
		done(ts_scene_open(context, &scene, "gallery:triangles=50k:texels=32", params, NULL));
		h = (host){.end_at = 0};
		done(ts_trace_run(context, &trace, scene, params, runs[i].effect, runs[i].method, &picture));
		ts_trace_close(trace);
		const int n = h.asked;
		if (n <= n_stages(runs[i].effect, runs[i].method)) fail_msg("%s: asked %d times", runs[i].method, n);
		for (int end = n / 8; end <= n / 4; end += n / 8) {
			h = (host){.end_at = end};
			refused(ts_trace_run(context, &trace, scene, params, runs[i].effect, runs[i].method, &picture),
			        "cancelled");
			assert_int_equal(ts_error_kind(), TS_KIND_CANCELLED);
			assert_int_equal(h.asked, end);
		}
		ts_scene_free(scene);
		ts_params_free(params);
		ts_context_close(context);
	}
}

static const ts_params *shared_params;
static const ts_scene *shared_scene;

static void *digest_of(void *hex)
{
	ts_context *context = open_context(1);
	ts_trace *trace = small_trace(context, shared_scene, shared_params, "epr");
	done(ts_trace_digest(trace, "image.srgb", hex));
	ts_trace_close(trace);
	ts_context_close(context);
	return NULL;
}

static int share(void **state)
{
	(void)state;
	ts_context *context = open_context(1);
	ts_params *params = small_params();
	shared_scene = small_scene(context, params);
	shared_params = params;
	ts_context_close(context);
	return 0;
}

static int unshare(void **state)
{
	(void)state;
	ts_scene_free((ts_scene *)(uintptr_t)shared_scene);
	ts_params_free((ts_params *)(uintptr_t)shared_params);
	return 0;
}

static void threads_may_share_a_scene(void **state)
{
	(void)state;
	pthread_t threads[4];
	char hex[4][65];
	for (int i = 0; i < 4; i++) assert_int_equal(pthread_create(&threads[i], NULL, digest_of, hex[i]), 0);
	for (int i = 0; i < 4; i++) assert_int_equal(pthread_join(threads[i], NULL), 0);
	for (int i = 1; i < 4; i++) assert_string_equal(hex[0], hex[i]);
}

/* In a child, whose parent computed with two threads: 0 if its own context gives the same picture. */
static int in_child(ts_context *of_parent, const char *hex)
{
	char own[65];
	ts_context *context;
	ts_trace *trace;
	alarm(20);
	if (ts_trace_run(of_parent, &trace, shared_scene, shared_params, "reflections", "mvr", NULL) != TS_ERROR) return 1;
	if (strstr(ts_error_message(), "a fork; a context of its own would be right") == NULL) return 2;
	if (ts_context_open(&context, &(ts_context_options){.bytes = sizeof(ts_context_options), .threads = 2}) != TS_OK)
		return 3;
	if (ts_trace_run(context, &trace, shared_scene, shared_params, "reflections", "mvr", NULL) != TS_OK) return 4;
	if (ts_trace_digest(trace, "image.srgb", own) != TS_OK || strcmp(own, hex) != 0) return 5;
	ts_trace_close(trace);
	ts_context_close(context);
	return 0;
}

static void the_child_of_a_fork_opens_its_own(void **state)
{
	(void)state;
	int told;
	char hex[65];
	ts_context *context = open_context(2);
	ts_trace *trace = small_trace(context, shared_scene, shared_params, "mvr");
	done(ts_trace_digest(trace, "image.srgb", hex));
	ts_trace_close(trace);
	pid_t child = fork();
	if (child == 0) _exit(in_child(context, hex));
	assert_int_equal(waitpid(child, &told, 0), child);
	assert_int_equal(told, 0);
	trace = small_trace(context, shared_scene, shared_params, "mvr");
	ts_trace_close(trace);
	ts_context_close(context);
}

/* A host whose progress calls the library, or leaves by longjmp. */
typedef struct {
	ts_context *context;
	char folder[FOLDER];
	bool leaves;
	jmp_buf away;
	char said[256];
} rude;

static void write_into(rude *r, const char *name)
{
	char path[PATH];
	snprintf(path, sizeof path, "%s/%s", r->folder, name);
	const ts_status status = ts_trace_write(r->context, path, shared_scene, shared_params, "reflections", "mvr", NULL);
	snprintf(r->said, sizeof r->said, "%s", status == TS_OK ? "" : ts_error_message());
}

static void rude_progress(void *user, const char *label, uint64_t done_now, uint64_t total)
{
	(void)label;
	(void)done_now;
	(void)total;
	rude *r = user;
	if (r->leaves) longjmp(r->away, 1);
	if (r->said[0] == 0) write_into(r, "inner");
}

static void open_rude(rude *r)
{
	const ts_context_options options = {.bytes = sizeof options, .threads = 1, .user = r, .progress = rude_progress};
	make_folder(r->folder);
	done(ts_context_open(&r->context, &options));
}

static void a_call_within_a_call_is_refused(void **state)
{
	(void)state;
	ts_trace *trace;
	rude r = {.leaves = false};
	open_rude(&r);
	done(ts_trace_run(r.context, &trace, shared_scene, shared_params, "reflections", "mvr", NULL));
	ts_trace_close(trace);
	if (strstr(r.said, "called within a function of a context's options") == NULL) fail_msg("%s", r.said);
	write_into(&r, "outer");
	assert_string_equal(r.said, "");
	ts_context_close(r.context);
	remove_folder(r.folder);
}

static void *write_apart(void *user)
{
	rude other = {.leaves = false, .said = "no calls"};
	(void)user;
	open_rude(&other);
	write_into(&other, "apart");
	remove_folder(other.folder);
	return other.said[0] == 0 ? user : NULL;
}

/* In a child, for what was begun is lost: 0 if this thread is told so, and another thread writes a trace. */
static int left_in_child(void)
{
	pthread_t other;
	void *wrote = NULL;
	static rude r = {.leaves = true};
	alarm(20);
	open_rude(&r);
	if (setjmp(r.away) == 0) {
		write_into(&r, "left");
		return 1;
	}
	r.leaves = false;
	write_into(&r, "again");
	remove_folder(r.folder);
	if (strstr(r.said, "or after one that did not return") == NULL) return 2;
	if (pthread_create(&other, NULL, write_apart, &r) != 0 || pthread_join(other, &wrote) != 0) return 3;
	return wrote == &r ? 0 : 4;
}

static void a_call_that_was_left_locks_nothing(void **state)
{
	(void)state;
	int told;
	pid_t child = fork();
	if (child == 0) _exit(left_in_child());
	assert_int_equal(waitpid(child, &told, 0), child);
	assert_int_equal(told, 0);
}

/* Nothing is printed, of failures neither, and the locale stays. */
static void the_library_prints_nothing(void **state)
{
	(void)state;
	char path[] = "/tmp/touchstone-api-XXXXXX", hex[65];
	int file = mkstemp(path), out = dup(1), err = dup(2);
	assert_true(file >= 0 && out >= 0 && err >= 0);
	const char *locale = setlocale(LC_ALL, "C.UTF-8");
	fflush(stdout);
	assert_true(dup2(file, 1) == 1 && dup2(file, 2) == 2);
	digest_of(hex);
	ts_trace *trace;
	ts_context *context = open_context(2000 / 10);
	ts_status status = ts_trace_open(context, &trace, "/nowhere");
	ts_context_close(context);
	fflush(stdout);
	assert_true(dup2(out, 1) == 1 && dup2(err, 2) == 2);
	assert_int_equal(lseek(file, 0, SEEK_END), 0);
	assert_string_equal(setlocale(LC_ALL, NULL), locale);
	refused(status, "/nowhere");
	close(file);
	close(out);
	close(err);
	unlink(path);
}

/* Devices of each backend end somewhere; the backend in C has one, exact. */
static void devices_of_each_backend_end_somewhere(void **state)
{
	(void)state;
	const char *backend;
	for (size_t b = 0; (backend = ts_backend_at(b)) != NULL; b++) {
		uint32_t n = 0;
		for (ts_device_info device = {.bytes = sizeof device}; n < 32 && ts_device_at(&device, backend, n) == TS_OK;
		     n++) {
			assert_true(device.name[0] != 0 && (b > 0 || (device.rounded && device.atomics)));
			device = (ts_device_info){.bytes = sizeof device};
		}
		assert_true(n < 32 && (b > 0 || n == 1));
	}
#pragma omp parallel for num_threads(4)
	for (int i = 0; i < 16; i++) {
		ts_device_info own = {.bytes = sizeof own};
		(void)ts_device_at(&own, ts_backend_at((size_t)i % 4), 0);
	}
	struct {
		ts_device_info known;
		char unset[32];
	} larger;
	memset(&larger, 7, sizeof larger);
	larger.known.bytes = sizeof larger;
	done(ts_device_at(&larger.known, "c", 0));
	assert_int_equal(larger.unset[0], 7);
	ts_device_info device = {.bytes = sizeof device};
	assert_int_equal(ts_device_at(&device, "c", 1), TS_SKIPPED);
	refused(ts_device_at(&device, "cc", 0), "cc");
	device.bytes = 0;
	refused(ts_device_at(&device, "c", 0), "bytes");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(wrong_options_of_a_context_are_refused),
		cmocka_unit_test(a_run_ends_at_any_stage),
		cmocka_unit_test(a_run_ends_within_a_stage),
		cmocka_unit_test(threads_may_share_a_scene),
		cmocka_unit_test(the_child_of_a_fork_opens_its_own),
		cmocka_unit_test(a_call_within_a_call_is_refused),
		cmocka_unit_test(a_call_that_was_left_locks_nothing),
		cmocka_unit_test(the_library_prints_nothing),
		cmocka_unit_test(devices_of_each_backend_end_somewhere),
	};
	return cmocka_run_group_tests(tests, share, unshare);
}
