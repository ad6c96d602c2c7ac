/* Text for files, gathered in memory first. glibc's own streams in memory silently lose bytes when memory ends. */
#define _GNU_SOURCE
#include <stdlib.h>
#include <string.h>
#include "output/file.h"

static ssize_t append(void *user, const char *data, size_t bytes)
{
	ts_file_text *text = user;
	void *grown = text->text;
	if (ts_grow(&grown, &text->capacity, text->bytes + bytes + 1, 1, "text") != TS_OK) return 0;
	text->text = grown;
	memcpy(text->text + text->bytes, data, bytes);
	text->bytes += bytes;
	text->text[text->bytes] = 0;
	return (ssize_t)bytes;
}

ts_status ts_file_text_begin(ts_file_text *text, const char *what)
{
	*text = (ts_file_text){.out = NULL};
	text->out = fopencookie(text, "w", (cookie_io_functions_t){.write = append});
	return text->out != NULL ? TS_OK : ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", what);
}

void ts_file_text_drop(ts_file_text *text)
{
	fclose(text->out);
	free(text->text);
	*text = (ts_file_text){.out = NULL};
}

ts_status ts_file_text_flush(ts_file_text *text, const char *what)
{
	return fflush(text->out) == 0 && ferror(text->out) == 0 ? TS_OK
	                                                        : ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", what);
}

ts_status ts_file_text_close(ts_file_text *text, const char *what)
{
	bool whole = fflush(text->out) == 0 && ferror(text->out) == 0 && append(text, "", 0) == 0 && text->text != NULL;
	whole &= fclose(text->out) == 0;
	text->out = NULL;
	if (whole) return TS_OK;
	free(text->text);
	*text = (ts_file_text){.out = NULL};
	return ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", what);
}

typedef ts_status writer(const char *path, const void *data, size_t bytes);

static ts_status end(ts_file_text *text, const char *path, writer *write)
{
	if (ts_file_text_close(text, path) != TS_OK) return TS_ERROR;
	ts_status status = write(path, text->text, text->bytes);
	free(text->text);
	*text = (ts_file_text){.out = NULL};
	return status;
}

static ts_status print(const char *path, const void *data, size_t bytes)
{
	(void)path;
	return ts_file_print(data, bytes);
}

ts_status ts_file_text_write(ts_file_text *text, const char *path) { return end(text, path, ts_file_write); }
ts_status ts_file_text_replace(ts_file_text *text, const char *path) { return end(text, path, ts_file_replace); }
ts_status ts_file_text_print(ts_file_text *text) { return end(text, "standard output", print); }
