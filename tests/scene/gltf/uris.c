/* Data URIs (RFC 2397): a buffer in base64 and the same, percent-encoded, give the same scene. */
#include "tests/scene/gltf/files.h"

enum { BYTES = 36 };

static unsigned char buffer[BYTES];

static int set_up(void **state)
{
	(void)state;
	const f32 positions[9] = {0.0f, 0.0f, 0.1f, 1.0f, 0.0f, -0.7f, 0.0f, 1e-3f, 3e7f};
	memcpy(buffer, positions, sizeof buffer);
	return 0;
}

/* Every byte as %XX, or as itself where RFC 3986 has it unreserved and `plainly` says so. */
static void percent(char *to, bool plainly, const char *digits)
{
	for (size_t i = 0; i < BYTES; i++) {
		unsigned char c = buffer[i];
		bool unreserved = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
		to += plainly && unreserved ? sprintf(to, "%c", c) : sprintf(to, "%%%c%c", digits[c >> 4], digits[c & 15]);
	}
}

static ts_build *load(const char *head, const char *data)
{
	char text[2048];
	snprintf(
		text, sizeof text,
		"{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%d,\"uri\":\"data:%s,%s\"}],\"bufferViews\":"
		"[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"type\":"
		"\"VEC3\",\"count\":3}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
		"\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]}",
		BYTES, head, data);
	return load_text(text, NULL, 8);
}

static void assert_positions(const char *head, const char *data)
{
	ts_build *build = load(head, data);
	if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
	const ts_scene *scene = ts_build_peek(build);
	assert_int_equal(scene->n_vertices, 3);
	for (size_t i = 0; i < 3; i++) assert_memory_equal(scene->vertices[i].position, buffer + 12 * i, 12);
	ts_build_free(build);
}

static void base64_gives_the_same_buffer(void **state)
{
	(void)state;
	char data[BYTES / 3 * 4 + 5], longer[64];
	base64(data, buffer, BYTES);
	assert_positions("application/octet-stream;base64", data);
	assert_positions("application/gltf-buffer;base64", data);
	assert_positions("application/octet-stream;charset=binary;base64", data);
	for (int extra = 1; extra <= 2; extra++) {
		snprintf(longer, sizeof longer, "%s%s", data, extra == 1 ? "AA==" : "AAA=");
		assert_positions("application/octet-stream;base64", longer);
	}
}

static void percent_encoding_gives_the_same_buffer(void **state)
{
	(void)state;
	char data[3 * BYTES + 1];
	for (int plainly = 0; plainly < 2; plainly++) {
		percent(data, plainly, plainly ? "0123456789ABCDEF" : "0123456789abcdef");
		assert_positions("application/octet-stream", data);
		assert_positions("application/gltf-buffer;charset=binary", data);
		assert_positions("Application/Octet-Stream", data);
	}
}

static void wrong_data_uris_are_refused(void **state)
{
	(void)state;
	char data[3 * BYTES + 1], coded[BYTES / 3 * 4 + 1];
	percent(data, false, "0123456789abcdef");
	base64(coded, buffer, BYTES);
	assert_refused(load("text/html", data), "media type \"text/html\"; application/octet-stream");
	assert_refused(load("application/octet-stream", ""), "buffers/0/uri: a data URI that holds nothing");
	assert_refused(load("application/octet-stream;base64", ""), "buffers/0/uri: a data URI that holds nothing");
	assert_refused(load("application/octet-stream", "abc"), "buffers/0/uri holds 3 bytes; byteLength says 36");
	base64(coded, buffer, BYTES - 1);
	assert_refused(load("application/octet-stream;base64", coded), "buffers/0/uri holds 35 bytes; byteLength says 36");
	base64(coded, buffer, BYTES - 2);
	assert_refused(load("application/octet-stream;base64", coded), "buffers/0/uri holds 34 bytes; byteLength says 36");
	base64(coded, buffer, BYTES);
	coded[0] = '*';
	assert_refused(load("application/octet-stream;base64", coded), "byte 0 of the data is no base64");
	coded[0] = '=';
	assert_refused(load("application/octet-stream;base64", coded), "byte 0 of the data is no base64");
	assert_refused(load("application/octet-stream;base64", coded + 1), "47 base64 characters; a multiple of 4");
	base64(coded, buffer, BYTES);
	memcpy(coded + BYTES / 3 * 4 - 3, "===", 3);
	assert_refused(load("application/octet-stream;base64", coded), "byte 45 of the data is no base64");
	data[3 * (BYTES - 2)] = 0;
	assert_refused(load("application/octet-stream", data), "buffers/0/uri holds 34 bytes; byteLength says 36");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(base64_gives_the_same_buffer),
		cmocka_unit_test(percent_encoding_gives_the_same_buffer),
		cmocka_unit_test(wrong_data_uris_are_refused),
	};
	return cmocka_run_group_tests(tests, set_up, NULL);
}
