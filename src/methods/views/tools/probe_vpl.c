/* A virtual point light or particle that a pixel draws: its origin and its contribution. */
#include <inttypes.h>
#include <stdlib.h>
#include "kernels/views/particle.h"
#include "methods/stages.h"
#include "methods/views/tools/probe.h"
#include "methods/views/views.h"

/* Each path begins at a texel, and its lights exist. */
static ts_status check_paths(const ts_probe *p, const ts_probe_gather *g)
{
	u64 n_offsets = ts_probe_n(p, TS_B_vpl_offset);
	const char *path = p->trace->item[TS_B_vpl_path].path;
	if (n_offsets != g->vpl.n_patches + 1 || (g->n_paths > 0 && g->vpl.n_patches == 0)) {
		return ts_fail("%s: one a texel of the maps and one would be right", p->trace->item[TS_B_vpl_offset].path);
	}
	for (u64 i = 0; i <= g->n_paths; i++) {
		u32 least = i > 0 ? g->paths[i - 1] : 0, most = i < g->n_paths ? g->args.n_lights : least;
		if (g->paths[i] >= least && g->paths[i] <= (i > 0 ? g->args.n_lights : 0)) continue;
		return ts_fail("%s: element %" PRIu64 " is %u; %u to %u would be right", path, i, (unsigned)g->paths[i],
		               (unsigned)least, (unsigned)most);
	}
	if (g->paths[g->n_paths] == g->args.n_lights) return TS_OK;
	return ts_fail("%s: ends at %u; there are %u lights", path, (unsigned)g->paths[g->n_paths],
	               (unsigned)g->args.n_lights);
}

ts_status ts_probe_read_paths(ts_probe *p, ts_probe_gather *g)
{
	u64 n = ts_probe_n(p, TS_B_vpl_path);
	if (!ts_probe_makes(p, TS_B_vpl_path)) return TS_OK;
	u32 *offset = ts_probe_whole(p, TS_B_vpl_offset);
	g->paths = offset != NULL ? ts_probe_whole(p, TS_B_vpl_path) : NULL;
	if (g->paths == NULL || ts_probe_read_lamps(p, TS_PROBE_A_VIEW, &g->lamps) != TS_OK) return TS_ERROR;
	if (n == 0) return ts_fail("%s: one more than there are paths would be right", p->trace->item[TS_B_vpl_path].path);
	g->n_paths = n - 1;
	if (ts_vpl_ask(&p->load->run, &g->vpl) != TS_OK) return TS_ERROR;
	g->vpl.offset = offset;
	g->vpl.paths = g->paths;
	g->vpl.n = (u32)g->n_paths;
	if (check_paths(p, g) != TS_OK) return TS_ERROR;
	g->vpl.n_lit = offset[g->vpl.n_patches];
	return TS_OK;
}

/* The path of a light: the last that does not begin after the light. */
static u32 path_of(const ts_probe_gather *g, u32 light)
{
	u32 low = 0, high = g->vpl.n - 1;
	while (low < high) {
		u32 middle = low + (high - low + 1) / 2;
		if (g->paths[middle] <= light)
			low = middle;
		else
			high = middle - 1;
	}
	return low;
}

/* Where a path begins: at a texel of a lamp's map, or at random on a triangle. */
static ts_status put_start(ts_probe *p, json_t *start, const ts_probe_gather *g, u32 path)
{
	if (g->vpl.areas == NULL) {
		u32 texel = (u32)ts_k_vpl_start(&g->vpl, path);
		return ts_probe_put_patch(p, start, &g->lamps, texel, &g->vpl.patches[texel]);
	}
	ts_probe_put_triangle(p, start, ts_k_vpl_surface(&g->vpl, path));
	ts_probe_put(p, start, "weights", ts_probe_v3(ts_k_vpl_weights(&g->vpl, path)));
	return TS_OK;
}

/* Follows the path again, up to the light. */
static ts_status put_path(ts_probe *p, json_t *o, const ts_probe_gather *g, u32 light, ts_vpl *made)
{
	u32 path = path_of(g, light), triangle = TS_NONE;
	ts_light_k at = ts_k_vpl_first(&g->vpl, path);
	json_t *start = json_object();
	ts_status status = put_start(p, start, g, path);
	for (u32 k = g->paths[path]; k < light; k++) {
		triangle = ts_k_cast(&g->vpl.cast, at.p, ts_k_vpl_direction(&g->vpl, path, at.bounce, at.n)).triangle;
		if (!ts_k_vpl_next(&g->vpl, path, &at)) break;
	}
	ts_k_vpl_store(made, &at);
	ts_probe_put(p, o, "path", ts_probe_int(path));
	ts_probe_put(p, o, "bounce", ts_probe_int(at.bounce));
	if (triangle != TS_NONE) ts_probe_put_triangle(p, o, triangle);
	ts_probe_put(p, o, "begins_at", start);
	return status;
}

static ts_status make_particle(ts_probe *p, u32 particle, ts_vpl *made)
{
	ts_particle_args args = ts_particle_values(&p->load->run);
	args.lights = ts_alloc_zero(particle + (size_t)1, sizeof *args.lights, "particles");
	if (args.lights == NULL) return TS_ERROR;
	ts_k_particle_item(&args, particle);
	*made = args.lights[particle];
	free(args.lights);
	return TS_OK;
}

