/* The claims of MegaViews, and what tests them. */
#include "methods/views/tools/tools.h"

/* clang-format off */
const ts_claim ts_views_claims[] = {
	{ "MegaViews", "figure 1", "views share most of what is rendered", "mega-10",
	  "views that share|pairs of ManyLoDs", NULL },
	{ "MegaViews", "figure 2", "two hierarchies, and what becomes of pairs", NULL, NULL,
	  "a sketch; `list methods` has the stages" },
	{ "MegaViews", "figure 3", "a cone holds the directions of a node's views", NULL, NULL,
	  "a sketch; tests/kernels/views/view_octree.c asks for it" },
	{ "MegaViews", "figure 4", "how pairs are culled", "mega-10",
	  "RMSE to the image without culling|pairs that culling", NULL },
	{ "MegaViews", "figure 5", "culling loses nothing that a view of the node sees", "mega-10",
	  "RMSE to the image without culling", NULL },
	{ "MegaViews", "figure 6", "what is shared is what each view renders", "mega-15", "dB less ManyLoDs", NULL },
	{ "MegaViews", "figure 7", "views beside the middle of a node see a place in another texel", NULL, NULL,
	  "a sketch; tests/kernels/views/pair.c counts such texels" },
	{ "MegaViews", "figure 8", "which node of a pair is divided", NULL, NULL,
	  "a rule; tests/methods/views/traverse.c asks for it" },
	{ "MegaViews", "figure 9", "texels of large leaves are filled, in a view in colour", "mega-9", NULL, NULL },
	{ "MegaViews", "figure 10", "time, pairs and memory grow slower than views, a tenth of ManyLoDs' at last",
	  "mega-10", NULL, NULL },
	{ "MegaViews", "figure 10, four bounces", "the same of views that are less clustered", "mega-10-bounces", NULL,
	  NULL },
	{ "MegaViews", "figure 11", "views at random in the scene are rendered four times slower", "mega-11", NULL, NULL },
	{ "MegaViews", "figure 12", "twice the side takes four times the time, and less is shared", "mega-12", NULL, NULL },
	{ "MegaViews", "figure 13", "flatter octrees are faster, and coarser", "mega-13", NULL, NULL },
	{ "MegaViews", "figure 14", "many small maps are better than few large ones", "mega-14", NULL, NULL },
	{ "MegaViews", "figure 15", "maps of 64 texels are much better than those of 16; ManyLoDs is hardly better",
	  "mega-15", NULL, NULL },
	{ "MegaViews", "figure 16", "culling lights makes less noise", "mega-16", NULL, NULL },
	{ "MegaViews", "figure 17", "particles have shadows", "mega-17", NULL, NULL },
	{ "MegaViews", "figure 17, times", "particles share less than lights on walls, and take half of ManyLoDs' time",
	  "mega-particles", NULL, NULL },
	{ 0 },
};
/* clang-format on */
