/* Byte order: files are little-endian on every machine. */
#ifndef TS_MODEL_ORDER_H
#define TS_MODEL_ORDER_H
#include "model/table.h"

/* True where memory has the order of files. */
enum { TS_LITTLE_ENDIAN = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ };

/* Copies n elements of a buffer with the bytes of each number reversed, as a big-endian machine must between memory and
 * file. */
void ts_order_reverse(void *to, const void *from, ts_buffer_id id, u64 n);

/* Reads an unsigned number of 1 to 8 bytes of a file. */
static inline u64 ts_order_read(const void *at, size_t bytes)
{
	u64 value = 0;
	memcpy(&value, at, bytes);
	return TS_LITTLE_ENDIAN ? value : __builtin_bswap64(value);
}

#endif
