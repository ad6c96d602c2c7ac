/* The command `touchstone`: its table of commands. */
#include "cli.h"

#define WHERE (TS_OPT_SIZE | TS_OPT_FRAME | TS_OPT_REFLECTORS | TS_OPT_REFLECTOR | TS_OPT_CAMERA | TS_OPT_SET)
#define HOW (TS_OPT_THREADS | TS_OPT_REFERENCE)

const char *const ts_program = "touchstone";

const ts_command ts_command_table[] = {
	{ "render", "EFFECT [SCENE]", "render an effect by one or more methods, and judge them by ground truth",
	  "EFFECT: reflections.\n"
	  "SCENE: atrium (the default), gallery or dining, each also with \":triangles=COUNT\"; or a .gltf or .glb file.\n"
	  "Writes METHOD.png and .exr, truth-a.png ..., differences, pictures of the stages, traces and report.json to DIR,\n"
	  "and prints times, counters, memory and metrics.",
	  1, 2, TS_OPT_METHOD | TS_OPT_TRUTH | WHERE | HOW | TS_OPT_BACKEND | TS_OPT_OUTPUT | TS_OPT_FORCE |
	  TS_OPT_NO_IMAGES | TS_OPT_TRACE | TS_OPT_TRACE_ONLY | TS_OPT_CROP | TS_OPT_JSON, ts_render_command },
	{ "replay", "TRACE", "run a stage again, alone, from the buffers of a trace or of a port, and compare",
	  "TRACE: a folder that render --trace wrote. One line an output: the same bits, or the first element and field\n"
	  "that differ. With --inputs the port's buffers are the inputs and its outputs are judged: each of its stages,\n"
	  "given its own stages before. Buffers are checked before they are used. -o DIR writes what the stage should make.",
	  1, 1, TS_OPT_STAGE | TS_OPT_INPUTS | TS_OPT_THREADS | TS_OPT_OUTPUT | TS_OPT_JSON, ts_replay_command },
	{ "info", "SCENE", "what was loaded, and what in the file was not understood", "",
	  1, 1, WHERE | TS_OPT_JSON, ts_info_command },
	{ "list", "WHAT", "tables: stages, buffers, params, methods, scenes or backends", "",
	  1, 1, TS_OPT_JSON, ts_list_command },
	{ "bench", "TABLE", "the papers' tables, measured here",
	  "TABLE: epr-1 (shading operations) or epr-2 (times, points and errors) of the EPR paper; its figures stand below\n"
	  "ours. Their GPU's times are not ours: compare ratios. Errors are against truth C unless --truth says otherwise.",
	  1, 1, TS_OPT_SCENE | TS_OPT_OBJECTS | TS_OPT_RUNS | TS_OPT_TRUTH | TS_OPT_SIZE | TS_OPT_FRAME | TS_OPT_SET | HOW |
	  TS_OPT_JSON, ts_bench_command },
	{ "digest", "[SCENE]", "SHA-256 of every buffer of a built-in scene, in pipeline order", "",
	  0, 1, TS_OPT_METHOD | TS_OPT_SIZE | TS_OPT_FRAME | TS_OPT_REFLECTORS | TS_OPT_SET | HOW | TS_OPT_FLUSH_DENORMALS,
	  ts_digest_command },
	{ "help", "[COMMAND]", "what a command does and takes", "", 0, 1, 0, ts_help_command },
	{ 0 }
};

int main(int argc, char **argv) { return ts_cli_main(argc, argv); }
