/* The columns of `bench backends`: C with one thread and with --threads, and the devices. */
#include <string.h>
#include "output/json/text.h"
#include "study/bench_backends.h"
#include "vectors/vectors.h"

void ts_bench_note(ts_bench_table *table, const char *format, ...)
{
	char text[1024];
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(text, sizeof text, format, arguments);
	va_end(arguments);
	json_array_append_new(table->notes, ts_text_json(text));
}

static ts_bench_column *add(ts_bench_table *table, const ts_backend_kind *kind, u32 index, const char *device)
{
	ts_bench_column *c = &table->column[table->n_columns++];
	*c = (ts_bench_column){.kind = kind, .index = index, .how = table->job->how};
	snprintf(c->name, sizeof c->name, "%s%u", kind->name, (unsigned)index);
	snprintf(c->device, sizeof c->device, "%s", device);
	return c;
}

static void add_c(ts_bench_table *table, u32 threads)
{
	ts_device about[TS_MAX_DEVICES];
	u32 n;
	ts_c_kind.devices(about, &n);
	table->reference = table->n_columns;
	ts_bench_column *c = add(table, &ts_c_kind, threads, about[0].name);
	c->how.backend = NULL;
	c->how.threads = threads;
}

static void add_device(ts_bench_table *table, const ts_backend_kind *kind, u32 index, ts_backend *backend, bool own)
{
	ts_device about[TS_MAX_DEVICES];
	u32 n;
	kind->devices(about, &n);
	ts_bench_column *c = add(table, kind, index, backend->device);
	c->how.backend = backend;
	c->own = own;
	if (index < n) snprintf(c->platform, sizeof c->platform, "%s", about[index].platform);
}

static ts_status open_device(ts_bench_table *table, const ts_backend_kind *kind, u32 index)
{
	ts_backend_options options = table->job->device;
	ts_backend *backend;
	options.device = index;
	ts_status status = kind->open(&backend, &options);
	if (status != TS_OK) return status;
	add_device(table, kind, index, backend, true);
	status = ts_vectors_verify(backend, options.inexact);
	if (status == TS_OK) return TS_OK;
	table->n_columns--;
	backend->close(backend);
	return status;
}

static void open_all(ts_bench_table *table, const ts_backend_kind *kind)
{
	ts_device about[TS_MAX_DEVICES];
	u32 n;
	if (kind->devices(about, &n) != TS_OK) ts_bench_note(table, "%s", ts_error_message());
	for (u32 i = 0; i < n; i++) {
		if (table->n_columns == TS_BENCH_COLUMNS) {
			ts_bench_note(table, "%s%u and beyond: no room; choose one with --device", kind->name, (unsigned)i);
			return;
		}
		if (open_device(table, kind, i) != TS_OK) {
			ts_bench_note(table, "%s%u: left out: %s", kind->name, (unsigned)i, ts_error_message());
		}
	}
}

static ts_status open_devices(ts_bench_table *table)
{
	const ts_job *job = table->job;
	if (job->device_named) return open_device(table, job->backends[1], job->device.device);
	for (u32 i = 1; job->backends[i] != NULL; i++) open_all(table, job->backends[i]);
	bool lacks = table->n_columns == table->reference + 1 && job->require;
	return lacks ? ts_fail("--require: no device can be measured; `touchstone list backends` names them") : TS_OK;
}

ts_status ts_bench_columns_open(ts_bench_table *table)
{
	const ts_job *job = table->job;
	ts_status status = TS_OK;
	add_c(table, 1);
	if (job->how.threads > 1) add_c(table, job->how.threads);
	if (job->how.backend != NULL) {
		add_device(table, job->backend, job->device.device, job->how.backend, false);
	} else if (!job->backend_named) {
		status = open_devices(table);
	}
	return status == TS_SKIPPED && job->require ? TS_ERROR : status;
}

bool ts_bench_column_leave_out(ts_bench_table *table, u32 index)
{
	ts_bench_column *c = &table->column[index];
	if (!c->own || table->job->device_named || table->job->require) return false;
	ts_bench_note(table, "%s: left out: %s", c->name, ts_error_message());
	c->how.backend->close(c->how.backend);
	memmove(c, c + 1, (--table->n_columns - index) * sizeof *c);
	return true;
}

void ts_bench_columns_close(ts_bench_table *table)
{
	for (u32 i = 0; i < table->n_columns; i++) {
		ts_backend *backend = table->column[i].how.backend;
		if (table->column[i].own) backend->close(backend);
	}
}
