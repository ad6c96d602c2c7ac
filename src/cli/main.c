/* The command `touchstone`: its table of commands. */
#include <touchstone/image.h>
#include "golden.h"

#define WHERE \
	(TS_OPT_SIZE | TS_OPT_FRAME | TS_OPT_REFLECTORS | TS_OPT_REFLECTOR | TS_OPT_FROM_MESH | TS_OPT_CAMERA | TS_OPT_SET)
#define HOW (TS_OPT_THREADS | TS_OPT_REFERENCE | BACKEND)
#define BACKEND (TS_OPT_BACKEND | TS_OPT_DEVICE | TS_OPT_WORK_GROUP | TS_OPT_BUILD | TS_OPT_INEXACT | TS_OPT_REQUIRE)

const char *const ts_program = "touchstone";
ts_preview *const ts_golden_preview = ts_image_write_png;
const ts_backend_kind *const ts_backend_kinds[] = { &ts_c_kind, &ts_opencl_kind, NULL };

const ts_command ts_command_table[] = {
	{ "render", "EFFECT [SCENE]", "render an effect by one or more methods, and judge them by ground truth",
	  "EFFECT: reflections; soft-shadows, of a lamp or the scene's lights; omni-shadows, of a ball of light in the middle;\n"
	  "indirect, the light of a lamp or the scene's lights after one bounce; particles, the light of many in the air.\n"
	  "Shadows, indirect light and particles are shown without mirrors unless --reflectors says how many.\n"
	  "surfels: elliptical splats of a file, or of triangles by --set from_mesh=COUNT; eye=outside sees all of a model.\n"
	  "SCENE: atrium (the default), gallery or dining, each also with \":triangles=COUNT:texels=SIDE\"; checkerboard, of\n"
	  "surfels, also with \":surfels=COUNT\"; or a .gltf, .glb or .ply file. Writes METHOD.png and .exr, truth-NAME.png,\n"
	  "differences, pictures of the stages, traces and report.json to DIR, and prints times, counters, memory and metrics.\n"
	  "Of a parameter with several values, --set NAME=A,B, every combination is rendered, and CSV is printed.",
	  1, 2, TS_OPT_METHOD | TS_OPT_TRUTH | WHERE | HOW | TS_OPT_ORDER | TS_OPT_OUTPUT | TS_OPT_FORCE |
	  TS_OPT_NO_IMAGES | TS_OPT_TRACE | TS_OPT_TRACE_ONLY | TS_OPT_CROP | TS_OPT_MARGINS |
	  TS_OPT_VIEWER | TS_OPT_JSON, ts_render_command },
	{ "replay", "TRACE", "run a stage again, alone, from the buffers of a trace or of a port, and compare",
	  "TRACE: a folder that render --trace wrote. One line an output: the same bits, or the first element and field\n"
	  "that differ. With --inputs the port's buffers are the inputs and its outputs are judged: each of its stages,\n"
	  "given its own stages before. Buffers are checked before they are used. -o DIR writes what the stage should make.",
	  1, 1, TS_OPT_STAGE | TS_OPT_INPUTS | TS_OPT_THREADS | TS_OPT_OUTPUT | TS_OPT_JSON, ts_replay_command },
	{ "info", "SCENE", "what was loaded, and what in the file was not understood", "",
	  1, 1, WHERE | TS_OPT_JSON, ts_info_command },
	{ "list", "WHAT", "tables: stages, buffers, params, methods, truths, scenes or backends", "",
	  1, 1, TS_OPT_JSON, ts_list_command },
	{ "bench", "TABLE", "the papers' tables, measured here; and what the backends take",
	  "TABLE: of the iVIR paper ivir-1 (soft shadows), ivir-2 (reflections), ivir-3 (omnidirectional shadows); of the EPR\n"
	  "paper epr-1 (shading operations), epr-2 (times, points and errors), epr-3 (omnidirectional shadows). The paper's\n"
	  "figures stand below ours, and behind them what must hold, and whether it does. Their GPU's times are not ours:\n"
	  "compare ratios. Errors of epr-2 are against truth C unless --truth says otherwise. Models of ivir-1 and of SSAGH\n"
	  "are in the folder TS_SCENES (scenes). epr-6: speed against accuracy, as density, sampling and faces\n"
	  "vary, of one scene (atrium) with one number of mirrors (10). Of the SSAGH paper ssagh-1 (frames a second, by size;\n"
	  "--objects takes sizes, WxH), ssagh-segments (labels of its algorithm 1 beside connected components), and ssagh-5\n"
	  "(its curves c and s) and ssagh-7 (errors of integrals with the cosine), which need no scene. Of the MegaViews\n"
	  "paper mega-10 (MegaViews and ManyLoDs as views become many), mega-10-bounces (of four bounces), mega-particles (at\n"
	  "random in the air), mega-12 (as maps become large), mega-13 (as octrees become deep) and mega-16 (what gathering\n"
	  "culls), of the atrium unless --scene says otherwise; --objects are paths of light, these, particles, texels a\n"
	  "side, levels, and levels. Of the slides on surface splatting nv40 (surfels a second, and fragments a pixel;\n"
	  "--objects takes sizes). With -o DIR the report, each table as CSV, and plots, as SVG, are written to DIR. Or\n"
	  "backends: each stage in C, with 1 and with --threads threads, and on every OpenCL device, or\n"
	  "the one of --backend or --device, which takes the cores it likes; one frame by one --method (epr), of one scene\n"
	  "(atrium) with one number of mirrors (10); what bounds scattering; and how long the kernels take to build, in a\n"
	  "process of its own, with an empty cache too where it is PoCL's. Or start: the seconds from opening --backend to\n"
	  "its first frames.",
	  1, 1, TS_OPT_METHOD | TS_OPT_SCENE | TS_OPT_OBJECTS | TS_OPT_RUNS | TS_OPT_TRUTH | TS_OPT_SIZE | TS_OPT_FRAME |
	  TS_OPT_SET | HOW | TS_OPT_OUTPUT | TS_OPT_FORCE | TS_OPT_JSON, ts_bench_command },
	{ "compare", "REFERENCE CANDIDATE", "two traces, buffers or images: where they first differ, and how much",
	  "REFERENCE: a folder that render --trace wrote, or one of its .npy files, or an image.\n"
	  "CANDIDATE: the same of a port (reference/TRACES.md says what it must have at least).\n"
	  "Everything must be the same to the bit, unless a relaxation is typed. Exit code 0 same, 1 different, 2 could not.\n"
	  "Ulps count floats from the reference to the candidate: positive where the candidate is greater.\n"
	  "With -o DIR, a picture of the pixels that differ for each buffer that has them.",
	  2, 2, TS_OPT_FORCED | TS_OPT_THREADS |
	  TS_OPT_DECIDED | TS_OPT_ULP | TS_OPT_ABS | TS_OPT_REL | TS_OPT_ALLOW | TS_OPT_IGNORE | TS_OPT_MASK |
	  TS_OPT_LAYOUT | TS_OPT_ORDER | TS_OPT_JUNIT | TS_OPT_TAP | TS_OPT_OUTPUT | TS_OPT_FORCE | TS_OPT_JSON,
	  ts_compare_command },
	{ "probe", "TRACE", "why a pixel, texel, triangle or point of a trace is what it is",
	  "TRACE: a folder that render --trace wrote, or a port's, of reflections by epr or mvr; --pixel also of shadows,\n"
	  "indirect light and particles.\n"
	  "--pixel: who competed for it, who won by how much, what each sample looked up, each term of its light.\n"
	  "With --view a texel: of a face of a cube, or, of MegaViews, of half the map of a light's leaf or of a node of\n"
	  "views: which pairs were rendered into it and into those above, by what tests, and what fusion made of them.\n"
	  "--triangle, --point: where it went, and which stage lost it.\n"
	  "What the buffers do not hold is computed again; each \"check\" says whether that has the bits of a buffer.",
	  1, 1, TS_OPT_PIXEL | TS_OPT_VIEW | TS_OPT_TRIANGLE | TS_OPT_POINT | TS_OPT_JSON, ts_probe_command },
	{ "digest", "[SCENE]", "SHA-256 of every buffer of a built-in scene, in pipeline order", "",
	  0, 1, TS_OPT_EFFECT | TS_OPT_METHOD | TS_OPT_SIZE | TS_OPT_FRAME | TS_OPT_REFLECTORS | TS_OPT_SET | HOW |
	  TS_OPT_FLUSH_DENORMALS,
	  ts_digest_command },
	{ "golden", "ACTION [CASE]", "check, new or bless: the goldens of reference/",
	  TS_GOLDEN_DETAILS,
	  1, 2, HOW | TS_OPT_REASON | TS_OPT_REFERENCE_DIR, ts_golden_command },
	{ "vectors", "-o DIR | --check DIR",
	  "inputs and outputs of every arithmetic primitive, to write, or to check a port with",
	  "Before a port renders anything: write them with -o DIR, let the port compute PRIMITIVE.out.npy from\n"
	  "PRIMITIVE.in.npy, and judge its folder with --check DIR. vectors.json describes each primitive. Exact: 0 all right,\n"
	  "1 different. Primitives that the folder does not hold are not judged, but named.",
	  0, 0, TS_OPT_OUTPUT | TS_OPT_FORCE | TS_OPT_CHECK | TS_OPT_JSON, ts_vectors_command },
	{ "help", "[COMMAND]", "what a command does and takes", "", 0, 1, 0, ts_help_command },
	{ 0 }
};

int main(int argc, char **argv) { return ts_cli_main(argc, argv); }
