/* Dimensions of a buffer from the text of its shape. */
#include "shape.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>

static ts_size *find(const ts_sizes *sizes, const char *name, size_t length)
{
	for (u32 i = 0; i < sizes->n; i++) {
		const ts_size *size = &sizes->size[i];
		if (strlen(size->name) == length && memcmp(size->name, name, length) == 0) return (ts_size *)(uintptr_t)size;
	}
	return NULL;
}

void ts_sizes_set(ts_sizes *sizes, const char *name, u64 n)
{
	ts_size *size = find(sizes, name, strlen(name));
	if (size == NULL) {
		assert(sizes->n < TS_MAX_SIZES);
		size = &sizes->size[sizes->n++];
	}
	*size = (ts_size){name, n};
}

static bool multiply(u64 *product, u64 factor)
{
	if (factor != 0 && *product > UINT64_MAX / factor) return false;
	*product *= factor;
	return true;
}

/* "V", "25", "P*K" or "P*K+1". */
static bool dimension(const char *text, size_t length, const ts_sizes *sizes, u64 *dim)
{
	bool one_more = length > 2 && memcmp(text + length - 2, "+1", 2) == 0;
	const char *end = text + length - (one_more ? 2 : 0);
	*dim = 1;
	while (text < end) {
		size_t n = strcspn(text, "* +");
		const ts_size *size = find(sizes, text, n);
		bool digits = strspn(text, "0123456789") == n;
		if ((size == NULL && !digits) || !multiply(dim, size != NULL ? size->n : strtoull(text, NULL, 10))) return false;
		text += n + (text[n] == '*');
	}
	*dim += one_more;
	return *dim != 0 || !one_more;
}

bool ts_shape_dims(const char *shape, const ts_sizes *sizes, u32 *n_dims, u64 dims[TS_MAX_DIMS])
{
	for (*n_dims = 0; *shape != 0; (*n_dims)++) {
		size_t length = strcspn(shape, " ");
		if (*n_dims == TS_MAX_DIMS || !dimension(shape, length, sizes, &dims[*n_dims])) return false;
		shape += length + (shape[length] == ' ');
	}
	return *n_dims > 0;
}

bool ts_shape_count(u64 *n, u32 n_dims, const u64 *dims)
{
	*n = 1;
	for (u32 i = 0; i < n_dims; i++) {
		if (!multiply(n, dims[i])) return false;
	}
	return true;
}
