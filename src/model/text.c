/* Untrusted text on its way out. */
#include "model/core.h"

void ts_line_clean(char *text)
{
	for (unsigned char *c = (unsigned char *)text; *c != 0; c++) {
		bool c1 = c[0] == 0xc2 && c[1] >= 0x80 && c[1] <= 0x9f;
		if (c1) c[1] = '?';
		if (c1 || *c < 0x20 || *c == 0x7f) *c = '?';
	}
}
