#include "model/decimal.h"
#include <locale.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
	locale_t c, before;
} visit;

/* Switches to the C locale, on this thread alone. */
static bool enter(visit *v)
{
	v->c = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
	if (v->c == (locale_t)0) return false;
	v->before = uselocale(v->c);
	return true;
}

static void leave(const visit *v)
{
	uselocale(v->before);
	freelocale(v->c);
}

#define READER(type, name, read) \
	type name(const char *text, char **end) \
	{ \
		visit v; \
		if (end != NULL) *end = (char *)text; \
		if (!enter(&v)) return 0; \
		type value = read(text, end); \
		leave(&v); \
		return value; \
	}

READER(float, ts_strtof, strtof)
READER(double, ts_strtod, strtod)

bool ts_decimal_plain(const char *text, const char *end)
{
	return end > text && strspn(text, "+-.0123456789eE") >= (size_t)(end - text);
}
