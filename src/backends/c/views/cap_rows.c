/* The texels of a cap, from the coarsest level on. The terms of ts_k_cap_inside per column and per row are computed
 * once each. Rounded sums do not fall as a term grows, so a row has no texel inside if its best column is not
 * inside. */
#include "backends/c/views/cap_rows.h"
#include "backends/wide.h"

/* The terms of ts_k_cap_inside along one axis, for n texels of a level from `first` on; and the greatest. */
typedef struct {
	u32 first, n;
	f32 most, part[TS_MOST_SIDE];
} parts;

/* A level: terms per column and per row; whether any texel is inside; the margin for rounding. */
typedef struct {
	parts columns, rows;
	bool any;
	f32 slack;
} level_parts;

static void find_parts(parts *p, const f32 *middle, f32 y, f32 b, u32 level, ts_reach reach)
{
	u32 last = (1u << level) - 1;
	f32 bent = level == 0 ? b : ts_max(b, 0.0f);
	p->first = (u32)reach.from >> level;
	p->n = (((u32)reach.to - 1) >> level) - p->first + 1;
	for (u32 k = 0; k < p->n; k++) {
		const f32 *from = middle + ((p->first + k) << level);
		p->part[k] = ts_k_cap_least(y, bent, from[0], from[last]);
		p->most = k == 0 ? p->part[0] : ts_max(p->most, p->part[k]);
	}
}

static inline bool is_inside(const ts_cap *cap, f32 column, f32 row, f32 slack)
{
	return (cap->c + (column + row)) - slack >= 0.0f;
}

static void find_level(level_parts *p, const ts_cap_sides *sides, const ts_cap *cap, const ts_cap_box *box, u32 level)
{
	find_parts(&p->columns, sides->middle, cap->y, cap->b, level, box->x);
	find_parts(&p->rows, sides->middle, cap->z, cap->b, level, box->y);
	p->slack = level == 0 ? 0.0f : cap->rounding;
	p->any = is_inside(cap, p->columns.most, p->rows.most, p->slack);
}

/* Fills those of n texels that are inside. */
TS_WIDE(void, fill_row, (u64 *restrict texels, const f32 *restrict part, u32 n, f32 c, f32 row, f32 slack, u64 key),
        (texels, part, n, c, row, slack, key))
{
	for (u32 k = 0; k < n; k++) {
		f32 inside = (c + (part[k] + row)) - slack;
		u64 nearest = key < texels[k] ? key : texels[k];
		texels[k] = inside >= 0.0f ? nearest : texels[k];
	}
}

/* Like fill_row, but skips texels below one that is inside. */
static void fill_below(u64 *texels, const level_parts *p, const level_parts *above, u32 row, const ts_cap *cap, u64 key)
{
	f32 part = p->rows.part[row], part_above = above->rows.part[((p->rows.first + row) >> 1) - above->rows.first];
	for (u32 k = 0; k < p->columns.n; k++) {
		f32 over = above->columns.part[((p->columns.first + k) >> 1) - above->columns.first];
		if (is_inside(cap, over, part_above, above->slack)) continue;
		if (is_inside(cap, p->columns.part[k], part, p->slack)) texels[k] = key < texels[k] ? key : texels[k];
	}
}

static void fill_level(u64 *texels, u32 width, const level_parts *p, const level_parts *above, const ts_cap *cap,
                       u64 key)
{
	const parts *columns = &p->columns, *rows = &p->rows;
	for (u32 row = 0; row < rows->n; row++) {
		u64 *first = texels + (rows->first + row) * width + columns->first;
		if (!is_inside(cap, columns->most, rows->part[row], p->slack)) continue;
		if (above != NULL) fill_below(first, p, above, row, cap, key);
		if (above == NULL) fill_row(first, columns->part, columns->n, cap->c, rows->part[row], p->slack, key);
	}
}

void ts_cap_sides_set(ts_cap_sides *sides, const ts_pyramid *pyramid)
{
	sides->pyramid = *pyramid;
	for (u32 level = 0; level < pyramid->levels; level++) sides->before[level] = ts_k_pyramid_first(pyramid, level);
	for (u32 i = 0; i < pyramid->n; i++) sides->middle[i] = ts_k_paraboloid_middle(i, pyramid->n);
}

void ts_cap_rows_fill(u64 *map, const ts_cap_sides *sides, const ts_cap *cap, bool back, u64 key)
{
	ts_cap_box box = ts_k_cap_box(cap, sides->pyramid.n);
	level_parts level[2], *above = NULL;
	if (box.x.from >= box.x.to || box.y.from >= box.y.to) return;
	for (u32 l = sides->pyramid.levels; l-- > 0;) {
		u32 width = sides->pyramid.n >> l;
		level_parts *here = &level[l & 1];
		find_level(here, sides, cap, &box, l);
		if (here->any) fill_level(map + sides->before[l] + (back ? width * width : 0), width, here, above, cap, key);
		above = here->any ? here : NULL;
	}
}

#include "backends/selftest.h"
