/* Which devices there are, and what they can do. */
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include "backends/devices/driver.h"
#include "backends/vulkan/vk.h"

static const char none[] = "no Vulkan device; install a driver, such as Debian's mesa-vulkan-drivers";

static ts_status loader(PFN_vkGetInstanceProcAddr *find)
{
	static void *library;
	ts_status status =
		library != NULL ? TS_OK : ts_driver_open(&library, "libvulkan.so.1", RTLD_NOW | RTLD_LOCAL, "vulkan", none);
	if (status != TS_OK) return status;
	*find = (PFN_vkGetInstanceProcAddr)dlsym(library, "vkGetInstanceProcAddr");
	return *find != NULL ? TS_OK : ts_fail("backend vulkan: libvulkan.so.1 is no loader of Vulkan");
}

static ts_status make_instance(const ts_vk_calls *call, VkInstance *instance)
{
	u32 version = VK_API_VERSION_1_0;
	if (call->EnumerateInstanceVersion != NULL) call->EnumerateInstanceVersion(&version);
	if (version < VK_API_VERSION_1_2) return ts_fail("backend vulkan: libvulkan.so.1 is older than Vulkan 1.2");
	const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
	                                       .pApplicationName = "touchstone",
	                                       .apiVersion = VK_API_VERSION_1_2};
	const VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
	                                   .pApplicationInfo = &application};
	VkResult result = call->CreateInstance(&info, NULL, instance);
	if (result == VK_ERROR_INCOMPATIBLE_DRIVER) return ts_driver_none("vulkan", none);
	return result == VK_SUCCESS ? TS_OK : ts_vk_failed("an instance", result);
}

/* The loader's and one instance's calls, found once. The instance stays as long as the process lives: the loader
 * unloads drivers with it, and their leaks would have no names. */
static struct {
	ts_vk_calls call;
	VkInstance instance;
} vulkan;

static ts_status start(void)
{
	PFN_vkGetInstanceProcAddr find;
	ts_vk_calls *call = &vulkan.call;
	if (vulkan.instance != VK_NULL_HANDLE) return TS_OK;
	ts_status status = loader(&find);
	if (status != TS_OK) return status;
#define GLOBAL(name) call->name = (PFN_vk##name)find(NULL, "vk" #name);
	TS_VK_GLOBAL(GLOBAL)
#undef GLOBAL
	status = make_instance(call, &vulkan.instance);
	if (status != TS_OK) return status;
#define CALL(name) call->name = (PFN_vk##name)find(vulkan.instance, "vk" #name);
	TS_VK_CALLS(CALL)
#undef CALL
	return TS_OK;
}

static ts_status all_devices(VkPhysicalDevice devices[TS_MAX_DEVICES], u32 *n)
{
	ts_status status = start();
	*n = 0;
	if (status != TS_OK) return status;
	u32 most = TS_MAX_DEVICES;
	VkResult result = vulkan.call.EnumeratePhysicalDevices(vulkan.instance, &most, devices);
	/* The loader's word for no device. */
	if (result == VK_ERROR_INITIALIZATION_FAILED) return ts_driver_none("vulkan", none);
	if (result != VK_SUCCESS && result != VK_INCOMPLETE) return ts_vk_failed("the devices", result);
	*n = most;
	return most > 0 ? TS_OK : ts_driver_none("vulkan", none);
}

/* A device's features, as the query's structs. */
typedef struct {
	VkPhysicalDeviceVulkan12Features more;
	VkPhysicalDeviceFeatures2 features;
} features;

