// As example.c, in C++: whether a port's stage is wrong, given what came before.
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

int main()
{
	ts_context *c = nullptr;
	ts_params *params = nullptr;
	check(ts_context_open(&c, nullptr));
	check(ts_params_make(&params));
	check(ts_params_set(params, "width", "96"));
	check(ts_params_set(params, "height", "54"));
	auto scene = make(ts_scene_free, ts_scene_open, c, "gallery:triangles=10000", params, nullptr);
	auto ours = make(ts_trace_close, ts_trace_run, c, scene.get(), params, "reflections", "mvr", nullptr);
	auto port = make(ts_trace_close, ts_trace_candidate, c, ours.get(), 0);
	const ts_buffer_view *image = ts_trace_buffer(ours.get(), "image.radiance");
	const float *right = static_cast<const float *>(image->data);
	std::vector<float> theirs(right, right + 54 * 96 * 3);
	theirs[1000] *= 1.0000001f;
	check(ts_trace_put(port.get(), image->name, 3, image->shape, theirs.data(), theirs.size() * sizeof(float)));
	auto verdicts = make(ts_verdicts_free, ts_replay, c, "image", ours.get(), port.get(), nullptr);
	std::puts(ts_verdicts_first(verdicts.get())->line);
}
