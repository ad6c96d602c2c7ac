/* The kernels' text: a program for each paragraph of kernels.def, built by the driver when the first of its kernels is
 * launched; the driver caches it. The options are those of CONTRACT section 1: no contraction (the text says so),
 * correctly rounded quotients and roots, nothing unsafe. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "backends/opencl/cl.h"
#include "program.inc"

/* False if the log is empty. */
static bool show_log(const ts_cl *cl, cl_program program)
{
	size_t bytes = 0;
	ts_cl_call.GetProgramBuildInfo(program, cl->device, CL_PROGRAM_BUILD_LOG, 0, NULL, &bytes);
	char *log = calloc(bytes + 1, 1);
	if (log == NULL) return false;
	ts_cl_call.GetProgramBuildInfo(program, cl->device, CL_PROGRAM_BUILD_LOG, bytes, log, NULL);
	size_t length = strlen(log);
	while (length > 0 && strchr(" \n", log[length - 1]) != NULL) log[--length] = 0;
	for (char *line = log, *end; *line != 0; line = end) {
		end = line + strcspn(line, "\n");
		if (*end != 0) *end++ = 0;
		ts_say("%s", line);
	}
	free(log);
	return length > 0;
}

ts_status ts_cl_put_flags(ts_cl *cl)
{
	char parts[64] = "";
	const char *rounded = cl->about.rounded ? " -cl-fp32-correctly-rounded-divide-sqrt" : "";
	const char *space = cl->options[0] != 0 ? " " : "";
	if (cl->part_bytes != 0) {
		snprintf(parts, sizeof parts, " -DTS_PARTS=%d -DTS_PART_BYTES=%" PRIu64, TS_PARTS, cl->part_bytes);
	}
	int length = snprintf(cl->flags, sizeof cl->flags, "-cl-std=CL1.2%s%s%s%s", rounded, parts, space, cl->options);
	return length >= 0 && (size_t)length < sizeof cl->flags ? TS_OK
	                                                        : ts_fail("build: at most 128 characters are taken");
}

void ts_cl_forget_programs(ts_cl *cl)
{
	for (u32 i = 0; i < TS_N_KERNELS; i++) {
		if (cl->kernels[i] != NULL) ts_cl_call.ReleaseKernel(cl->kernels[i]);
		cl->kernels[i] = NULL;
	}
	for (u32 i = 0; i < TS_CL_PROGRAMS; i++) {
		if (cl->programs[i] != NULL) ts_cl_call.ReleaseProgram(cl->programs[i]);
		cl->programs[i] = NULL;
	}
}

static ts_status build(ts_cl *cl, u32 index)
{
	char *entries = ts_cl_entries(cl, index);
	const char *text[] = {source, entries};
	char flags[sizeof cl->flags + 32];
	cl_int status;
	snprintf(flags, sizeof flags, "%s -DTS_PROGRAM=%u", cl->flags, index);
	if (entries == NULL) return ts_fail_as(TS_KIND_MEMORY, "out of memory for the text of kernels");
	cl_program program = ts_cl_call.CreateProgramWithSource(cl->context, 2, text, NULL, &status);
	free(entries);
	if (status != CL_SUCCESS) return ts_cl_failed("a program", status);
	cl->programs[index] = program;
	status = ts_cl_call.BuildProgram(program, 1, &cl->device, flags, NULL, NULL);
	if (status == CL_SUCCESS) return TS_OK;
	bool shown = show_log(cl, program);
	return ts_cl_failed(shown ? "building the kernels, whose log stands above" : "building the kernels", status);
}

ts_status ts_cl_make_kernel(ts_cl *cl, ts_kernel kernel)
{
	u32 program = ts_cl_program_of[kernel];
	const char *name = ts_kernel_name(kernel);
	cl_int status;
	if (cl->kernels[kernel] != NULL) return TS_OK;
	if (cl->programs[program] == NULL && build(cl, program) != TS_OK) return TS_ERROR;
	cl->kernels[kernel] = ts_cl_call.CreateKernel(cl->programs[program], name, &status);
	return status == CL_SUCCESS ? TS_OK : ts_cl_failed(name, status);
}
