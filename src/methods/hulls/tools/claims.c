/* SSAGH's claims, and what tests them. */
#include "methods/hulls/tools/tools.h"

/* clang-format off */
const ts_claim ts_hulls_claims[] = {
	{ "SSAGH", "table 1", "hulls are 5 to 30 times faster than direct, and more so in larger images", "ssagh-1",
	  "direct |gathers of direct", NULL },
	{ "SSAGH", "algorithm 1", "four sweeps part what does not hang together, and more", "ssagh-segments", NULL, NULL },
	{ "SSAGH", "equation 6", "a BRDF that is a Gaussian reflects the lobes specularly, at low frequency",
	  "ssagh-gloss", NULL, NULL },
	{ "SSAGH", "section 5", "lighting is mostly stable under animation, camera and light movement", "ssagh-flicker",
	  NULL, NULL },
	{ "SSAGH", "figure 1", "light is captured at the vertices of a coarse mesh", NULL, NULL,
	  "a sketch; render indirect --method hulls writes the mesh, segments.png, and the light, lobes.png" },
	{ "SSAGH", "figure 2", "a grid without segments shades wrongly at edges in depth", "ssagh-2", "grid", NULL },
	{ "SSAGH", "figure 3", "a constant cosine shades wrongly", "ssagh-3", NULL, NULL },
	{ "SSAGH", "figure 4", "a Gaussian for the cosine has longer tails", "ssagh-4", NULL, NULL },
	{ "SSAGH", "figure 5", "c lies between two cosines, s is what parts them", "ssagh-5", NULL, NULL },
	{ "SSAGH", "figure 6", "logistic curves fit s, with RMSE of 4.38e-11 to 3.8e-3", "ssagh-6", NULL, NULL },
	{ "SSAGH", "figure 7", "the closed form has the least error; a constant cosine errs by up to 4", "ssagh-7", NULL,
	  NULL },
	{ "SSAGH", "figure 8", "pictures of hulls are those of direct, but for few pixels", "ssagh-1",
	  "PSNR|SSIM|RMSE|median", NULL },
	{ 0 },
};
/* clang-format on */
