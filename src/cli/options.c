/* The options of all commands and their parser, over getopt_long. */
#include <errno.h>
#include <getopt.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <strings.h>
#include "cli.h"
#include "sweep.h"
#include "truths.h"

const ts_option ts_option_table[] = {
	{ TS_OPT_EFFECT, "effect", "EFFECT", "what is rendered (reflections)", "methods" },
	{ TS_OPT_METHOD, "method", "NAME,...", "methods to run, or \"all\"; by default all but vir", "methods" },
	{ TS_OPT_TRUTH, "truth", "[=NAME,...]", "ground truth to judge by: those named, or without names each of the\n"
	  "effect; \"none\". Also rays through off-screen texels, and those of lights' maps: holes,\n"
	  "leaks, wrong depths", "truths" },
	{ TS_OPT_SIZE, "size", "WxH", "size of the eye image in pixels", "" },
	{ TS_OPT_FRAME, "frame", "K", "frame of the animation", "" },
	{ TS_OPT_REFLECTORS, "reflectors", "N", "mirrors that are added to the scene", "" },
	{ TS_OPT_REFLECTOR, "reflector", "NAME", "node of the file to make a mirror of", "" },
	{ TS_OPT_FROM_MESH, "from-mesh", "N", "sample about N surfels from the scene's triangles", "" },
	{ TS_OPT_CAMERA, "camera", "NAME", "camera of the file; without it the eye circles the scene", "" },
	{ TS_OPT_SCENE, "scene", "SPEC,...", "scenes to measure, instead of the table's", "" },
	{ TS_OPT_OBJECTS, "objects", "N,...", "numbers of mirrors or light samples, or sizes, instead of the table's", "" },
	{ TS_OPT_RUNS, "runs", "N", "runs of which the median is taken (3; bench backends: 5)", "" },
	{ TS_OPT_SET, "set", "NAME=VALUE", "any parameter, repeatable", "params" },
	{ TS_OPT_THREADS, "threads", "N", "threads, by default one a core; never changes a result", "" },
	{ TS_OPT_BACKEND, "backend", "NAME", "what runs the kernels (c); never changes a result", "backends" },
	{ TS_OPT_DEVICE, "device", "N", "the backend's device (0)", "backends" },
	{ TS_OPT_WORK_GROUP, "work-group", "N", "items of a work group of the device (64); 0: the driver chooses", "" },
	{ TS_OPT_BUILD, "build", "OPTIONS", "more options for the compiler of the device's driver", "" },
	{ TS_OPT_INEXACT, "inexact", "", "also a device that breaks the numeric contract; the trace says so", "" },
	{ TS_OPT_REQUIRE, "require", "", "a backend without a device is an error, not skipped with exit code 77", "" },
	{ TS_OPT_REFERENCE, "reference", "", "turn all fast paths off", "" },
	{ TS_OPT_OUTPUT, "output", "DIR", "folder to write, whole or not at all (render: out). Short: -o DIR", "" },
	{ TS_OPT_FORCE, "force", "", "replace DIR if an earlier run wrote it", "" },
	{ TS_OPT_CHECK, "check", "DIR", "folder of what a port computed, to be judged", "" },
	{ TS_OPT_NO_IMAGES, "no-images", "", "write no files", "" },
	{ TS_OPT_TRACE, "trace", "", "write every buffer of every stage to DIR/trace-METHOD (reference/TRACES.md)", "" },
	{ TS_OPT_TRACE_ONLY, "trace-only", "STAGE,...", "trace, but files of these stages only; \"scene\": the scene's arrays",
	  "stages" },
	{ TS_OPT_CROP, "crop", "X,Y,W,H", "trace, but this part only of buffers that have a row a row of pixels", "" },
	{ TS_OPT_VIEWER, "viewer", "", "trace, and EXR, PLY and PNG copies for viewers in DIR/view-METHOD", "" },
	{ TS_OPT_MARGINS, "margins", "", "trace, and also how near every decision was, for compare --decided", "" },
	{ TS_OPT_DECIDED, "decided", "", "judge only what the reference, rendered with --margins, decides", "" },
	{ TS_OPT_FORCED, "forced", "", "judge each stage by what it makes of CANDIDATE's own inputs", "" },
	{ TS_OPT_ULP, "ulp", "N", "floats may be N floats apart", "" },
	{ TS_OPT_ABS, "abs", "A", "floats may be A apart", "" },
	{ TS_OPT_REL, "rel", "R", "floats may be R times the reference's value apart", "" },
	{ TS_OPT_ALLOW, "allow", "N", "N elements of a buffer may differ", "" },
	{ TS_OPT_IGNORE, "ignore", "NAME,...", "buffers, or fields as buffer.field, that are not judged", "buffers" },
	{ TS_OPT_MASK, "mask", "FILE", "PNG of the eye's size: pixels that are black in it are not judged", "" },
	{ TS_OPT_LAYOUT, "layout", "NAME=FILE,...",
	  "CANDIDATE has no trace.json: these are its buffers, .npy or raw little-endian", "buffers" },
	{ TS_OPT_ORDER, "order", "ORDER", "of the points: canonical (the default), or arrival, as threads append them", "" },
	{ TS_OPT_JUNIT, "junit", "FILE", "also write the verdicts as JUnit XML, a case a stage", "" },
	{ TS_OPT_TAP, "tap", "", "print the verdicts as TAP, a line a stage", "" },
	{ TS_OPT_PIXEL, "pixel", "X,Y", "pixel of the eye, or texel of what --view names, from the top left", "" },
	{ TS_OPT_VIEW, "view", "VIEW",
	  "eye (the default), REFLECTOR.FACE of a cube: 3.+X, or 3.0, or half a map of MegaViews: LIGHT.front, nodeN.back", "" },
	{ TS_OPT_TRIANGLE, "triangle", "T", "triangle, from 0", "" },
	{ TS_OPT_POINT, "point", "P", "point, by its index or its key PIECE,X,Y", "" },
	{ TS_OPT_STAGE, "stage", "NAME", "the stage to replay; without it all, one after the other", "stages" },
	{ TS_OPT_INPUTS, "inputs", "DIR", "trace of a port: its buffers are taken and judged before those of TRACE", "" },
	{ TS_OPT_JSON, "json", "", "print one JSON object and nothing else", "" },
	{ TS_OPT_FLUSH_DENORMALS, "flush-denormals", "", "let the processor flush denormals, which must not change a digest",
	  "" },
	{ TS_OPT_REASON, "reason", "TEXT", "why a golden changes, one line for CHANGES", "" },
	{ TS_OPT_REFERENCE_DIR, "reference-dir", "DIR", "folder of the goldens (reference)", "" },
	{ TS_OPT_HELP, "help", "", "this text. Short: -h", "" },
	{ 0 }
};

