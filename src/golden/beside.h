/* What a golden has beside its buffers: preview.png and CHANGES. Both are untrusted. Part of the core. */
#ifndef TS_GOLDEN_BESIDE_H
#define TS_GOLDEN_BESIDE_H
#include "golden.h"

enum { TS_REASON_BYTES = 400, TS_REASONS_BYTES = 1 << 20 }; /* one; all that CHANGES holds */
enum { TS_GOLDEN_TEXT = 512, TS_GOLDEN_PIXELS = 1 << 20 };  /* of what differs; of the picture, at most */

/* A reason to bless: one line that says something, of at most TS_REASON_BYTES. */
ts_status ts_reason_check(const char *reason);
/* Whether CHANGES of a folder is lines of reasons. */
ts_status ts_golden_check_changes(const ts_golden_dir *dir);

/* Reads a PNG file in memory, as ts_image_decode does, which the core does not have. */
typedef ts_status ts_golden_decoder(u8 **rgba, u32 *width, u32 *height, const void *file, size_t bytes, u64 most_pixels,
                                    const char *what);
/* Compares the preview with the picture that was computed, if there is one. TS_DIFFERENT: `text` says where. */
ts_status ts_golden_check_preview(char text[TS_GOLDEN_TEXT], const ts_golden_dir *dir, const ts_golden *computed,
                                  ts_golden_decoder *decode);

#endif
