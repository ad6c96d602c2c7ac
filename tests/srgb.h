/* The sRGB curve as IEC 61966-2-1 states it, of values from 0 to 1: the truth for what src computes by tables. */
#ifndef TS_TESTS_SRGB_H
#define TS_TESTS_SRGB_H
#include <math.h>

static inline long double srgb_decoded(long double code)
{
	return code <= 0.04045L ? code / 12.92L : powl((code + 0.055L) / 1.055L, 2.4L);
}

static inline double srgb_encoded(double linear)
{
	return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

#endif
