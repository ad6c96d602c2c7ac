/* Videos by ffmpeg, in a process of its own that writes to memory: the folder of results gets complete videos only. */
#define _GNU_SOURCE
#include "study/video.h"
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include "output/file.h"
#include "output/folder.h"

enum { OUT = 3, BLOCK = 1 << 16 };

/* Sides are even, as the format requires; one thread and no dates, so that two runs give the same bytes. */
#define PICTURES "-nostdin", "-v", "error", "-f", "image2", "-framerate", TS_VIDEO_RATE, "-pattern_type", "glob"
#define SHAPE "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-crf", "16", "-pix_fmt", "yuv420p"
#define SAME "-threads", "1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-map_metadata", "-1"

/* 0, or errno; then *ended is ffmpeg's status. */
static int encode(int *ended, const char *pattern, int out, int complaints)
{
	char *from = (char *)(uintptr_t)pattern;
	char *const arguments[] = {"ffmpeg", PICTURES, "-i", from, SHAPE, SAME, "-f", "mp4", "-y", "/proc/self/fd/3", NULL};
	posix_spawn_file_actions_t actions;
	pid_t child;
	if (posix_spawn_file_actions_init(&actions) != 0) return ENOMEM;
	int error = posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
	if (error == 0) error = posix_spawn_file_actions_adddup2(&actions, complaints, STDERR_FILENO);
	if (error == 0) error = posix_spawn_file_actions_adddup2(&actions, out, OUT);
	if (error == 0) error = posix_spawn_file_actions_addchdir_np(&actions, ts_folder_path());
	if (error == 0) error = posix_spawnp(&child, arguments[0], &actions, NULL, arguments, environ);
	posix_spawn_file_actions_destroy(&actions);
	if (error != 0) return error;
	return waitpid(child, ended, 0) == child ? 0 : errno;
}

/* ffmpeg's complaint, or that there is no ffmpeg. */
static void explain(char *why, size_t why_bytes, int error, int complaints)
{
	char line[200] = "";
	ssize_t n = pread(complaints, line, sizeof line - 1, 0);
	line[n > 0 ? strcspn(line, "\n") : 0] = 0;
	const char *what = error != 0 ? strerror(error) : line;
	if (error == ENOENT) {
		snprintf(why, why_bytes, "no video: ffmpeg is not installed");
	} else {
		snprintf(why, why_bytes, "no video: ffmpeg failed%s%s", what[0] != 0 ? ": " : "", what);
	}
	ts_line_clean(why);
}

static ts_status copy(const char *path, int from)
{
	ts_file file;
	char *block = ts_alloc(BLOCK, 1, "a video");
	ts_status status = block != NULL ? ts_file_begin(&file, path) : TS_ERROR;
	bool open = status == TS_OK;
	ssize_t n = 1;
	for (off_t at = 0; status == TS_OK && n > 0; at += n) {
		n = pread(from, block, BLOCK, at);
		if (n > 0) status = ts_file_put(&file, block, (size_t)n);
	}
	free(block);
	if (status == TS_OK && n < 0) status = ts_fail("%s: %s", path, strerror(errno));
	if (status == TS_OK) return ts_file_end(&file);
	if (open) ts_file_drop(&file);
	return TS_ERROR;
}

static ts_status write_video(char *why, size_t why_bytes, const char *name, const char *pattern, int out,
                             int complaints)
{
	int ended = 0, error = encode(&ended, pattern, out, complaints);
	bool made = error == 0 && WIFEXITED(ended) && WEXITSTATUS(ended) == 0 && lseek(out, 0, SEEK_END) > 0;
	if (!made) {
		explain(why, why_bytes, error, complaints);
		return TS_OK;
	}
	const char *path = ts_folder_file(name);
	return path != NULL ? copy(path, out) : TS_ERROR;
}

ts_status ts_video_write(char *why, size_t why_bytes, const char *name, const char *pattern)
{
	int out = memfd_create("video", MFD_CLOEXEC), complaints = memfd_create("complaints", MFD_CLOEXEC);
	ts_status status = TS_OK;
	why[0] = 0;
	if (out >= 0 && complaints >= 0) {
		status = write_video(why, why_bytes, name, pattern, out, complaints);
	} else {
		snprintf(why, why_bytes, "no video: no memory for one: %s", strerror(errno));
	}
	if (out >= 0) close(out);
	if (complaints >= 0) close(complaints);
	return status;
}
