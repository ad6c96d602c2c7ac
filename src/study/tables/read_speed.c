/* Reads what `bench speed` measures. */
#include <string.h>
#include "study/tables/reader.h"

/* METHOD,... of the effect. */
static void take_methods(ts_table_reader *r, ts_speed_scene *scene)
{
	u32 n = 0;
	for (char *word = ts_cursor_word(&r->c, "methods"), *next; word != NULL; word = next) {
		next = strchr(word, ',');
		if (next != NULL) *next++ = 0;
		if (r->c.status == TS_OK && ts_pipeline_find(scene->effect, word) == NULL)
			ts_cursor_wrong(&r->c, word, "no method \"%s\" of %s; `touchstone list methods` lists all", word,
			                scene->effect);
		scene->methods[ts_take_next(r, &n, TS_SPEED_METHODS, "methods")] = word;
	}
}

/* `NAME = EFFECT METHODS SCENE` */
static ts_speed_scene take_scene(ts_table_reader *r)
{
	ts_speed_scene scene = {.name = ts_cursor_key(&r->c, "a name"), .set = ""};
	for (u32 i = 0; i < r->texts->n_scenes; i++)
		if (strcmp(r->texts->scenes[i].name, scene.name) == 0)
			ts_cursor_wrong(&r->c, scene.name, "the frame \"%s\" stands above", scene.name);
	ts_cursor_expect(&r->c, "=");
	scene.effect = ts_take_effect(r);
	take_methods(r, &scene);
	scene.spec = ts_cursor_word(&r->c, "a scene");
	return scene;
}

/* `[NAME=VALUE,...]` */
static const char *take_set(ts_table_reader *r, const char *word)
{
	if (*word != 0) ts_check_set(r, word, false);
	return word;
}

/* `frame NAME = EFFECT METHODS SCENE [model] [rays] [points] [NAME=VALUE,...]` */
void ts_take_frame(ts_table_reader *r)
{
	ts_speed_scene scene = take_scene(r);
	const struct {
		const char *name;
		bool *flag;
	} flags[] = {{"model", &scene.model}, {"rays", &scene.rays}, {"points", &scene.points}};
	const char *word = ts_cursor_more(&r->c);
	for (u32 i = 0; i < sizeof flags / sizeof *flags; i++) {
		if (strcmp(word, flags[i].name) != 0) continue;
		*flags[i].flag = true;
		word = ts_cursor_more(&r->c);
	}
	scene.set = take_set(r, word);
	r->texts->scenes[ts_take_next(r, &r->texts->n_scenes, MOST_FRAMES, "frames")] = scene;
}

static const ts_speed_own *find_own(const char *name)
{
	const ts_speed_own *own = ts_speed_owns;
	while (own->name != NULL && strcmp(own->name, name) != 0) own++;
	return own->name != NULL ? own : NULL;
}

/* What stands behind the name of a scene: a figure of `bench speed`, of a method, or of the scene. */
static ts_status find_behind(const ts_table_reader *r, ts_speed_name *name, const char *behind)
{
	static const char *const truths[] = {NULL};
	const ts_speed_scene *scene = &r->texts->scenes[name->scene];
	ts_name_scope scope = {scene->methods, truths, 0, r->texts->lists, r->texts->n_lists, false};
	while (scene->methods[scope.n_variants] != NULL) scope.n_variants++;
	name->own = find_own(behind);
	return name->own != NULL ? TS_OK : ts_name_find(&name->figure, &scope, behind);
}

static ts_status find_name(const ts_table_reader *r, ts_speed_name *name, const char *text)
{
	const size_t n = strcspn(text, ".");
	*name = (ts_speed_name){.scene = TS_NONE};
	if (strcmp(text, "threads") == 0) return TS_OK;
	for (u32 i = 0; i < r->texts->n_scenes && text[n] == '.'; i++)
		if (strncmp(r->texts->scenes[i].name, text, n) == 0 && r->texts->scenes[i].name[n] == 0) name->scene = i;
	if (name->scene == TS_NONE) return ts_fail("%s: begins with no frame above, and is not \"threads\"", text);
	return find_behind(r, name, text + n + 1);
}

