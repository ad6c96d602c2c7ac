/* The machine that `bench speed` measures, and its limits. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "output/json/text.h"
#include "study/speed_work.h"

const u32 ts_speed_mib[TS_SPEED_SIZES] = {1, 16, 128};

/* The text after the first ": " of the first line of /proc/cpuinfo that begins with "model name"; "" if there is
 * none. */
static void read_model(char *text, size_t bytes)
{
	char line[256];
	text[0] = 0;
	FILE *in = fopen("/proc/cpuinfo", "r");
	if (in == NULL) return;
	while (text[0] == 0 && fgets(line, sizeof line, in) != NULL) {
		const char *value = strstr(line, ": ");
		line[strcspn(line, "\n")] = 0;
		bool found = strncmp(line, "model name", strlen("model name")) == 0 && value != NULL;
		if (found) snprintf(text, bytes, "%.*s", (int)bytes - 1, value + 2);
	}
	fclose(in);
}

/* "32 KiB, 1024 KiB, 32768 KiB": data caches that the system reports. */
static void read_caches(char *text, size_t bytes)
{
	size_t used = 0;
	text[0] = 0;
#if defined(_SC_LEVEL1_DCACHE_SIZE)
	static const int levels[] = {_SC_LEVEL1_DCACHE_SIZE, _SC_LEVEL2_CACHE_SIZE, _SC_LEVEL3_CACHE_SIZE};
	for (u32 i = 0; i < 3 && used < bytes; i++) {
		long size = sysconf(levels[i]);
		if (size > 0)
			used += (size_t)snprintf(text + used, bytes - used, "%s%ld KiB", used > 0 ? ", " : "", size >> 10);
	}
#endif
}

void ts_speed_machine_print(const ts_speed *speed)
{
	char model[128], caches[128], text[320];
	ts_c_backend c;
	ts_c_begin(&c, 1);
	const ts_backend *backend = speed->job->how.backend != NULL ? speed->job->how.backend : &c.backend;
	u32 processors = ts_processors();
	read_model(model, sizeof model);
	read_caches(caches, sizeof caches);
	snprintf(text, sizeof text, "%s, %u processors, caches %s", model[0] != 0 ? model : "an unknown processor",
	         (unsigned)processors, caches[0] != 0 ? caches : "unknown");
	ts_report_line(speed->report, "%s", text);
	ts_report_line(speed->report, "compiler %s, %s", backend->compiler, backend->flags);
	ts_report_timed(speed->report, "machine", ts_text_json(text));
	ts_report_value(speed->report, "compiler", ts_text_json(backend->compiler));
	ts_report_value(speed->report, "flags", ts_text_json(backend->flags));
}

static ts_status measure_minima(double *values, const ts_speed_machine *machine, u32 size)
{
	return ts_limit_minima(values, (u64)ts_speed_mib[size] << 20, machine->threads);
}

static ts_status measure_small(double *values, void *of) { return measure_minima(values, of, 0); }
static ts_status measure_middle(double *values, void *of) { return measure_minima(values, of, 1); }
static ts_status measure_large(double *values, void *of) { return measure_minima(values, of, 2); }

static ts_status measure_stream(double *values, void *of)
{
	return ts_limit_stream(values, ((const ts_speed_machine *)of)->threads);
}

ts_status ts_speed_machine_begin(ts_speed_machine *machine, u32 threads, u32 runs)
{
	static ts_status (*const measures[TS_SPEED_SIZES])(double *, void *) = {measure_small, measure_middle,
	                                                                        measure_large};
	ts_status status = TS_OK;
	machine->threads = threads;
	machine->stream.measure = measure_stream;
	machine->stream.of = machine;
	status = ts_speed_row_begin(&machine->stream, 1, runs);
	for (u32 i = 0; i < TS_SPEED_SIZES && status == TS_OK; i++) {
		machine->minima[i].measure = measures[i];
		machine->minima[i].of = machine;
		status = ts_speed_row_begin(&machine->minima[i], 1, runs);
	}
	return status;
}

ts_status ts_speed_machine_run(ts_speed_machine *machine, u32 run, ts_quiet *quiet)
{
	ts_status status = ts_speed_row_run(&machine->stream, run, quiet);
	for (u32 i = 0; i < TS_SPEED_SIZES && status == TS_OK; i++)
		status = ts_speed_row_run(&machine->minima[i], run, quiet);
	return status;
}

void ts_speed_machine_end(ts_speed_machine *machine)
{
	ts_speed_row_end(&machine->stream);
	for (u32 i = 0; i < TS_SPEED_SIZES; i++) ts_speed_row_end(&machine->minima[i]);
}
