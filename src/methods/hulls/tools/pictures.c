/* Pictures of what hulls are made of (SSAGH section 3): the segments of each block with their boxes, and the lobes at
 * the boxes' corners. */
#include <math.h>
#include <stdio.h>
#include "image/falsecolour.h"
#include "kernels/base/srgb.h"
#include "kernels/hulls/segment_box.h"
#include "kernels/raster/gbuffer.h"
#include "kernels/raster/view.h"
#include "methods/hulls/tools/tools.h"

enum { MOST_PIXELS = 2048, MOST_ACROSS = 3840, MOST_ZOOM = 8 };

/* Pixels per texel of the grid; between blocks one is left black. */
static u32 texel_pixels(const ts_run *run)
{
	return TS_PARAM(&run->params, depth_grid_px) < MOST_PIXELS ? MOST_PIXELS / TS_PARAM(&run->params, depth_grid_px)
	                                                           : 1;
}

static u32 texel_place(u32 texel, u32 pixels) { return texel * pixels + texel / TS_BLOCK + 1; }

/* A rectangle of the picture in parts of 8 of a segment's colour. */
static void paint(ts_stage_picture *p, u32 x0, u32 y0, u32 x1, u32 y1, u32 segment, u32 eighths)
{
	u8 colour[3];
	ts_falsecolour_name(colour, segment);
	for (u32 y = y0; y < y1; y++) {
		for (u32 x = x0; x < x1; x++) {
			for (u32 c = 0; c < 3; c++) p->rgb[3 * ((u64)y * p->width + x) + c] = (u8)(colour[c] * eighths / 8);
		}
	}
}

static ts_status take_segments(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	u32 grid = TS_PARAM(&run->params, depth_grid_px), pixels = texel_pixels(run), side = texel_place(grid, pixels);
	ts_stage_picture *p = ts_stage_pictures_add(pictures, "segments", side, side, false);
	if (p == NULL) return TS_ERROR;
	const u32 *labels = ts_frame_data(&run->frame, id);
	const f32 *depths = ts_frame_data(&run->frame, TS_B_depth_grid_depth);
	for (u32 y = 0; y < grid; y++) {
		for (u32 x = 0; x < grid; x++) {
			u64 i = (u64)y * grid + x;
			u32 x0 = texel_place(x, pixels), y0 = texel_place(y, pixels);
			u32 segment = ts_k_block_of(grid, x, y) * TS_BLOCK_TEXELS + labels[i];
			paint(p, x0, y0, x0 + pixels, y0 + pixels, segment, depths[i] == TS_SKY ? 1 : 4);
		}
	}
	snprintf(p->caption, sizeof p->caption,
	         "depth grid, %u pixels a texel: segments in colours with their boxes, blocks parted, sky dark",
	         (unsigned)pixels);
	return TS_OK;
}

static ts_status take_boxes(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	ts_stage_picture *p = ts_stage_pictures_find(pictures, "segments");
	const ts_segment *boxes = ts_frame_data(&run->frame, id);
	u32 pixels = texel_pixels(run);
	for (u64 b = 0; b < ts_frame_n(&run->frame, id); b++) {
		const ts_segment *box = &boxes[b];
		u32 x0 = texel_place(box->low[0], pixels), x1 = texel_place(box->high[0], pixels) + pixels;
		u32 y0 = texel_place(box->low[1], pixels), y1 = texel_place(box->high[1], pixels) + pixels;
		paint(p, x0, y0, x1, y0 + 1, box->label, 8);
		paint(p, x0, y1 - 1, x1, y1, box->label, 8);
		paint(p, x0, y0, x0 + 1, y1, box->label, 8);
		paint(p, x1 - 1, y0, x1, y1, box->label, 8);
	}
	return TS_OK;
}

enum { LEAST_TEXELS = 24, DISCS_A_BLOCK = 3 }; /* across and down: smallest box that is drawn; discs side by side */

/* Where discs are drawn, and the axes that they face. */
typedef struct {
	ts_stage_picture *picture;
	ts_camera_k view;
	f32 radius; /* of a disc, in pixels */
} canvas;

static void put(ts_stage_picture *p, u64 at, const u8 *rgb)
{
	p->mask[at] = 1;
	memcpy(p->rgb + 3 * at, rgb, 3);
}

/* A disc's pixel (x, y), in units of its radius: all directions, by their angle to the viewer's, which is the
 * middle. */
