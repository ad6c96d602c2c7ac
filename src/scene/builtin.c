/* The built-in scenes by name: reading "atrium:triangles=1.05M", choosing the detail that gives the count, building.
 * The detail is found by bisection over the same code that builds, in counting mode; what is left goes to one part. */
#include <stdio.h>
#include "../core/core.h"
#include "builtin.h"
#include "sources.h"

enum { ATRIUM, GALLERY, DINING, N_SCENES };
enum { LEAST = 10000, MOST = 3000000, USUAL = 300000 };

static const ts_builtin_info table[N_SCENES] = {
	[ATRIUM] = {"atrium", "a colonnaded court of two storeys with hanging cloth, plants and flags; open to the sky"},
	[GALLERY] = {"gallery", "a hall of pictures under a skylight, cabinets behind doorways, benches, a bicycle"},
	[DINING] = {"dining", "a dining room: laid table, chairs, blinds, shelves of books, fireplace, chandelier"},
};

static const ts_builtin *const scenes[N_SCENES] = {
	[ATRIUM] = &ts_builtin_atrium,
	[GALLERY] = &ts_builtin_gallery,
	[DINING] = &ts_builtin_dining,
};

const ts_builtin_info *ts_builtin_table(size_t *n)
{
	*n = N_SCENES;
	return table;
}

void ts_builtin_names(char *text, size_t text_bytes)
{
	size_t used = 0;
	for (u32 i = 0; i < N_SCENES && used < text_bytes; i++) {
		const char *between = i == 0 ? "" : i + 1 < N_SCENES ? ", " : " and ";
		used += (size_t)snprintf(text + used, text_bytes - used, "%s%s", between, table[i].name);
	}
}

static const ts_builtin *find(const char *spec)
{
	size_t length = strcspn(spec, ":");
	for (u32 i = 0; i < N_SCENES; i++)
		if (strlen(table[i].name) == length && memcmp(table[i].name, spec, length) == 0) return scenes[i];
	return NULL;
}

bool ts_builtin_is(const char *spec) { return find(spec) != NULL; }

/* Digits, perhaps with a fraction, and perhaps k or M; counted in integers. False if it is none or more than ten digits
 * long. */
static bool read_count(u64 *count, const char *text)
{
	u64 value = 0, scale = 1;
	u32 digits = 0;
	bool fraction = false;
	for (; (*text >= '0' && *text <= '9') || (*text == '.' && !fraction); text++) {
		if (*text == '.') {
			fraction = true;
			continue;
		}
		if (++digits > 10) return false;
		value = value * 10 + (u64)(*text - '0');
		if (fraction) scale *= 10;
	}
	if (*text == 'k') value *= 1000;
	if (*text == 'M') value *= 1000000;
	if (*text == 'k' || *text == 'M') text++;
	*count = value / scale;
	return digits > 0 && *text == '\0';
}

static bool read_spec(u32 *count, ts_build *build, const char *spec)
{
	static const char key[] = ":triangles=";
	const char *options = spec + strcspn(spec, ":");
	u64 wanted = USUAL;
	bool known = *options == '\0' || strncmp(options, key, sizeof key - 1) == 0;
	bool number = *options == '\0' || (known && read_count(&wanted, options + sizeof key - 1));
	*count = (u32)wanted;
	if (!known) {
		ts_build_fail(build, "%s: unknown option \"%s\"; write NAME or NAME:triangles=COUNT", spec, options + 1);
	} else if (!number) {
		ts_build_fail(build, "%s: \"%s\" is no count; write digits, perhaps with k or M, as in triangles=1.05M", spec,
					  options + sizeof key - 1);
	} else if (wanted < LEAST || wanted > MOST) {
		ts_build_fail(build, "%s: %llu triangles are out of range; %d to %d", spec, (unsigned long long)wanted, LEAST,
					  MOST);
		return false;
	}
	return known && number;
}

static u64 count_at(const ts_builtin *scene, const u32 *material, f32 detail, u32 seed)
{
	ts_mesh mesh = {.seed = seed, .detail = detail, .place = ts_place_world()};
	scene->shape(&mesh, material);
	return mesh.n;
}

/* The greatest detail whose shapes leave a part in 32 of the count to the filler. */
static f32 find_detail(const ts_builtin *scene, const u32 *material, u32 count, u32 seed)
{
	u64 limit = count - count / 32u;
	f32 low = 0.0f, high = 16.0f;
	for (u32 k = 0; k < 20; k++) {
		f32 middle = (low + high) * 0.5f;
		if (count_at(scene, material, middle, seed) <= limit)
			low = middle;
		else
			high = middle;
	}
	return low;
}

void ts_builtin_make(ts_build *build, const char *spec, u32 seed)
{
	const ts_builtin *scene = find(spec);
	u32 material[TS_MAX_PAINTS] = {0}, count;
	if (!read_spec(&count, build, spec)) return;
	for (u32 i = 0; i < scene->n_paints; i++)
		material[i] = ts_paint_add(build, &scene->paints[i], seed + 1000u * i);
	ts_mesh mesh = {
		.build = build, .seed = seed, .detail = find_detail(scene, material, count, seed), .place = ts_place_world()};
	scene->shape(&mesh, material);
	mesh.place = ts_place_world();
	mesh.material = material[scene->rug.material];
	ts_part_rug(&mesh, &scene->rug, (u32)(count - mesh.n));
}

ts_status ts_builtin_open(ts_scene **scene, const char *spec, const ts_params *params, const char *camera)
{
	char names[128];
	*scene = NULL;
	ts_builtin_names(names, sizeof names);
	if (!ts_builtin_is(spec)) return ts_fail("\"%s\" is no built-in scene; there are %s", spec, names);
	ts_build *build = ts_build_new(spec);
	if (build == NULL) return TS_ERROR;
	ts_builtin_make(build, spec, params->seed);
	ts_reflectors_add(build, params, camera);
	return ts_build_finish(build, params, camera, scene);
}
