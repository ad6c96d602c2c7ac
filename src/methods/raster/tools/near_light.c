/* Pixels near a triangle of light: the image is quartered down to small parts, each with those triangles whose balls
 * meet the box about its places. */
#include <stdlib.h>
#include "kernels/base/records.h"
#include "methods/raster/tools/tools.h"
#include "study/picture.h"

enum { SMALL = 8 }; /* pixels per side of parts that are not quartered */

typedef struct {
	double middle[3], square; /* of the side */
} ball;

typedef struct {
	const ts_gpixel *pixels;
	u64 width;
	ball *balls; /* in any order */
	u8 *near, *elsewhere;
} work;

typedef struct {
	u64 x, y, right, bottom; /* columns and rows before these */
} part;

typedef struct {
	double low[3], high[3];
} box;

static bool is_sky(const ts_gpixel *pixel) { return pixel->depth == 1.0f; }

/* False if there is only sky. */
static bool box_of(box *found, const work *w, const part *a)
{
	bool any = false;
	for (u64 y = a->y; y < a->bottom; y++) {
		for (u64 x = a->x; x < a->right; x++) {
			const ts_gpixel *pixel = &w->pixels[y * w->width + x];
			if (is_sky(pixel)) continue;
			for (int c = 0; c < 3; c++) {
				double at = (double)pixel->position[c];
				if (!any || at < found->low[c]) found->low[c] = at;
				if (!any || at > found->high[c]) found->high[c] = at;
			}
			any = true;
		}
	}
	return any;
}

/* The box may be a point. */
static bool meets(const ball *b, const box *of)
{
	double square = 0;
	for (int c = 0; c < 3; c++) {
		double below = of->low[c] - b->middle[c], above = b->middle[c] - of->high[c];
		double apart = below > 0 ? below : above > 0 ? above : 0;
		square += apart * apart;
	}
	return square <= b->square;
}

/* Moves the balls that meet the box to the front; returns their number. */
static u64 choose(ball *balls, u64 n, const box *of)
{
	u64 first = 0;
	for (u64 k = 0; k < n; k++) {
		if (!meets(&balls[k], of)) continue;
		ball met = balls[k];
		balls[k] = balls[first];
		balls[first++] = met;
	}
	return first;
}

static void mark_pixels(const work *w, const part *a, u64 n)
{
	for (u64 y = a->y; y < a->bottom; y++) {
		for (u64 x = a->x; x < a->right; x++) {
			u64 i = y * w->width + x, k = 0;
			const part one = {x, y, x + 1, y + 1};
			box place;
			if (!box_of(&place, w, &one)) continue;
			while (k < n && !meets(&w->balls[k], &place)) k++;
			w->near[i] = k < n;
			w->elsewhere[i] = k == n;
		}
	}
}

static void mark(const work *w, const part *a, u64 n)
{
	box of;
	if (!box_of(&of, w, a)) return;
	n = choose(w->balls, n, &of);
	if (n == 0 || (a->right - a->x <= SMALL && a->bottom - a->y <= SMALL)) {
		mark_pixels(w, a, n);
		return;
	}
	u64 x = (a->x + a->right + 1) / 2, y = (a->y + a->bottom + 1) / 2;
	const part quarters[] = {
		{a->x, a->y, x, y}, {x, a->y, a->right, y}, {a->x, y, x, a->bottom}, {x, y, a->right, a->bottom}};
	for (int k = 0; k < 4; k++) mark(w, &quarters[k], n);
}

/* Texels that reflect no light have no triangle. */
static u64 take_balls(ball *balls, const ts_patch *patches, u64 n_patches)
{
	u64 n = 0;
	for (u64 k = 0; k < n_patches; k++) {
		const ts_patch *p = &patches[k];
		ball b = {.square = 0};
		for (int c = 0; c < 3; c++) {
			double side = (double)p->b[c] - (double)p->a[c];
			b.middle[c] = ((double)p->a[c] + (double)p->b[c] + (double)p->c[c]) / 3;
			b.square += side * side;
		}
		if (b.square > 0) balls[n++] = b;
	}
	return n;
}

ts_status ts_near_light_mark(ts_picture *picture, const ts_run *run)
{
	if (!run->frame.buffer[TS_B_rsm_patch].made || !run->frame.buffer[TS_B_gbuffer_pixel].made) return TS_OK;
	const part all = {0, 0, TS_PARAM(&run->params, width), TS_PARAM(&run->params, height)};
	u64 n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch), n = all.right * all.bottom;
	picture->near = ts_alloc_zero(n, 1, "a picture");
	picture->elsewhere = ts_alloc_zero(n, 1, "a picture");
	work w = {.pixels = ts_frame_data(&run->frame, TS_B_gbuffer_pixel),
	          .width = all.right,
	          .balls = ts_alloc(n_patches, sizeof(ball), "the triangles of light"),
	          .near = picture->near,
	          .elsewhere = picture->elsewhere};
	bool room = w.near != NULL && w.elsewhere != NULL && w.balls != NULL;
	if (room) mark(&w, &all, take_balls(w.balls, ts_frame_data(&run->frame, TS_B_rsm_patch), n_patches));
	free(w.balls);
	return room ? TS_OK : TS_ERROR;
}
