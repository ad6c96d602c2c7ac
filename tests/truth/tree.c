/* Embree's devices, scenes and geometries: all that is made is released, also where Embree fails; what is said then;
 * of the failures of many threads one is kept, whole; and Embree opens when memory is back. */
#include <assert.h>
#include <sys/resource.h>
#include "tests/model/test.h"
#include "tests/truth/world.h"
#include "truth/bare.h"
#include "truth/tree.h"

/* Embree as it is, and what it is made to do. */
static ts_rtc_calls own;
static struct {
	bool no_device, no_scene, no_geometry;
	enum RTCError code; /* of every call */
	const char *text;   /* reported when a scene is made; NULL: nothing is */
} fault;
static i32 n_held, n_made;
static RTCErrorFunction on_error;
static RTCMemoryMonitorFunction on_memory;
static void *user_of_error, *user_of_memory;

static void *made(void *it)
{
	n_made++;
	n_held += it != NULL;
	return it;
}

static RTCDevice new_device(const char *options) { return made(fault.no_device ? NULL : own.NewDevice(options)); }

static RTCScene new_scene(RTCDevice device)
{
	if (fault.text != NULL) on_error(user_of_error, RTC_ERROR_INVALID_OPERATION, fault.text);
	return made(fault.no_scene ? NULL : own.NewScene(device));
}

static RTCGeometry new_geometry(RTCDevice device, enum RTCGeometryType type)
{
	return made(fault.no_geometry ? NULL : own.NewGeometry(device, type));
}

static void release_device(RTCDevice device)
{
	n_held--;
	own.ReleaseDevice(device);
}

static void release_scene(RTCScene scene)
{
	n_held--;
	own.ReleaseScene(scene);
}

static void release_geometry(RTCGeometry geometry)
{
	n_held--;
	own.ReleaseGeometry(geometry);
}

static enum RTCError device_error(RTCDevice device)
{
	enum RTCError code = own.GetDeviceError(device);
	return fault.code != RTC_ERROR_NONE ? fault.code : code;
}

static void set_error(RTCDevice device, RTCErrorFunction function, void *user)
{
	on_error = function;
	user_of_error = user;
	own.SetDeviceErrorFunction(device, function, user);
}

static void set_memory(RTCDevice device, RTCMemoryMonitorFunction function, void *user)
{
	on_memory = function;
	user_of_memory = user;
	own.SetDeviceMemoryMonitorFunction(device, function, user);
}

static void *no_buffer(RTCGeometry geometry, enum RTCBufferType type, unsigned int slot, enum RTCFormat format,
                       size_t stride, size_t n)
{
	(void)geometry;
	(void)type;
	(void)slot;
	(void)format;
	(void)stride;
	(void)n;
	return NULL;
}

static world *room;

static int begin(void **state)
{
	(void)state;
	if (ts_rtc_open() != TS_OK) return -1;
	own = ts_rtc;
	ts_rtc.NewDevice = new_device;
	ts_rtc.NewScene = new_scene;
	ts_rtc.NewGeometry = new_geometry;
	ts_rtc.ReleaseDevice = release_device;
	ts_rtc.ReleaseScene = release_scene;
	ts_rtc.ReleaseGeometry = release_geometry;
	ts_rtc.GetDeviceError = device_error;
	ts_rtc.SetDeviceErrorFunction = set_error;
	ts_rtc.SetDeviceMemoryMonitorFunction = set_memory;
	room = malloc(sizeof *room);
	if (room == NULL) return -1;
	world_begin(room);
	world_room(room, ts_v3_make(-1, -1, -1), ts_v3_make(1, 1, 1), ONE_SIDED, 0);
	world_pose(room);
	ts_offscreen *view = ts_frame_make1(&room->run.frame, TS_B_offscreen_view, 1);
	*view = (ts_offscreen){
		.focal = 8, .right = {1, 0, 0}, .up = {0, 1, 0}, .back = {0, 0, 1}, .width = 4, .height = 4, .near = 0.1f};
	return 0;
}

