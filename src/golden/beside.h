/* The files of a golden beside its buffers: preview.png and CHANGES. Both are untrusted. Part of the core. */
#ifndef TS_GOLDEN_BESIDE_H
#define TS_GOLDEN_BESIDE_H
#include "golden/golden.h"

enum { TS_REASON_BYTES = 400, TS_REASONS_BYTES = 1 << 20 }; /* of one reason; of CHANGES */
enum { TS_GOLDEN_TEXT = 512, TS_GOLDEN_PIXELS = 1 << 20 };  /* of a text; greatest number of pixels of the picture */

/* Fails unless a reason to bless is one line that is not empty, of at most TS_REASON_BYTES. */
ts_status ts_reason_check(const char *reason);
/* Fails unless CHANGES of a folder consists of lines of reasons. */
ts_status ts_golden_check_changes(const ts_golden_dir *dir);

/* Decodes a PNG file in memory, like ts_image_decode, which the core does not have. */
typedef ts_status ts_golden_decoder(u8 **rgba, u32 *width, u32 *height, const void *file, size_t bytes, u64 most_pixels,
                                    const char *what);
/* Compares the preview with the picture that was computed, if there is one. TS_DIFFERENT: `text` says where. */
ts_status ts_golden_check_preview(char text[TS_GOLDEN_TEXT], const ts_golden_dir *dir, const ts_golden *computed,
                                  ts_golden_decoder *decode);

#endif
