/* The kernels' text, built by the driver, which keeps what it built in a cache of its own. The options are those of NUMERICS
 * section 2: no contraction (the text says so), correctly rounded quotients and roots, nothing unsafe. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cl.h"
#include "program.inc"

static void show_log(const ts_cl *cl)
{
	size_t bytes = 0;
	clGetProgramBuildInfo(cl->program, cl->device, CL_PROGRAM_BUILD_LOG, 0, NULL, &bytes);
	char *log = calloc(bytes + 1, 1);
	if (log == NULL) return;
	clGetProgramBuildInfo(cl->program, cl->device, CL_PROGRAM_BUILD_LOG, bytes, log, NULL);
	fprintf(stderr, "%s\n", log);
	free(log);
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
	show_log(cl);
	return ts_cl_failed("building the kernels, whose log stands above,", status);
}