static int restart(void **state)
{
	(void)state;
	memset(&fault, 0, sizeof fault);
	return 0;
}

static int end(void **state)
{
	(void)state;
	ts_rtc = own;
	ts_run_end(&room->run);
	free(room);
	return 0;
}

static void all_that_is_made_is_released(void **state)
{
	(void)state;
	ts_truth *truth;
	ts_bare *bare;
	n_made = 0;
	assert_int_equal(ts_truth_new(&truth, &room->run), TS_OK);
	assert_int_equal(n_held, 2);
	ts_truth_free(truth);
	assert_int_equal(n_held, 0);
	assert_int_equal(ts_bare_new(&bare, &room->run), TS_OK);
	assert_int_equal(n_held, 2);
	ts_bare_free(bare);
	assert_true(n_held == 0 && n_made == 6);
	ts_truth_free(NULL);
	ts_bare_free(NULL);
}

/* Neither a truth nor bare rays begin, both say why, and nothing is held. */
static void fails(const char *doing, const char *why)
{
	ts_truth *truth = (ts_truth *)1;
	ts_bare *bare = (ts_bare *)1;
	char message[256];
	snprintf(message, sizeof message, "truth: Embree failed while %s: %s; it may take %llu MiB", doing, why,
	         (unsigned long long)ts_memory_limit() / 1048576);
	assert_int_equal(ts_truth_new(&truth, &room->run), TS_ERROR);
	assert_string_equal(ts_error_message(), message);
	assert_true(truth == NULL && n_held == 0);
	assert_int_equal(ts_bare_new(&bare, &room->run), TS_ERROR);
	assert_true(bare == NULL && n_held == 0);
	assert_non_null(strstr(ts_error_message(), why));
}

static void a_failure_of_embree_says_why(void **state)
{
	(void)state;
	fault.no_device = true;
	fails("starting", "no reason given");
	fault.code = RTC_ERROR_OUT_OF_MEMORY;
	fails("starting", "out of memory");
	fault.no_device = false;
	fault.no_scene = true;
	fails("making a scene", "out of memory");
	fault.code = RTC_ERROR_UNSUPPORTED_CPU;
	fails("making a scene", "no reason given");
	fault.no_scene = false;
	fails("copying the triangles", "no reason given");
	fault.code = RTC_ERROR_NONE;
	fault.no_scene = true;
	fails("making a scene", "no reason given");
	fault.no_scene = false;
	fault.no_geometry = true;
	fails("making a geometry", "no reason given");
	fault.no_geometry = false;
	fault.text = "because";
	fails("copying the triangles", "error 3, because");
	fault.code = RTC_ERROR_OUT_OF_MEMORY;
	fails("copying the triangles", "error 3, because");
}

/* A truth copies its triangles to Embree. */
static void without_room_for_indices_no_truth_begins(void **state)
{
	(void)state;
	ts_truth *truth;
	ts_rtc.SetNewGeometryBuffer = no_buffer;
	assert_int_equal(ts_truth_new(&truth, &room->run), TS_ERROR);
	ts_rtc.SetNewGeometryBuffer = own.SetNewGeometryBuffer;
	assert_non_null(strstr(ts_error_message(), "copying the triangles: no reason given"));
	assert_true(truth == NULL && n_held == 0);
}

/* Embree may take what a run may, in all: less is granted, more is not, and what was freed may be taken again. */
static void embree_stays_within_a_runs_memory(void **state)
{
	(void)state;
	ts_truth *truth;
	ssize_t most = (ssize_t)ts_memory_limit();
	assert_int_equal(ts_truth_new(&truth, &room->run), TS_OK);
	assert_true(on_memory(user_of_memory, 1 << 20, false));
	assert_false(on_memory(user_of_memory, most, false));
	assert_true(on_memory(user_of_memory, 1, true));
	assert_true(on_memory(user_of_memory, -most, false));
	assert_true(on_memory(user_of_memory, most / 2, false));
	assert_false(on_memory(user_of_memory, most / 2, false));
	assert_true(on_memory(user_of_memory, -(most / 2) * 2 - (1 << 20) - 1, true));
	ts_truth_free(truth);
}