static ts_status put_light(ts_probe *p, json_t *o, const ts_probe_gather *g, u32 light)
{
	ts_vpl made;
	const ts_vpl *held = &g->args.lights[light];
	ts_status status = g->paths != NULL ? put_path(p, o, g, light, &made) : make_particle(p, light, &made);
	if (status != TS_OK) return status;
	ts_probe_put(p, o, "leaf", ts_probe_int(g->args.leaves[light]));
	ts_probe_put(p, o, "position", ts_probe_v3(ts_load3(held->position)));
	if (g->paths != NULL) ts_probe_put(p, o, "normal", ts_probe_v3(ts_load3(held->normal)));
	ts_probe_put(p, o, "flux", ts_probe_v3_bits(ts_load3(held->flux)));
	ts_probe_put_record_check(p, o, TS_B_vpl_light, &made, held);
	return TS_OK;
}

/* Whether the surface in a texel is far enough away, and if not, too near the tangent plane. */
static void put_tests(ts_probe *p, json_t *o, const ts_probe_gather *g, u32 light, u32 texel, u64 shown)
{
	const ts_vpl_gather_args *args = &g->args;
	u32 leaf = args->leaves[light];
	f32 map = ts_u2f((u32)(shown >> 32));
	ts_v3 at = ts_load3(args->lights[light].position), centre = ts_load3(args->nodes[leaf].centre);
	ts_v3 place = ts_load3(g->pixel.position), n = ts_load3(g->pixel.normal), way = ts_sub(place, at);
	f32 reach = ts_k_vpl_reach(args, light, shown, texel, place, n), d = ts_length(way);
	ts_probe_put(p, o, "map", ts_probe_bits(map));
	ts_probe_put(p, o, "moved_to_the_light", ts_probe_bits(ts_k_moved_depth(centre, map, at, texel, args->n)));
	ts_probe_put(p, o, "bias", ts_probe_bits(ts_k_vpl_slack(args, way, n)));
	ts_probe_put(p, o, "free", json_real((double)reach - (double)d));
	if (args->by_plane == 0 || d <= reach) return;
	ts_probe_put(p, o, "above_the_plane", ts_probe_bits(ts_k_node_height(&args->scene[(u32)shown], place, n)));
	ts_probe_put(p, o, "clear_from", ts_probe_bits(ts_k_vpl_clear(args, &args->scene[(u32)shown])));
}

/* The result from the map of the light's leaf, with all inputs. */
static ts_status put_question(ts_probe *p, json_t *object, const ts_probe_gather *g, u32 light, ts_v3 way)
{
	json_t *o = json_object();
	ts_status status = TS_OK;
	ts_v3 place = ts_load3(g->pixel.position), n = ts_load3(g->pixel.normal);
	u32 side = g->args.n, leaf = g->args.leaves[light], texel = ts_k_paraboloid_texel(way, side);
	u64 shown = ts_k_vpl_shown(&g->args, light, texel);
	ts_probe_put(p, o, "half", json_string(texel < side * side ? "front" : "back"));
	ts_probe_put(p, o, "texel", ts_probe_pair(texel % side, texel / side % side));
	if ((u32)shown == TS_NONE) {
		ts_probe_put(p, o, "answer", json_string("lit: the texel is empty"));
	} else {
		bool lit = ts_k_vpl_reaches(&g->args, light, texel, place, n);
		put_tests(p, o, g, light, texel, shown);
		ts_probe_put(p, o, "answer", json_string(lit ? "lit" : "in shadow"));
		status = ts_probe_put_pair(p, o, leaf, texel);
	}
	ts_probe_put(p, object, "shadow", o);
	return status;
}

ts_status ts_probe_vpl(ts_probe *p, json_t *o, const ts_probe_gather *g, u32 light)
{
	if (put_light(p, o, g, light) != TS_OK) return TS_ERROR;
	ts_v3 from = ts_load3(g->args.lights[light].normal), n = ts_load3(g->pixel.normal);
	ts_v3 way = ts_sub(ts_load3(g->pixel.position), ts_load3(g->args.lights[light].position)), d = ts_normalize(way);
	f32 near = g->args.near * ts_k_leaf_side(&g->args), form = ts_k_vpl_form(way, from, n, near);
	ts_probe_put(p, o, "distance", ts_probe_bits(ts_length(way)));
	if (ts_length(way) < near) ts_probe_put(p, o, "taken_as", ts_probe_bits(near));
	ts_probe_put(p, o, "leaves_by", ts_probe_bits(ts_k_vpl_leaves(d, from)));
	ts_probe_put(p, o, "arrives_by", ts_probe_bits(-ts_dot(d, n)));
	ts_probe_put(p, o, "geometry", ts_probe_bits(form));
	if (form > 0.0f && g->args.shadows != 0) return put_question(p, o, g, light, way);
	ts_probe_put(p, o, "shadow", json_string(form > 0.0f ? "not asked" : "turned away"));
	return TS_OK;
}
