# What the scripts of this folder share beside ../cli/tap.bash. Sourced, not run.
export PYTHONDONTWRITEBYTECODE=1

# trace FOLDER SCENE OPTION...: a trace of EPR, in $scratch/FOLDER/trace-epr.
trace() {
	local folder=$1
	shift
	run render reflections "$@" --method epr --trace --no-images -o "$scratch/$folder"
	[ "$status" -eq 0 ]
}

# micro FOLDER SCENE OPTION...: the same of one of the triangles of scenes/; its values are in reference/PORTING.md.
micro() {
	local folder=$1 scene=$2
	shift 2
	trace "$folder" "scenes/$scene.gltf" --camera camera --reflectors 0 --size 64x64 --set cube.px=16 "$@"
}

# find_numpy: $python, a python3 that has numpy; without one, says that the test is skipped.
find_numpy() {
	for python in python3 /usr/bin/python3; do
		"$python" -c 'import numpy' 2> /dev/null && return 0
	done
	echo '1..0 # skip no python3 with numpy'
	return 1
}
