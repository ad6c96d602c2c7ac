/* Arguments of launches, from declarations of kernels and stages: buffers are made by their shapes, pointers are
 * set. */
#include <assert.h>
#include "methods/stage.h"

static bool is_batched(ts_buffer_id id)
{
	const ts_shape *shape = ts_buffer_shape(id);
	for (u32 i = 0; i < shape->n; i++) {
		for (u32 k = 0; k < shape->axis[i].n_factors; k++) {
			if (ts_dim_table[shape->axis[i].factor[k]].how == TS_IS_batched) return true;
		}
	}
	return false;
}

/* The buffer's current dimensions. */
static ts_status shape_now(const ts_run *run, ts_buffer_id id, u32 more, u64 dims[TS_MAX_DIMS])
{
	ts_sizes sizes;
	const ts_shape *shape = ts_buffer_shape(id);
	for (u32 dim = 0; dim < TS_N_DIMS; dim++) sizes.n[dim] = ts_run_size(run, (ts_dim)dim);
	if (!ts_shape_dims(shape, &sizes, dims)) {
		const ts_buffer_info *info = &ts_buffer_table[id];
		return ts_fail("%s: its shape, %s, has a size that is not known", info->name, info->shape);
	}
	dims[0] += more;
	return TS_OK;
}

/* Only the first batch makes buffers that no batch changes. */
static ts_status make(ts_run *run, ts_buffer_id id, ts_role role, u32 more)
{
	u64 dims[TS_MAX_DIMS];
	u32 n_dims = ts_buffer_shape(id)->n;
	bool stays = run->made[id] || (run->first_unit != 0 && !is_batched(id) && run->frame.buffer[id].made);
	run->made[id] = true;
	if (stays) return TS_OK;
	if (shape_now(run, id, more, dims) != TS_OK) return TS_ERROR;
	if (role == TS_ROLE_SUM) return ts_run_zeros(run, id, n_dims, dims) != NULL ? TS_OK : TS_ERROR;
	if (ts_frame_make(&run->frame, id, n_dims, dims) == NULL) return TS_ERROR;
	return role == TS_ROLE_MIN ? ts_run_fill(run, id, 0xff) : TS_OK;
}

void *ts_run_make(ts_run *run, ts_buffer_id id)
{
	return make(run, id, TS_ROLE_OUT, 0) == TS_OK ? ts_frame_handle(&run->frame, id) : NULL;
}

static bool is_written(ts_role role) { return role == TS_ROLE_OUT || role == TS_ROLE_MIN || role == TS_ROLE_SUM; }

static ts_bound bound_by_name(const ts_launch *launch, const char *name)
{
	const ts_pointers *p = ts_kernel_pointers(launch->kernel);
	u32 i = 0;
	while (i < p->n && strcmp(p->pointer[i].name, name) != 0) i++;
	assert(i < p->n);
	return ts_launch_bound(launch, &p->pointer[i]);
}

ts_status ts_launch_make(ts_run *run, const ts_launch *launch, const char *name, u32 more)
{
	const ts_bound bound = bound_by_name(launch, name);
	assert(bound.bound && is_written(bound.role));
	return make(run, (ts_buffer_id)bound.to, bound.role, more);
}

void ts_launch_make_again(ts_run *run, const ts_launch *launch)
{
	const ts_pointers *p = ts_kernel_pointers(launch->kernel);
	for (u32 i = 0; i < p->n; i++) {
		const ts_bound bound = ts_launch_bound(launch, &p->pointer[i]);
		if (bound.bound && is_written(bound.role)) run->made[bound.to] = false;
	}
}

void ts_launch_cut(ts_run *run, const ts_launch *launch, const char *name, u32 less)
{
	ts_buffer_id id = (ts_buffer_id)bound_by_name(launch, name).to;
	ts_frame_cut(&run->frame, id, ts_frame_n(&run->frame, id) - less);
}

