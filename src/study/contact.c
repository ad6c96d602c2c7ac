/* A contact sheet. */
#include "study/contact.h"
#include <stdlib.h>
#include <string.h>
#include <touchstone/image.h>
#include "output/folder.h"

enum { WIDEST = 240, GAP = 4, DARK = 32 };

ts_status ts_contact_begin(ts_contact *contact, u32 columns, u32 rows, u32 width, u32 height)
{
	u32 cell_width = width < WIDEST ? width : WIDEST;
	u32 cell_height = (u32)((u64)height * cell_width / width);
	*contact = (ts_contact){.cell_width = cell_width, .cell_height = cell_height > 0 ? cell_height : 1};
	contact->width = GAP + columns * (contact->cell_width + GAP);
	contact->height = GAP + rows * (contact->cell_height + GAP);
	size_t bytes = (size_t)contact->width * contact->height * 3;
	contact->rgb = ts_alloc(bytes, 1, "a contact sheet");
	if (contact->rgb == NULL) return TS_ERROR;
	memset(contact->rgb, DARK, bytes);
	return TS_OK;
}

/* The pixels below pixel `at` of `cells`: at least one. */
static void below(u32 *first, u32 *end, u32 at, u32 cells, u32 pixels)
{
	*first = (u32)((u64)at * pixels / cells);
	*end = (u32)((u64)(at + 1) * pixels / cells);
	if (*end == *first) ++*end;
}

static void put_pixel(u8 *to, const u8 *srgb, u32 width, const u32 x[2], const u32 y[2])
{
	u64 sum[3] = {0}, n = (u64)(x[1] - x[0]) * (y[1] - y[0]);
	for (u32 j = y[0]; j < y[1]; j++) {
		for (u32 i = x[0]; i < x[1]; i++) {
			for (u32 c = 0; c < 3; c++) sum[c] += srgb[((size_t)j * width + i) * 3 + c];
		}
	}
	for (u32 c = 0; c < 3; c++) to[c] = (u8)((sum[c] + n / 2) / n);
}

void ts_contact_put(ts_contact *contact, u32 column, u32 row, const u8 *srgb, u32 width, u32 height)
{
	u32 left = GAP + column * (contact->cell_width + GAP), top = GAP + row * (contact->cell_height + GAP);
	for (u32 j = 0; j < contact->cell_height; j++) {
		for (u32 i = 0; i < contact->cell_width; i++) {
			u32 x[2], y[2];
			below(&x[0], &x[1], i, contact->cell_width, width);
			below(&y[0], &y[1], j, contact->cell_height, height);
			put_pixel(contact->rgb + ((size_t)(top + j) * contact->width + left + i) * 3, srgb, width, x, y);
		}
	}
}

ts_status ts_contact_write(const ts_contact *contact, const char *name)
{
	const char *path = ts_folder_file(name);
	return path != NULL ? ts_image_write_png(path, contact->rgb, contact->width, contact->height, 3, NULL) : TS_ERROR;
}

void ts_contact_free(ts_contact *contact)
{
	free(contact->rgb);
	contact->rgb = NULL;
}
