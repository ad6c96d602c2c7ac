/* Kernels on a device. Their arguments, whose pointers become addresses, have a block of their own. */
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "backends/vulkan/vk.h"

ts_status ts_vk_failed(const char *what, VkResult result)
{
	static const struct {
		VkResult result;
		const char *name;
	} names[] = {
		{VK_ERROR_OUT_OF_HOST_MEMORY, "no memory on the host"},
		{VK_ERROR_OUT_OF_DEVICE_MEMORY, "no memory on the device"},
		{VK_ERROR_DEVICE_LOST, "the device was lost"},
		{VK_ERROR_INITIALIZATION_FAILED, "the driver does not start"},
		{VK_ERROR_FEATURE_NOT_PRESENT, "the device does not have this"},
		{VK_ERROR_TOO_MANY_OBJECTS, "more than the device allocates"},
	};
	const char *name = NULL;
	for (size_t i = 0; i < sizeof names / sizeof *names; i++) name = names[i].result == result ? names[i].name : name;
	return name == NULL ? ts_fail_as(TS_KIND_DEVICE, "backend vulkan: %s: Vulkan error %d", what, result)
	                    : ts_fail_as(TS_KIND_DEVICE, "backend vulkan: %s: %s (%d)", what, name, result);
}

/* What a launch hands to a kernel: its arguments, and the addresses of the parts of its buffers. */
typedef struct {
	u8 args[TS_ARGUMENTS];
	u64 parts[TS_POINTERS][TS_PARTS];
	u32 n_parted;
	u32 parted_at[TS_POINTERS]; /* offset in args of the address of parts[i] */
} arguments;

static ts_status set_pointer(ts_vk *vk, ts_frame *frame, const ts_launch *launch, const ts_pointer *pointer,
                             arguments *a)
{
	void *parts[TS_PARTS] = {NULL};
	u64 offset, address = 0, part_bytes = pointer->row->parted ? vk->part_bytes : 0;
	ts_buffer *buffer = ts_device_buffer(frame, launch, pointer, a->args, &offset);
	ts_access access = ts_device_access(launch, pointer);
	if (buffer != NULL && ts_store_use(&vk->store, parts, buffer, part_bytes, access) != TS_OK) return TS_ERROR;
	if (parts[0] != NULL && part_bytes != 0) {
		for (u32 i = 0; i < TS_PARTS && parts[i] != NULL; i++) {
			a->parts[a->n_parted][i] = ((ts_vk_block *)parts[i])->address;
		}
		a->parted_at[a->n_parted++] = (u32)pointer->offset;
	} else if (parts[0] != NULL) {
		address = ((ts_vk_block *)parts[0])->address + offset;
	}
	memcpy(a->args + pointer->offset, &address, sizeof address);
	return TS_OK;
}