/* LONG: what getopt_long answers for the first long option, above every letter. */
enum { LONG = 256, MAX_OPTIONS = 64, MAX_THREADS = 1024, MAX_WORK_GROUP = 4096, MAX_RUNS = 1000 };

bool ts_cli_given(const ts_cli *cli, u64 option) { return (cli->given & option) != 0; }

ts_status ts_cli_count(u32 *value, const char *text, u32 min, u32 max, const char *what)
{
	char *end;
	errno = 0;
	unsigned long n = strtoul(text, &end, 10);
	if (text[0] < '0' || text[0] > '9' || *end != 0 || errno != 0 || n < min || n > max) {
		return ts_fail("%s: \"%s\" is not a whole number from %u to %u", what, text, (unsigned)min, (unsigned)max);
	}
	*value = (u32)n;
	return TS_OK;
}

bool ts_cli_item(const char **list, char *item, size_t item_bytes)
{
	if (*list == NULL) return false;
	const char *comma = strchr(*list, ',');
	size_t n = comma != NULL ? (size_t)(comma - *list) : strlen(*list);
	snprintf(item, item_bytes, "%.*s", (int)(n < item_bytes ? n : item_bytes - 1), *list);
	*list = comma != NULL ? comma + 1 : NULL;
	return true;
}

static ts_status set_param(ts_cli *cli, const char *assignment)
{
	char name[64];
	const char *equals = strchr(assignment, '=');
	if (equals == NULL) return ts_fail("--set %s: no \"=\"; write --set NAME=VALUE", assignment);
	snprintf(name, sizeof name, "%.*s", (int)(equals - assignment < 64 ? equals - assignment : 63), assignment);
	size_t n;
	const ts_param_info *params = ts_param_table(&n);
	ts_nearest nearest = ts_nearest_begin(name);
	for (size_t i = 0; i < n; i++) ts_nearest_offer(&nearest, params[i].name);
	if (strcmp(name, "reflectors") == 0) cli->given |= TS_OPT_REFLECTORS;
	if (nearest.distance != 0) {
		return ts_fail("--set %s: no such parameter; the nearest is %s%s", name, nearest.best,
		               ts_cli_find("list") != NULL ? ", and \"touchstone list params\" lists all" : "");
	}
	return strchr(equals, ',') != NULL ? ts_sweep_add(&cli->sweep, &cli->params, name, equals + 1)
	                                   : ts_params_set(&cli->params, name, equals + 1);
}

#define DIGITS "0123456789"

