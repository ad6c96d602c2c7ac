// As example.c, in C++: a wrong bit in a port's stage, found alone and given the port's own inputs.
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <touchstone/touchstone.h>
#include <vector>

static void check(ts_status status)
{
	if (status != TS_ERROR) return;
	std::fprintf(stderr, "%s\n", ts_error_message());
	std::exit(2);
}

// What a function of the API makes, which `release` releases at the end of its scope.
template <class T, class... P, class... A>
auto make(void (*release)(T *), ts_status (*function)(ts_context *, T **, P...), ts_context *context, A... arguments)
{
	T *handle = nullptr;
	check(function(context, &handle, arguments...));
	return std::unique_ptr<T, void (*)(T *)>(handle, release);
}

static ts_vertex corner(float x, float z) { return {{x, 0, z}, 0, {0, 1, 0}, 0, {}, {}, {1, 1, 1, 1}}; }

int main()
{
	const ts_vertex corners[] = {corner(-1, 1), corner(1, 1), corner(1, -1), corner(-1, -1)};
	const ts_triangle halves[] = {{{0, 1, 2}, TS_NO_INDEX}, {{0, 2, 3}, TS_NO_INDEX}};
	ts_scene_arrays arrays = {};
	arrays.bytes = sizeof arrays;
	arrays.vertices = corners, arrays.n_vertices = 4;
	arrays.triangles = halves, arrays.n_triangles = 2;
	ts_context *c = nullptr;
	ts_params *params = nullptr;
	check(ts_context_open(&c, nullptr));
	check(ts_params_make(&params));
	check(ts_params_set(params, "width", "96"));
	check(ts_params_set(params, "height", "54"));
	auto scene = make(ts_scene_free, ts_scene_make, c, &arrays, params, nullptr);
	auto ours = make(ts_trace_close, ts_trace_run, c, scene.get(), params, "reflections", "epr", nullptr);
	auto port = make(ts_trace_close, ts_trace_candidate, c, ours.get(), 0);
	const ts_buffer_view *keys = ts_trace_buffer(ours.get(), "eye.depth_triangle");
	const uint64_t *right = static_cast<const uint64_t *>(keys->data);
	std::vector<uint64_t> theirs(right, right + 54 * 96);
	theirs[27 * 96 + 48] ^= 1ull << 32;
	check(ts_trace_put(port.get(), keys->name, keys->n_dims, keys->shape, theirs.data(), theirs.size() * 8));
	auto alone = make(ts_verdicts_free, ts_compare, c, ours.get(), port.get(), nullptr);
	auto given = make(ts_verdicts_free, ts_replay, c, "eye", ours.get(), port.get(), nullptr);
	std::puts(ts_verdicts_first(alone.get())->line);
	std::puts(ts_verdicts_first(given.get())->line);
}
