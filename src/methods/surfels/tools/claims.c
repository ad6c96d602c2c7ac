/* The claims of the slides on surface splatting, and what tests them. */
#include "methods/surfels/tools/tools.h"

#define FILTER "nv40-filter"
#define SHADING "nv40-shading"

/* clang-format off */
const ts_claim ts_surfels_claims[] = {
	{ "NV40", "Perspectively Correct Rendering", "surfels are rasterized as rays see them", "nv40-discs", NULL,
	  NULL },
	{ "NV40", "Per-Pixel Phong Shading", "shading of pixels keeps highlights that flat and Gouraud's lose", SHADING,
	  "dB|SSIM", NULL },
	{ "NV40", "Phong Shading for PBR", "normals are splatted, and shaded once a pixel", SHADING,
	  "shading operations a pixel", NULL },
	{ "NV40", "3-Pass Shading", "shading before blending shades every fragment", SHADING, "shading operations, Phong",
	  NULL },
	{ "NV40", "3-Pass Deferred Shading", "shading behind blending shades every pixel", SHADING,
	  "shading operations a pixel", NULL },
	{ "NV40", "Deferred Shading", "7 fragments a pixel, one shading operation, whatever the shader", "nv40",
	  "shading|the same without the screen|the same of NPR|rate of NPR", NULL },
	{ "NV40", "Required GPU Features", "several render targets, blending of floats", NULL, NULL,
	  "names what hardware must have; Floating Point Precision is asked" },
	{ "NV40", "Floating Point Precision", "sums of 8 bits fail, those of half floats do not", FILTER,
	  "dB that 8|dB that half|dB that floats", NULL },
	{ "NV40", "EWA Filtering", "exact EWA removes aliasing", FILTER, "dB of the lesser radius over exact", NULL },
	{ "NV40", "Object-Space Filter Only", "without a screen filter there is aliasing", FILTER,
	  "dB of the lesser radius over the object|SSIM", NULL },
	{ "NV40", "Approximate EWA Filtering", "the lesser radius is near exact EWA, by 30 fragments a pixel", "nv40",
	  "fragments", NULL },
	{ "NV40", "Phong Shading", "pictures of models with Phong shading", SHADING, "dB, deferred over flat", NULL },
	{ "NV40", "NPR Shading", "pictures of models with other shading, as fast", "nv40",
	  "rate of NPR|the same with shadows|the same of NPR", NULL },
	{ "NV40", "Timings & Comparison", "15 to 23 million splats a second, with shadows two thirds", "nv40", "rate",
	  NULL },
	{ 0 },
};
/* clang-format on */
