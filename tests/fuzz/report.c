/* libFuzzer on the folders that `report` shows: `make fuzz`. An input is the report.json of a folder with pictures, a
 * plot, a video, and links to a secret beside it. The page is written, or the folder refused; the secret is not in the
 * page. */
#define _GNU_SOURCE /* memmem */
#include <touchstone/image.h>
#include "model/input.h"
#include "report/report.h"
#include "tests/fuzz/folder.h"

static const char *report, *page_path;
static const char secret[] = "c2VjcmV0IHdvcmRz"; /* "secret words" as base64 */

static void begin(void)
{
	static const char *const links[] = {"link.png", "link.svg", "link.mp4"};
	static u8 pixels[12 * 7 * 3];
	fuzz_begin();
	const char *folder = fuzz_name("folder");
	if (mkdir(folder, 0700) != 0 || mkdir(fuzz_name("folder/sub"), 0700) != 0) abort();
	report = fuzz_name("folder/report.json");
	page_path = fuzz_name("page.html");
	const char *outside = fuzz_name("secret");
	fuzz_write(outside, "secret words", 12);
	fuzz_write(fuzz_name("folder/a.svg"), "<svg/>", 6);
	fuzz_write(fuzz_name("folder/a.mp4"), "mp4", 3);
	ts_status status = ts_image_write_png(fuzz_name("folder/epr.png"), pixels, 12, 7, 3, NULL);
	if (status == TS_OK) status = ts_image_write_png(fuzz_name("folder/sub/truth-B.png"), pixels, 12, 7, 3, NULL);
	if (status != TS_OK) abort();
	for (size_t i = 0; i < sizeof links / sizeof *links; i++) {
		char name[32];
		snprintf(name, sizeof name, "folder/%s", links[i]);
		if (symlink(outside, fuzz_name(name)) != 0) abort();
	}
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	char folder[64];
	size_t bytes;
	if (report == NULL) begin();
	fuzz_write(report, data, n);
	snprintf(folder, sizeof folder, "%s/folder", fuzz_root);
	ts_page *page = ts_page_make(67, 4);
	ts_status status = page != NULL ? ts_page_add_folder(page, folder) : TS_ERROR;
	if (status == TS_OK) status = ts_page_write(page, page_path);
	ts_page_free(page);
	if (status != TS_OK) {
		fuzz_refused();
		return 0;
	}
	char *text = ts_input_read(&bytes, page_path, TS_INPUT_ANY);
	bool told = memmem(data, n, secret, sizeof secret - 1) != NULL; /* libFuzzer reads what is compared */
	assert(text != NULL && strlen(text) == bytes && (told || strstr(text, secret) == NULL));
	free(text);
	return 0;
}