static ts_status term_of(void *user, const char *text, size_t n, ts_term *term)
{
	ts_table_reader *r = user;
	ts_speed_of *speed = &r->texts->speed;
	if (speed->n_names == MOST_NAMES) return ts_fail("more than %d names", MOST_NAMES);
	*term = (ts_term){.kind = TS_TERM_MEASURED, .at = speed->n_names};
	return find_name(r, &r->texts->speed_names[speed->n_names++], ts_keep_name(r, text, n));
}

static ts_speed_bound take_bound(ts_table_reader *r, double *goal)
{
	const char *word = ts_cursor_more(&r->c);
	if (strcmp(word, "=") == 0) return TS_SPEED_SHOWN;
	if (strcmp(word, "at") != 0) ts_cursor_wrong(&r->c, word, "\"at most\", \"at least\" or \"=\" is expected");
	word = ts_cursor_more(&r->c);
	bool least = strcmp(word, "least") == 0;
	if (!least && strcmp(word, "most") != 0) ts_cursor_wrong(&r->c, word, "\"most\" or \"least\" is expected");
	*goal = ts_cursor_number(&r->c);
	ts_cursor_expect(&r->c, "=");
	return least ? TS_SPEED_LEAST : TS_SPEED_MOST;
}

/* `speed "TEXT" "UNIT" DECIMALS [at most N|at least N] = EXPRESSION` */
void ts_take_speed(ts_table_reader *r)
{
	const char *at;
	ts_table_texts *texts = r->texts;
	ts_speed_figure figure = {.text = ts_cursor_word(&r->c, "a text"), .terms = texts->terms + texts->n_terms};
	figure.unit = ts_cursor_word(&r->c, "a unit");
	figure.decimals = ts_take_decimals(r);
	figure.bound = take_bound(r, &figure.goal);
	const char *expression = ts_cursor_rest(&r->c, "an expression");
	if (r->c.status != TS_OK) return;
	figure.n_terms = MOST_TERMS - texts->n_terms;
	if (ts_expression_read(texts->terms + texts->n_terms, &figure.n_terms, expression, &at, term_of, r) != TS_OK)
		ts_cursor_wrong(&r->c, at, "%s", ts_error_message());
	texts->n_terms += figure.n_terms;
	texts->figures[ts_take_next(r, &texts->n_figures, MOST_SPEEDS, "figures of speed")] = figure;
}

/* `growth NAME = EFFECT METHODS SCENE PARAMETER VALUE,... STAGES "CALLED" [NAME=VALUE,...]` */
void ts_take_growth(ts_table_reader *r)
{
	ts_speed_growth growth = {.of = take_scene(r)};
	growth.param = ts_cursor_word(&r->c, "a parameter, size, threads or -");
	bool other = strcmp(growth.param, "size") == 0 || strcmp(growth.param, "threads") == 0;
	const char *spec = growth.of.spec;
	if (strcmp(growth.param, "-") == 0) {
		if (r->c.status == TS_OK && spec[strlen(spec) - 1] != '=')
			ts_cursor_wrong(&r->c, spec, "\"%s\" takes no value: its end is no \"=\"", spec);
	} else if (!other && r->c.status == TS_OK && !ts_name_is_param(growth.param)) {
		ts_cursor_wrong(&r->c, growth.param, "no parameter \"%s\"", growth.param);
	}
	growth.values = ts_cursor_word(&r->c, "values");
	const char *list = ts_cursor_word(&r->c, "a list of stages");
	for (u32 i = 0; i < r->texts->n_lists; i++)
		if (strcmp(r->texts->lists[i].name, list) == 0) growth.stages = r->texts->lists[i].items;
	if (growth.stages == NULL) ts_cursor_wrong(&r->c, list, "no list of stages \"%s\" above", list);
	growth.called = ts_cursor_word(&r->c, "what these stages are called");
	growth.of.set = take_set(r, ts_cursor_more(&r->c));
	r->texts->growths[ts_take_next(r, &r->texts->n_growths, MOST_GROWTHS, "growths")] = growth;
}
