/* Which devices there are, and what they can do. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include "backends/devices/driver.h"
#include "backends/opencl/cl.h"
#include "model/library.h"

static const char none[] = "no OpenCL device; install a driver, such as Debian's pocl-opencl-icd";
enum { PLATFORMS = 16, NO_PLATFORM = -1001 };

ts_cl_calls ts_cl_call;

/* The program's own OpenCL is preferred. */
static ts_status find_calls(void)
{
#define NAME(name) "cl" #name,
	static const char *const names[] = {TS_CL_CALLS(NAME)};
#undef NAME
	void *library;
	ts_status status = ts_driver_open(&library, "libOpenCL.so.1", RTLD_NOW | RTLD_GLOBAL, "opencl", none);
	if (status != TS_OK) return status;
	bool found = ts_library_find(&ts_cl_call, names, sizeof names / sizeof *names, RTLD_DEFAULT);
	return found ? TS_OK : ts_fail("backend opencl: libOpenCL.so.1 is older than OpenCL 1.2");
}

typedef struct {
	bool there, pocl; /* pocl: PoCL is there, without a device */
	u32 n;
	cl_int status;
	cl_device_id devices[TS_MAX_DEVICES];
} answer;

static bool is_pocl(cl_platform_id platform)
{
	char name[64] = "";
	ts_cl_call.GetPlatformInfo(platform, CL_PLATFORM_NAME, sizeof name - 1, name, NULL);
	return strcmp(name, TS_POCL) == 0;
}

static answer all_devices(void)
{
	cl_platform_id platforms[PLATFORMS];
	cl_uint n_platforms = 0;
	answer a = {.there = true, .status = ts_cl_call.GetPlatformIDs(PLATFORMS, platforms, &n_platforms)};
	for (cl_uint p = 0; a.status == CL_SUCCESS && p < n_platforms && p < PLATFORMS; p++) {
		cl_uint more = 0, room = TS_MAX_DEVICES - a.n;
		cl_int status = ts_cl_call.GetDeviceIDs(platforms[p], CL_DEVICE_TYPE_ALL, room, a.devices + a.n, &more);
		if (status == CL_SUCCESS) a.n += more < room ? more : room;
		a.pocl |= status != CL_SUCCESS && is_pocl(platforms[p]);
		if (a.n == TS_MAX_DEVICES) break;
	}
	return a;
}

static ts_status judge(const answer *a)
{
	if (a->n > 0) return TS_OK;
	if (a->pocl) {
		return ts_fail("backend opencl: PoCL finds no device, as where it cannot write its cache; a folder in "
		               "POCL_CACHE_DIR that it can write would be right");
	}
	if (a->status == CL_SUCCESS || a->status == NO_PLATFORM) return ts_driver_none("opencl", none);
	return ts_cl_failed("the devices", a->status);
}

static ts_status ended(int how)
{
	int number = WIFSIGNALED(how) ? WTERMSIG(how) : 0;
	if (number != 0) {
		return ts_fail("backend opencl: a driver crashed when it was asked for devices: signal %d, %s", number,
		               strsignal(number));
	}
	return ts_fail("backend opencl: a driver ended the process that asked for devices, with exit code %d",
	               WEXITSTATUS(how));
}

static ts_status ask_in_child(answer *shared)
{
	int how = 0;
	fflush(NULL);
	pid_t child = fork();
	if (child < 0) return ts_fail("backend opencl: no process to ask for devices: %s", strerror(errno));
	if (child == 0) {
		if (freopen("/dev/null", "w", stderr) != NULL) *shared = all_devices();
		_exit(0);
	}
	while (waitpid(child, &how, 0) < 0 && errno == EINTR) continue;
	return shared->there ? judge(shared) : ended(how);
}

/* A child asks first: a driver may end the process that asks, as PoCL does where there is no /sys. */
static ts_status ask(void)
{
	static bool there;
	if (there) return TS_OK;
	ts_status status = find_calls();
	if (status != TS_OK) return status;
	answer *shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	if (shared == MAP_FAILED) return ts_fail_as(TS_KIND_MEMORY, "backend opencl: no memory to ask for devices");
	status = ask_in_child(shared);
	munmap(shared, sizeof *shared);
	there = status == TS_OK;
	return status;
}

