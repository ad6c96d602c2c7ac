/* The order of the bytes of a number: in files lowest first, on every machine. */
#ifndef TS_MODEL_ORDER_H
#define TS_MODEL_ORDER_H
#include "table.h"

/* True where memory has the order of files. */
enum { TS_LITTLE_ENDIAN = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ };

/* Copies n elements of a buffer with the bytes of each of their numbers reversed: what a big-endian machine does
 * between memory and file. */
void ts_order_reverse(void *to, const void *from, ts_buffer_id id, u64 n);

/* A number of a file: 1 to 8 bytes. */
static inline u64 ts_order_read(const void *at, size_t bytes)
{
	u64 value = 0;
	memcpy(&value, at, bytes);
	return TS_LITTLE_ENDIAN ? value : __builtin_bswap64(value);
}

#endif
