/* `touchstone info`: what was loaded, and which parts of the file were not understood, as text or JSON. */
#include <errno.h>
#include <inttypes.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include "kernels/base/num.h"
#include "model/core.h"
#include "output/json/text.h"
#include "scene/scene.h"
#include "scene/surfel.h"

static uint64_t scene_bytes(const ts_scene *s)
{
	return s->n_vertices * (u64)sizeof *s->vertices + s->n_triangles * (u64)sizeof *s->triangles +
	       s->n_materials * (u64)sizeof *s->materials + s->n_slots * (u64)sizeof *s->slots +
	       s->n_images * (u64)sizeof *s->images + s->n_texels * sizeof *s->texels +
	       s->n_lights * (u64)sizeof *s->lights + s->n_objects * (u64)sizeof *s->objects +
	       s->n_surfels * (u64)sizeof *s->surfels;
}

/* Every figure once, for both formats. */
typedef struct {
	const char *name;
	uint64_t value;
	const char *doc;
} figure;
enum { N_FIGURES = 14 };

static void figures_of(figure *f, const ts_scene *s)
{
	const figure all[N_FIGURES] = {
		{"triangles", s->n_triangles, "with the added reflectors"},
		{"triangles_own", s->n_triangles_file, "without them"},
		{"triangles_degenerate", s->n_degenerate, "of these; they have no area and are dropped"},
		{"vertices", s->n_vertices, ""},
		{"objects", s->n_objects, "the static scene, each reflector and what the file moves"},
		{"reflectors", s->info.n_reflectors, ""},
		{"materials", s->n_materials, ""},
		{"texture_references", s->n_slots, ""},
		{"images", s->n_images, ""},
		{"texels", s->n_texels, "with mip levels"},
		{"surfels", s->n_surfels, ""},
		{"lights", s->n_lights, ""},
		{"cameras", s->n_cameras, ""},
		{"bytes", scene_bytes(s), "of the scene's arrays"},
	};
	memcpy(f, all, sizeof all);
}

static const char *const light_kinds[] = {"directional", "point", "spot"};

/* The value, or NULL without memory: a part of it is `bad`. */
static json_t *whole(json_t *value, int bad)
{
	if (bad == 0) return value;
	json_decref(value);
	return NULL;
}

static json_t *json_floats(const f32 *values, size_t n)
{
	json_t *array = json_array();
	int bad = 0;
	for (size_t i = 0; i < n; i++) bad |= json_array_append_new(array, json_real((double)values[i]));
	return whole(array, bad);
}

static json_t *json_lights(const ts_scene *s)
{
	json_t *array = json_array();
	int bad = 0;
	for (u32 i = 0; i < s->n_lights; i++) {
		const ts_light *l = &s->lights[i];
		json_t *light =
			json_pack("{s:s, s:o, s:o, s:o}", "kind", light_kinds[l->kind], "position", json_floats(l->position, 3),
		              "direction", json_floats(l->direction, 3), "intensity", json_floats(l->intensity, 3));
		bad |= json_array_append_new(array, light);
	}
	return whole(array, bad);
}

static json_t *json_nodes(const ts_scene *s)
{
	json_t *list = json_array();
	int bad = 0;
	for (u32 i = 0; i < s->n_nodes; i++) {
		json_t *node = json_pack("{s:o, s:I}", "name", ts_text_json(s->nodes[i].name), "triangles",
		                         (json_int_t)s->nodes[i].n_triangles);
		bad |= json_array_append_new(list, node);
	}
	return whole(list, bad);
}

static json_t *json_cameras(const ts_scene *s)
{
	json_t *list = json_array();
	int bad = 0;
	for (u32 i = 0; i < s->n_cameras; i++) bad |= json_array_append_new(list, ts_text_json(s->cameras[i].name));
	return whole(list, bad);
}

static json_t *json_notes(const ts_scene *s)
{
	json_t *list = json_array();
	int bad = 0;
	for (u32 i = 0; i < s->n_notes; i++) bad |= json_array_append_new(list, ts_text_json(s->notes[i]));
	return whole(list, bad);
}

static json_t *json_of(const ts_scene *s, const f32 *radius)
{
	figure f[N_FIGURES];
	json_t *root = json_object();
	int bad = json_object_set_new(root, "scene", ts_text_json(s->name));
	figures_of(f, s);
	for (size_t i = 0; i < N_FIGURES; i++) {
		bad |= json_object_set_new(root, f[i].name, json_integer((json_int_t)f[i].value));
	}
	bad |= json_object_set_new(root, "box_min", json_floats(s->info.box_min, 3));
	bad |= json_object_set_new(root, "box_max", json_floats(s->info.box_max, 3));
	bad |= json_object_set_new(root, "origin", json_pack("[f, f, f]", s->origin[0], s->origin[1], s->origin[2]));
	bad |= json_object_set_new(root, "hall_min", json_floats(s->info.hall_min, 2));
	bad |= json_object_set_new(root, "hall_max", json_floats(s->info.hall_max, 2));
	bad |= json_object_set_new(root, "ambient", json_real((double)s->info.ambient));
	bad |= json_object_set_new(root, "light", json_lights(s));
	bad |= json_object_set_new(root, "camera", json_cameras(s));
	bad |= json_object_set_new(root, "eye", s->camera == TS_NONE ? json_string("circling") : json_integer(s->camera));
	bad |= json_object_set_new(root, "nodes", json_nodes(s));
	bad |= json_object_set_new(root, "notes", json_notes(s));
	if (s->n_surfels > 0) {
		bad |= json_object_set_new(root, "surfel_radius", json_floats(radius, TS_SURFEL_QUANTILES));
	}
	return whole(root, bad);
}

