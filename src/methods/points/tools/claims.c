/* What EPR and iVIR show, and who asks it. */
#include "benches.h"

/* clang-format off */
const ts_claim ts_points_claims[] = {
	{ "EPR", "table 1", "EPR shades 4 to 104 times less often than MVR", "epr-1", NULL, NULL },
	{ "EPR", "table 2", "EPR is 1.4 to 6.7 times faster than MVR, its errors are as small", "epr-2", "iVIR|time|RMSE",
	  NULL },
	{ "EPR", "table 3", "shadows all around a light take fewer points than iVIR's", "epr-3", NULL, NULL },
	{ "EPR", "figure 1", "reflections of 50 mirrors, of one bounce and two", "epr-2", "time", NULL },
	{ "EPR", "figure 2", "the stages", NULL, NULL, "a sketch; `list methods` has the stages" },
	{ "EPR", "figure 3", "the way of light from a triangle by a mirror", NULL, NULL,
	  "a sketch; tests/kernels/points/density.c asks for its lengths" },
	{ "EPR", "figure 4", "the stages of deferred shading", NULL, NULL, "a sketch; `list methods` has the stages" },
	{ "EPR", "figure 5", "further bounces take more shading", "epr-2", "frame", NULL },
	{ "EPR", "figure 6", "errors fall with density; adaptive sampling brings nothing", "epr-6", "RMSE by", NULL },
	{ "EPR", "figure 7", "reflections by MVR, EPR and iVIR look alike", "epr-2", "RMSE", NULL },
	{ "EPR", "figure 8", "close views differ little to the eye", NULL, NULL,
	  "HDR-VDP2 is not at hand; figure 7 is asked by RMSE" },
	{ "EPR", "figure 9", "the shadow of a triangle", NULL, NULL,
	  "a sketch; tests/kernels/points/shadow_density.c asks for its distances" },
	{ "EPR", "figure 10", "shadows by MVR, iVIR and EPR look alike", "epr-3", "RMSE", NULL },
	{ "iVIR", "table 1", "soft shadows take fewer points than VIR's and less time than MVR", "ivir-1",
	  "iVIR|the same|points|they|frame", NULL },
	{ "iVIR", "table 2", "environment maps take a tenth of VIR's points", "ivir-2", "iVIR", NULL },
	{ "iVIR", "table 3", "shadows all around a light take fewer points than VIR's", "ivir-3", "iVIR|speed", NULL },
	{ "iVIR", "figure 1", "pictures of the three effects", NULL, NULL,
	  "nothing is compared; figures 4, 6 and 7 are asked" },
	{ "iVIR", "figure 2", "a pixel's area on a triangle", NULL, NULL,
	  "a sketch; tests/kernels/points/view_density.c asks for its rate" },
	{ "iVIR", "figure 3", "stochastic culling is hardly seen", "ivir-1", "RMSE by stochastic", NULL },
	{ "iVIR", "figure 4", "soft shadows by iVIR look as those by VIR", "ivir-1", "RMSE to", NULL },
	{ "iVIR", "figure 5", "16 views of iVIR are better than PCSS", "ivir-5", NULL, NULL },
	{ "iVIR", "figure 6", "reflections by iVIR look as those by VIR", "ivir-2", "RMSE", NULL },
	{ "iVIR", "figure 7", "shadows all around by iVIR look as those by VIR", "ivir-3", "RMSE", NULL },
	{ 0 },
};
/* clang-format on */
