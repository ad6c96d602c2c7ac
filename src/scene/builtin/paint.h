/* Textures of the built-in scenes: a painter computes one point of a material, and the material's maps are made of such
 * points. All arithmetic is of integers and ts_ functions, so the texels are the same everywhere. */
#ifndef TS_SCENE_BUILTIN_PAINT_H
#define TS_SCENE_BUILTIN_PAINT_H
#include "kernels/base/scene.h"
#include "scene/build.h"

/* One point of a material. Colour: sRGB-coded, 0 to 1. Height: metres over the surface. */
typedef struct {
	ts_v3 colour;
	f32 alpha, height, roughness, metallic, occlusion, glow;
} ts_dab;

/* (u, v) in [0,1), v down; the picture must repeat. `kind` chooses among a painter's variants. */
typedef void ts_painter(ts_dab *dab, f32 u, f32 v, u32 kind, u32 seed);

/* stone.c, fabric.c, picture.c. */
ts_painter ts_paint_ashlar, ts_paint_tiles, ts_paint_plaster, ts_paint_marble, ts_paint_terracotta, ts_paint_parquet,
	ts_paint_wood, ts_paint_soil, ts_paint_metal;
ts_painter ts_paint_weave, ts_paint_carpet, ts_paint_wallpaper, ts_paint_leather, ts_paint_leaf, ts_paint_shade,
	ts_paint_book;
ts_painter ts_paint_picture;
enum { TS_N_PICTURES = 8 };

/* Maps beside the base colour. */
enum { TS_MAP_NORMAL = 1, TS_MAP_SURFACE = 2 /* occlusion, roughness, metallic */, TS_MAP_GLOW = 4 };

typedef struct {
	ts_painter *painter; /* NULL: no texture */
	u32 kind, size;      /* variant; texels a side */
	f32 tile[2];         /* metres that one image covers along s and t */
	u32 maps;
	u32 flags;               /* TS_DOUBLE_SIDED, TS_MASKED */
	ts_v3 base;              /* linear factor */
	f32 roughness, metallic; /* factors */
} ts_paint;

/* clang-format off */
#define TS_WHITE {1.0f, 1.0f, 1.0f}
/* clang-format on */

/* Adds the material and its images; returns its index. */
u32 ts_paint_add(ts_build *build, const ts_paint *paint, u32 seed);

/* Value noise in [0,1] over a lattice that repeats every `period` cells. */
f32 ts_paint_noise(f32 x, f32 y, u32 period_x, u32 period_y, u32 seed);
/* A sum of octaves of ts_paint_noise, each of twice the frequency and half the weight; (u, v) in [0,1). */
f32 ts_paint_fbm(f32 u, f32 v, u32 period, u32 octaves, u32 seed);
/* Uniform in [0,1), by cell and seed. */
f32 ts_paint_hash(i32 x, i32 y, u32 seed);
/* x less its floor. */
f32 ts_paint_fract(f32 x);
/* 0 below lo, 1 above hi, smooth between. */
f32 ts_paint_ramp(f32 lo, f32 hi, f32 x);
/* a at t = 0, b at t = 1. */
ts_v3 ts_paint_mix(ts_v3 a, ts_v3 b, f32 t);

#endif
