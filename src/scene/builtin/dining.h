/* Shared by the files of the built-in scene "dining". */
#ifndef TS_SCENE_BUILTIN_DINING_H
#define TS_SCENE_BUILTIN_DINING_H
#include "scene/builtin/mesh.h"

enum {
	D_PARQUET,
	D_PAPER,
	D_CEILING,
	D_TRIM,
	D_WALNUT,
	D_MAHOGANY,
	D_OAK,
	D_LINEN,
	D_SEAT,
	D_CURTAIN,
	D_BLIND,
	D_PORCELAIN,
	D_GLASS,
	D_BOTTLE,
	D_SILVER,
	D_BRASS,
	D_SHADE,
	D_WAX,
	D_APPLE,
	D_ORANGE,
	D_POT,
	D_SOIL,
	D_STEM,
	D_LEAF,
	D_GILT,
	D_MARBLE,
	D_SOOT,
	D_BOOK,
	D_RUG,
	D_VASE,
	D_PICTURE,
	D_PICTURE_2,
	D_PICTURE_3,
	D_N_PAINTS,
};

/* The table on the floor at mesh->place, long along x, laid for eight, with its chairs. */
void ts_dining_table(ts_mesh *mesh, const u32 *material);
/* A chair whose sitter looks to -z. */
void ts_dining_chair(ts_mesh *mesh, const u32 *material);
/* A candle with its flame and its stick, of this height in metres. */
void ts_dining_candle(ts_mesh *mesh, const u32 *material, f32 height);
/* A branched light on a chain from mesh->place down. */
void ts_dining_chandelier(ts_mesh *mesh, const u32 *material);
/* A bowl of fruit. */
void ts_dining_fruit(ts_mesh *mesh, const u32 *material);

#endif
