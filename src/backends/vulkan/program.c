/* The kernels' SPIR-V, packed into the library or in a folder of the user's, and the pipelines that the driver makes
 * of it, each as it is first launched. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>
#include "vk.h"
#include "spirv.inc"

enum { SPIRV_MAGIC = 0x07230203, MOST_OF_FILE = 16 << 20 };

/* The words of one kernel. */
typedef struct {
	const u32 *words;
	size_t bytes;
	u32 *read; /* to be freed */
} module;

/* All kernels one after the other, once. */
static ts_status unpack(ts_vk *vk)
{
	if (vk->spirv != NULL) return TS_OK;
	uLongf bytes = SPIRV_BYTES;
	u32 *words = ts_alloc(SPIRV_BYTES, 1, "the kernels' SPIR-V");
	if (words == NULL) return TS_ERROR;
	if (uncompress((Bytef *)words, &bytes, (const Bytef *)packed, PACKED_BYTES) != Z_OK || bytes != SPIRV_BYTES) {
		free(words);
		return ts_fail("backend vulkan: no memory to unpack the kernels");
	}
	vk->spirv = words;
	return TS_OK;
}

static ts_status refuse(const char *path, const char *reason)
{
	return ts_fail("--build: %s: %s; one NAME.spv for each kernel is wanted", path, reason);
}

static ts_status read_open(FILE *file, const char *path, module *m)
{
	u32 *words = ts_alloc(MOST_OF_FILE, 1, path);
	if (words == NULL) return TS_ERROR;
	m->words = m->read = words;
	m->bytes = fread(words, 1, MOST_OF_FILE, file);
	if (ferror(file)) return refuse(path, strerror(errno));
	if (m->bytes < 20 || m->bytes % 4 != 0 || m->bytes == MOST_OF_FILE || words[0] != SPIRV_MAGIC)
		return refuse(path, "not a SPIR-V module of this machine's byte order, of less than 16 MiB");
	return TS_OK;
}

static ts_status read_module(const char *folder, ts_kernel kernel, module *m)
{
	char path[1024];
	int length = snprintf(path, sizeof path, "%s/%s.spv", folder, ts_kernel_name(kernel));
	if (length < 0 || (size_t)length >= sizeof path) return ts_fail("--build: at most 900 characters are taken");
	FILE *file = fopen(path, "rb");
	if (file == NULL) return refuse(path, strerror(errno));
	ts_status status = read_open(file, path, m);
	fclose(file);
	return status;
}

static ts_status find_module(ts_vk *vk, ts_kernel kernel, module *m)
{
	if (vk->folder[0] != 0) return read_module(vk->folder, kernel, m);
	if (unpack(vk) != TS_OK) return TS_ERROR;
	m->words = vk->spirv + first_word[kernel];
	m->bytes = (first_word[kernel + 1] - first_word[kernel]) * sizeof *m->words;
	return TS_OK;
}

static ts_status make_module(ts_vk *vk, ts_kernel kernel, VkShaderModule *made)
{
	module m = {.read = NULL};
	ts_status status = find_module(vk, kernel, &m);
	const VkShaderModuleCreateInfo info = {
		.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = m.bytes, .pCode = m.words};
	VkResult result = status == TS_OK ? vk->call.CreateShaderModule(vk->device, &info, NULL, made) : VK_SUCCESS;
	free(m.read);
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
	const u32 constants[2] = {vk->work_group, logarithm(vk->part_bytes)};
	const VkSpecializationMapEntry entries[2] = {{0, 0, 4}, {1, 4, 4}};
	const VkSpecializationInfo known = {2, entries, sizeof constants, constants};
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