static void ask_features(features *f)
{
	f->more = (VkPhysicalDeviceVulkan12Features){.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
	f->features = (VkPhysicalDeviceFeatures2){.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, .pNext = &f->more};
}

static bool suffices(const features *f, const VkPhysicalDeviceVulkan12Properties *p)
{
	return f->more.bufferDeviceAddress && f->more.scalarBlockLayout && f->more.shaderInt8 &&
	       f->more.storageBuffer8BitAccess && f->more.shaderBufferInt64Atomics && f->features.features.shaderInt64 &&
	       p->shaderSignedZeroInfNanPreserveFloat32 && p->shaderRoundingModeRTEFloat32;
}

static u64 memory_of(VkPhysicalDevice device)
{
	VkPhysicalDeviceMemoryProperties memory;
	u64 most = 0;
	vulkan.call.GetPhysicalDeviceMemoryProperties(device, &memory);
	for (u32 i = 0; i < memory.memoryHeapCount; i++) {
		const VkMemoryHeap *heap = &memory.memoryHeaps[i];
		if ((heap->flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0 && heap->size > most) most = heap->size;
	}
	return most;
}

static ts_device describe(VkPhysicalDevice device, ts_vk_limits *most)
{
	VkPhysicalDeviceVulkan12Properties more = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES};
	VkPhysicalDeviceVulkan11Properties limits = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES,
	                                             .pNext = &more};
	VkPhysicalDeviceProperties2 all = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &limits};
	features f;
	ask_features(&f);
	vulkan.call.GetPhysicalDeviceProperties2(device, &all);
	vulkan.call.GetPhysicalDeviceFeatures2(device, &f.features);
	const VkPhysicalDeviceProperties *p = &all.properties;
	ts_device d = {.rounded = true, .little_endian = true};
	snprintf(d.name, sizeof d.name, "%.*s", (int)sizeof d.name - 1, p->deviceName);
	snprintf(d.platform, sizeof d.platform, "%.63s, Vulkan %u.%u", more.driverName, VK_API_VERSION_MAJOR(p->apiVersion),
	         VK_API_VERSION_MINOR(p->apiVersion));
	snprintf(d.driver, sizeof d.driver, "%.63s", more.driverInfo);
	ts_line_clean(d.name);
	ts_line_clean(d.platform);
	ts_line_clean(d.driver);
	d.denormals = more.shaderDenormPreserveFloat32 != 0;
	d.atomics = p->apiVersion >= VK_API_VERSION_1_2 && suffices(&f, &more);
	d.unified = p->deviceType == VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU || p->deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
	d.memory = memory_of(device);
	d.most = limits.maxMemoryAllocationSize;
	*most = (ts_vk_limits){.groups = p->limits.maxComputeWorkGroupCount[0],
	                       .items = p->limits.maxComputeWorkGroupInvocations,
	                       .vector = limits.subgroupSize,
	                       .ends_loops = more.driverID == VK_DRIVER_ID_MESA_LLVMPIPE};
	return d;
}

ts_status ts_vk_devices(ts_device devices[TS_MAX_DEVICES], u32 *n)
{
	VkPhysicalDevice found[TS_MAX_DEVICES];
	ts_vk_limits most;
	ts_status status = all_devices(found, n);
	for (u32 i = 0; i < *n; i++) devices[i] = describe(found[i], &most);
	return status;
}

static ts_status queue_family(ts_vk *vk)
{
	VkQueueFamilyProperties families[32];
	u32 n = sizeof families / sizeof *families;
	vk->call.GetPhysicalDeviceQueueFamilyProperties(vk->physical, &n, families);
	for (u32 i = 0; i < n; i++) {
		if ((families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0) continue;
		vk->family = i;
		return TS_OK;
	}
	return ts_fail("backend vulkan: %s computes nothing", vk->about.name);
}

ts_status ts_vk_find(ts_vk *vk, u32 index)
{
	VkPhysicalDevice found[TS_MAX_DEVICES];
	u32 n;
	ts_status status = all_devices(found, &n);
	if (status != TS_OK) return status;
	if (index >= n) return ts_fail("device %u: there are %u devices, from 0", index, n);
	vk->physical = found[index];
	vk->call = vulkan.call;
	vk->about = describe(vk->physical, &vk->most);
	return queue_family(vk);
}

ts_status ts_vk_open_device(ts_vk *vk)
{
	if (!vk->about.atomics) {
		return ts_fail(
			"backend vulkan: %s lacks Vulkan 1.2, 64-bit integers, their atomics, 8-bit storage, buffer addresses, "
			"scalar layout, or floats that round to nearest and keep signed zeros, infinities and NaN",
			vk->about.name);
	}
	const float priority = 1;
	features f;
	ask_features(&f);
	f.features.features.shaderInt64 = VK_TRUE;
	f.more.bufferDeviceAddress = f.more.scalarBlockLayout = VK_TRUE;
	f.more.shaderInt8 = f.more.storageBuffer8BitAccess = f.more.shaderBufferInt64Atomics = VK_TRUE;
	const VkDeviceQueueCreateInfo queue = {.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
	                                       .queueFamilyIndex = vk->family,
	                                       .queueCount = 1,
	                                       .pQueuePriorities = &priority};
	const VkDeviceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
	                                 .pNext = &f.features,
	                                 .queueCreateInfoCount = 1,
	                                 .pQueueCreateInfos = &queue};
	VkResult result = vk->call.CreateDevice(vk->physical, &info, NULL, &vk->device);
	if (result != VK_SUCCESS) return ts_vk_failed("the device", result);
	vk->call.GetDeviceQueue(vk->device, vk->family, 0, &vk->queue);
	return TS_OK;
}