static void disc_colour(u8 *rgb, const canvas *c, const ts_lobes *lobes, f32 x, f32 y)
{
	f32 r = hypotf(x, y), aside = r > 0 ? ts_sin_turn(r / 2) / r : 0;
	f32 most = ts_max(ts_max(lobes->mu[0], lobes->mu[1]), lobes->mu[2]);
	ts_v3 omega = ts_scale(c->view.back, ts_cos_turn(r / 2));
	omega = ts_mad(omega, c->view.right, aside * x);
	omega = ts_mad(omega, c->view.up, aside * y);
	for (u32 k = 0; k < 3; k++) {
		f32 share = most > 0 ? lobes->mu[k] / most : 0;
		rgb[k] = (u8)ts_srgb_byte(share * expf(lobes->lambda[k] * (ts_dot(omega, ts_load3(lobes->phi + 3 * k)) - 1)));
	}
}

/* The disc that touches the corner (x, y) of a box from within. */
static void draw_disc(const canvas *c, const ts_lobes *lobes, f32 x, f32 y)
{
	i32 reach = (i32)c->radius + 1, width = (i32)c->picture->width, height = (i32)c->picture->height;
	for (i32 j = (i32)y - reach; j <= (i32)y + reach; j++) {
		for (i32 i = (i32)x - reach; i <= (i32)x + reach; i++) {
			f32 dx = ((f32)i + 0.5f - x) / c->radius, dy = (y - (f32)j - 0.5f) / c->radius;
			if (i < 0 || j < 0 || i >= width || j >= height || dx * dx + dy * dy > 1) continue;
			u8 rgb[3];
			disc_colour(rgb, c, lobes, dx, dy);
			put(c->picture, (u64)j * (u32)width + (u64)i, rgb);
		}
	}
}

static void draw_frame(ts_stage_picture *p, u32 x0, u32 y0, u32 x1, u32 y1)
{
	static const u8 frame[3] = {96, 96, 96};
	for (u32 x = x0; x < x1; x++) {
		put(p, (u64)y0 * p->width + x, frame);
		put(p, (u64)(y1 - 1) * p->width + x, frame);
	}
	for (u32 y = y0; y < y1; y++) {
		put(p, (u64)y * p->width + x0, frame);
		put(p, (u64)y * p->width + x1 - 1, frame);
	}
}

static void draw_box(const canvas *c, const ts_segment *box, const ts_lobes *lobes, u32 grid)
{
	ts_stage_picture *p = c->picture;
	if (box->high[0] - box->low[0] + 1 < LEAST_TEXELS || box->high[1] - box->low[1] + 1 < LEAST_TEXELS) return;
	u32 x0 = (u32)((u64)box->low[0] * p->width / grid), x1 = (u32)((u64)(box->high[0] + 1) * p->width / grid);
	u32 y0 = (u32)((u64)box->low[1] * p->height / grid), y1 = (u32)((u64)(box->high[1] + 1) * p->height / grid);
	if (x0 == x1 || y0 == y1) return;
	draw_frame(p, x0, y0, x1, y1);
	for (u32 k = 0; k < 4; k++) {
		f32 x = (k & 1) == 0 ? (f32)x0 + c->radius + 1 : (f32)x1 - c->radius - 1;
		f32 y = (k & 2) == 0 ? (f32)y0 + c->radius + 1 : (f32)y1 - c->radius - 1;
		draw_disc(c, &lobes[k], x, y);
	}
}

static ts_status take_lobes(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	const ts_frame *frame = &run->frame;
	u32 width = TS_PARAM(&run->params, width), height = TS_PARAM(&run->params, height),
		grid = TS_PARAM(&run->params, depth_grid_px);
	u32 zoom = width * MOST_ZOOM < MOST_ACROSS ? MOST_ZOOM : width < MOST_ACROSS ? MOST_ACROSS / width : 1;
	canvas c = {.picture = ts_stage_pictures_add(pictures, "lobes", width * zoom, height * zoom, true)};
	if (c.picture == NULL) return TS_ERROR;
	c.picture->zoom = zoom;
	c.view = ts_k_view(ts_frame_data(frame, TS_B_eye_view));
	c.radius = (f32)((width < height ? width : height) * zoom * TS_BLOCK) / (f32)(grid * 2 * DISCS_A_BLOCK);
	const ts_segment *boxes = ts_frame_data(frame, TS_B_segment_box);
	const ts_lobes *lobes = ts_frame_data(frame, id);
	for (u64 b = 0; b < ts_frame_n(frame, TS_B_segment_box); b++) draw_box(&c, &boxes[b], &lobes[4 * b], grid);
	snprintf(c.picture->caption, sizeof c.picture->caption,
	         "light by direction at corners of larger boxes: middle from the viewer, rim from ahead");
	return TS_OK;
}

const ts_stage_picture_rule ts_hulls_pictures[] = {
	{TS_B_segment_label, take_segments},
	{TS_B_segment_box, take_boxes},
	{TS_B_corner_lobes, take_lobes},
	{.take = NULL},
};
