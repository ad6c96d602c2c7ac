/* Commands are recorded into one buffer, and each sees the writes of those before it; flushing runs them and waits. */
#include <string.h>
#include "backends/vulkan/vk.h"

ts_status ts_vk_record(ts_vk *vk)
{
	if (vk->recording) return TS_OK;
	const VkCommandBufferBeginInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
	                                       .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
	VkResult result = vk->call.BeginCommandBuffer(vk->commands, &info);
	vk->recording = result == VK_SUCCESS;
	return vk->recording ? TS_OK : ts_vk_failed("commands", result);
}

void ts_vk_next(ts_vk *vk)
{
	const VkMemoryBarrier barrier = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
	                                 .srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT,
	                                 .dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT};
	const VkPipelineStageFlags all = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, host = VK_PIPELINE_STAGE_HOST_BIT;
	vk->call.CmdPipelineBarrier(vk->commands, all, all | host, 0, 1, &barrier, 0, NULL, 0, NULL);
	vk->store.busy = true;
}

/* A driver may end loops silently: the kernels report that (compat.glsl). */
static ts_status whole(const ts_vk *vk)
{
	u32 kernel;
	memcpy(&kernel, vk->arguments.mapped, sizeof kernel);
	if (kernel >= TS_N_KERNELS) return TS_OK;
	return ts_fail_as(
		TS_KIND_DEVICE,
		"backend vulkan: %s: the driver ended a loop of %s early; llvmpipe's limit is 65,535 turns of all loops "
		"of 8 items: ask for fewer pixels, points or triangles",
		vk->about.name, ts_kernel_name((ts_kernel)kernel));
}

void ts_vk_empty_arguments(ts_vk *vk)
{
	memset(vk->arguments.mapped, 0xff, TS_VK_ALIGN);
	vk->n_arguments = TS_VK_ALIGN;
}

ts_status ts_vk_flush(ts_vk *vk)
{
	if (!vk->recording) return TS_OK;
	const VkSubmitInfo info = {
		.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &vk->commands};
	vk->recording = false;
	VkResult result = vk->call.EndCommandBuffer(vk->commands);
	if (result == VK_SUCCESS) result = vk->call.QueueSubmit(vk->queue, 1, &info, vk->fence);
	if (result == VK_SUCCESS) result = vk->call.WaitForFences(vk->device, 1, &vk->fence, VK_TRUE, UINT64_MAX);
	if (result == VK_SUCCESS) result = vk->call.ResetFences(vk->device, 1, &vk->fence);
	ts_status status = result == VK_SUCCESS ? whole(vk) : ts_vk_failed("kernels", result);
	ts_vk_empty_arguments(vk);
	return status;
}
