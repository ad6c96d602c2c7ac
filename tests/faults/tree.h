/* Folders as a whole: copied, removed, compared. */
#ifndef TS_TESTS_FAULTS_TREE_H
#define TS_TESTS_FAULTS_TREE_H
#include <stdbool.h>
#include <stddef.h>

enum { TS_MAX_PATH = 4096 };

/* A file in memory, with a zero behind it; a new block, or NULL if there is no such file. */
char *ts_tree_read(const char *path, size_t *bytes);
/* Removes what is there, if anything is. */
void ts_tree_remove(const char *path);
/* Copies a folder to one that is not there. Ends the process on failure. */
void ts_tree_copy(const char *from, const char *to);
/* Whether two files, or both folders and all in them, are the same; else `where`, of TS_MAX_PATH, says what is not.
 * Numbers of a times.json may differ. What begins with a dot, such as a driver's cache, is
 * not seen. */
bool ts_tree_same(const char *a, const char *b, char *where);
/* From here on what is in the second folder alone may be there if this text, or NULL, names it. */
void ts_tree_told(const char *text);
/* The same of two texts, whose numbers and blanks may differ. */
bool ts_tree_same_words(const char *a, const char *b);

#endif
