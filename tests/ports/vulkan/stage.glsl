// What the four stages share. The records, the arithmetic and the rules of CONTRACT.md come from the installed headers
// (share/touchstone/glsl); the stages are written from METHODS, section 2.
#include "raster/cube.glsl"
#include "raster/clip.glsl"
#include "raster/cover.glsl"
layout(local_size_x = 64) in;

// Of this invocation. Groups stand in rows, because one row of them has too few (maxComputeWorkGroupCount).
uint item()
{
	return gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x;
}

const int HALF_SIZE = 129; // of a texel's square, in 1/256 (rule 19)

ts_v3 load(float p[3])
{
	return ts_v3_make(p[0], p[1], p[2]);
}

// Every float passes ts_put before it is stored (rule 12).
float[3] stored(ts_v3 p)
{
	return float[3](ts_put(p.x), ts_put(p.y), ts_put(p.z));
}
