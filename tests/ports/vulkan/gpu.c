#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <vulkan/vulkan.h>
#include "gpu.h"

enum { GROUP = 64, ROW = 256, MOST_BLOCKS = 64 }; /* items of a group, groups of a row */
static VkInstance instance;
static VkPhysicalDevice physical;
static VkPhysicalDeviceProperties properties;
static VkDevice device;
static VkQueue queue;
static uint32_t family;
static VkCommandPool pool;
static struct {
	VkBuffer buffer;
	VkDeviceMemory memory;
} blocks[MOST_BLOCKS];
static int n_blocks;

void gpu_fail(const char *format, ...)
{
	va_list list;
	va_start(list, format);
	fputs("port: ", stderr);
	vfprintf(stderr, format, list);
	fputc('\n', stderr);
	va_end(list);
	exit(2);
}

static void check(VkResult result, const char *call)
{
	if (result != VK_SUCCESS) gpu_fail("%s: VkResult %d", call, (int)result);
}
#define CHECK(call, ...) check(call(__VA_ARGS__), #call)

void *gpu_read(const char *path, size_t *bytes)
{
	FILE *file = fopen(path, "rb");
	if (file == NULL) gpu_fail("%s: cannot be opened", path);
	fseek(file, 0, SEEK_END);
	*bytes = (size_t)ftell(file);
	rewind(file);
	void *data = malloc(*bytes + 1);
	if (data == NULL || fread(data, 1, *bytes, file) != *bytes) gpu_fail("%s: cannot be read", path);
	fclose(file);
	return data;
}

/* What the kernels' GLSL asks for (DEVICES.md): addresses, C's layout, and integers of 8 and 64 bits. */
static VkPhysicalDeviceVulkan12Features wanted = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES,
                                                  .storageBuffer8BitAccess = VK_TRUE,
                                                  .shaderInt8 = VK_TRUE,
                                                  .shaderBufferInt64Atomics = VK_TRUE,
                                                  .scalarBlockLayout = VK_TRUE,
                                                  .bufferDeviceAddress = VK_TRUE,
                                                  .vulkanMemoryModel = VK_TRUE,
                                                  .vulkanMemoryModelDeviceScope = VK_TRUE};

static bool suffices(VkPhysicalDevice candidate)
{
	VkPhysicalDeviceVulkan12Features has = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
	VkPhysicalDeviceFeatures2 features = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, .pNext = &has};
	vkGetPhysicalDeviceProperties(candidate, &properties);
	if (properties.apiVersion < VK_API_VERSION_1_2) return false;
	vkGetPhysicalDeviceFeatures2(candidate, &features);
	return features.features.shaderInt64 && has.storageBuffer8BitAccess && has.shaderInt8 &&
	       has.shaderBufferInt64Atomics && has.scalarBlockLayout && has.bufferDeviceAddress && has.vulkanMemoryModel &&
	       has.vulkanMemoryModelDeviceScope;
}

static bool find_device(void)
{
	VkPhysicalDevice all[16];
	uint32_t n = 16;
	if (vkEnumeratePhysicalDevices(instance, &n, all) < 0) return false;
	for (uint32_t i = 0; i < n; i++) {
		physical = all[i];
		if (suffices(physical)) return true;
	}
	return false;
}

static void find_family(void)
{
	VkQueueFamilyProperties all[16];
	uint32_t n = 16;
	vkGetPhysicalDeviceQueueFamilyProperties(physical, &n, all);
	for (family = 0; family < n; family++)
		if (all[family].queueFlags & VK_QUEUE_COMPUTE_BIT) return;
	gpu_fail("%s: no queue for compute", properties.deviceName);
}

const char *gpu_open(void)
{
	const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
	                                       .apiVersion = VK_API_VERSION_1_2};
	const VkInstanceCreateInfo of_instance = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
	                                          .pApplicationInfo = &application};
	if (vkCreateInstance(&of_instance, NULL, &instance) != VK_SUCCESS || !find_device()) return NULL;
	find_family();
	const float priority = 1;
	const VkDeviceQueueCreateInfo of_queue = {.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
	                                          .queueFamilyIndex = family,
	                                          .queueCount = 1,
	                                          .pQueuePriorities = &priority};
	const VkPhysicalDeviceFeatures2 features = {
		.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, .pNext = &wanted, .features.shaderInt64 = VK_TRUE};
	const VkDeviceCreateInfo of_device = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
	                                      .pNext = &features,
	                                      .queueCreateInfoCount = 1,
	                                      .pQueueCreateInfos = &of_queue};
	CHECK(vkCreateDevice, physical, &of_device, NULL, &device);
	vkGetDeviceQueue(device, family, 0, &queue);
	const VkCommandPoolCreateInfo of_pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
	                                         .queueFamilyIndex = family};
	CHECK(vkCreateCommandPool, device, &of_pool, NULL, &pool);
	return properties.deviceName;
}

