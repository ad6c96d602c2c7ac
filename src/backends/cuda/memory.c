/* Parts of buffers on the device: copies, made and fetched in the order of the kernels. */
#include <stdlib.h>
#include "backends/cuda/cu.h"

static ts_cu *of(ts_store *store) { return (ts_cu *)((u8 *)store - offsetof(ts_cu, store)); }

static ts_status done(const ts_cu *cu, const char *what, CUresult result)
{
	return result == CUDA_SUCCESS ? TS_OK : ts_cu_failed(cu, what, result);
}

static void *make(ts_store *store, void *data, u64 bytes)
{
	ts_cu *cu = of(store);
	(void)data;
	CUdeviceptr *part = ts_alloc_zero(1, sizeof *part, "device buffer");
	if (part == NULL) return NULL;
	CUresult result = ts_cu_enter(cu);
	if (result == CUDA_SUCCESS) result = cu->call->MemAlloc(part, bytes);
	if (done(cu, "device memory", result) == TS_OK) return part;
	free(part);
	return NULL;
}

static void release(ts_store *store, void *part)
{
	ts_cu *cu = of(store);
	if (ts_cu_enter(cu) == CUDA_SUCCESS) cu->call->MemFree(*(CUdeviceptr *)part);
	free(part);
}

static ts_status upload(ts_store *store, void *part, const void *data, u64 bytes)
{
	ts_cu *cu = of(store);
	CUresult result = ts_cu_enter(cu);
	if (result == CUDA_SUCCESS) result = cu->call->MemcpyHtoD(*(CUdeviceptr *)part, data, bytes);
	return done(cu, "a transfer to the device", result);
}

static ts_status download(ts_store *store, void *part, void *data, u64 bytes)
{
	ts_cu *cu = of(store);
	CUresult result = ts_cu_enter(cu);
	if (result == CUDA_SUCCESS) result = cu->call->MemcpyDtoH(data, *(CUdeviceptr *)part, bytes);
	return done(cu, "a transfer from the device", result);
}

static ts_status wait(ts_store *store)
{
	ts_cu *cu = of(store);
	CUresult result = ts_cu_enter(cu);
	return done(cu, "kernels", result == CUDA_SUCCESS ? cu->call->CtxSynchronize() : result);
}

void ts_cu_open_store(ts_cu *cu)
{
	cu->store = (ts_store){
		.about = &cu->about, .make = make, .free = release, .upload = upload, .download = download, .wait = wait};
}
