/* SPDX-License-Identifier: Apache-2.0 */
/* Answers as trees: an object has members with names, a list has elements, and every other node is a leaf. */
#ifndef TOUCHSTONE_TREE_H
#define TOUCHSTONE_TREE_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct ts_tree ts_tree;

typedef enum {
	TS_TREE_NULL,
	TS_TREE_BOOL,
	TS_TREE_INTEGER,
	TS_TREE_REAL,
	TS_TREE_TEXT,
	TS_TREE_LIST,
	TS_TREE_OBJECT,
} ts_tree_kind;

/* The kind of a node; TS_TREE_NULL for NULL. */
TS_API ts_tree_kind ts_tree_kind_of(const ts_tree *node);
/* The number of members or elements; 0 for a leaf. */
TS_API size_t ts_tree_n(const ts_tree *node);
/* Member or element i, and the name of member i; NULL if there is none. Nodes and names belong to the tree. */
TS_API const ts_tree *ts_tree_at(const ts_tree *node, size_t i);
TS_API const char *ts_tree_name(const ts_tree *node, size_t i);
/* The member of that name; NULL if there is none. */
TS_API const ts_tree *ts_tree_get(const ts_tree *node, const char *name);
/* The value of a leaf; 0, or NULL, if the leaf is of another kind. A bool is an integer, too, and an integer a real. */
TS_API int64_t ts_tree_integer(const ts_tree *node);
TS_API double ts_tree_real(const ts_tree *node);
TS_API const char *ts_tree_text(const ts_tree *node);
/* The whole tree as one line of JSON, to be released by free(); NULL, with the message set, without memory. */
TS_API char *ts_tree_json(const ts_tree *node);
/* Releases a whole tree, by its root; NULL is allowed. */
TS_API void ts_tree_free(ts_tree *root);

#ifdef __cplusplus
}
#endif
#endif
