/* Comparing two images. */
#ifndef TS_CLI_COMPARE_IMAGES_H
#define TS_CLI_COMPARE_IMAGES_H
#include "cli/cli.h"

/* Compares the image files cli->arguments, value by value, with the relaxations and tolerances of cli. Reports the
 * number of values and pixels that differ, the first of them, the greatest difference and the root mean square of all.
 * A picture of display values (PNG, JPEG) and one of linear radiance (EXR) are compared only with --exposure, as
 * display values. */
ts_status ts_compare_images(ts_cli *cli);

#endif
