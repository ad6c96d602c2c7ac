/* A contact sheet: small pictures of several renders in rows and columns. */
#ifndef TS_STUDY_CONTACT_H
#define TS_STUDY_CONTACT_H
#include "kernels/base/compat.h"
#include "model/core.h"

typedef struct {
	u8 *rgb;
	u32 width, height;           /* of the sheet */
	u32 cell_width, cell_height; /* of a picture in it */
} ts_contact;

/* Makes a dark sheet for columns x rows pictures of that size, each shown at most 240 pixels wide. Released by
 * ts_contact_free, also on failure. */
ts_status ts_contact_begin(ts_contact *contact, u32 columns, u32 rows, u32 width, u32 height);
/* Puts a picture of any size into a cell: each pixel of the cell is the mean of the display values of the pixels that
 * it covers. */
void ts_contact_put(ts_contact *contact, u32 column, u32 row, const u8 *srgb, u32 width, u32 height);
/* Writes the sheet to the folder of results. */
ts_status ts_contact_write(const ts_contact *contact, const char *name);
void ts_contact_free(ts_contact *contact);

#endif
