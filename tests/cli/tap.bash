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

# without_images, with_images: $touchstone is from here on a copy that finds no module of images, which takes five times
# as long to load as a small frame takes; of a golden's preview it says that it was not compared. And the other way
# round.
without_images() {
	mkdir -p "$scratch/without-images"
	[ -e "$scratch/without-images/touchstone" ] || cp "$touchstone" "$scratch/without-images/"
	touchstone=$scratch/without-images/touchstone
}
with_images() { touchstone=$(realpath -m "${BUILD:-build/release}/touchstone"); }

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
