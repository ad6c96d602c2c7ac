/* Modules of kernels: of the library, packed; of a build that has none. */
#include <zlib.h>
#include "backends/devices/modules.h"
#include "tests/model/test.h"

enum { BYTES = 5 };
static const ts_kernel kernel = 2;

static ts_status find(const u32 *first, const u8 *packed, u64 n_packed, ts_module *module)
{
	ts_modules modules = {"cuda", "ptx", {packed, n_packed, first}, "", NULL};
	ts_status status = ts_modules_find(&modules, kernel, module);
	if (status == TS_OK) assert_memory_equal(module->bytes, "head", module->n_bytes);
	ts_module_free(module);
	ts_modules_free(&modules);
	return status;
}

static void modules_are_unpacked(void **state)
{
	(void)state;
	u32 first[TS_N_KERNELS + 1] = {0};
	for (u32 after = kernel + 1; after <= TS_N_KERNELS; after++) first[after] = BYTES;
	u8 packed[64];
	uLongf n_packed = sizeof packed;
	assert_int_equal(compress(packed, &n_packed, (const u8 *)"head", BYTES), Z_OK);
	ts_module module;
	assert_int_equal(find(first, packed, n_packed, &module), TS_OK);
	assert_int_equal(module.n_bytes, BYTES);
}

static void a_build_without_kernels_says_so(void **state)
{
	(void)state;
	static const u32 first[TS_N_KERNELS + 1];
	ts_module module;
	assert_int_equal(find(first, (const u8 *)"", 0, &module), TS_ERROR);
	assert_string_equal(ts_error_message(),
	                    "backend cuda: built without its kernels; `make` without DEVICES= adds them, CUDA's by clang");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(modules_are_unpacked),
		cmocka_unit_test(a_build_without_kernels_says_so),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
