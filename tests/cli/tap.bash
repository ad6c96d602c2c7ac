# What the scripts of this folder share: the command, a scratch folder, and TAP. Sourced, not run.
touchstone=$(realpath -m "${BUILD:-build/release}/touchstone")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tests=0
failures=0

# verdict STATUS NAME: one line of TAP.
verdict() {
	tests=$((tests + 1))
	if [ "$1" -eq 0 ]; then
		echo "ok $tests - $2"
	else
		echo "not ok $tests - $2"
		failures=$((failures + 1))
	fi
}

# limits_files: whether the size of files can be limited: any program of ThreadSanitizer and libomp ends with a bus
# error before main then.
limits_files() {
	[[ ${BUILD:-} != *tsan ]] && return
	echo "ok $((tests += 1)) - a disk that fills # SKIP ThreadSanitizer and libomp map files"
	false
}

# run ARGUMENT...: the command, with $status, $scratch/stdout and $scratch/stderr.
run() {
	timeout 300 "$touchstone" "$@" > "$scratch/stdout" 2> "$scratch/stderr"
	status=$?
}

# refuses PATTERN ARGUMENT...: exit code 2, nothing on stdout, and one line on stderr that matches.
refuses() {
	local pattern=$1
	shift
	run "$@"
	[ "$status" -eq 2 ] && [ "$(wc -l < "$scratch/stderr")" -eq 1 ] && grep -q -- "$pattern" "$scratch/stderr" &&
		[ ! -s "$scratch/stdout" ]
	verdict $? "refused: $*"
}

# prints PATTERN ARGUMENT...: exit code 0, and a line on stdout that matches.
prints() {
	local pattern=$1
	shift
	run "$@"
	[ "$status" -eq 0 ] && grep -q -- "$pattern" "$scratch/stdout"
	verdict $? "printed by: $*"
}

# accepts FOLDER CASE...: what `golden new` proposed there becomes the golden, as if it was blessed.
accepts() {
	local folder=$1 case
	shift
	for case; do
		mv "$folder/$case.new" "$folder/$case" && echo accepted > "$folder/$case/CHANGES"
	done
}

finish() {
	echo "1..$tests"
	[ "$failures" -eq 0 ]
	exit
}
