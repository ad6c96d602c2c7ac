/* The families, in the order in which their rows stand in the tables of the engines. */
#include "tools.h"
#include "../methods/tools/family.h"

extern const ts_family_tools ts_points_tools;

static const ts_family_tools *const families[] = {&ts_points_tools};
enum { N_FAMILIES = sizeof families / sizeof *families };

void ts_tools_begin(void)
{
	static const ts_tie_rule *ties[N_FAMILIES + 1];
	u32 n_ties = 0;
	for (u32 i = 0; i < N_FAMILIES; i++) {
		if (families[i]->ties != NULL) ties[n_ties++] = families[i]->ties;
	}
	ts_tie_use(ties);
}
