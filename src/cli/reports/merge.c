/* `merge DIR...`: checks that the folders are the shards of one run, each given once. */
#include "cli/reports/merge.h"
#include <stdlib.h>
#include <string.h>

static int by_index(const void *a, const void *b)
{
	const ts_part *x = a, *y = b;
	return (x->index > y->index) - (x->index < y->index);
}

static const char *text_of(const ts_part *part, const char *key)
{
	return json_string_value(json_object_get(part->shard, key));
}

/* The first word that only one of them has; "" if one has no more. */
static const char *other_word(const json_t *words, const json_t *others)
{
	for (size_t i = 0; i < json_array_size(words); i++) {
		if (!json_equal(json_array_get(words, i), json_array_get(others, i))) {
			return json_string_value(json_array_get(words, i));
		}
	}
	return "";
}

static ts_status check_run(const ts_part *part, const ts_part *first)
{
	static const char *const texts[] = {"command", "commit"};
	if (part->of != first->of) {
		return ts_fail("%s: shard %u of %u; %s is one of %u: name shards of one run", part->dir, (unsigned)part->index,
		               (unsigned)part->of, first->dir, (unsigned)first->of);
	}
	for (u32 i = 0; i < 2; i++) {
		if (strcmp(text_of(part, texts[i]), text_of(first, texts[i])) == 0) continue;
		return ts_fail("%s: of %s %s, and %s of %s: name shards of one run", part->dir, texts[i],
		               text_of(part, texts[i]), first->dir, text_of(first, texts[i]));
	}
	const json_t *typed = json_object_get(part->shard, "typed"), *other = json_object_get(first->shard, "typed");
	if (!json_equal(typed, other)) {
		return ts_fail("%s: ran with \"%s\", and %s with \"%s\": name shards of one run", part->dir,
		               other_word(typed, other), first->dir, other_word(other, typed));
	}
	bool same = json_equal(json_object_get(part->shard, "cases"), json_object_get(first->shard, "cases"));
	if (same && strcmp(text_of(part, "class"), text_of(first, "class")) == 0) return TS_OK;
	return ts_fail("%s: has other cases than %s: name shards of one run", part->dir, first->dir);
}

/* Another program may write other reports. */
static ts_status check_program(const ts_part *part)
{
	if (strcmp(text_of(part, "commit"), ts_commit()) == 0) return TS_OK;
	return ts_fail("%s: of commit %s, and this program of %s: merge by the program that ran", part->dir,
	               text_of(part, "commit"), ts_commit());
}

/* The parts are sorted. */
static ts_status check_whole(const ts_parts *p)
{
	char missing[200] = "";
	size_t used = 0;
	u32 expected = 1, n_missing = 0;
	for (u32 i = 0; i < p->n; i++) {
		const ts_part *part = &p->part[i];
		if (i > 0 && part->index == part[-1].index) {
			return ts_fail("%s and %s: both are shard %u; name each once", part[-1].dir, part->dir,
			               (unsigned)part->index);
		}
	}
	for (u32 i = 0; expected <= p->part[0].of; expected++) {
		if (i < p->n && p->part[i].index == expected) {
			i++;
			continue;
		}
		n_missing++;
		if (used + 12 < sizeof missing) {
			used += (size_t)snprintf(missing + used, sizeof missing - used, "%s%u", used > 0 ? ", " : "",
			                         (unsigned)expected);
		}
	}
	if (n_missing == 0) return TS_OK;
	return ts_fail("merge: of %u shards %u %s missing: %s; name %s too", (unsigned)p->part[0].of, (unsigned)n_missing,
	               n_missing == 1 ? "is" : "are", missing, n_missing == 1 ? "its folder" : "their folders");
}

/* An error is worst, then a difference, then a missing device. */
static const ts_part *worst_of(ts_parts *p)
{
	static const ts_status order[] = {TS_OK, TS_SKIPPED, TS_DIFFERENT, TS_ERROR};
	const ts_part *worst = &p->part[0];
	for (u32 k = 0; k < 4; k++) {
		for (u32 i = 0; i < p->n; i++) {
			if (json_integer_value(json_object_get(p->part[i].shard, "status")) != order[k]) continue;
			worst = &p->part[i];
			p->status = order[k];
		}
	}
	return worst;
}

static ts_status put_together(ts_cli *cli, ts_parts *p)
{
	qsort(p->part, p->n, sizeof *p->part, by_index);
	for (u32 i = 1; i < p->n; i++) {
		if (check_run(&p->part[i], &p->part[0]) != TS_OK) return TS_ERROR;
	}
	if (check_whole(p) != TS_OK || check_program(&p->part[0]) != TS_OK) return TS_ERROR;
	const ts_part *worst = worst_of(p);
	p->command = text_of(&p->part[0], "command");
	p->class_name = text_of(&p->part[0], "class");
	p->cases = json_object_get(p->part[0].shard, "cases");
	const bool renders = strcmp(p->command, "render") == 0;
	if (renders && ts_merge_renders == NULL) return ts_fail("merge: shards of render, which touchstone merges");
	ts_status status = renders ? ts_merge_renders(cli, p) : ts_merge_rows(cli, p);
	if (status != TS_OK || p->status < TS_ERROR) return status == TS_OK ? p->status : status;
	ts_fail("merge: shard %u in %s %s", (unsigned)worst->index, worst->dir,
	        p->status == TS_ERROR ? "ended with an error" : "had no device");
	return p->status;
}

ts_status ts_merge_command(ts_cli *cli)
{
	if (ts_judging_check(cli) != TS_OK) return TS_ERROR;
	ts_parts p = {.part = ts_alloc_zero(cli->n_arguments, sizeof *p.part, "shards"), .status = TS_OK};
	ts_status status = p.part != NULL ? TS_OK : TS_ERROR;
	for (; p.n < cli->n_arguments && status == TS_OK; p.n++) status = ts_part_read(&p.part[p.n], cli->arguments[p.n]);
	if (status == TS_OK) status = put_together(cli, &p);
	for (u32 i = 0; i < p.n; i++) ts_part_end(&p.part[i]);
	free(p.part);
	return status;
}
