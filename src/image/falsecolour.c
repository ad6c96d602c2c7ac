/* Colours for figures and names. */
#include "image/falsecolour.h"
#include "kernels/base/num.h"

static const uint8_t ramp[][3] = {
	{18, 12, 52}, {34, 48, 112}, {26, 96, 130}, {30, 140, 120}, {92, 180, 84}, {182, 208, 66}, {252, 240, 160},
};
enum { LAST = sizeof ramp / sizeof ramp[0] - 1 };

void ts_falsecolour_ramp(uint8_t rgb[3], double t)
{
	double x = t > 0 ? (t < 1 ? t : 1) * LAST : 0;
	int i = x < LAST ? (int)x : LAST - 1;
	for (int c = 0; c < 3; c++) {
		rgb[c] = (uint8_t)(ramp[i][c] + (x - i) * (ramp[i + 1][c] - ramp[i][c]) + 0.5);
	}
}

void ts_falsecolour_name(uint8_t rgb[3], uint32_t name)
{
	u32 h = ts_pcg(name);
	u32 weak = h % 3u; /* one channel stays low, so colours are saturated */
	for (u32 c = 0; c < 3; c++) {
		u32 byte = (h >> (8u + 8u * c)) & 255u;
		rgb[c] = (uint8_t)(c == weak ? byte / 4 + 16 : byte / 2 + 128);
	}
}
