/* "checkerboard": surfels in a regular grid on a plane that recedes to where its squares are far smaller than a pixel;
 * FIGURES 12 measures filters on it. 64 by 256 m of squares of 1 m; the camera "receding" looks along it. */
#include "scene/build_parts.h"
#include "scene/builtin/builtin.h"
#include "scene/sources.h"
#include "scene/surfel.h"

enum { WIDTH = 64, TIMES = 4 }; /* the ratio of length to width */
#define LIGHT 0.75f
#define DARK 0.0625f

/* Squares lie at whole coordinates. */
bool ts_checkerboard_at(f32 *albedo, f32 x, f32 z)
{
	if (!(ts_abs(x) <= 0.5f * (f32)WIDTH && z <= 0.0f && z >= -(f32)(WIDTH * TIMES))) return false;
	*albedo = ((ts_floor_i32(x) + ts_floor_i32(z)) & 1) == 0 ? LIGHT : DARK;
	return true;
}

/* A surfel has the colour of the square that its centre is in. */
static void add_surfel(ts_build *build, f32 x, f32 z, f32 radius)
{
	static const f32 up[3] = {0.0f, 1.0f, 0.0f};
	f32 albedo = DARK;
	ts_checkerboard_at(&albedo, x, z);
	ts_surfel s = {.centre = {x, 0.0f, z}, .colour = {albedo, albedo, albedo}};
	ts_surfel_circle(&s, up, radius);
	ts_build_surfel(build, &s);
}

/* Columns and rows of equal spacing, as many as `count` allows. */
static void add_grid(ts_build *build, u32 count, f32 splat_radius)
{
	u32 columns = 1;
	while ((columns + 1) * (columns + 1) * TIMES <= count) columns++;
	f32 spacing = (f32)WIDTH / (f32)columns;
	for (u32 row = 0; row < TIMES * columns; row++) {
		for (u32 column = 0; column < columns; column++) {
			f32 x = ((f32)column + 0.5f) * spacing, z = ((f32)row + 0.5f) * spacing;
			add_surfel(build, x - (f32)WIDTH * 0.5f, -z, spacing * splat_radius);
		}
	}
	ts_builtin_camera(build, "receding", ts_v3_make(0.0f, 2.0f, 0.0f), 0.125f);
	build->scene->is_checkerboard = true;
}

const ts_builtin ts_builtin_checkerboard = {
	.info = {"checkerboard", "surfels in a regular grid on a plane of squares that recedes before a camera"},
	.surfels = add_grid,
	.camera = "receding",
};