ts_status ts_cli_size(ts_params *params, const char *text, const char *what)
{
	char width[32];
	const char *x = strpbrk(text, "xX");
	if (x == NULL || x - text >= (ptrdiff_t)sizeof width || strspn(text, DIGITS) != (size_t)(x - text) || x == text ||
	    x[1] == 0 || x[1 + strspn(x + 1, DIGITS)] != 0) {
		return ts_fail("%s %s: not a size; write WIDTHxHEIGHT, for instance 1920x1080", what, text);
	}
	snprintf(width, sizeof width, "%.*s", (int)(x - text), text);
	ts_status status = ts_params_set(params, "width", width);
	return status != TS_OK ? status : ts_params_set(params, "height", x + 1);
}

static ts_status set_number(u64 *value, const char *text, const char *what)
{
	u32 n = 0;
	ts_status status = ts_cli_count(&n, text, 0, 4294967295u, what);
	*value = n;
	return status;
}

static ts_status set_distance(double *value, const char *text, const char *what)
{
	char *end;
	double distance = strtod(text, &end);
	if (text[0] == 0 || *end != 0 || !(distance >= 0) || distance > 1e30) {
		return ts_fail("%s: \"%s\" is not a number from 0 to 1e30", what, text);
	}
	*value = distance;
	return TS_OK;
}

static ts_status set_order(ts_cli *cli, const char *text)
{
	cli->how.arrival = strcmp(text, "arrival") == 0;
	if (cli->how.arrival || strcmp(text, "canonical") == 0) return TS_OK;
	return ts_fail("--order: no order \"%s\"; there are canonical and arrival", text);
}

static ts_status take(ts_cli *cli, u64 bit, const char *text)
{
	cli->given |= bit;
	switch (bit) {
	case TS_OPT_EFFECT: cli->effect = text; break;
	case TS_OPT_METHOD: cli->method = text; break;
	case TS_OPT_TRUTH: cli->truth = text; break;
	case TS_OPT_SIZE: return ts_cli_size(&cli->params, text, "--size");
	case TS_OPT_FRAME: return ts_params_set(&cli->params, "frame", text);
	case TS_OPT_REFLECTORS: return ts_params_set(&cli->params, "reflectors", text);
	case TS_OPT_FROM_MESH: return ts_params_set(&cli->params, "from_mesh", text);
	case TS_OPT_REFLECTOR: cli->scene.reflector = text; break;
	case TS_OPT_CAMERA: cli->scene.camera = text; break;
	case TS_OPT_SCENE: cli->scenes = text; break;
	case TS_OPT_OBJECTS: cli->objects = text; break;
	case TS_OPT_OUTPUT: cli->output = text; break;
	case TS_OPT_ULP: return set_number(&cli->ulp, text, "--ulp");
	case TS_OPT_ALLOW: return set_number(&cli->allow, text, "--allow");
	case TS_OPT_ABS: return set_distance(&cli->abs, text, "--abs");
	case TS_OPT_REL: return set_distance(&cli->rel, text, "--rel");
	case TS_OPT_IGNORE: cli->ignore = text; break;
	case TS_OPT_MASK: cli->mask = text; break;
	case TS_OPT_LAYOUT: cli->layout = text; break;
	case TS_OPT_ORDER: return set_order(cli, text);
	case TS_OPT_JUNIT: cli->junit = text; break;
	case TS_OPT_PIXEL: cli->pixel = text; break;
	case TS_OPT_VIEW: cli->view = text; break;
	case TS_OPT_POINT: cli->point = text; break;
	case TS_OPT_TRIANGLE: return set_number(&cli->triangle, text, "--triangle");
	case TS_OPT_TRACE_ONLY: cli->trace_only = text; break;
	case TS_OPT_CROP: cli->crop = text; break;
	case TS_OPT_REASON: cli->reason = text; break;
	case TS_OPT_REFERENCE_DIR: cli->reference_dir = text; break;
	case TS_OPT_CHECK: cli->check = text; break;
	case TS_OPT_STAGE: cli->stage = text; break;
	case TS_OPT_INPUTS: cli->inputs = text; break;
	case TS_OPT_BACKEND: return ts_backend_find(&cli->backend, text);
	case TS_OPT_DEVICE: return ts_cli_count(&cli->device.device, text, 0, TS_MAX_DEVICES - 1, "--device");
	case TS_OPT_WORK_GROUP: return ts_cli_count(&cli->device.work_group, text, 0, MAX_WORK_GROUP, "--work-group");
	case TS_OPT_BUILD: cli->device.build = text; break;
	case TS_OPT_INEXACT: cli->device.inexact = true; break;
	case TS_OPT_REFERENCE: cli->how.reference = true; break;
	case TS_OPT_SET: return set_param(cli, text);
	case TS_OPT_THREADS: return ts_cli_count(&cli->how.threads, text, 1, MAX_THREADS, "--threads");
	case TS_OPT_RUNS: return ts_cli_count(&cli->runs, text, 1, MAX_RUNS, "--runs");
	default: break;
	}
	return TS_OK;
}

