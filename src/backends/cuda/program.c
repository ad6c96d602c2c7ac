/* The kernels' PTX. The driver compiles each when it is first launched, and keeps a cache. */
#include <stdio.h>
#include <string.h>
#include "backends/cuda/cu.h"
#include "ptx.inc"

void ts_cu_open_modules(ts_cu *cu, const char *folder)
{
	cu->modules = (ts_modules){"cuda", "ptx", {packed, sizeof packed - 1, first_byte}, folder, NULL};
}

/* Prints the log of the driver's compiler on standard error. */
static CUresult compile(ts_cu *cu, ts_kernel kernel, const ts_module *module)
{
	char log[4096] = "";
	size_t room = sizeof log - 1;
	int options[] = {CU_JIT_ERROR_LOG_BUFFER, CU_JIT_ERROR_LOG_BUFFER_SIZE_BYTES};
	void *values[] = {log, (void *)room};
	CUresult result = ts_cu_enter(cu);
	if (result == CUDA_SUCCESS)
		result = cu->call->ModuleLoadDataEx(&cu->loaded[kernel], module->bytes, 2, options, values);
	for (char *line = strtok(log, "\n"); line != NULL; line = strtok(NULL, "\n")) ts_say("%s", line);
	if (result != CUDA_SUCCESS) cu->loaded[kernel] = NULL;
	return result;
}

ts_status ts_cu_make_kernel(ts_cu *cu, ts_kernel kernel)
{
	const char *name = ts_kernel_name(kernel);
	ts_module module;
	if (cu->functions[kernel] != NULL) return TS_OK;
	ts_status status = ts_modules_find(&cu->modules, kernel, &module);
	CUresult result = status == TS_OK ? compile(cu, kernel, &module) : CUDA_SUCCESS;
	ts_module_free(&module);
	if (status != TS_OK) return status;
	CUfunction *function = &cu->functions[kernel];
	if (result == CUDA_SUCCESS) result = cu->call->ModuleGetFunction(function, cu->loaded[kernel], name);
	if (result == CUDA_SUCCESS) return TS_OK;
	*function = NULL;
	return ts_cu_failed(cu, name, result);
}

void ts_cu_forget_kernels(ts_cu *cu)
{
	for (u32 i = 0; i < TS_N_KERNELS; i++) {
		if (cu->loaded[i] != NULL) cu->call->ModuleUnload(cu->loaded[i]);
		cu->loaded[i] = NULL;
		cu->functions[i] = NULL;
	}
}
