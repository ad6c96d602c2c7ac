# What the scripts on backends of devices share. Sourced after tap.bash and traces.bash.

# need_device BACKEND: ends the script where there is no device, as a skip,
# or as a failure if TS_REQUIRE names the backend.
need_device() {
	run list backends
	grep -q "^$1 " "$scratch/stdout" && return
	if [[ ${TS_REQUIRE:-} == *$1* ]]; then
		verdict 1 "a device for $1, which TS_REQUIRE asks for"
	else
		tests=$((tests + 1))
		echo "ok $tests - a device for $1 # SKIP none here"
	fi
	finish
}

# ends STATUS PATTERN NAME: the command that ran ended so, and if it failed, with one line that matches and no output.
ends() {
	[ "$status" -eq "$1" ] && { [ "$1" -eq 0 ] || [ "$(wc -l < "$scratch/stderr")" -eq 1 ]; } &&
		{ [ "$1" -le 1 ] || { grep -q -- "$2" "$scratch/stderr" && [ ! -s "$scratch/stdout" ]; }; }
	verdict $? "$3"
}

# ends_without_device BACKEND PATTERN: what commands do where there is none,
# which the script's own without_device sees to.
ends_without_device() {
	without_device digest --backend "$1"
	ends 77 "$2" 'no device: skipped'
	without_device digest --backend "$1" --require
	ends 2 "$2" 'no device: an error with --require'
	without_device render reflections --backend "$1" -o "$scratch/none"
	ends 77 "$2" 'no device: nothing rendered'
	[ ! -e "$scratch/none" ] && [ ! -e "$scratch/none.partial" ]
	verdict $? 'and nothing written'
	without_device list backends
	[ "$status" -eq 0 ] && grep -q '^c ' "$scratch/stdout" && ! grep -q "^$1" "$scratch/stdout"
	verdict $? 'no device: none is listed'
}

# same REFERENCE CANDIDATE NAME OPTION...: two traces of the same bits.
same() {
	local reference=$1 candidate=$2 name=$3
	shift 3
	run compare "$reference" "$candidate" "$@"
	[ "$status" -eq 0 ] && grep -q ' 0 different' "$scratch/stdout"
	verdict $? "$name"
}

# same_digests NAME RUN OPTION...: of C and of what the backend's options, the array `on`, name.
# RUN: the command as it runs there.
same_digests() {
	local name=$1 runs=$2
	shift 2
	run digest "$@"
	cp "$scratch/stdout" "$scratch/expected"
	"$runs" digest "$@" "${on[@]}"
	[ "$status" -eq 0 ] && grep -q image.srgb "$scratch/stdout" && cmp -s "$scratch/stdout" "$scratch/expected"
	verdict $? "$name"
}

# same_traces RUN: those of C and of the backend, in canonical order and in that of arrival.
# Leaves them, and the list of backends.
same_traces() {
	local runs=$1 order
	run "${frame[@]}" --method epr --trace -o "$scratch/c"
	for order in canonical arrival; do
		"$runs" "${frame[@]}" --method epr --trace -o "$scratch/$order" "${on[@]}" --order "$order"
		same "$scratch/c/trace-epr" "$scratch/$order/trace-epr" "the trace of C, in $order order"
	done
	digests_hold "$scratch/canonical/trace-epr"
	verdict $? 'whose digests hold'
	"$touchstone" list backends --json > "$scratch/backends"
	python3 - "$scratch" "${on[1]}" <<'PY'
import json, sys
folder, backend = sys.argv[1:]
trace = json.load(open(folder + "/canonical/trace-epr/trace.json"))
device = next(d for d in json.load(open(folder + "/backends"))["backends"] if d["name"] == backend)
producer, arithmetic = trace["producer"], trace["arithmetic"]
assert producer["backend"] == backend and producer["device"].startswith(device["device"] + ", ")
assert producer["device"].removeprefix(device["device"] + ", ").strip()
assert producer["compiler"] and producer["flags"]
assert arithmetic["rounding"] == "nearest even" and arithmetic["contraction"] is False and arithmetic["selftest"] == 0
PY
	verdict $? "its producer and arithmetic are the device's"
}

# stand_in_cuda: the driver that needs no GPU (tests/backends/cuda) stands before the machine's own, if there is one.
stand_in_cuda() {
	without_driver=${LD_LIBRARY_PATH:-}
	export LD_LIBRARY_PATH=${touchstone%/*}/cuda${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
}
