/* The kernels' SPIR-V, and the pipelines that the driver makes from it, each when first launched. */
#include "backends/vulkan/vk.h"
#include "spirv.inc"

enum { SPIRV_MAGIC = 0x07230203 };

void ts_vk_open_modules(ts_vk *vk, const char *folder)
{
	vk->modules = (ts_modules){"vulkan", "spv", {packed, sizeof packed - 1, first_byte}, folder, NULL};
}

static ts_status find_module(ts_vk *vk, ts_kernel kernel, ts_module *module)
{
	if (ts_modules_find(&vk->modules, kernel, module) != TS_OK) return TS_ERROR;
	const u32 *words = (const u32 *)module->bytes;
	if (module->n_bytes >= 20 && module->n_bytes % 4 == 0 && words[0] == SPIRV_MAGIC) return TS_OK;
	return ts_modules_refuse(&vk->modules, kernel, "not a SPIR-V module of this machine's byte order");
}

static ts_status make_module(ts_vk *vk, ts_kernel kernel, VkShaderModule *made)
{
	ts_module module;
	ts_status status = find_module(vk, kernel, &module);
	const VkShaderModuleCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
	                                       .codeSize = module.n_bytes,
	                                       .pCode = (const u32 *)module.bytes};
	VkResult result = status == TS_OK ? vk->call.CreateShaderModule(vk->device, &info, NULL, made) : VK_SUCCESS;
	ts_module_free(&module);
	return result == VK_SUCCESS ? status : ts_vk_failed(ts_kernel_name(kernel), result);
}

static u32 logarithm(u64 power)
{
	u32 n = 0;
	while (power >> n > 1) n++;
	return n;
}

ts_status ts_vk_make_pipeline(ts_vk *vk, ts_kernel kernel)
{
	VkShaderModule shader;
	if (vk->pipelines[kernel] != VK_NULL_HANDLE) return TS_OK;
	if (make_module(vk, kernel, &shader) != TS_OK) return TS_ERROR;
	const u32 constants[3] = {vk->work_group, logarithm(vk->part_bytes), vk->by_integers};
	const VkSpecializationMapEntry entries[3] = {{0, 0, 4}, {1, 4, 4}, {2, 8, 4}};
	const VkSpecializationInfo known = {3, entries, sizeof constants, constants};
	const VkComputePipelineCreateInfo info = {
		.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
		.stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
	              .stage = VK_SHADER_STAGE_COMPUTE_BIT,
	              .module = shader,
	              .pName = "main",
	              .pSpecializationInfo = &known},
		.layout = vk->layout,
	};
	VkPipeline *pipeline = &vk->pipelines[kernel];
	VkResult result = vk->call.CreateComputePipelines(vk->device, VK_NULL_HANDLE, 1, &info, NULL, pipeline);
	vk->call.DestroyShaderModule(vk->device, shader, NULL);
	if (result != VK_SUCCESS) *pipeline = VK_NULL_HANDLE;
	return result == VK_SUCCESS ? TS_OK : ts_vk_failed(ts_kernel_name(kernel), result);
}

void ts_vk_forget_pipelines(ts_vk *vk)
{
	for (u32 i = 0; i < TS_N_KERNELS; i++) {
		if (vk->pipelines[i] != VK_NULL_HANDLE) vk->call.DestroyPipeline(vk->device, vk->pipelines[i], NULL);
		vk->pipelines[i] = VK_NULL_HANDLE;
	}
}
