/* Which devices there are, and what they can do. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "backends/opencl/cl.h"
#include "model/library.h"

enum { PLATFORMS = 16 };

ts_cl_calls ts_cl_call;

/* The program's own OpenCL is preferred. */
static bool find_calls(void)
{
#define NAME(name) "cl" #name,
	static const char *const names[] = {TS_CL_CALLS(NAME)};
#undef NAME
	return dlopen("libOpenCL.so.1", RTLD_NOW | RTLD_GLOBAL) != NULL &&
	       ts_library_find(&ts_cl_call, names, sizeof names / sizeof *names, RTLD_DEFAULT);
}

static u32 all_devices(cl_device_id devices[TS_MAX_DEVICES])
{
	cl_platform_id platforms[PLATFORMS];
	cl_uint n_platforms = 0, n = 0;
	if (ts_cl_call.GetPlatformIDs(PLATFORMS, platforms, &n_platforms) != CL_SUCCESS) return 0;
	for (cl_uint p = 0; p < n_platforms && p < PLATFORMS; p++) {
		cl_uint more = 0, room = TS_MAX_DEVICES - n;
		if (ts_cl_call.GetDeviceIDs(platforms[p], CL_DEVICE_TYPE_ALL, room, devices + n, &more) != CL_SUCCESS) continue;
		n += more < room ? more : room;
		if (n == TS_MAX_DEVICES) break;
	}
	return n;
}

/* A child asks first: a driver may end the process that asks, as PoCL does where there is no /sys. */
static ts_status ask(void)
{
	static bool known, there;
	if (known) return there ? TS_OK : TS_SKIPPED;
	known = !find_calls();
	if (known) return TS_SKIPPED;
	fflush(NULL);
	pid_t child = fork();
	if (child < 0) return ts_fail("backend opencl: no process to ask for devices: %s", strerror(errno));
	if (child == 0) {
		cl_device_id devices[TS_MAX_DEVICES];
		if (freopen("/dev/null", "w", stderr) == NULL) _exit(1);
		_exit(all_devices(devices) != 0 ? 0 : 1);
	}
	int status = 1;
	there = waitpid(child, &status, 0) == child && status == 0;
	known = true;
	return there ? TS_OK : TS_SKIPPED;
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

u32 ts_cl_devices(ts_device devices[TS_MAX_DEVICES])
{
	cl_device_id ids[TS_MAX_DEVICES];
	u32 n = ask() == TS_OK ? all_devices(ids) : 0;
	for (u32 i = 0; i < n; i++) devices[i] = describe(ids[i]);
	return n;
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
	cl_device_id ids[TS_MAX_DEVICES];
	ts_status asked = ask();
	if (asked == TS_ERROR) return TS_ERROR;
	u32 n = asked == TS_OK ? all_devices(ids) : 0;
	if (n == 0) {
		ts_fail("backend opencl: no OpenCL device; install a driver, such as Debian's pocl-opencl-icd");
		return TS_SKIPPED;
	}
	if (index >= n) {
		return ts_fail("device %u: there are %u devices, from 0", index, n);
	}
	*device = ids[index];
	*about = describe(ids[index]);
	choose_pocl_method(*device);
	return TS_OK;
}