static ts_status set_pointers(ts_vk *vk, ts_frame *frame, const ts_launch *launch, const void *args, arguments *a)
{
	const ts_pointers *pointers = ts_kernel_pointers(launch->kernel);
	size_t bytes = ts_kernel_args(launch->kernel)->bytes;
	assert(bytes <= sizeof a->args);
	memcpy(a->args, args, bytes);
	a->n_parted = 0;
	memset(a->parts, 0, sizeof a->parts);
	for (u32 i = 0; i < pointers->n; i++) {
		if (set_pointer(vk, frame, launch, &pointers->pointer[i], a) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static u64 aligned(u64 bytes) { return (bytes + TS_VK_ALIGN - 1) / TS_VK_ALIGN * TS_VK_ALIGN; }

/* Writes the arguments behind those of recorded launches, and returns where. */
static ts_status place(ts_vk *vk, const ts_launch *launch, arguments *a, u64 *address)
{
	u64 bytes = ts_kernel_args(launch->kernel)->bytes, parts = a->n_parted * sizeof *a->parts;
	u64 begin = aligned(bytes), whole = begin + aligned(parts);
	if (vk->n_arguments + whole > TS_VK_ARGUMENTS && ts_vk_flush(vk) != TS_OK) return TS_ERROR;
	*address = vk->arguments.address + vk->n_arguments;
	for (u32 i = 0; i < a->n_parted; i++) {
		u64 at = *address + begin + i * sizeof *a->parts;
		memcpy(a->args + a->parted_at[i], &at, sizeof at);
	}
	u8 *to = vk->arguments.mapped + vk->n_arguments;
	memcpy(to, a->args, bytes);
	memcpy(to + begin, a->parts, parts);
	vk->n_arguments += whole;
	return TS_OK;
}

/* Records items [0, n), as many at once as there may be groups. */
static void dispatch(ts_vk *vk, ts_kernel kernel, u64 address, u64 n)
{
	const VkShaderStageFlags compute = VK_SHADER_STAGE_COMPUTE_BIT;
	u64 most = (u64)vk->most.groups * vk->work_group;
	vk->call.CmdBindPipeline(vk->commands, VK_PIPELINE_BIND_POINT_COMPUTE, vk->pipelines[kernel]);
	for (u64 first = 0; first < n; first += most) {
		const u64 launch[5] = {address, first, n, vk->arguments.address, kernel};
		u64 items = n - first < most ? n - first : most;
		vk->call.CmdPushConstants(vk->commands, vk->layout, compute, 0, sizeof launch, launch);
		vk->call.CmdDispatch(vk->commands, (u32)((items + vk->work_group - 1) / vk->work_group), 1, 1);
	}
	ts_vk_next(vk);
}

/* Kernels that get arrays in parts are different programs. */
static ts_status admit(ts_vk *vk, u64 part_bytes)
{
	if (vk->part_bytes == part_bytes) return TS_OK;
	if (ts_vk_flush(vk) != TS_OK) return TS_ERROR;
	vk->part_bytes = part_bytes;
	ts_vk_forget_pipelines(vk);
	return TS_OK;
}

static ts_status enqueue(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	ts_vk *vk = (ts_vk *)backend;
	arguments a;
	u64 address;
	if (admit(vk, ts_device_parts(&vk->store, vk->part_bytes, frame, launch, args)) != TS_OK) return TS_ERROR;
	if (ts_vk_make_pipeline(vk, launch->kernel) != TS_OK) return TS_ERROR;
	if (set_pointers(vk, frame, launch, args, &a) != TS_OK) return TS_ERROR;
	if (place(vk, launch, &a, &address) != TS_OK || ts_vk_record(vk) != TS_OK) return TS_ERROR;
	dispatch(vk, launch->kernel, address, n);
	return TS_OK;
}

static ts_status launch(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	return ts_device_launch(backend, frame, launch, args, n, enqueue);
}

static ts_status fill(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u8 byte)
{
	ts_vk *vk = (ts_vk *)backend;
	ts_buffer *buffer = &frame->buffer[id];
	bool parted = ts_may_be_parted(id);
	void *parts[TS_PARTS];
	frame->residence = &ts_store_residence;
	if (parted && admit(vk, ts_device_parts_of(&vk->store, vk->part_bytes, buffer)) != TS_OK) return TS_ERROR;
	if (ts_store_use(&vk->store, parts, buffer, parted ? vk->part_bytes : 0, TS_OVERWRITES) != TS_OK) return TS_ERROR;
	if (ts_vk_record(vk) != TS_OK) return TS_ERROR;
	for (u32 i = 0; i < TS_PARTS && parts[i] != NULL; i++) {
		const ts_vk_block *block = parts[i];
		vk->call.CmdFillBuffer(vk->commands, block->buffer, 0, VK_WHOLE_SIZE, byte * 0x01010101u);
	}
	ts_vk_next(vk);
	return TS_OK;
}

static bool repair(ts_backend *backend)
{
	ts_vk *vk = (ts_vk *)backend;
	if (vk->by_integers) return false;
	vk->by_integers = true;
	ts_vk_forget_pipelines(vk);
	snprintf(vk->flags, sizeof vk->flags, "group=%u, quotients and roots by integers", vk->work_group);
	return true;
}

static ts_status finish(ts_backend *backend) { return ts_store_finish(&((ts_vk *)backend)->store); }

static void close_device(ts_vk *vk)
{
	ts_vk_forget_pipelines(vk);
	ts_vk_free_block(vk, &vk->arguments);
	ts_vk_free_block(vk, &vk->staging);
	if (vk->layout != VK_NULL_HANDLE) vk->call.DestroyPipelineLayout(vk->device, vk->layout, NULL);
	if (vk->fence != VK_NULL_HANDLE) vk->call.DestroyFence(vk->device, vk->fence, NULL);
	if (vk->pool != VK_NULL_HANDLE) vk->call.DestroyCommandPool(vk->device, vk->pool, NULL);
	vk->call.DestroyDevice(vk->device, NULL);
}

static void end(ts_backend *backend)
{
	ts_vk *vk = (ts_vk *)backend;
	if (vk->device != VK_NULL_HANDLE) close_device(vk);
	ts_modules_free(&vk->modules);
	free(vk);
}

static VkResult make_commands(ts_vk *vk)
{
	const VkCommandPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
	                                      .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
	                                      .queueFamilyIndex = vk->family};
	const VkFenceCreateInfo fence = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
	VkResult result = vk->call.CreateCommandPool(vk->device, &pool, NULL, &vk->pool);
	const VkCommandBufferAllocateInfo commands = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
	                                              .commandPool = vk->pool,
	                                              .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
	                                              .commandBufferCount = 1};
	if (result == VK_SUCCESS) result = vk->call.AllocateCommandBuffers(vk->device, &commands, &vk->commands);
	return result == VK_SUCCESS ? vk->call.CreateFence(vk->device, &fence, NULL, &vk->fence) : result;
}

static VkResult make_layout(ts_vk *vk)
{
	const VkPushConstantRange range = {VK_SHADER_STAGE_COMPUTE_BIT, 0, 40};
	const VkPipelineLayoutCreateInfo info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
	                                         .pushConstantRangeCount = 1,
	                                         .pPushConstantRanges = &range};
	return vk->call.CreatePipelineLayout(vk->device, &info, NULL, &vk->layout);
}

