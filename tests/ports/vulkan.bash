# The port to Vulkan, compiled, and its shaders, in $scratch/exact; the script ends here where they cannot run. Sourced
# after ports.bash.
. "$(dirname "$0")/../cli/vulkan.bash"
need_device vulkan
if ! command -v glslangValidator > /dev/null; then
	echo "1..0 # skip no glslangValidator"
	exit 0
fi

# made FOLDER [FILE SED]: the shaders as SPIR-V, which keep the contract; FILE, edited so, first.
made() {
	local to=$scratch/$1 stage
	rm -rf "$to" && cp -R "$scratch/glsl" "$to" && cp tests/ports/vulkan/*.{comp,glsl} "$to"
	if [ -n "${2:-}" ]; then
		sed -i "$3" "$to/$2"
		cmp -s "$to/$2" "tests/ports/vulkan/$2" && return 1
	fi
	for stage in align points splat lookup; do
		glslangValidator -V -g0 --target-env vulkan1.2 -o "$to/$stage.spv" "$to/$stage.comp" > "$to/$stage.log" ||
			return 1
		scripts/spirv-exact "$to/$stage.spv" || return 1
	done
}

# compared FOLDER SCENE OPTION...: the bits of the modules in FOLDER and those of the scene's trace;
# $with runs the port.
with=(env)
compared() {
	local from=$scratch/$1 to=$scratch/$2
	status=2
	rm -rf "$to/port" && mkdir "$to/port" &&
		"${with[@]}" "$scratch/port" "$from" "$to/trace-epr" "$to/port" > "$scratch/device" ||
		return 2
	shift 2
	run compare "$to/trace-epr" "$to/port" "$@"
}

scripts/glsl "$scratch/glsl"
${CC:-gcc} -std=c11 -D_GNU_SOURCE -O1 -Iinclude tests/ports/vulkan/{port,gpu}.c -lvulkan -o "$scratch/port"
verdict $? 'the port compiles'
made exact
verdict $? 'its shaders compile'
