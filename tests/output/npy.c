/* .npy headers against the specification of the format, by a parser of its own; and every way to damage one. */
#include "tests/trace/folder.h"

static const struct {
	const char *descr;
	size_t bytes;
} dtypes[] = {
	{"'|u1'", 1},
	{"'<f4'", 4},
	{"'<u8'", 8},
	{"[('centre', '<f4', (3,)), ('piece', '<u4')]", 16},
};

static const char *const words[] = {"descr", "fortran_order", "shape"};

/* Reads a header by the letter of the specification: magic, version, length, a dictionary literal whose keys ascend,
 * blanks, a line feed; the data begin at a multiple of 64. Returns its bytes and the text of the values. */
static size_t spec_parse(const char *head, char values[3][2048])
{
	const unsigned char *raw = (const unsigned char *)head;
	assert_memory_equal(raw, "\x93NUMPY\x01\x00", 8);
	size_t bytes = 10u + raw[8] + 256u * raw[9];
	assert_int_equal(bytes % 64, 0);
	assert_int_equal(head[bytes - 1], '\n');
	const char *at = head + 10;
	assert_int_equal(*at++, '{');
	for (int k = 0; k < 3; k++) {
		char key[32];
		int n = snprintf(key, sizeof key, "'%s': ", words[k]);
		assert_memory_equal(at, key, n);
		at += n;
		const char *next = k < 2 ? strstr(at, k == 0 ? ", 'fortran_order'" : ", 'shape'") : strstr(at, ", }");
		assert_non_null(next);
		snprintf(values[k], sizeof values[k], "%.*s", (int)(next - at), at);
		at = next + 2;
	}
	assert_int_equal(*at++, '}');
	for (; at < head + bytes - 1; at++) assert_int_equal(*at, ' ');
	return bytes;
}

static ts_status parse(ts_npy *npy, const char *head, size_t head_bytes, u64 data_bytes)
{
	return ts_npy_parse(npy, "file", head, head_bytes, head_bytes + data_bytes, "'<f4'", 4);
}

static void headers_follow_the_specification(void **state)
{
	(void)state;
	static const struct {
		u32 n_dims;
		u64 shape[4];
		const char *text;
	} cases[] = {
		{1, {0}, "(0,)"},
		{1, {7}, "(7,)"},
		{2, {3, 4}, "(3, 4)"},
		{3, {1080, 1920, 3}, "(1080, 1920, 3)"},
		{4, {1, 2, 3, 4}, "(1, 2, 3, 4)"},
		{1, {UINT64_MAX}, "(18446744073709551615,)"},
	};
	char head[TS_NPY_HEADER], values[3][2048];
	for (u32 d = 0; d < sizeof dtypes / sizeof *dtypes; d++) {
		for (u32 c = 0; c < sizeof cases / sizeof *cases; c++) {
			size_t bytes = ts_npy_header(head, dtypes[d].descr, cases[c].n_dims, cases[c].shape);
			assert_int_equal(spec_parse(head, values), bytes);
			assert_string_equal(values[0], dtypes[d].descr);
			assert_string_equal(values[1], "False");
			assert_string_equal(values[2], cases[c].text);
		}
	}
}

static void headers_read_back_what_was_written(void **state)
{
	(void)state;
	char head[TS_NPY_HEADER];
	for (u32 d = 0; d < sizeof dtypes / sizeof *dtypes; d++) {
		ts_npy npy;
		const u64 shape[] = {5, 3};
		size_t bytes = ts_npy_header(head, dtypes[d].descr, 2, shape), data = 15 * dtypes[d].bytes;
		assert_int_equal(ts_npy_parse(&npy, "f", head, bytes, bytes + data, dtypes[d].descr, dtypes[d].bytes), TS_OK);
		assert_true(npy.n == 15 && npy.n_dims == 2 && npy.shape[0] == 5 && npy.shape[1] == 3 && npy.data_at == bytes);
	}
}

/* Other writers: orders of keys, quotes, blanks, versions with longer prefixes, no padding. */
static void headers_of_other_writers_are_read(void **state)
{
	(void)state;
	static const char *const dicts[] = {
		"{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }",
		"{'shape':(2,3),'descr':'<f4','fortran_order':False}",
		"{\"descr\": \"<f4\", \"shape\": (2, 3,), \"fortran_order\": False}",
		" { 'shape' : ( 2 , 3 ) ,\n'descr' : '<f4' , 'fortran_order' : False } \n",
	};
	for (u32 i = 0; i < sizeof dicts / sizeof *dicts; i++) {
		for (int version = 1; version <= 3; version++) {
			char head[2048] = "\x93NUMPY";
			ts_npy npy;
			size_t prefix = version == 1 ? 10 : 12, n = strlen(dicts[i]);
			head[6] = (char)version;
			head[8] = (char)n;
			memcpy(head + prefix, dicts[i], n);
			if (parse(&npy, head, prefix + n, 24) != TS_OK)
				fail_msg("%d %s: %s", version, dicts[i], ts_error_message());
			assert_true(npy.n == 6 && npy.data_at == prefix + n);
		}
	}
}

static void refuses(const char *dict, const char *what)
{
	char head[2048];
	ts_npy npy;
	size_t n = npy_head(head, dict);
	if (parse(&npy, head, n, 24) == TS_OK) fail_msg("%s is taken", dict);
	says(what);
}

