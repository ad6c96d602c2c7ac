/* Goldens (CONTRIBUTING, Goldens): the digests of a run's files, and the contents of the small ones; computed now, or
 * stored in
 *   <case>/SHA256SUMS   what ts_sums_print prints
 *   <case>/small/       some of the files that it names
 *   <case>/params.txt   what was rendered
 *   <case>/preview.png  what it looks like
 *   <case>/CHANGES      why it was blessed, a line each time
 * A proposal is in <case>.new/, without CHANGES. Stored files are untrusted. Part of the core. */
#ifndef TS_GOLDEN_GOLDEN_H
#define TS_GOLDEN_GOLDEN_H
#include "golden/file.h"
#include "trace/emitted/sums.h"

/* The largest file that is stored as it is, and the largest of any kind. */
enum { TS_GOLDEN_SMALL_BYTES = 192 << 10, TS_GOLDEN_FILE_BYTES = 8 << 20 };
#define TS_GOLDEN_SUMS "SHA256SUMS"
#define TS_GOLDEN_PARAMS "params.txt"
#define TS_GOLDEN_PREVIEW "preview.png"
#define TS_GOLDEN_CHANGES "CHANGES"

typedef struct {
	char *data; /* a whole .npy file; NULL: not kept */
	size_t bytes;
	size_t taken;              /* bytes that are there */
	ts_npy npy;                /* its header */
	char hex[TS_DIGEST_BYTES]; /* its digest, if it was read */
} ts_golden_file;

typedef struct {
	ts_sums sums;
	ts_golden_file file[TS_N_BUFFERS];
	/* Set only if the golden was computed: */
	u64 bytes[TS_N_BUFFERS]; /* of each file, kept or not */
	ts_buffer_id stray;      /* the first buffer with a number that none may have; TS_N_BUFFERS: none */
	u64 n_strays;            /* number of such numbers in all buffers */
} ts_golden;

/* The way to compute a golden. */
typedef struct {
	const ts_pipeline *pipeline;
	const ts_scene *scene;
	const ts_params *params;
	ts_how how;
} ts_golden_job;

/* Computes the digests, and keeps image.srgb and all files of at most TS_GOLDEN_SMALL_BYTES. ts_golden_free also after
 * a failure. */
ts_status ts_golden_compute(ts_golden *golden, const ts_golden_job *job);
/* Reads SHA256SUMS and small/ of a folder. Lines that a run of the pipeline cannot print and files that SHA256SUMS does
 * not name are refused. ts_golden_free also after a failure. */
ts_status ts_golden_read(ts_golden *golden, const ts_golden_dir *dir, const ts_pipeline *pipeline);
/* Writes SHA256SUMS and, with `small`, small/ to the folder that is written (output/folder.h). */
ts_status ts_golden_write(const ts_golden *golden, const ts_pipeline *pipeline, bool small);
/* Copies to the output folder all of a golden except CHANGES. */
ts_status ts_golden_copy(const ts_golden_dir *from);
/* A ts_folder_judge: whether everything in the folder is of a golden. */
ts_status ts_golden_judge(const char *path);
/* Releases the golden's memory. */
void ts_golden_free(ts_golden *golden);

/* Number of floats in a buffer's file that are NaN, infinite, -0 or nearer to 0 than 2^-100 (CONTRACT rule 12), and of
 * keys whose distance is one, or an axial depth of 0. */
u64 ts_golden_strays(ts_buffer_id id, const void *data, u64 bytes);
/* Whether all pixels of the computed image.srgb are the same, or there are none. */
bool ts_golden_is_constant(const ts_golden *golden);
/* The pixels of the computed image.srgb. */
const u8 *ts_golden_image(const ts_golden *golden, u32 *width, u32 *height);

/* Whether a case with `small` must have the buffer's file. */
bool ts_golden_is_small(const ts_golden *computed, ts_buffer_id id);
/* The first file in the order of the pipeline that differs. TS_OK: none. TS_DIFFERENT: `text` says which and where.
 * TS_ERROR, with the message set: `small` and a file that should be stored is not. */
ts_status ts_golden_compare(char *text, size_t text_bytes, const ts_golden *stored, const ts_golden *computed,
                            const ts_pipeline *pipeline, bool small);
/* The buffer with whose file such a text begins; TS_N_BUFFERS: none. */
ts_buffer_id ts_golden_named(const char *text, const ts_pipeline *pipeline);
/* The first difference of two files of one buffer, as "element [3, 5], field centre[2]: golden ... here ..."; `text` is
 * empty if there is none. */
void ts_golden_first(char *text, size_t text_bytes, ts_buffer_id id, const ts_golden_file *stored,
                     const ts_golden_file *computed);

#endif