enum { N_THREADS = 8, N_ROUNDS = 200 };

static void the_first_error_is_kept(void **state)
{
	(void)state;
	ts_first_error error;
	ts_first_error_begin(&error);
	assert_null(ts_first_error_text(&error));
	ts_first_error_keep(&error, 4, NULL);
	ts_first_error_keep(&error, 5, "later");
	assert_string_equal(ts_first_error_text(&error), "error 4, no text");
	ts_first_error_end(&error);
}

static void a_long_text_is_cut(void **state)
{
	(void)state;
	char text[1024];
	ts_first_error error;
	memset(text, 'x', sizeof text);
	text[sizeof text - 1] = 0;
	ts_first_error_begin(&error);
	ts_first_error_keep(&error, 1, text);
	assert_int_equal(strlen(ts_first_error_text(&error)), sizeof error.text - 1);
	ts_first_error_end(&error);
}

typedef struct {
	ts_first_error *error;
	int code;
} failing;

/* Each thread's text is a run of its own letter, of its own length. */
static void *fail_once(void *user)
{
	failing *f = user;
	char text[64] = "";
	memset(text, 'a' + f->code, 20 + (size_t)f->code);
	ts_first_error_keep(f->error, f->code, text);
	assert(ts_first_error_text(f->error) != NULL);
	return NULL;
}

static void one_error_of_many_is_kept_whole(void **state)
{
	(void)state;
	for (int round = 0; round < N_ROUNDS; round++) {
		ts_first_error error;
		pthread_t thread[N_THREADS];
		failing each[N_THREADS];
		ts_first_error_begin(&error);
		for (int i = 0; i < N_THREADS; i++) {
			each[i] = (failing){&error, i};
			assert_int_equal(pthread_create(&thread[i], NULL, fail_once, &each[i]), 0);
		}
		for (int i = 0; i < N_THREADS; i++) pthread_join(thread[i], NULL);
		const char *text = ts_first_error_text(&error);
		size_t code = (size_t)(text[6] - '0'), length = 20 + code;
		assert_int_equal(strlen(text), 9 + length);
		for (size_t i = 0; i < length; i++) assert_int_equal(text[9 + i], 'a' + (int)code);
		ts_first_error_end(&error);
	}
}

static void embree_opens_when_memory_is_back(void **state)
{
	(void)state;
	struct rlimit usual, none;
	if (TS_TEST_SANITIZED) skip();
	assert_int_equal(getrlimit(RLIMIT_AS, &usual), 0);
	none = (struct rlimit){1, usual.rlim_max};
	assert_int_equal(setrlimit(RLIMIT_AS, &none), 0);
	ts_status status = ts_rtc_open();
	assert_int_equal(setrlimit(RLIMIT_AS, &usual), 0);
	assert_int_equal(status, TS_ERROR);
	assert_int_equal(ts_error_kind(), TS_KIND_MEMORY);
	assert_non_null(strstr(ts_error_message(), "Embree does not open: out of memory"));
	assert_int_equal(ts_rtc_open(), TS_OK);
}

/* Before Embree is open for all. */
static int open_first(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(embree_opens_when_memory_is_back)};
	return cmocka_run_group_tests_name("open", tests, NULL, NULL);
}

int main(void)
{
	int failed = open_first();
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup(all_that_is_made_is_released, restart),
		cmocka_unit_test_setup(a_failure_of_embree_says_why, restart),
		cmocka_unit_test_setup(without_room_for_indices_no_truth_begins, restart),
		cmocka_unit_test_setup(embree_stays_within_a_runs_memory, restart),
		cmocka_unit_test(the_first_error_is_kept),
		cmocka_unit_test(a_long_text_is_cut),
		cmocka_unit_test(one_error_of_many_is_kept_whole),
	};
	return failed + cmocka_run_group_tests(tests, begin, end);
}
