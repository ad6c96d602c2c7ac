/* Numbers that no stage may store: CONTRACT rules 12 and 24. */
#include "golden/golden.h"
#include "kernels/base/num.h"
#include "model/order.h"

/* A float that is NaN, infinite, -0 or nearer to 0 than 2^-100. */
static bool is_stray(u32 bits)
{
	u32 size = bits & 0x7fffffffu;
	return size >= 0x7f800000u || (bits != 0 && size < 0x0d800000u);
}

/* True if word `at` of an element is a float. */
static bool is_float(ts_buffer_id id, size_t at)
{
	const char *element = ts_buffer_table[id].element;
	if (strcmp(element, "f32") == 0) return true;
	size_t n, word = 0;
	const ts_field_info *fields = ts_field_table(&n);
	for (size_t i = 0; i < n; i++) {
		if (strcmp(fields[i].record, element) != 0) continue;
		size_t words = fields[i].count * (ts_type_bytes(fields[i].type) / 4);
		if (at >= word && at < word + words) return strcmp(fields[i].type, "f32") == 0;
		word += words;
	}
	return false;
}

/* A key's high half is a distance; an axial one of 0 is before the near plane. */
static bool is_stray_key(ts_buffer_id id, u64 key)
{
	u32 distance = (u32)(key >> 32);
	bool axial = strstr(ts_buffer_table[id].doc, "axial") != NULL;
	return key != TS_EMPTY && (is_stray(distance) || (distance == 0 && axial));
}

static u64 stray_keys(ts_buffer_id id, const u8 *data, u64 bytes)
{
	u64 count = 0;
	for (u64 i = 0; i < bytes / 8; i++) count += is_stray_key(id, ts_order_read(data + 8 * i, 8));
	return count;
}

u64 ts_golden_strays(ts_buffer_id id, const void *data, u64 bytes)
{
	const ts_buffer_info *info = &ts_buffer_table[id];
	bool floats[64] = {false}, any = false;
	size_t n_words = info->element_bytes / 4;
	if (strcmp(info->element, "u64") == 0 && strstr(info->name, ".depth_") != NULL) return stray_keys(id, data, bytes);
	for (size_t i = 0; i < n_words && i < 64; i++) any |= floats[i] = is_float(id, i);
	u64 count = 0;
	for (u64 i = 0; any && i < bytes / 4; i++) {
		count += floats[i % n_words] && is_stray((u32)ts_order_read((const u8 *)data + 4 * i, 4));
	}
	return count;
}
