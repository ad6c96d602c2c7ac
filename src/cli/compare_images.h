/* Comparing two images. */
#ifndef TS_CLI_COMPARE_IMAGES_H
#define TS_CLI_COMPARE_IMAGES_H
#include "cli.h"

/* PNG or EXR files cli->arguments, value by value, with the relaxations of cli; prints the first pixel that differs,
 * how many values do, and the root mean square of their differences. */
ts_status ts_compare_images(const ts_cli *cli);

#endif
