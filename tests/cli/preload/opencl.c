/* A library to be preloaded before the OpenCL loader. Of the calls that the backend makes, the one whose number, from
 * 1, is in TOUCHSTONE_CL_FAIL_AT fails with the error in TOUCHSTONE_CL_ERROR; with TOUCHSTONE_CL_LOST so do all after
 * it. The names of all calls go, a line each, to the file TOUCHSTONE_CL_CALLS. TOUCHSTONE_CL_COPIES: no device has the
 * host's memory. TOUCHSTONE_CL_REVERSE: work groups run one by one, from the last to the first. */
#define _GNU_SOURCE
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <dlfcn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_CALLS = 1 << 20 };
static const char *calls[MOST_CALLS];
static long count;

static void write_calls(void)
{
	FILE *file = fopen(getenv("TOUCHSTONE_CL_CALLS"), "w");
	for (long i = 0; file != NULL && i < count && i < MOST_CALLS; i++) fprintf(file, "%s\n", calls[i]);
	if (file != NULL) fclose(file);
}

static cl_int number(const char *variable)
{
	const char *text = getenv(variable);
	return text != NULL ? (cl_int)atol(text) : 0;
}

static bool fails(const char *name)
{
	if (count == 0 && getenv("TOUCHSTONE_CL_CALLS") != NULL) atexit(write_calls);
	if (count < MOST_CALLS) calls[count] = name;
	count++;
	long at = number("TOUCHSTONE_CL_FAIL_AT");
	return count == at || (at > 0 && count > at && getenv("TOUCHSTONE_CL_LOST") != NULL);
}

#define ERROR number("TOUCHSTONE_CL_ERROR")
#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

/* A call that returns its status, and one that returns what it made and its status in *e. */
#define STATUS(name, parameters, arguments) \
	cl_int CL_API_CALL name parameters { return fails(#name) ? ERROR : NEXT(name) arguments; }
#define MAKES(type, name, parameters, arguments) \
	type CL_API_CALL name parameters \
	{ \
		if (!fails(#name)) return NEXT(name) arguments; \
		if (e != NULL) *e = ERROR; \
		return NULL; \
	}

STATUS(clGetPlatformIDs, (cl_uint n, cl_platform_id *p, cl_uint *m), (n, p, m))
STATUS(clGetPlatformInfo, (cl_platform_id p, cl_platform_info i, size_t n, void *v, size_t *m), (p, i, n, v, m))
STATUS(clGetDeviceIDs, (cl_platform_id p, cl_device_type t, cl_uint n, cl_device_id *d, cl_uint *m), (p, t, n, d, m))
STATUS(clGetProgramBuildInfo, (cl_program p, cl_device_id d, cl_program_build_info i, size_t n, void *v, size_t *m),
       (p, d, i, n, v, m))
STATUS(clBuildProgram,
       (cl_program p, cl_uint n, const cl_device_id *d, const char *o, void(CL_CALLBACK *f)(cl_program, void *),
        void *u),
       (p, n, d, o, f, u))
STATUS(clSetKernelArg, (cl_kernel k, cl_uint i, size_t n, const void *v), (k, i, n, v))
STATUS(clEnqueueFillBuffer,
       (cl_command_queue q, cl_mem b, const void *p, size_t w, size_t o, size_t s, cl_uint n, const cl_event *l,
        cl_event *v),
       (q, b, p, w, o, s, n, l, v))
STATUS(clEnqueueWriteBuffer,
       (cl_command_queue q, cl_mem b, cl_bool w, size_t o, size_t s, const void *p, cl_uint n, const cl_event *l,
        cl_event *v),
       (q, b, w, o, s, p, n, l, v))
STATUS(clEnqueueReadBuffer,
       (cl_command_queue q, cl_mem b, cl_bool w, size_t o, size_t s, void *p, cl_uint n, const cl_event *l,
        cl_event *v),
       (q, b, w, o, s, p, n, l, v))
STATUS(clEnqueueUnmapMemObject, (cl_command_queue q, cl_mem b, void *p, cl_uint n, const cl_event *l, cl_event *v),
       (q, b, p, n, l, v))

/* The host frees its memory after a wait that failed: nothing may still work on it. */
cl_int CL_API_CALL clFinish(cl_command_queue queue)
{
	cl_int finished = NEXT(clFinish)(queue);
	return fails("clFinish") ? ERROR : finished;
}

STATUS(clReleaseKernel, (cl_kernel k), (k))
STATUS(clReleaseProgram, (cl_program p), (p))
STATUS(clReleaseMemObject, (cl_mem b), (b))
STATUS(clReleaseCommandQueue, (cl_command_queue q), (q))
STATUS(clReleaseContext, (cl_context c), (c))
MAKES(cl_context, clCreateContext,
      (const cl_context_properties *p, cl_uint n, const cl_device_id *d,
       void(CL_CALLBACK *f)(const char *, const void *, size_t, void *), void *u, cl_int *e),
      (p, n, d, f, u, e))
MAKES(cl_command_queue, clCreateCommandQueue, (cl_context c, cl_device_id d, cl_command_queue_properties p, cl_int *e),
      (c, d, p, e))
MAKES(cl_program, clCreateProgramWithSource, (cl_context c, cl_uint n, const char **t, const size_t *s, cl_int *e),
      (c, n, t, s, e))
MAKES(cl_kernel, clCreateKernel, (cl_program p, const char *t, cl_int *e), (p, t, e))
MAKES(cl_mem, clCreateBuffer, (cl_context c, cl_mem_flags f, size_t n, void *p, cl_int *e), (c, f, n, p, e))
MAKES(void *, clEnqueueMapBuffer,
      (cl_command_queue q, cl_mem b, cl_bool w, cl_map_flags f, size_t o, size_t s, cl_uint n, const cl_event *l,
       cl_event *v, cl_int *e),
      (q, b, w, f, o, s, n, l, v, e))

cl_int CL_API_CALL clGetDeviceInfo(cl_device_id d, cl_device_info i, size_t n, void *v, size_t *m)
{
	if (fails("clGetDeviceInfo")) return ERROR;
	cl_int status = NEXT(clGetDeviceInfo)(d, i, n, v, m);
	bool own = i == CL_DEVICE_HOST_UNIFIED_MEMORY && getenv("TOUCHSTONE_CL_COPIES") != NULL;
	if (own && v != NULL) *(cl_bool *)v = CL_FALSE;
	return status;
}

cl_int CL_API_CALL clEnqueueNDRangeKernel(cl_command_queue q, cl_kernel k, cl_uint dims, const size_t *first,
                                          const size_t *items, const size_t *group, cl_uint n, const cl_event *l,
                                          cl_event *v)
{
	if (fails("clEnqueueNDRangeKernel")) return ERROR;
	if (getenv("TOUCHSTONE_CL_REVERSE") == NULL || group == NULL)
		return NEXT(clEnqueueNDRangeKernel)(q, k, dims, first, items, group, n, l, v);
	cl_int status = CL_SUCCESS;
	for (size_t left = items[0]; left > 0 && status == CL_SUCCESS; left -= group[0]) {
		size_t at = left - group[0];
		status = NEXT(clEnqueueNDRangeKernel)(q, k, 1, &at, group, group, 0, NULL, NULL);
	}
	return status;
}
