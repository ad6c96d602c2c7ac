# For the scripts of this folder: $python, a python3 that has numpy, or "". Sourced, not run.
python=""
export PYTHONDONTWRITEBYTECODE=1
for candidate in python3 /usr/bin/python3; do
	if "$candidate" -c 'import numpy' 2> /dev/null; then
		python=$candidate
		break
	fi
done

# trace FOLDER SCENE OPTION...: a trace of EPR in $scratch/FOLDER/trace-epr.
trace() {
	local folder=$1
	shift
	run render reflections "$@" --method epr --reflectors "${reflectors:-0}" --trace --no-images -o "$scratch/$folder"
	[ "$status" -eq 0 ]
}

# numpy_port FOLDER OPTION...: the port's candidate of that trace, in $scratch/FOLDER/numpy; exit status 1 if it differs.
numpy_port() {
	local folder=$1
	shift
	"$python" tests/ports/numpy/port.py "$scratch/$folder/trace-epr" "$scratch/$folder/numpy" --check "$@" > "$scratch/port"
}
