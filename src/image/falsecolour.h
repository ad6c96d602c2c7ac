/* Colours for figures and names, for pictures that people look at; never hashed. */
#ifndef TS_IMAGE_FALSECOLOUR_H
#define TS_IMAGE_FALSECOLOUR_H
#include <stdint.h>

/* A ramp of rising lightness, dark blue over green to pale yellow. t: 0 to 1, clamped; NaN is 0. */
void ts_falsecolour_ramp(uint8_t rgb[3], double t);
/* A bright colour that differs between neighbouring names. */
void ts_falsecolour_name(uint8_t rgb[3], uint32_t name);

#endif