static ts_status begin(ts_vk *vk, const ts_backend_options *options)
{
	enum { GROUP = 64 };
	ts_status found = ts_vk_find(vk, options->device);
	if (found != TS_OK) return found;
	if (ts_vk_open_device(vk) != TS_OK) return TS_ERROR;
	vk->work_group = options->work_group != 0 ? options->work_group : GROUP;
	vk->part_bytes = options->part_bytes;
	ts_vk_open_modules(vk, options->build);
	if (vk->work_group > vk->most.items || vk->work_group % vk->most.vector != 0) {
		return ts_fail("work group of %u: %s runs at most %u items at once, and %u together", vk->work_group,
		               vk->about.name, vk->most.items, vk->most.vector);
	}
	vk->sees = vk->about.unified && !options->copies;
	ts_vk_open_store(vk);
	VkResult result = make_commands(vk);
	if (result == VK_SUCCESS) result = make_layout(vk);
	if (result != VK_SUCCESS) return ts_vk_failed("a queue", result);
	if (ts_vk_make_block(vk, &vk->arguments, TS_VK_ARGUMENTS, true) != TS_OK) return TS_ERROR;
	ts_vk_empty_arguments(vk);
	return ts_vk_make_pipeline(vk, TS_KERNEL_vectors); /* the first to run: a refusal by the compiler shows here */
}

static ts_status open_device(ts_backend **backend, const ts_backend_options *options)
{
	ts_vk *vk = ts_alloc_zero(1, sizeof *vk, "Vulkan backend");
	*backend = NULL;
	if (vk == NULL) return TS_ERROR;
	ts_status status = begin(vk, options);
	if (status != TS_OK) {
		end(&vk->backend);
		return status;
	}
	snprintf(vk->device_line, sizeof vk->device_line, "%s, %s", vk->about.name, vk->about.platform);
	snprintf(vk->flags, sizeof vk->flags, "group=%u", vk->work_group);
	vk->backend = (ts_backend){.name = "vulkan",
	                           .device = vk->device_line,
	                           .compiler = vk->about.driver,
	                           .flags = vk->flags,
	                           .ends_loops = vk->most.ends_loops,
	                           .launch = launch,
	                           .fill = fill,
	                           .scan = ts_device_scan,
	                           .finish = finish,
	                           .repair = repair,
	                           .close = end};
	*backend = &vk->backend;
	return TS_OK;
}

const ts_backend_kind ts_vulkan_kind = {"vulkan", ts_vk_devices, open_device};