static const char *const none[] = {
	"",
	"{",
	"}",
	"{}",
	"{'descr'",
	"{'descr': ",
	"{'descr': }",
	"{'descr': '<f4'}",
	"{'descr': '<f4', 'fortran_order': False}",
	"{'descr': '<f4', 'fortran_order': False, 'shape': }",
	"{'descr': '<f4', 'fortran_order': False, 'shape': (6,)",
	"{'descr': '<f4', 'fortran_order': False, 'shape': (6,)} x",
	"{'descr': '<f4', 'descr': '<f4', 'fortran_order': False, 'shape': (6,)}",
	"{'descr': '<f4', 'fortran_order': False, 'shape': (6,), 'shape': (6,)}",
	"{'descr': '<f4', 'fortran_order': False, 'shape': (6,), 'other': 1}",
	"{'descr' '<f4', 'fortran_order': False, 'shape': (6,)}",
	"{'descr': '<f4' 'fortran_order': False, 'shape': (6,)}",
	"['descr', '<f4']",
	"{descr: '<f4', fortran_order: False, shape: (6,)}",
};
static const char *const shapes[] = {
	"()",
	"(,)",
	"6",
	"(6)",
	"[6]",
	"(6,,)",
	"(-6,)",
	"(+6,)",
	"(6.0,)",
	"(0x6,)",
	"(6L,)",
	"('6',)",
	"(1, 1, 1, 1, 6)",
	"(6 1)",
	"(18446744073709551616,)",
	"(4294967296, 4294967296)",
	"(4611686018427387904,)",
	"(None,)",
	"(99999999999999999999999999999999999999999999,)",
	"(6,) (6,)",
};
static const char *const others[] = {
	"'>f4'", "'<f8'", "'<i4'",         "'<u4'",  "'f4'",       "'=f4'",  "'|f4'",
	"'<f4",  "<f4",   "[('', '<f4')]", "'< f4'", "('<f4', 1)", "'<f44'", "None",
};

static void malformed_headers_are_refused(void **state)
{
	(void)state;
	char dict[256];
	for (u32 i = 0; i < sizeof none / sizeof *none; i++) refuses(none[i], "not a .npy file");
	for (u32 i = 0; i < sizeof shapes / sizeof *shapes; i++) {
		snprintf(dict, sizeof dict, "{'descr': '<f4', 'fortran_order': False, 'shape': %s, }", shapes[i]);
		refuses(dict, "file: its shape is not 1 to 4 whole numbers");
	}
	for (u32 i = 0; i < sizeof others / sizeof *others; i++) {
		snprintf(dict, sizeof dict, "{'descr': %s, 'fortran_order': False, 'shape': (6,), }", others[i]);
		refuses(dict, "file: ");
	}
	refuses("{'descr': '<f4', 'fortran_order': True, 'shape': (2, 3), }", "Fortran order");
	refuses("{'descr': '<f4', 'fortran_order': 0, 'shape': (2, 3), }", "file: ");
	refuses("{'descr': '<f4', 'fortran_order': False, 'shape': (7,), }", "24 bytes of data; its shape needs 28");
	refuses("{'descr': '<f4', 'fortran_order': False, 'shape': (5,), }", "24 bytes of data; its shape needs 20");
}

/* Cut anywhere, in a block of exactly that size: the sanitizers see a byte too many. */
static void truncated_headers_are_refused(void **state)
{
	(void)state;
	char head[TS_NPY_HEADER];
	const u64 shape[] = {6};
	size_t bytes = ts_npy_header(head, "'<f4'", 1, shape);
	for (size_t n = 0; n < bytes; n++) {
		ts_npy npy;
		char *cut = malloc(n + 1);
		assert_non_null(cut);
		memcpy(cut, head, n);
		assert_int_equal(ts_npy_parse(&npy, "f", cut, n, n, "'<f4'", 4), TS_ERROR);
		free(cut);
	}
}

/* Every byte of the prefix and of the text changed in every bit: never more data than the file has. */
static void no_flipped_bit_gives_more_data(void **state)
{
	(void)state;
	char head[TS_NPY_HEADER];
	const u64 shape[] = {6};
	size_t bytes = ts_npy_header(head, "'<f4'", 1, shape);
	for (size_t at = 0; at < bytes; at++) {
		for (int bit = 0; bit < 8; bit++) {
			ts_npy npy;
			char flipped[TS_NPY_HEADER];
			memcpy(flipped, head, bytes);
			flipped[at] ^= (char)(1 << bit);
			if (parse(&npy, flipped, bytes, 24) != TS_OK) continue;
			assert_true(npy.data_at + 4 * npy.n == bytes + 24);
			if (at < 8) fail_msg("byte %zu, bit %d of the prefix says nothing", at, bit);
		}
	}
}

int main(void)
{
	const struct CMUnitTest npy[] = {
		cmocka_unit_test(headers_follow_the_specification),  cmocka_unit_test(headers_read_back_what_was_written),
		cmocka_unit_test(headers_of_other_writers_are_read), cmocka_unit_test(malformed_headers_are_refused),
		cmocka_unit_test(truncated_headers_are_refused),     cmocka_unit_test(no_flipped_bit_gives_more_data),
	};
	return cmocka_run_group_tests(npy, NULL, NULL);
}