static ts_status print_json(const ts_scene *scene, FILE *out)
{
	f32 radius[TS_SURFEL_QUANTILES];
	if (scene->n_surfels > 0 && ts_surfel_quantiles(radius, scene->surfels, scene->n_surfels) != TS_OK) return TS_ERROR;
	json_t *root = json_of(scene, radius);
	if (root == NULL) return ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", scene->name);
	int failed = json_dumpf(root, out, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
	json_decref(root);
	if (failed && !ferror(out)) return ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", scene->name);
	fputc('\n', out);
	return TS_OK;
}

/* Cleans names, which come from files. */
static ts_status print_name(FILE *out, const char *name)
{
	char *line = strdup(name);
	if (!line) return ts_fail_as(TS_KIND_MEMORY, "no memory to print a name of %zu bytes", strlen(name));
	ts_line_clean(line);
	fputs(line, out);
	free(line);
	return TS_OK;
}

static void print_range(FILE *out, const char *what, f32 low, f32 high)
{
	fprintf(out, "  %-21s %g to %g\n", what, (double)low, (double)high);
}

static void print_bounds(const ts_info *info, FILE *out)
{
	print_range(out, "box x", info->box_min[0], info->box_max[0]);
	print_range(out, "box y", info->box_min[1], info->box_max[1]);
	print_range(out, "box z", info->box_min[2], info->box_max[2]);
	print_range(out, "hall x", info->hall_min[0], info->hall_max[0]);
	print_range(out, "hall z", info->hall_min[1], info->hall_max[1]);
}

static ts_status print_surfels(const ts_scene *s, FILE *out)
{
	f32 r[TS_SURFEL_QUANTILES];
	if (s->n_surfels == 0) return TS_OK;
	if (ts_surfel_quantiles(r, s->surfels, s->n_surfels) != TS_OK) return TS_ERROR;
	fprintf(out, "  %-21s %g to %g, quartiles %g %g %g; the longer half-axis\n", "surfel radius", (double)r[0],
	        (double)r[4], (double)r[1], (double)r[2], (double)r[3]);
	return TS_OK;
}

static void print_lights(const ts_scene *s, FILE *out)
{
	fprintf(out, "  ambient               %g\n", (double)s->info.ambient);
	for (u32 i = 0; i < s->n_lights; i++) {
		const ts_light *l = &s->lights[i];
		fprintf(out, "  light %-4u            %s, intensity %g %g %g\n", i, light_kinds[l->kind],
		        (double)l->intensity[0], (double)l->intensity[1], (double)l->intensity[2]);
	}
}

static ts_status print_cameras(const ts_scene *s, FILE *out)
{
	for (u32 i = 0; i < s->n_cameras; i++) {
		fprintf(out, "  camera %-4u           ", i);
		if (print_name(out, s->cameras[i].name) != TS_OK) return TS_ERROR;
		fprintf(out, "%s\n", i == s->camera ? " (chosen)" : "");
	}
	if (s->camera == TS_NONE) fputs("  eye                   circling\n", out);
	return TS_OK;
}

/* Names for --reflector. */
static ts_status print_nodes(const ts_scene *s, FILE *out)
{
	enum { MOST = 20 };
	for (u32 i = 0; i < s->n_nodes && i < MOST; i++) {
		fprintf(out, "  node                  %12" PRIu64 "  triangles: ", s->nodes[i].n_triangles);
		if (print_name(out, s->nodes[i].name) != TS_OK) return TS_ERROR;
		fputc('\n', out);
	}
	if (s->n_nodes > MOST) fprintf(out, "  %u more nodes; as JSON all are listed\n", s->n_nodes - MOST);
	return TS_OK;
}

static ts_status print_text(const ts_scene *s, FILE *out)
{
	figure f[N_FIGURES];
	figures_of(f, s);
	if (print_name(out, s->name) != TS_OK) return TS_ERROR;
	fputc('\n', out);
	for (size_t i = 0; i < N_FIGURES; i++)
		fprintf(out, "  %-21s %12" PRIu64 "%s%s\n", f[i].name, f[i].value, *f[i].doc ? "  " : "", f[i].doc);
	print_bounds(&s->info, out);
	if (print_surfels(s, out) != TS_OK) return TS_ERROR;
	print_lights(s, out);
	if (print_cameras(s, out) != TS_OK || print_nodes(s, out) != TS_OK) return TS_ERROR;
	for (u32 i = 0; i < s->n_notes; i++) fprintf(out, "  note: %s\n", s->notes[i]);
	return TS_OK;
}

ts_status ts_scene_print(const ts_scene *scene, FILE *out, int json)
{
	if (TS_LACKS(scene) || TS_LACKS(out)) return TS_ERROR;
	ts_floats_hold(1);
	ts_status status = json ? print_json(scene, out) : print_text(scene, out);
	ts_floats_give();
	if (status == TS_OK && fflush(out) != 0) {
		return ts_fail_as(TS_KIND_FILE, "%s: its description cannot be written: %s", scene->name, strerror(errno));
	}
	return status == TS_OK && ferror(out) ? ts_fail("%s: its description cannot be written", scene->name) : status;
}
