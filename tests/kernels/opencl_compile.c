/* Every kernel header compiles as OpenCL C 1.2, alone, through clBuildProgram on each device that is there. */
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <glob.h>
#include <unistd.h>
#include "tests/backends/device.h"

static cl_device_id first_device(void)
{
	cl_platform_id platforms[16];
	cl_uint n = 0;
	cl_device_id device = NULL;
	if (clGetPlatformIDs(16, platforms, &n) != CL_SUCCESS) {
		return NULL;
	}
	for (cl_uint i = 0; i < n && i < 16 && !device; i++) {
		clGetDeviceIDs(platforms[i], CL_DEVICE_TYPE_ALL, 1, &device, NULL);
	}
	return device;
}

/* True if `text` builds; otherwise prints the compiler's log. */
static bool builds(cl_context context, cl_device_id device, const char *text, const char *name, bool quiet)
{
	char folder[2048], options[4096], log[8192] = "";
	if (!getcwd(folder, sizeof folder)) {
		return false;
	}
	snprintf(options, sizeof options, "-cl-std=CL1.2 -I%s/src/kernels", folder);
	cl_int status;
	cl_program program = clCreateProgramWithSource(context, 1, &text, NULL, &status);
	assert_int_equal(status, CL_SUCCESS);
	status = clBuildProgram(program, 1, &device, options, NULL, NULL);
	if (status != CL_SUCCESS && !quiet) {
		clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, sizeof log - 1, log, NULL);
		printf("%s: clBuildProgram gives %d\n%s\n", name, status, log);
	}
	clReleaseProgram(program);
	return status == CL_SUCCESS;
}

static void every_header_builds(void **state)
{
	(void)state;
	if (!device_is_there(&ts_opencl_kind)) skip();
	cl_device_id device = first_device();
	cl_int status;
	cl_context context = clCreateContext(NULL, 1, &device, NULL, NULL, &status);
	assert_int_equal(status, CL_SUCCESS);
	glob_t headers;
	assert_int_equal(glob("src/kernels/*/*.h", 0, NULL, &headers), 0);
	size_t bad = 0;
	for (size_t i = 0; i < headers.gl_pathc; i++) {
		char text[512];
		snprintf(text, sizeof text, "#include \"%s\"\n__kernel void k(__global float *a) { a[0] = 0.0f; }\n",
		         headers.gl_pathv[i] + strlen("src/kernels/"));
		bad += !builds(context, device, text, headers.gl_pathv[i], false);
	}
	assert_true(headers.gl_pathc > 3);
	assert_int_equal(bad, 0);
	assert_false(
		builds(context, device, "#include \"base/num.h\"\nf32 f(void) { return no_such_thing; }", "bad", true));
	globfree(&headers);
	clReleaseContext(context);
}

int main(void)
{
	device_begin();
	const struct CMUnitTest opencl_compile[] = {
		cmocka_unit_test(every_header_builds),
	};
	return cmocka_run_group_tests(opencl_compile, NULL, NULL);
}