static void text(char *to, size_t bytes, cl_device_id device, cl_device_info what)
{
	char long_text[1024] = "";
	ts_cl_call.GetDeviceInfo(device, what, sizeof long_text - 1, long_text, NULL);
	snprintf(to, bytes, "%.*s", (int)bytes - 1, long_text);
	ts_line_clean(to);
}

static bool has(cl_device_id device, const char *extension)
{
	static char all[1 << 16];
	memset(all, 0, sizeof all);
	if (ts_cl_call.GetDeviceInfo(device, CL_DEVICE_EXTENSIONS, sizeof all - 1, all, NULL) != CL_SUCCESS) return false;
	size_t length = strlen(extension);
	for (const char *at = all; (at = strstr(at, extension)) != NULL; at += length) {
		if ((at == all || at[-1] == ' ') && (at[length] == 0 || at[length] == ' ')) return true;
	}
	return false;
}

static ts_device describe(cl_device_id device)
{
	ts_device d = {.memory = 0};
	cl_platform_id platform = NULL;
	cl_device_fp_config floats = 0;
	cl_bool unified = CL_FALSE, little = CL_FALSE;
	cl_ulong memory = 0, most = 0;
	text(d.name, sizeof d.name, device, CL_DEVICE_NAME);
	text(d.driver, sizeof d.driver, device, CL_DRIVER_VERSION);
	ts_cl_call.GetDeviceInfo(device, CL_DEVICE_PLATFORM, sizeof platform, &platform, NULL);
	ts_cl_call.GetPlatformInfo(platform, CL_PLATFORM_NAME, sizeof d.platform - 1, d.platform, NULL);
	ts_line_clean(d.platform);
	ts_cl_call.GetDeviceInfo(device, CL_DEVICE_SINGLE_FP_CONFIG, sizeof floats, &floats, NULL);
	ts_cl_call.GetDeviceInfo(device, CL_DEVICE_HOST_UNIFIED_MEMORY, sizeof unified, &unified, NULL);
	ts_cl_call.GetDeviceInfo(device, CL_DEVICE_ENDIAN_LITTLE, sizeof little, &little, NULL);
	ts_cl_call.GetDeviceInfo(device, CL_DEVICE_GLOBAL_MEM_SIZE, sizeof memory, &memory, NULL);
	ts_cl_call.GetDeviceInfo(device, CL_DEVICE_MAX_MEM_ALLOC_SIZE, sizeof most, &most, NULL);
	d.rounded = (floats & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0;
	d.denormals = (floats & CL_FP_DENORM) != 0;
	d.atomics = has(device, "cl_khr_int64_base_atomics") && has(device, "cl_khr_int64_extended_atomics");
	d.unified = unified == CL_TRUE;
	d.little_endian = little == CL_TRUE;
	d.memory = memory;
	d.most = most;
	return d;
}

ts_status ts_cl_devices(ts_device devices[TS_MAX_DEVICES], u32 *n)
{
	ts_status status = ask();
	*n = 0;
	if (status != TS_OK) return status;
	const answer a = all_devices();
	for (; *n < a.n; (*n)++) devices[*n] = describe(a.devices[*n]);
	return judge(&a);
}

/* PoCL 6.0 ends the process as it compiles some kernels (its issue 1608), except with another way of making
 * work-groups. PoCL reads the variable with each kernel; the user's setting stays. An unknown version may be 6.0. */
static void choose_pocl_method(cl_device_id device)
{
	char version[256] = "";
	cl_platform_id platform = NULL;
	ts_cl_call.GetDeviceInfo(device, CL_DEVICE_PLATFORM, sizeof platform, &platform, NULL);
	ts_cl_call.GetPlatformInfo(platform, CL_PLATFORM_VERSION, sizeof version - 1, version, NULL);
	if (version[0] == 0 || strstr(version, "PoCL 6.0") != NULL) setenv("POCL_WORK_GROUP_METHOD", "cbs", 0);
}

ts_status ts_cl_find(cl_device_id *device, ts_device *about, u32 index)
{
	ts_status status = ask();
	if (status != TS_OK) return status;
	const answer a = all_devices();
	if (a.n == 0) return judge(&a);
	if (index >= a.n) return ts_fail("device %u: there are %u devices, from 0", index, a.n);
	*device = a.devices[index];
	*about = describe(*device);
	choose_pocl_method(*device);
	return TS_OK;
}
