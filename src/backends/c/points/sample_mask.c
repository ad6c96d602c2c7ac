/* Alpha masks of samples. */
#include "backends/c/points/sample_mask.h"

/* Like ts_k_slot_sample. */
static void find_levels(ts_sample_mask *m, const ts_arrays *scene, f32 area, f32 footprint)
{
	ts_v2 a = m->uv[0], b = m->uv[1], c = m->uv[2];
	const ts_image *image = &scene->images[m->slot->image];
	f32 uv_area = ts_abs(ts_diff_of_products(b.x - a.x, c.y - a.y, b.y - a.y, c.x - a.x));
	u32 last = (image->n_levels - 1) * 256,
		lod = ts_k_texture_lod(image->width, image->height, footprint, uv_area, area);
	if (lod > last) lod = last;
	ts_texture_level level = ts_k_texture_finest(scene, image);
	for (u32 l = lod >> 8; l != 0; l--) level = ts_k_texture_coarser(level);
	m->level[0] = level;
	m->next = lod & 255;
	if (m->next != 0) m->level[1] = ts_k_texture_coarser(level);
}

ts_sample_mask ts_sample_mask_of(const ts_arrays *scene, const ts_align *frame, u32 triangle)
{
	ts_corners t = ts_k_corners(scene, triangle);
	ts_sample s = ts_k_sample(scene, triangle, t.n, t.n, 1.0f / frame->s);
	const ts_vertex *vertex[] = {s.a, s.b, s.c};
	const ts_v3 corner[] = {t.a, t.b, t.c};
	ts_sample_mask m = {.factor = s.material->base[3], .cutoff = s.material->alpha_cutoff};
	if (s.material->slot[0] != TS_NONE) m.slot = &scene->slots[s.material->slot[0]];
	for (u32 k = 0; k < 3; k++) {
		m.corner[k] = ts_k_lattice(ts_load3(frame->c), ts_load3(frame->u), ts_load3(frame->v), frame->s, corner[k]);
		m.alpha[k] = vertex[k]->colour[3];
		if (m.slot != NULL) m.uv[k] = ts_k_slot_uv(m.slot, vertex[k]);
	}
	if (m.slot != NULL) find_levels(&m, scene, s.area, s.footprint);
	return m;
}

static u32 alpha_of(const ts_texture_level *level, ts_v2 uv, const u32 *wrap)
{
	ts_texels at = ts_k_texture_around(level->width, level->height, uv, wrap);
	const u64 *t = level->texels;
	return ts_k_texture_mix4((u32)(t[at.a] >> 48), (u32)(t[at.b] >> 48), (u32)(t[at.c] >> 48), (u32)(t[at.d] >> 48),
	                         at.fx, at.fy);
}

static f32 texture_alpha(const ts_sample_mask *m, ts_v3 w)
{
	const u32 *wrap = m->slot->wrap;
	ts_v2 uv = {ts_blend1(w, m->uv[0].x, m->uv[1].x, m->uv[2].x), ts_blend1(w, m->uv[0].y, m->uv[1].y, m->uv[2].y)};
	uv = ts_v2_make(ts_k_texture_wrap(uv.x, wrap[0]), ts_k_texture_wrap(uv.y, wrap[1]));
	u32 alpha = alpha_of(&m->level[0], uv, wrap);
	if (m->next != 0) alpha = ts_k_texture_mix2(alpha, alpha_of(&m->level[1], uv, wrap), m->next);
	return ts_k_texture_unit(alpha);
}

bool ts_sample_mask_cuts(const ts_sample_mask *m, i32 x, i32 y)
{
	ts_v3 w = ts_k_weights_around(m->corner[0], m->corner[1], m->corner[2], x, y);
	f32 alpha = m->factor * ts_blend1(w, m->alpha[0], m->alpha[1], m->alpha[2]);
	if (m->slot != NULL) alpha = alpha * texture_alpha(m, w);
	return alpha < m->cutoff;
}

#include "backends/selftest.h"
