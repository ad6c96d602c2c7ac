/* The kernels' text, built by the driver, which keeps what it built in a cache of its own. The options are those of NUMERICS
 * section 2: no contraction (the text says so), correctly rounded quotients and roots, nothing unsafe. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cl.h"
#include "program.inc"

/* False if it says nothing. */
static bool show_log(const ts_cl *cl)
{
	size_t bytes = 0;
	clGetProgramBuildInfo(cl->program, cl->device, CL_PROGRAM_BUILD_LOG, 0, NULL, &bytes);
	char *log = calloc(bytes + 1, 1);
	if (log == NULL) return false;
	clGetProgramBuildInfo(cl->program, cl->device, CL_PROGRAM_BUILD_LOG, bytes, log, NULL);
	size_t length = strlen(log);
	while (length > 0 && strchr(" \n", log[length - 1]) != NULL) log[--length] = 0;
	if (length > 0) fprintf(stderr, "%s\n", log);
	free(log);
	return length > 0;
}

ts_status ts_cl_build(ts_cl *cl, const char *options)
{
	const char *text = source;
	const char *rounded = cl->about.rounded ? " -cl-fp32-correctly-rounded-divide-sqrt" : "";
	int length = snprintf(cl->flags, sizeof cl->flags, "-cl-std=CL1.2%s%s%s", rounded, options[0] != 0 ? " " : "", options);
	if (length < 0 || (size_t)length >= sizeof cl->flags) return ts_fail("--build: at most 150 characters of options");
	cl_int status;
	cl->program = clCreateProgramWithSource(cl->context, 1, &text, NULL, &status);
	if (status != CL_SUCCESS) return ts_cl_failed("the program", status);
	status = clBuildProgram(cl->program, 1, &cl->device, cl->flags, NULL, NULL);
	if (status == CL_SUCCESS) return TS_OK;
	return ts_cl_failed(show_log(cl) ? "building the kernels, whose log stands above" : "building the kernels", status);
}
