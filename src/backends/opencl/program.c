/* The kernels' text, built by the driver, which keeps what it built in a cache of its own. The options are those of
 * CONTRACT section 1: no contraction (the text says so), correctly rounded quotients and roots, nothing unsafe. */
#include <inttypes.h>
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

static ts_status put_flags(ts_cl *cl)
{
	char parts[64] = "";
	const char *rounded = cl->about.rounded ? " -cl-fp32-correctly-rounded-divide-sqrt" : "";
	const char *space = cl->options[0] != 0 ? " " : "";
	if (cl->part_bytes != 0) {
		snprintf(parts, sizeof parts, " -DTS_PARTS=%d -DTS_PART_BYTES=%" PRIu64, TS_CL_PARTS, cl->part_bytes);
	}
	int length = snprintf(cl->flags, sizeof cl->flags, "-cl-std=CL1.2%s%s%s%s", rounded, parts, space, cl->options);
	return length >= 0 && (size_t)length < sizeof cl->flags ? TS_OK : ts_fail("--build: at most 128 characters are taken");
}

void ts_cl_forget_program(ts_cl *cl)
{
	for (u32 i = 0; i < TS_N_KERNELS; i++) {
		if (cl->kernels[i] != NULL) clReleaseKernel(cl->kernels[i]);
		cl->kernels[i] = NULL;
	}
	if (cl->program != NULL) clReleaseProgram(cl->program);
	cl->program = NULL;
}

ts_status ts_cl_build(ts_cl *cl)
{
	const char *text = source;
	ts_cl_forget_program(cl);
	if (put_flags(cl) != TS_OK) return TS_ERROR;
	cl_int status;
	cl->program = clCreateProgramWithSource(cl->context, 1, &text, NULL, &status);
	if (status != CL_SUCCESS) return ts_cl_failed("the program", status);
	status = clBuildProgram(cl->program, 1, &cl->device, cl->flags, NULL, NULL);
	if (status == CL_SUCCESS) return TS_OK;
	return ts_cl_failed(show_log(cl) ? "building the kernels, whose log stands above" : "building the kernels", status);
}
