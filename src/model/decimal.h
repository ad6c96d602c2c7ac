/* Decimal numbers in texts: with a point, whatever the host program's locale. */
#ifndef TS_MODEL_DECIMAL_H
#define TS_MODEL_DECIMAL_H

#ifdef __cplusplus
extern "C" {
#endif

/* As strtof and strtod of C's own locale; without memory no number is found, and *end is text. end may be NULL. */
float ts_strtof(const char *text, char **end);
double ts_strtod(const char *text, char **end);

#ifdef __cplusplus
}
#endif
#endif