/* The options of `command` for getopt_long; val is LONG and the place in ts_option_table. */
static void long_options(struct option *list, const ts_command *command)
{
	u32 n = 0;
	for (int i = 0; ts_option_table[i].name != NULL; i++) {
		const ts_option *o = &ts_option_table[i];
		if ((command->options & o->bit) == 0 && o->bit != TS_OPT_HELP) continue;
		int has_argument = o->argument[0] == 0 ? no_argument : required_argument;
		has_argument = o->argument[0] == '[' ? optional_argument : has_argument;
		list[n++] = (struct option){ o->name, has_argument, NULL, LONG + i };
	}
	list[n] = (struct option){ NULL, 0, NULL, 0 };
}

/* Part of a character of several bytes is no text. */
static ts_status refuse_letter(const ts_command *command, u32 letter)
{
	char text[8];
	snprintf(text, sizeof text, letter > 32 && letter < 127 ? "%c" : "\\x%02x", letter);
	return ts_fail("%s: no option -%s; \"%s help %s\" lists all", command->name, text, ts_program, command->name);
}

static ts_status refuse(const ts_command *command, const struct option *list, int answer, char **argv)
{
	const char *typed = argv[optind - 1];
	if (answer == ':' && optopt == 'o') return ts_fail("%s: option -o needs a value, a folder", command->name);
	if (answer == ':') {
		const ts_option *o = &ts_option_table[optopt - LONG];
		return ts_fail("%s: option --%s needs a value, %s", command->name, o->name, o->argument);
	}
	if (optopt >= LONG) {
		return ts_fail("%s: option --%s takes no value", command->name, ts_option_table[optopt - LONG].name);
	}
	if (optopt != 0) return refuse_letter(command, (unsigned char)optopt);
	char name[64];
	snprintf(name, sizeof name, "%.*s", (int)strcspn(typed, "="), typed);
	ts_nearest nearest = ts_nearest_begin(name + strspn(name, "-"));
	for (; list->name != NULL; list++) ts_nearest_offer(&nearest, list->name);
	return ts_fail("%s: no option %s; the nearest is --%s, and \"%s help %s\" lists all", command->name, name,
	               nearest.best, ts_program, command->name);
}

static ts_status take_arguments(ts_cli *cli, const ts_command *command, int n, char **arguments)
{
	if ((u32)n < command->min_arguments) {
		return ts_fail("%s: too few arguments; write %s %s %s", command->name, ts_program, command->name,
		               command->arguments);
	}
	const char *last = n > 0 && ts_cli_given(cli, TS_OPT_TRUTH) ? arguments[n - 1] : "";
	if (ts_truths_named(last)) {
		return ts_fail("%s: \"%s\" stands alone; write --truth=%s, with \"=\"", command->name, last, last);
	}
	if ((u32)n > command->max_arguments) {
		return ts_fail("%s: one argument too many, \"%s\"; write %s %s %s", command->name,
		               arguments[command->max_arguments], ts_program, command->name, command->arguments);
	}
	for (int i = 0; i < n; i++) cli->arguments[cli->n_arguments++] = arguments[i];
	return TS_OK;
}

ts_status ts_cli_parse(ts_cli *cli, const ts_command *command, int argc, char **argv)
{
	struct option list[MAX_OPTIONS + 1];
	memset(cli, 0, sizeof *cli);
	ts_params_default(&cli->params);
	cli->backend = ts_backend_kinds[0];
	cli->device = (ts_backend_options){ .work_group = 64, .build = "" };
	cli->how.threads = (u32)omp_get_num_procs();
	cli->runs = 3;
	long_options(list, command);
	opterr = 0;
	optind = 1;
	const char *letters = (command->options & TS_OPT_OUTPUT) != 0 ? ":ho:" : ":h";
	for (int answer; (answer = getopt_long(argc, argv, letters, list, NULL)) != -1;) {
		if (answer == '?' || answer == ':') return refuse(command, list, answer, argv);
		u64 bit = answer == 'h' ? TS_OPT_HELP : answer == 'o' ? TS_OPT_OUTPUT : ts_option_table[answer - LONG].bit;
		ts_status status = take(cli, bit, optarg);
		if (status != TS_OK) return status;
	}
	cli->options = argv + 1;
	cli->n_options = (u32)optind - 1;
	return ts_cli_given(cli, TS_OPT_HELP) ? TS_OK : take_arguments(cli, command, argc - optind, argv + optind);
}
