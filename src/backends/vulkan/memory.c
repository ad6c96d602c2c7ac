/* Blocks of memory, and the frame's buffers in them: written by the host where it sees the device's memory, otherwise
 * copied through a staging block that it sees. */
#include <stdlib.h>
#include <string.h>
#include "backends/vulkan/vk.h"

enum { STAGING = 8 << 20 };

static u32 memory_type(const ts_vk *vk, u32 among, VkMemoryPropertyFlags wanted)
{
	VkPhysicalDeviceMemoryProperties memory;
	vk->call.GetPhysicalDeviceMemoryProperties(vk->physical, &memory);
	for (u32 i = 0; i < memory.memoryTypeCount; i++) {
		if ((among >> i & 1) != 0 && (memory.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
	}
	return UINT32_MAX;
}

static VkResult make_buffer(ts_vk *vk, ts_vk_block *block)
{
	const VkBufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
	                                 .size = block->bytes,
	                                 .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
	                                          VK_BUFFER_USAGE_TRANSFER_DST_BIT |
	                                          VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT};
	return vk->call.CreateBuffer(vk->device, &info, NULL, &block->buffer);
}

static VkResult make_memory(ts_vk *vk, ts_vk_block *block, bool seen)
{
	const VkMemoryPropertyFlags host = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
	VkMemoryRequirements needs;
	vk->call.GetBufferMemoryRequirements(vk->device, block->buffer, &needs);
	u32 type = memory_type(vk, needs.memoryTypeBits, seen ? host : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
	if (type == UINT32_MAX) return VK_ERROR_FEATURE_NOT_PRESENT;
	const VkMemoryAllocateFlagsInfo flags = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO,
	                                         .flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT};
	const VkMemoryAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
	                                   .pNext = &flags,
	                                   .allocationSize = needs.size,
	                                   .memoryTypeIndex = type};
	VkResult result = vk->call.AllocateMemory(vk->device, &info, NULL, &block->memory);
	if (result == VK_SUCCESS) result = vk->call.BindBufferMemory(vk->device, block->buffer, block->memory, 0);
	void **at = (void **)&block->mapped;
	if (result == VK_SUCCESS && seen) result = vk->call.MapMemory(vk->device, block->memory, 0, VK_WHOLE_SIZE, 0, at);
	return result;
}

ts_status ts_vk_make_block(ts_vk *vk, ts_vk_block *block, u64 bytes, bool seen)
{
	*block = (ts_vk_block){.bytes = (bytes + 7) / 8 * 8};
	VkResult result = make_buffer(vk, block);
	if (result == VK_SUCCESS) result = make_memory(vk, block, seen);
	if (result != VK_SUCCESS) {
		ts_vk_free_block(vk, block);
		return ts_vk_failed("device memory", result);
	}
	const VkBufferDeviceAddressInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO,
	                                        .buffer = block->buffer};
	block->address = vk->call.GetBufferDeviceAddress(vk->device, &info);
	return TS_OK;
}

void ts_vk_free_block(ts_vk *vk, ts_vk_block *block)
{
	if (block->buffer != VK_NULL_HANDLE) vk->call.DestroyBuffer(vk->device, block->buffer, NULL);
	if (block->memory != VK_NULL_HANDLE) vk->call.FreeMemory(vk->device, block->memory, NULL);
	*block = (ts_vk_block){0};
}

static ts_vk *of(ts_store *store) { return (ts_vk *)((u8 *)store - offsetof(ts_vk, store)); }

static void *make(ts_store *store, void *data, u64 bytes)
{
	ts_vk *vk = of(store);
	(void)data;
	ts_vk_block *block = ts_alloc_zero(1, sizeof *block, "device buffer");
	if (block == NULL || ts_vk_make_block(vk, block, bytes, vk->sees) == TS_OK) return block;
	free(block);
	return NULL;
}

static void release(ts_store *store, void *part)
{
	ts_vk_free_block(of(store), part);
	free(part);
}

/* Copies one stretch of a block through the staging block; the caller copies the host's side. */
static ts_status copy(ts_vk *vk, const ts_vk_block *from, u64 from_offset, const ts_vk_block *to, u64 to_offset,
                      u64 bytes)
{
	const VkBufferCopy region = {from_offset, to_offset, bytes};
	if (ts_vk_record(vk) != TS_OK) return TS_ERROR;
	vk->call.CmdCopyBuffer(vk->commands, from->buffer, to->buffer, 1, &region);
	ts_vk_next(vk);
	return ts_vk_flush(vk);
}

static ts_status require_staging(ts_vk *vk)
{
	return vk->staging.mapped != NULL ? TS_OK : ts_vk_make_block(vk, &vk->staging, STAGING, true);
}

/* Recorded commands may still read the part. */
static ts_status upload(ts_store *store, void *part, const void *data, u64 bytes)
{
	ts_vk *vk = of(store);
	const ts_vk_block *block = part;
	if (ts_vk_flush(vk) != TS_OK) return TS_ERROR;
	if (block->mapped != NULL) {
		memcpy(block->mapped, data, bytes);
		return TS_OK;
	}
	ts_status status = require_staging(vk);
	for (u64 at = 0; at < bytes && status == TS_OK; at += STAGING) {
		u64 n = bytes - at < STAGING ? bytes - at : STAGING;
		memcpy(vk->staging.mapped, (const u8 *)data + at, n);
		status = copy(vk, &vk->staging, 0, block, at, n);
	}
	return status;
}

static ts_status download(ts_store *store, void *part, void *data, u64 bytes)
{
	ts_vk *vk = of(store);
	const ts_vk_block *block = part;
	if (ts_vk_flush(vk) != TS_OK) return TS_ERROR;
	if (block->mapped != NULL) {
		memcpy(data, block->mapped, bytes);
		return TS_OK;
	}
	ts_status status = require_staging(vk);
	for (u64 at = 0; at < bytes && status == TS_OK; at += STAGING) {
		u64 n = bytes - at < STAGING ? bytes - at : STAGING;
		status = copy(vk, block, at, &vk->staging, 0, n);
		if (status == TS_OK) memcpy((u8 *)data + at, vk->staging.mapped, n);
	}
	return status;
}

static ts_status wait(ts_store *store) { return ts_vk_flush(of(store)); }

void ts_vk_open_store(ts_vk *vk)
{
	vk->store = (ts_store){
		.about = &vk->about, .make = make, .free = release, .upload = upload, .download = download, .wait = wait};
}
