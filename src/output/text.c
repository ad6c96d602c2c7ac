/* Text for files, gathered in memory first. */
#include "file.h"
#include <stdlib.h>

ts_status ts_file_text_begin(ts_file_text *text, const char *what)
{
	*text = (ts_file_text){.out = NULL};
	text->out = open_memstream(&text->text, &text->bytes);
	return text->out != NULL ? TS_OK : ts_fail("%s: out of memory", what);
}

void ts_file_text_drop(ts_file_text *text)
{
	fclose(text->out);
	free(text->text);
	*text = (ts_file_text){.out = NULL};
}

ts_status ts_file_text_close(ts_file_text *text, const char *what)
{
	bool whole = ferror(text->out) == 0;
	whole &= fclose(text->out) == 0;
	text->out = NULL;
	if (whole && text->text != NULL && ts_starved_check(what) == TS_OK) return TS_OK;
	free(text->text);
	*text = (ts_file_text){.out = NULL};
	return ts_fail("%s: out of memory", what);
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