void gpu_close(void)
{
	for (; n_blocks > 0; n_blocks--) {
		vkDestroyBuffer(device, blocks[n_blocks - 1].buffer, NULL);
		vkFreeMemory(device, blocks[n_blocks - 1].memory, NULL);
	}
	vkDestroyCommandPool(device, pool, NULL);
	vkDestroyDevice(device, NULL);
	vkDestroyInstance(instance, NULL);
}

static uint32_t host_visible(uint32_t types)
{
	VkPhysicalDeviceMemoryProperties all;
	const VkMemoryPropertyFlags flags = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
	vkGetPhysicalDeviceMemoryProperties(physical, &all);
	for (uint32_t i = 0; i < all.memoryTypeCount; i++)
		if ((types >> i & 1) && (all.memoryTypes[i].propertyFlags & flags) == flags) return i;
	gpu_fail("%s: no memory that the host sees", properties.deviceName);
}

gpu_memory gpu_allocate(size_t bytes)
{
	if (n_blocks == MOST_BLOCKS) gpu_fail("more than %d allocations", MOST_BLOCKS);
	const VkBufferCreateInfo of_buffer = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
	                                      .size = bytes > 0 ? bytes : 1,
	                                      .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
	                                               VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT};
	VkBuffer buffer;
	CHECK(vkCreateBuffer, device, &of_buffer, NULL, &buffer);
	VkMemoryRequirements needs;
	vkGetBufferMemoryRequirements(device, buffer, &needs);
	const VkMemoryAllocateFlagsInfo by_address = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO,
	                                              .flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT};
	const VkMemoryAllocateInfo of_memory = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
	                                        .pNext = &by_address,
	                                        .allocationSize = needs.size,
	                                        .memoryTypeIndex = host_visible(needs.memoryTypeBits)};
	VkDeviceMemory memory;
	CHECK(vkAllocateMemory, device, &of_memory, NULL, &memory);
	CHECK(vkBindBufferMemory, device, buffer, memory, 0);
	const VkBufferDeviceAddressInfo which = {.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO, .buffer = buffer};
	gpu_memory made = {.address = vkGetBufferDeviceAddress(device, &which)};
	CHECK(vkMapMemory, device, memory, 0, VK_WHOLE_SIZE, 0, &made.data);
	blocks[n_blocks].buffer = buffer;
	blocks[n_blocks++].memory = memory;
	return made;
}

static VkPipeline make_pipeline(const char *path, VkPipelineLayout layout)
{
	VkShaderModuleCreateInfo of_module = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
	uint32_t *code = gpu_read(path, &of_module.codeSize);
	of_module.pCode = code;
	VkShaderModule module;
	CHECK(vkCreateShaderModule, device, &of_module, NULL, &module);
	free(code);
	const VkPipelineShaderStageCreateInfo stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
	                                               .stage = VK_SHADER_STAGE_COMPUTE_BIT,
	                                               .module = module,
	                                               .pName = "main"};
	const VkComputePipelineCreateInfo of_pipeline = {
		.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO, .stage = stage, .layout = layout};
	VkPipeline pipeline;
	CHECK(vkCreateComputePipelines, device, VK_NULL_HANDLE, 1, &of_pipeline, NULL, &pipeline);
	vkDestroyShaderModule(device, module, NULL);
	return pipeline;
}

static void submit(VkCommandBuffer commands)
{
	const VkSubmitInfo work = {
		.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
	CHECK(vkEndCommandBuffer, commands);
	CHECK(vkQueueSubmit, queue, 1, &work, VK_NULL_HANDLE);
	CHECK(vkQueueWaitIdle, queue);
	vkFreeCommandBuffers(device, pool, 1, &commands);
}

void gpu_run(const char *path, uint64_t n_items, const void *constants, uint32_t bytes)
{
	const VkPushConstantRange range = {.stageFlags = VK_SHADER_STAGE_COMPUTE_BIT, .size = bytes};
	const VkPipelineLayoutCreateInfo of_layout = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
	                                              .pushConstantRangeCount = 1,
	                                              .pPushConstantRanges = &range};
	VkPipelineLayout layout;
	CHECK(vkCreatePipelineLayout, device, &of_layout, NULL, &layout);
	VkPipeline pipeline = make_pipeline(path, layout);
	const VkCommandBufferAllocateInfo of_commands = {
		.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, .commandPool = pool, .commandBufferCount = 1};
	VkCommandBuffer commands;
	CHECK(vkAllocateCommandBuffers, device, &of_commands, &commands);
	const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
	const VkMemoryBarrier written = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
	                                 .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT,
	                                 .dstAccessMask = VK_ACCESS_HOST_READ_BIT | VK_ACCESS_SHADER_READ_BIT};
	CHECK(vkBeginCommandBuffer, commands, &begin);
	vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
	vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, bytes, constants);
	vkCmdDispatch(commands, ROW, (uint32_t)((n_items + GROUP * ROW - 1) / (GROUP * ROW)), 1);
	vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
	                     VK_PIPELINE_STAGE_HOST_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 1, &written, 0, NULL, 0,
	                     NULL);
	submit(commands);
	vkDestroyPipeline(device, pipeline, NULL);
	vkDestroyPipelineLayout(device, layout, NULL);
}
