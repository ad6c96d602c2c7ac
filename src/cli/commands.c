/* The command `touchstone`: its table of commands. */
#include <touchstone/image.h>
#include "golden.h"

#define WHERE \
	TS_OPT(SIZE), TS_OPT(FRAME), TS_OPT(REFLECTORS), TS_OPT(REFLECTOR), TS_OPT(ANIMATION), TS_OPT(FROM_MESH), \
		TS_OPT(CAMERA), TS_OPT(EYE), TS_OPT(TARGET), TS_OPT(PATH), TS_OPT(FOV), TS_OPT(MIRROR), TS_OPT(LAMP), \
		TS_OPT(SET)
#define HOW TS_OPT(THREADS), TS_OPT(REFERENCE), BACKEND
#define BACKEND TS_OPT(BACKEND), TS_OPT(DEVICE), TS_OPT(WORK_GROUP), TS_OPT(BUILD), TS_OPT(INEXACT), TS_OPT(REQUIRE)

const char *const ts_program = "touchstone";
const ts_preview ts_golden_preview = {ts_image_write_png, ts_image_decode};

const ts_command ts_command_table[] = {
	{"render",
     "EFFECT [SCENE]",
     "render an effect by one or more methods, and judge them by ground truth",
     "EFFECT: one of those below; all but reflections are shown without mirrors unless --reflectors says how many.\n"
     "SCENE: atrium (the default), gallery or dining, each also with \":triangles=COUNT:texels=SIDE\"; checkerboard,\n"
     "of surfels, also with \":surfels=COUNT\"; or a .gltf, .glb or .ply file. Writes METHOD.png and .exr,\n"
     "truth-NAME.png, differences, pictures of the stages, traces and report.json to DIR, and prints times, counters,\n"
     "memory and metrics. The header of each picture names its scene, parameters and version. Of a parameter with\n"
     "several values, --set NAME=A,B, every combination is rendered, in a folder of DIR each, and CSV is printed.",
     1,
     2,
     TS_OPT(METHOD),
     TS_OPT(TRUTH),
     TS_OPT(FRAMES),
     TS_OPT(EXPOSURE),
     WHERE,
     HOW,
     TS_OPT(ORDER),
     TS_OPT(SHARD),
     TS_OPT(OUTPUT),
     TS_OPT(FORCE),
     TS_OPT(NO_IMAGES),
     TS_OPT(TRACE),
     TS_OPT(TRACE_ONLY),
     TS_OPT(CROP),
     TS_OPT(MARGINS),
     TS_OPT(VIEWER),
     TS_OPT(REPORT),
     TS_OPT(QUIET),
     TS_OPT(JSON),
     .run = ts_render_command,
     .print_more = ts_render_help},
	{"replay", "TRACE", "run a stage again, alone, from the buffers of a trace or of a port, and compare",
     "TRACE: a folder that render --trace wrote. One line an output: the same bits, or the first element and field\n"
     "that differ. With --inputs the port's buffers are the inputs and its outputs are judged: each of its stages,\n"
     "given its own stages before. Buffers are checked before they are used. -o DIR writes what the stage should make.",
     1, 1, TS_OPT(STAGE), TS_OPT(INPUTS), TS_OPT(THREADS), TS_OPT(OUTPUT), TS_OPT(QUIET), TS_OPT(JSON),
     .run = ts_replay_command},
	{"explain", "TRACE [OTHER]", "what one item of a stage computes, line by line",
     "TRACE: a folder that render --trace wrote. The stage is replayed, and one item of its kernels tells each\n"
     "parameter, variable, decision, store and result, with its bits and its place in src/kernels. With --inputs the\n"
     "port's buffers are what it begins with. With OTHER, of the same method and parameters, it is explained from\n"
     "each trace's buffers, TRACE's where OTHER lacks one: < and > mark what differs, and the exit code is 1 if\n"
     "anything does.",
     1, 2, TS_OPT(STAGE), TS_OPT(ITEM), TS_OPT(KERNEL), TS_OPT(ELEMENT), TS_OPT(INPUTS), TS_OPT(PRIMITIVES),
     TS_OPT(LINES), TS_OPT(JSON), .run = ts_explain_command},
	{"info", "SCENE", "what was loaded, and what in the file was not understood", "", 1, 1, WHERE, TS_OPT(JSON),
     .run = ts_info_command},
	{"list", "WHAT", "stages, buffers, sizes, params, methods, truths, scenes, backends, vectors or benches",
     "params --method NAME: those that the method, of --effect or of any, and its scene read.", 1, 1, TS_OPT(EFFECT),
     TS_OPT(METHOD), TS_OPT(JSON), .run = ts_list_command},
	{"bench",
     "TABLE",
     "the papers' tables, measured here; and what the backends take",
     "TABLE: one of `list benches`:\n"
     "  a paper's table      its figures, and below them what must hold, and whether it does. The papers' GPUs are\n"
     "                       not this machine: compare ratios of times\n"
     "  backends             each stage in C, with 1 and with --threads threads, and on every device, or the one of\n"
     "                       --backend or --device; what bounds scattering; how long the kernels take to build, with\n"
     "                       an empty cache too where it is known how it is moved\n"
     "  start                the seconds from opening --backend to its first frames\n"
     "  speed                stages, Embree's rays for the same views, bare points, what memory allows, exponents\n"
     "\n"
     "What tables take:\n"
     "  --objects            numbers of mirrors or light samples; of speed, a growth's values\n"
     "  --scene              of speed, frames (S, A, M, ...) and growths (triangles, mirrors, maps, pixels, threads);\n"
     "                       epr-6, backends and start measure one scene, atrium, with one number of mirrors, 10\n"
     "  -o DIR               the report, each table as CSV, and plots as SVG are written to DIR\n"
     "  TS_SCENES            an environment variable: the folder of the models of ivir-1, ssagh-1 and ssagh-segments,\n"
     "                       scenes if it is not set",
     1,
     1,
     TS_OPT(METHOD),
     TS_OPT(SCENE),
     TS_OPT(OBJECTS),
     TS_OPT(RUNS),
     TS_OPT(BUSY),
     TS_OPT(TRUTH),
     TS_OPT(SIZE),
     TS_OPT(FRAME),
     TS_OPT(FRAMES),
     TS_OPT(SET),
     HOW,
     TS_OPT(OUTPUT),
     TS_OPT(FORCE),
     TS_OPT(JSON),
     .run = ts_bench_command},
	{"compare",
     "REFERENCE CANDIDATE",
     "two traces, buffers or images: where they first differ, and how much",
     "REFERENCE: a folder that render --trace wrote, or one of its .npy files, or an image.\n"
     "CANDIDATE: the same of a port (reference/TRACES.md says what it must have at least).\n"
     "Everything must be the same to the bit, unless a relaxation is typed. Exit code 0 same, 1 different, 2 could\n"
     "not. Ulps count floats from the reference to the candidate: positive where the candidate is greater.\n"
     "The first divergence is one line. With --forced each stage has a line, and each of its buffers that differs.\n"
     "Prefix sums are judged by their counts: the line names the thing whose count is wrong.\n"
     "With -o DIR, a picture of the pixels that differ for each buffer that has them, and of each cube that differs.\n"
     "Images: every typed --allow, --percent, --hardfail and --rmse must hold; without them no value may differ. The\n"
     "values of PNG and JPEG go from 0 to 1. EXR holds linear radiance, which --exposure E compares as displayed.",
     2,
     2,
     TS_OPT(FORCED),
     TS_OPT(FIRST),
     TS_OPT(THREADS),
     TS_OPT(DECIDED),
     TS_OPT(ULP),
     TS_OPT(ABS),
     TS_OPT(REL),
     TS_OPT(ALLOW),
     TS_OPT(PERCENT),
     TS_OPT(HARDFAIL),
     TS_OPT(RMSE),
     TS_OPT(EXPOSURE),
     TS_OPT(IGNORE),
     TS_OPT(BASELINE),
     TS_OPT(SKIP),
     TS_OPT(MASK),
     TS_OPT(LAYOUT),
     TS_OPT(ORDER),
     TS_OPT(SHARD),
     TS_OPT(JUNIT),
     TS_OPT(TAP),
     TS_OPT(REPORT),
     TS_OPT(OUTPUT),
     TS_OPT(FORCE),
     TS_OPT(QUIET),
     TS_OPT(JSON),
     .run = ts_compare_command,
     .failed = ts_compare_failed},
	{"report", "DIR...", "one page of HTML: pictures side by side, FLIP, heat maps, tables, first differences",
     "DIR: a trace, or a folder that render or compare wrote. Further traces of a method are compared with its first\n"
     "one. -o FILE.html is one file that needs no server and no network. It holds the pictures, and the probes of\n"
     "differing pixels on both sides; for any other pixel it shows the command that prints its probe.",
     1, TS_MAX_ARGUMENTS, TS_OPT(OUTPUT), TS_OPT(PPD), TS_OPT(PROBES), .run = ts_report_command},
	{"probe", "TRACE", "why a pixel, texel, triangle or point of a trace is what it is",
     "TRACE: a folder that render --trace wrote, or a port's.\n"
     "--pixel: who competed for it, who won by how much, and each term of its light; with --view a texel of a view\n"
     "that is not the eye's. --triangle, --point: where it went, and which stage lost it.\n"
     "What the buffers do not hold is computed again; each \"check\" says whether that has the bits of a buffer.\n"
     "What is told beside that, and of which methods:\n",
     1, 1, TS_OPT(PIXEL), TS_OPT(VIEW), TS_OPT(TRIANGLE), TS_OPT(POINT), TS_OPT(JSON), .run = ts_probe_command,
     .print_more = ts_probe_help},
	{"digest", "[SCENE]", "SHA-256 of every buffer of a built-in scene, in pipeline order", "", 0, 1, TS_OPT(EFFECT),
     TS_OPT(METHOD), TS_OPT(SIZE), TS_OPT(FRAME), TS_OPT(REFLECTORS), TS_OPT(SET), HOW, TS_OPT(FLUSH_DENORMALS),
     .run = ts_digest_command},
	{"golden",
     "ACTION [CASE]",
     "check, new or bless: the goldens of reference/",
     TS_GOLDEN_DETAILS,
     1,
     2,
     HOW,
     TS_OPT(SHARD),
     TS_OPT(BASELINE),
     TS_OPT(SKIP),
     TS_OPT(REASON),
     TS_OPT(REFERENCE_DIR),
     TS_OPT(JUNIT),
     TS_OPT(TAP),
     TS_OPT(OUTPUT),
     TS_OPT(FORCE),
     TS_OPT(QUIET),
     TS_OPT(JSON),
     .run = ts_golden_command,
     .failed = ts_golden_failed},
	{"merge", "DIR...", "results of shards, put together",
     "DIR: what a command with --shard I/N wrote to -o DIR; name all N folders. What merge writes, and says as JSON,\n"
     "TAP or JUnit XML, is what the command does without --shard, but for times. The exit code is the shards' worst.\n"
     "Refused: a shard that is missing or there twice, one of another run (commit, options, N), a damaged folder.",
     1, TS_MAX_ARGUMENTS, TS_OPT(JUNIT), TS_OPT(TAP), TS_OPT(OUTPUT), TS_OPT(FORCE), TS_OPT(QUIET), TS_OPT(JSON),
     .run = ts_merge_command},
	{"vectors", "-o DIR | --check DIR",
     "inputs and outputs of every arithmetic primitive, to write, or to check a port with",
     "Before a port renders anything: write them with -o DIR, let the port compute PRIMITIVE.out.npy from\n"
     "PRIMITIVE.in.npy, and judge its folder with --check DIR. vectors.json describes each primitive. Exact: 0 all\n"
     "right, 1 different. Primitives that the folder does not hold are not judged, but named.",
     0, 0, TS_OPT(OUTPUT), TS_OPT(FORCE), TS_OPT(CHECK), TS_OPT(QUIET), TS_OPT(JSON), .run = ts_vectors_command},
	{"help", "[COMMAND]", "what a command does and takes", "", 0, 1, .run = ts_help_command},
	{0},
};