bool ts_launch_spares(const ts_run *run, const ts_launch *launch, const char *name)
{
	return run->asked && !run->keep[bound_by_name(launch, name).to];
}

ts_status ts_launch_sum(ts_run *run, const ts_launch *launch, const char *name, u64 *total)
{
	return ts_run_scan(run, (ts_buffer_id)bound_by_name(launch, name).to, total);
}

static bool has_tallies(const ts_launch *launch, const ts_pointers *p)
{
	for (u32 i = 0; i < p->n; i++) {
		const ts_bound bound = ts_launch_bound(launch, &p->pointer[i]);
		if (bound.bound && bound.role == TS_ROLE_TALLY) return true;
	}
	return false;
}

/* Memory that the stage lends stays where it is. */
static ts_status set(ts_run *run, const ts_bound *bound, i64 *tallies, u8 *at)
{
	void *to = NULL;
	if (bound->bound && bound->role == TS_ROLE_WORK) return TS_OK;
	if (bound->bound && bound->role == TS_ROLE_TALLY) {
		to = tallies + bound->to;
	} else if (bound->bound) {
		assert(bound->to < TS_N_BUFFERS);
		if (is_written(bound->role) && make(run, (ts_buffer_id)bound->to, bound->role, 0) != TS_OK) return TS_ERROR;
		to = ts_frame_handle(&run->frame, (ts_buffer_id)bound->to);
	}
	memcpy(at, &to, sizeof to);
	return TS_OK;
}

ts_status ts_launch_fill(ts_run *run, const ts_launch *launch, void *args, size_t bytes)
{
	const ts_pointers *p = ts_kernel_pointers(launch->kernel);
	assert(bytes == ts_kernel_args(launch->kernel)->bytes);
	for (const ts_bind *b = launch->bind; b->how != TS_BINDS_END; b++) assert(ts_launch_knows(launch, b->name));
	i64 *tallies = has_tallies(launch, p) ? ts_frame_tallies(&run->frame) : NULL;
	for (u32 i = 0; i < p->n; i++) {
		const ts_bound bound = ts_launch_bound(launch, &p->pointer[i]);
		if (set(run, &bound, tallies, (u8 *)args + p->pointer[i].offset) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Leaves out buffers that the launch writes. */
ts_status ts_launch_ask(const ts_run *run, const ts_launch *launch, void *args, size_t bytes)
{
	const ts_pointers *p = ts_kernel_pointers(launch->kernel);
	assert(bytes == ts_kernel_args(launch->kernel)->bytes);
	for (u32 i = 0; i < p->n; i++) {
		const ts_bound bound = ts_launch_bound(launch, &p->pointer[i]);
		bool read = bound.bound && bound.role == TS_ROLE_IN;
		const ts_buffer *buffer = read ? &run->frame.buffer[bound.to] : NULL;
		if (read && !buffer->made) return ts_fail("%s: is not there", ts_buffer_table[bound.to].name);
		const void *to = read ? ts_frame_data(&run->frame, (ts_buffer_id)bound.to) : NULL;
		memcpy((u8 *)args + p->pointer[i].offset, &to, sizeof to);
	}
	return TS_OK;
}

ts_status ts_launch_items(ts_run *run, const ts_launch *launch, const void *args, u64 n)
{
	ts_backend *backend = ts_run_backend_of(run);
	return backend->launch(backend, &run->frame, launch, args, n);
}

bool ts_launch_at_once(ts_run *run, const ts_launch *launch, const void *source, const void *args, u64 n)
{
	ts_backend *backend = ts_run_backend_of(run);
	return backend->at_once != NULL && backend->at_once(backend, launch->kernel, source, args, n);
}

ts_status ts_launch_run(ts_run *run, const ts_launch *launch, void *args, size_t bytes, u64 n)
{
	return ts_launch_fill(run, launch, args, bytes) == TS_OK ? ts_launch_items(run, launch, args, n) : TS_ERROR;
}
