/* Goldens by the library: those of the repository hold; one whose digest, element, parameter or picture is another is
 * told, and a folder that is none is refused. */
#include <sys/stat.h>
#include <unistd.h>
#include "tests/api/api.h"

#define GOLDEN "reference/goldens/small-epr"

static ts_context *context;
static char folder[FOLDER];

static void run(const char *format, ...) __attribute__((format(printf, 1, 2)));
static void run(const char *format, ...)
{
	char command[1024];
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(command, sizeof command, format, arguments);
	va_end(arguments);
	assert_int_equal(system(command), 0);
}

static void copy(void) { run("rm -rf '%s'/golden && cp -r %s '%s'/golden", folder, GOLDEN, folder); }

static ts_status check(ts_golden_judged *judged)
{
	char path[PATH];
	snprintf(path, sizeof path, "%s/golden", folder);
	*judged = (ts_golden_judged){.bytes = sizeof *judged};
	return ts_golden_check(context, judged, path);
}

static void the_golden_of_the_repository_holds(void **state)
{
	(void)state;
	ts_golden_judged judged = {.bytes = sizeof judged};
	done(ts_golden_check(context, &judged, GOLDEN));
	assert_string_equal(judged.effect, "reflections");
	assert_string_equal(judged.method, "epr");
	assert_int_equal(judged.buffer[0] + judged.stage[0] + judged.text[0], 0);
}

/* The last byte of a file that is stored, and its digest with it: where it differs is told by element. */
static void a_wrong_element_is_told(void **state)
{
	(void)state;
	ts_golden_judged judged;
	copy();
	run("cd '%s'/golden/small && name=$(echo *-image.radiance.npy) && printf '\\100' |"
	    "dd of=$name bs=1 seek=$(($(stat -c %%s $name) - 1)) conv=notrunc status=none &&"
	    "hex=$(sha256sum $name | cut -c1-64) && sed -i \"s/^[^ ]*  $name/$hex  $name/\" ../SHA256SUMS",
	    folder);
	assert_int_equal(check(&judged), TS_DIFFERENT);
	assert_string_equal(judged.stage, "image");
	assert_string_equal(judged.buffer, "image.radiance");
	assert_non_null(strstr(judged.text, "element [35, 63, 2]"));
	copy();
	run("sed -i '/-image.radiance.npy/s/^../zz/' '%s'/golden/SHA256SUMS", folder);
	refused(check(&judged), "SHA256SUMS");
}

static void wrong_parameters_of_a_golden_are_refused(void **state)
{
	(void)state;
	ts_golden_judged judged;
	copy();
	run("sed -i 's/^width=.*/width=65536/' '%s'/golden/params.txt", folder);
	refused(check(&judged), "width");
	run("sed -i 's/^width=.*/width=8192/;s/^height=.*/height=8192/' '%s'/golden/params.txt", folder);
	refused(check(&judged), "a golden has at most");
	copy();
	run("sed -i 's/^method=.*/method=magic/' '%s'/golden/params.txt", folder);
	refused(check(&judged), "no such method");
	copy();
	run("sed -i 's|^scene=.*|scene=/etc/passwd|' '%s'/golden/params.txt", folder);
	refused(check(&judged), "neither a built-in scene");
	assert_int_equal(judged.scene[0], 0);
}

static void wrong_files_beside_a_golden_are_told(void **state)
{
	(void)state;
	ts_golden_judged judged;
	uint8_t *rgb = calloc(1024 * 1024, 3);
	char path[PATH];
	assert_non_null(rgb);
	copy();
	snprintf(path, sizeof path, "%s/golden/preview.png", folder);
	done(ts_image_write_png(path, rgb, 9, 7, 3, NULL));
	assert_int_equal(check(&judged), TS_DIFFERENT);
	assert_int_equal(judged.buffer[0], 0);
	assert_non_null(strstr(judged.text, "preview.png"));
	copy();
	run("printf 'a\\001b\\n' > '%s'/golden/CHANGES", folder);
	refused(check(&judged), "CHANGES");
	copy();
	run("rm '%s'/golden/SHA256SUMS", folder);
	refused(check(&judged), "SHA256SUMS");
	run("rm -rf '%s'/golden", folder);
	refused(check(&judged), "golden");
	judged.bytes = 8;
	refused(ts_golden_check(context, &judged, GOLDEN), "bytes");
	free(rgb);
}

static int set_up(void **state)
{
	(void)state;
	context = open_context(2);
	make_folder(folder);
	return 0;
}

static int tear_down(void **state)
{
	(void)state;
	remove_folder(folder);
	ts_context_close(context);
	return 0;
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_golden_of_the_repository_holds),
		cmocka_unit_test(a_wrong_element_is_told),
		cmocka_unit_test(wrong_parameters_of_a_golden_are_refused),
		cmocka_unit_test(wrong_files_beside_a_golden_are_told),
	};
	return cmocka_run_group_tests(tests, set_up, tear_down);
}
