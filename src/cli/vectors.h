/* Files of arithmetic vectors: a folder of PRIMITIVE.in.npy, PRIMITIVE.out.npy and vectors.json. */
#ifndef TS_CLI_VECTORS_H
#define TS_CLI_VECTORS_H
#include "cli/client.h"

u32 ts_vectors_total(void);

/* Room for the rows of any primitive: one block, which `in` begins. */
typedef struct {
	u32 *in, *out, *found;
} ts_vector_rows;
/* Release by free(rows->in). */
ts_status ts_vectors_rows(ts_vector_rows *rows);

/* Judges the outputs in the folder of --check: TS_OK all that are there are right, TS_DIFFERENT, or TS_ERROR. */
ts_status ts_vectors_check(const ts_cli *cli, ts_context *context);

/* Reads DIR/NAME.npy, elements of `descr` and of element_bytes in that shape, to `data`. *there: the file exists; if it
 * does not, nothing is read and nothing fails. */
ts_status ts_vectors_read(void *data, bool *there, const char *dir, const char *name, const char *descr,
                          size_t element_bytes, u32 n_dims, const u64 *shape);
/* Fails if DIR/vectors.json exists and is of another contract. */
ts_status ts_vectors_read_contract(const char *dir);
/* Fails unless every DIR/NAME.out.npy is named after a primitive; DIR must be a folder. */
ts_status ts_vectors_check_names(const char *dir);

#endif
