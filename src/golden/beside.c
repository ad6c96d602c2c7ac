/* A golden's other files: a preview, and the reasons for which it was blessed. */
#include "golden/beside.h"
#include <stdio.h>
#include <stdlib.h>

ts_status ts_reason_check(const char *reason)
{
	char clean[TS_REASON_BYTES + 1];
	if (reason[strspn(reason, " \t")] == 0) return ts_fail("no reason");
	if (strlen(reason) > TS_REASON_BYTES) return ts_fail("a reason has at most %d bytes", TS_REASON_BYTES);
	strcpy(clean, reason);
	ts_line_clean(clean);
	if (strcmp(clean, reason) == 0) return TS_OK;
	return ts_fail("a reason is one line, without control characters");
}

ts_status ts_golden_check_changes(const ts_golden_dir *dir)
{
	char *text, *end;
	size_t bytes;
	u32 number = 0;
	if (ts_golden_read_file(&text, &bytes, dir, TS_GOLDEN_CHANGES, TS_REASONS_BYTES) != TS_OK) return TS_ERROR;
	ts_status status = TS_OK;
	if (bytes == 0 || strlen(text) != bytes || text[bytes - 1] != '\n') status = ts_fail("not lines of text");
	for (char *line = text; status == TS_OK && (end = strchr(line, '\n')) != NULL; line = end + 1) {
		*end = 0;
		number++;
		status = ts_reason_check(line);
		if (status != TS_OK) ts_fail("line %u: %s", (unsigned)number, ts_error_message());
	}
	free(text);
	return status == TS_OK ? TS_OK : ts_fail("%s/%s: %s", dir->path, TS_GOLDEN_CHANGES, ts_error_message());
}

typedef struct {
	u32 width, height, channels;
	const u8 *pixels;
} picture;

static ts_status compare_pictures(char *text, const picture *stored, const picture *computed)
{
	const u8 *s = stored->pixels, *c = computed->pixels;
	if (stored->width != computed->width || stored->height != computed->height) {
		snprintf(text, TS_GOLDEN_TEXT, "%s: golden %u by %u pixels here %u by %u", TS_GOLDEN_PREVIEW,
		         (unsigned)stored->width, (unsigned)stored->height, (unsigned)computed->width,
		         (unsigned)computed->height);
		return TS_DIFFERENT;
	}
	u64 n = (u64)stored->width * stored->height, i = 0;
	for (; i < n && memcmp(s, c, 3) == 0; i++) {
		s += stored->channels;
		c += computed->channels;
	}
	if (i == n) return TS_OK;
	snprintf(text, TS_GOLDEN_TEXT, "%s: pixel [%u, %u]: golden %u %u %u here %u %u %u", TS_GOLDEN_PREVIEW,
	         (unsigned)(i / stored->width), (unsigned)(i % stored->width), s[0], s[1], s[2], c[0], c[1], c[2]);
	return TS_DIFFERENT;
}

ts_status ts_golden_check_preview(char text[TS_GOLDEN_TEXT], const ts_golden_dir *dir, const ts_golden *computed,
                                  ts_golden_decoder *decode)
{
	picture stored = {.channels = 4}, here = {.channels = 3};
	char *file, path[TS_GOLDEN_PATH + sizeof TS_GOLDEN_PREVIEW];
	size_t bytes;
	u8 *rgba = NULL;
	here.pixels = ts_golden_image(computed, &here.width, &here.height);
	if (here.pixels == NULL) return TS_OK;
	ts_status status = ts_golden_read_file(&file, &bytes, dir, TS_GOLDEN_PREVIEW, TS_GOLDEN_FILE_BYTES);
	if (status != TS_OK) return status;
	snprintf(path, sizeof path, "%s/%s", dir->path, TS_GOLDEN_PREVIEW);
	status = decode(&rgba, &stored.width, &stored.height, file, bytes, TS_GOLDEN_PIXELS, path);
	stored.pixels = rgba;
	if (status == TS_OK) status = compare_pictures(text, &stored, &here);
	free(rgba);
	free(file);
	return status;
}
