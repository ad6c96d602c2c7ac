/* Options of a scene by name and text. */
#include "scene/places.h"
#include "model/core.h"
#include "model/decimal.h"

static ts_status take_floats(f32 *to, u32 n, const char *name, const char *text)
{
	char *end = NULL;
	const char *at = text;
	for (u32 i = 0; i < n; i++, at = end + 1) {
		to[i] = ts_strtof(at, &end);
		if (!ts_decimal_plain(at, end) || *end != (i + 1 < n ? ',' : 0))
			return ts_fail("%s: \"%s\" is not %s", name, text, n == 3 ? "X,Y,Z" : "X,Y,Z,R");
	}
	return TS_OK;
}

static ts_status take_text(const char **to, const char *text)
{
	*to = text;
	return TS_OK;
}

static ts_status set_camera(ts_places *p, const char *text) { return take_text(&p->options.camera, text); }
static ts_status set_reflector(ts_places *p, const char *text) { return take_text(&p->options.reflector, text); }
static ts_status set_animation(ts_places *p, const char *text) { return take_text(&p->options.animation, text); }

static ts_status set_eye(ts_places *p, const char *text)
{
	p->options.eye = p->eye;
	return take_floats(p->eye, 3, "eye", text);
}

static ts_status set_target(ts_places *p, const char *text)
{
	p->options.target = p->target;
	return take_floats(p->target, 3, "target", text);
}

static ts_status set_lamp(ts_places *p, const char *text)
{
	p->options.lamp = p->lamp;
	return take_floats(p->lamp, 3, "lamp", text);
}

static ts_status set_mirror(ts_places *p, const char *text)
{
	if (p->options.n_mirrors == TS_MAX_MIRRORS) return ts_fail("mirror: at most %d can be given", TS_MAX_MIRRORS);
	p->options.mirrors = (const f32(*)[4])p->mirrors;
	return take_floats(p->mirrors[p->options.n_mirrors++], 4, "mirror", text);
}

static ts_status set_fov(ts_places *p, const char *text)
{
	(void)text;
	p->options.own_fov = 1;
	return TS_OK;
}

static const struct {
	const char *name;
	ts_status (*set)(ts_places *places, const char *text);
} table[] = {
	{"camera", set_camera},       {"eye", set_eye},       {"target", set_target}, {"fov", set_fov},
	{"reflector", set_reflector}, {"mirror", set_mirror}, {"lamp", set_lamp},     {"animation", set_animation},
};
enum { N = sizeof table / sizeof *table };

static u32 row_of(const char *name)
{
	u32 i = 0;
	while (i < N && strcmp(table[i].name, name) != 0) i++;
	return i;
}

bool ts_place_is(const char *name) { return row_of(name) < N; }

ts_status ts_place_set(ts_places *places, const char *name, const char *text)
{
	u32 row = row_of(name);
	return row < N ? table[row].set(places, text) : ts_fail("%s: no option of a scene", name);
}
