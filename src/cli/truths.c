/* The ground truths, and reading their names. */
#include "truths.h"
#include <string.h>
#include <strings.h>

enum { ALL = (1 << TS_N_TRUTHS) - 1, EACH = 1 << TS_N_TRUTHS }; /* EACH: nothing was named */

const ts_truth_kind ts_truth_kinds[TS_N_TRUTHS] = {
	[TS_AT_A] = { "A", "truth-a", "rays from the cube's centre", "sampling", "reflections" },
	[TS_AT_B] = { "B", "truth-b", "true reflections", "both", "reflections" },
	[TS_AT_C] = { "C", "truth-c", "MVR at 4 times the resolution", "", "reflections" },
	[TS_AT_SAMPLES] = { "samples", "truth-samples", "rays to the very samples of the lights", "method", "shadows" },
	[TS_AT_AREA] = { "area", "truth-area", "rays to as good as the whole lights", "both", "shadows" },
	[TS_AT_LIGHTS] = { "lights", "truth-lights", "the method's triangles of light, where they are seen", "", "indirect" },
	[TS_AT_BOUNCE] = { "bounce", "truth-bounce", "light after one bounce, path by path", "", "indirect" },
	[TS_AT_VPLS] = { "vpls", "truth-vpls", "all virtual point lights, where they are seen", "method", "indirect" },
	[TS_AT_GLOW] = { "glow", "truth-glow", "all particles, where they are seen", "method", "particles" },
	[TS_AT_DISCS] = { "discs", "truth-discs", "rays into the surfels themselves", "method", "surfels" },
	[TS_AT_SURFACE] = { "surface", "truth-surface", "rays into what surfels are samples of", "both", "surfels" },
};

static bool is_of(const ts_truth_kind *kind, const char *effect) { return strstr(effect, kind->of) != NULL; }

/* Its bit; 0: there is none. */
static u32 find(const char *name)
{
	for (u32 i = 0; i < TS_N_TRUTHS; i++) {
		if (strcasecmp(name, ts_truth_kinds[i].name) == 0) return 1u << i;
	}
	return 0;
}

ts_status ts_truths_parse(u32 *truths, const char *text)
{
	char item[16];
	*truths = text == NULL ? ALL | EACH : 0;
	if (text == NULL || strcmp(text, "none") == 0) return TS_OK;
	for (const char *list = text; ts_cli_item(&list, item, sizeof item);) {
		u32 bit = find(item);
		if (bit == 0) {
			return ts_fail("--truth %s: \"%s\" is no truth; there are A, B and C of reflections, samples and area of "
			               "shadows, lights, bounce and vpls of indirect, glow of particles, discs and surface of surfels, "
			               "or none", text, item);
		}
		*truths |= bit;
	}
	return TS_OK;
}

static const char *names_of(const char *effect)
{
	if (strcmp(effect, "particles") == 0) return "is glow";
	if (strcmp(effect, "surfels") == 0) return "are discs and surface";
	if (strcmp(effect, "indirect") == 0) return "are lights, bounce and vpls";
	return strcmp(effect, "reflections") == 0 ? "are A, B and C" : "are samples and area";
}

ts_status ts_truths_check(u32 *truths, const char *effect)
{
	bool each = (*truths & EACH) != 0;
	for (u32 i = 0; i < TS_N_TRUTHS; i++) {
		const ts_truth_kind *kind = &ts_truth_kinds[i];
		if ((*truths & 1u << i) == 0 || is_of(kind, effect)) continue;
		if (!each) {
			return ts_fail("--truth %s: no truth of %s; there %s, or none", kind->name, effect, names_of(effect));
		}
		*truths &= ~(1u << i);
	}
	*truths &= ALL;
	return TS_OK;
}

bool ts_truths_named(const char *text)
{
	char item[16];
	bool any = text[0] != 0;
	while (any && text != NULL && ts_cli_item(&text, item, sizeof item)) any = find(item) != 0;
	return any;
}
