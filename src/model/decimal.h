/* Decimal numbers in texts: with a point, whatever the host program's locale. */
#ifndef TS_MODEL_DECIMAL_H
#define TS_MODEL_DECIMAL_H

#include <stdbool.h>
#ifdef __cplusplus
extern "C" {
#endif

/* As strtof and strtod of C's own locale; without memory no number is found, and *end is text. end may be NULL. */
float ts_strtof(const char *text, char **end);
double ts_strtod(const char *text, char **end);
/* Whether the text before `end` has digits, signs, a point and an exponent alone, as numbers are typed: they also read
 * blanks, 0x10 and inf. */
bool ts_decimal_plain(const char *text, const char *end);

#ifdef __cplusplus
}
#endif
#endif
