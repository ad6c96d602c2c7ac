/* The kernels on Vulkan 1.2 devices with 64-bit integers and atomics, shared by the files of this folder, the only one
 * that names Vulkan. The loader is opened at run time, and finds the drivers. */
#ifndef TS_BACKENDS_VULKAN_VK_H
#define TS_BACKENDS_VULKAN_VK_H
#define VK_NO_PROTOTYPES
#include <vulkan/vulkan_core.h>
#include "backends/devices/device.h"
#include "backends/devices/modules.h"

/* The functions that are called. */
/* clang-format off */
#define TS_VK_GLOBAL(CALL) CALL(CreateInstance) CALL(EnumerateInstanceVersion)
#define TS_VK_CALLS(CALL) \
	CALL(EnumeratePhysicalDevices) CALL(GetPhysicalDeviceProperties2) \
	CALL(GetPhysicalDeviceFeatures2) CALL(GetPhysicalDeviceMemoryProperties) \
	CALL(GetPhysicalDeviceQueueFamilyProperties) CALL(CreateDevice) CALL(DestroyDevice) CALL(GetDeviceQueue) \
	CALL(CreateCommandPool) CALL(DestroyCommandPool) CALL(AllocateCommandBuffers) CALL(BeginCommandBuffer) \
	CALL(EndCommandBuffer) CALL(QueueSubmit) CALL(CreateFence) CALL(DestroyFence) CALL(WaitForFences) \
	CALL(ResetFences) CALL(CreateBuffer) CALL(DestroyBuffer) CALL(GetBufferMemoryRequirements) CALL(AllocateMemory) \
	CALL(FreeMemory) CALL(BindBufferMemory) CALL(MapMemory) CALL(GetBufferDeviceAddress) CALL(CreateShaderModule) \
	CALL(DestroyShaderModule) CALL(CreatePipelineLayout) CALL(DestroyPipelineLayout) CALL(CreateComputePipelines) \
	CALL(DestroyPipeline) CALL(CmdBindPipeline) CALL(CmdPushConstants) CALL(CmdDispatch) CALL(CmdFillBuffer) \
	CALL(CmdCopyBuffer) CALL(CmdPipelineBarrier)
/* clang-format on */
#define TS_VK_CALL(name) PFN_vk##name name;
typedef struct {
	TS_VK_GLOBAL(TS_VK_CALL)
	TS_VK_CALLS(TS_VK_CALL)
} ts_vk_calls;
#undef TS_VK_CALL

/* Memory of the device with an address there; mapped: its address on the host, NULL if the host does not see it. */
enum { TS_VK_ARGUMENTS = 1 << 18, TS_VK_ALIGN = 16 };
typedef struct {
	VkBuffer buffer;
	VkDeviceMemory memory;
	u64 address, bytes;
	u8 *mapped;
} ts_vk_block;

/* Groups of a dispatch, and items of a group. Groups are whole vectors, since llvmpipe does not end incomplete ones. */
typedef struct {
	u32 groups, items, vector;
	bool ends_loops; /* ends the loops of the 8 items of a vector after 65,535 iterations together: llvmpipe */
} ts_vk_limits;

typedef struct {
	ts_backend backend;
	ts_device about;
	char device_line[288], flags[64];
	ts_vk_calls call;
	VkPhysicalDevice physical;
	VkDevice device;
	VkQueue queue;
	u32 family;
	VkCommandPool pool;
	VkCommandBuffer commands;
	VkFence fence;
	bool recording;
	VkPipelineLayout layout;
	VkPipeline pipelines[TS_N_KERNELS]; /* made as they are needed */
	ts_vk_limits most;
	u32 work_group;
	bool by_integers;      /* quotients and roots are (divide.glsl) */
	u64 part_bytes;        /* of parted arrays; 0: none is in parts */
	ts_vk_block arguments; /* of the launches that are recorded, behind the kernel of which a loop was ended early */
	u64 n_arguments;       /* bytes */
	ts_vk_block staging;   /* used if the host does not see the device's memory */
	bool sees;             /* the host sees the device's memory */
	ts_modules modules;
	ts_store store;
} ts_vk;

/* A failed call as one line. */
ts_status ts_vk_failed(const char *what, VkResult result);

/* device.c: ts_vulkan_kind's devices; the one of an index, TS_SKIPPED without any; opened, with its queue. */
ts_status ts_vk_devices(ts_device devices[TS_MAX_DEVICES], u32 *n);
ts_status ts_vk_find(ts_vk *vk, u32 index);
ts_status ts_vk_open_device(ts_vk *vk);

/* memory.c */
ts_status ts_vk_make_block(ts_vk *vk, ts_vk_block *block, u64 bytes, bool seen);
void ts_vk_free_block(ts_vk *vk, ts_vk_block *block);
void ts_vk_open_store(ts_vk *vk);

/* commands.c: what is recorded begins with ts_vk_record, and ends with ts_vk_next if more may follow; it runs when
 * flushed. */
ts_status ts_vk_record(ts_vk *vk);
void ts_vk_next(ts_vk *vk);
ts_status ts_vk_flush(ts_vk *vk);
void ts_vk_empty_arguments(ts_vk *vk);

/* program.c: where SPIR-V comes from; makes a kernel's pipeline, unless it is there; releases all of them. */
void ts_vk_open_modules(ts_vk *vk, const char *folder);
ts_status ts_vk_make_pipeline(ts_vk *vk, ts_kernel kernel);
void ts_vk_forget_pipelines(ts_vk *vk);

#endif
