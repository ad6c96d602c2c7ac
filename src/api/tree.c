/* Answers as trees: a node is a value of jansson. */
#include <jansson.h>
#include <touchstone/tree.h>
#include "model/core.h"
#include "output/json/text.h"

static const json_t *json(const ts_tree *node) { return (const json_t *)node; }
static const ts_tree *tree(const json_t *value) { return (const ts_tree *)value; }

ts_tree_kind ts_tree_kind_of(const ts_tree *node)
{
	if (node == NULL) return TS_TREE_NULL;
	switch (json_typeof(json(node))) {
	case JSON_OBJECT: return TS_TREE_OBJECT;
	case JSON_ARRAY: return TS_TREE_LIST;
	case JSON_STRING: return TS_TREE_TEXT;
	case JSON_INTEGER: return TS_TREE_INTEGER;
	case JSON_REAL: return TS_TREE_REAL;
	case JSON_TRUE:
	case JSON_FALSE: return TS_TREE_BOOL;
	default: return TS_TREE_NULL;
	}
}

size_t ts_tree_n(const ts_tree *node)
{
	return json_is_object(json(node)) ? json_object_size(json(node)) : json_array_size(json(node));
}

/* Member i, as jansson walks them: in the order in which they were put. */
static void *member(const ts_tree *node, size_t i)
{
	json_t *object = (json_t *)(uintptr_t)node;
	void *at = json_object_iter(object);
	while (i-- > 0) at = json_object_iter_next(object, at);
	return at;
}

const ts_tree *ts_tree_at(const ts_tree *node, size_t i)
{
	if (i >= ts_tree_n(node)) return NULL;
	return tree(json_is_array(json(node)) ? json_array_get(json(node), i) : json_object_iter_value(member(node, i)));
}

const char *ts_tree_name(const ts_tree *node, size_t i)
{
	return json_is_object(json(node)) && i < ts_tree_n(node) ? json_object_iter_key(member(node, i)) : NULL;
}

const ts_tree *ts_tree_get(const ts_tree *node, const char *name)
{
	return tree(name != NULL ? json_object_get(json(node), name) : NULL);
}

int64_t ts_tree_integer(const ts_tree *node)
{
	return json_is_true(json(node)) ? 1 : (int64_t)json_integer_value(json(node));
}

double ts_tree_real(const ts_tree *node)
{
	return json_is_real(json(node)) ? json_real_value(json(node)) : (double)ts_tree_integer(node);
}

const char *ts_tree_text(const ts_tree *node) { return json_string_value(json(node)); }

char *ts_tree_json(const ts_tree *node)
{
	if (TS_LACKS(node)) return NULL;
	return ts_json_text(json(node), JSON_COMPACT | JSON_ENCODE_ANY, "an answer as JSON");
}

void ts_tree_free(ts_tree *root) { json_decref((json_t *)root); }
