/* A port's folder of outputs. Its files are untrusted. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>
#include "cli/vectors.h"
#include "model/input.h"
#include "model/json/read.h"
#include "output/npy.h"

enum { PATH_BYTES = 4096 + 300, MAX_INDEX_BYTES = 1 << 24 };

/* Opens a regular file; -1 with the message set. Does not wait for other files, such as pipes. */
static int open_regular(const char *path, u64 *bytes)
{
	struct stat info;
	int file = open(path, O_RDONLY | O_NONBLOCK);
	if (file < 0 || fstat(file, &info) != 0) {
		ts_fail("%s: %s", path, strerror(errno));
	} else if (!S_ISREG(info.st_mode)) {
		ts_fail("%s: not a regular file", path);
	} else {
		*bytes = (u64)info.st_size;
		return file;
	}
	if (file >= 0) close(file);
	return -1;
}

static size_t read_at(int file, void *data, size_t bytes, u64 at)
{
	size_t done = 0;
	for (ssize_t n = 1; n > 0; done += n > 0 ? (size_t)n : 0) {
		n = pread(file, (char *)data + done, bytes - done, (off_t)(at + done));
	}
	return done;
}

static void print_shape(char *text, size_t text_bytes, u32 n_dims, const u64 *shape)
{
	size_t used = (size_t)snprintf(text, text_bytes, "(");
	for (u32 i = 0; i < n_dims; i++) {
		used += (size_t)snprintf(text + used, text_bytes - used, "%s%" PRIu64, i == 0 ? "" : ", ", shape[i]);
	}
	snprintf(text + used, text_bytes - used, n_dims == 1 ? ",)" : ")");
}

static ts_status check_shape(const char *path, const ts_npy *npy, u32 n_dims, const u64 *shape)
{
	char found[TS_MAX_DIMS * 24 + 4], right[TS_MAX_DIMS * 24 + 4];
	if (npy->n_dims == n_dims && memcmp(npy->shape, shape, n_dims * sizeof *shape) == 0) return TS_OK;
	print_shape(found, sizeof found, npy->n_dims, npy->shape);
	print_shape(right, sizeof right, n_dims, shape);
	return ts_fail("%s: shape %s; %s would be right", path, found, right);
}

static ts_status read_file(int file, u64 file_bytes, void *data, const char *path, const char *descr,
                           size_t element_bytes, u32 n_dims, const u64 *shape)
{
	char head[TS_NPY_HEADER];
	ts_npy npy;
	size_t head_bytes = read_at(file, head, sizeof head, 0);
	ts_status status = ts_npy_parse(&npy, path, head, head_bytes, file_bytes, descr, element_bytes);
	if (status == TS_OK) status = check_shape(path, &npy, n_dims, shape);
	if (status != TS_OK) return status;
	size_t bytes = (size_t)npy.n * element_bytes;
	return read_at(file, data, bytes, npy.data_at) == bytes ? TS_OK : ts_fail("%s: cannot be read as a whole", path);
}

ts_status ts_vectors_read(void *data, bool *there, const char *dir, const char *name, const char *descr,
                          size_t element_bytes, u32 n_dims, const u64 *shape)
{
	char path[PATH_BYTES];
	struct stat info;
	u64 file_bytes = 0;
	snprintf(path, sizeof path, "%s/%s", dir, name);
	*there = !(stat(path, &info) != 0 && errno == ENOENT);
	if (!*there) return TS_OK;
	int file = open_regular(path, &file_bytes);
	if (file < 0) return TS_ERROR;
	ts_status status = read_file(file, file_bytes, data, path, descr, element_bytes, n_dims, shape);
	close(file);
	return status;
}

ts_status ts_vectors_read_contract(const char *dir)
{
	char path[PATH_BYTES];
	struct stat info;
	snprintf(path, sizeof path, "%s/vectors.json", dir);
	if (stat(path, &info) != 0) return TS_OK;
	size_t bytes = 0;
	bool readable = S_ISREG(info.st_mode) && info.st_size <= MAX_INDEX_BYTES;
	char *text = readable ? ts_text_read(&bytes, path, MAX_INDEX_BYTES) : NULL;
	if (readable && text == NULL) return TS_ERROR;
	json_t *root = text != NULL ? ts_json_read(text, bytes, false, path) : NULL;
	free(text);
	if (readable && root == NULL && ts_error_kind() == TS_KIND_MEMORY) return TS_ERROR;
	json_t *contract = json_object_get(root, "contract");
	json_int_t version = json_integer_value(contract);
	bool known = json_is_integer(contract);
	json_decref(root);
	if (!known) return ts_fail("%s: no \"contract\" in it; remove it, or copy the one that \"vectors -o\" wrote", path);
	if (version == TS_CONTRACT_VERSION) return TS_OK;
	return ts_fail("%s: contract %" JSON_INTEGER_FORMAT "; this is %s %s of contract %d, so write the vectors again",
	               path, version, ts_program, TS_VERSION, TS_CONTRACT_VERSION);
}

static ts_status check_name(const char *dir, const char *file)
{
	static const char suffix[] = ".out.npy";
	char name[256];
	size_t n = strlen(file), tail = sizeof suffix - 1;
	if (n < tail || strcmp(file + n - tail, suffix) != 0) return TS_OK;
	snprintf(name, sizeof name, "%.*s", (int)(n - tail), file);
	const ts_vector_info *v;
	for (size_t i = 0; (v = ts_vector_at(i)) != NULL; i++) {
		if (strcmp(v->name, name) == 0) return TS_OK;
	}
	ts_nearest nearest = ts_nearest_begin(name);
	for (size_t i = 0; (v = ts_vector_at(i)) != NULL; i++) ts_nearest_offer(&nearest, v->name);
	return ts_fail("%s/%s: no primitive \"%s\"%s", dir, file, name,
	               ts_nearest_hint(&nearest, "touchstone list vectors"));
}

ts_status ts_vectors_check_names(const char *dir)
{
	ts_status status = TS_OK;
	if (strlen(dir) > PATH_BYTES - 300) return ts_fail("--check: the name of the folder is too long");
	DIR *stream = opendir(dir);
	if (stream == NULL) return ts_fail("%s: %s; name the folder that holds PRIMITIVE.out.npy", dir, strerror(errno));
	for (struct dirent *e; status == TS_OK && (e = readdir(stream)) != NULL;) status = check_name(dir, e->d_name);
	closedir(stream);
	return status;
}
