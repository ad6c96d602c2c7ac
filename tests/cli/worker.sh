#!/bin/bash
# How a command ends: by its own exit code, by the signal that was sent, or, whatever else ends it, with 2, one line of
# ours and nothing half-written. What appears at DIR while it runs stays.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
source=$(realpath "$(dirname "$0")/preload/end.c")
cd "$scratch" || exit 2
own=handle_segv=0:handle_sigfpe=0:handle_abort=0 # a sanitizer reports these signals itself, unless it is told not to
export ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0:$own" TSAN_OPTIONS="${TSAN_OPTIONS:-}:$own"
tiny=(render reflections atrium:triangles=10000:texels=32 --size 16x16 --reflectors 1 --set cube.max_px=16 --method mvr)

if ! ${CC:-gcc} -shared -fPIC -o end.so "$source" -ldl 2> stderr; then
	echo "ok 1 - the library that ends # SKIP ${CC:-gcc} makes no shared library: $(head -1 stderr)"
	finish
fi
# Jobs of shells ignore some signals, and so does what nohup starts.
heeding=(env --default-signal=INT,TERM,HUP,QUIT,PIPE)
# ending HOW ARGUMENT...: the command, to which that happens as it makes its folder.
ending() {
	TOUCHSTONE_END=$1 TOUCHSTONE_END_AT=$scratch/now/here LD_PRELOAD=$scratch/end.so timeout 100 "${heeding[@]}" \
		"$touchstone" "${@:2}" > stdout 2> stderr
	status=$?
}
# leaves NAMES: the scratch folder holds that, and what this script made.
leaves() { [ "$(ls -A -I 'end.so' -I stdout -I stderr | tr '\n' ' ')" = "$1" ]; }

{ ending exit "${tiny[@]}" -o a/b; } 2> /dev/null
[ "$status" -eq 2 ] && leaves '' &&
	[ "$(cat stderr)" = \
		'touchstone: a library ended the run with exit code 1, for want of memory or threads; no result' ]
verdict $? 'a library that ends the process does not say "different"'
for signal in 6 11 9 8 24; do
	{ ending "signal $signal" "${tiny[@]}" -o a/b; } 2> /dev/null
	[ "$status" -eq 2 ] && leaves '' && [ "$(wc -l < stderr)" -eq 1 ] && grep -q 'signal\|killed' stderr
	verdict $? "signal $signal is exit code 2 and a line"
done
for signal in 1 2 3 13 15; do
	{ ending "signal $signal" "${tiny[@]}" -o a/b; } 2> /dev/null
	[ "$status" -eq $((128 + signal)) ] && leaves '' && [ ! -s stderr ]
	verdict $? "the command dies of signal $signal as its worker does"
done

# sent SIGNAL: the exit status of a command that waits, and gets it.
sent() {
	rm -rf now
	TOUCHSTONE_END=wait TOUCHSTONE_END_AT=$scratch/now/here LD_PRELOAD=$scratch/end.so "${heeding[@]}" \
		"$touchstone" "${tiny[@]}" -o "$scratch/a/b" > stdout 2> stderr &
	local process=$!
	for ((i = 0; i < 600; i++)); do [ -e now/here ] && break; sleep 0.05; done
	{ kill -"$1" $process; wait $process; } 2> /dev/null
	status=$?
	rm -rf now
}
for signal in INT TERM HUP QUIT PIPE; do
	sent $signal
	[ "$status" -eq $((128 + $(kill -l $signal))) ] && leaves '' && [ ! -s stderr ]
	verdict $? "$signal is passed on, and nothing stays"
done
sent KILL
for ((i = 0; i < 100; i++)); do pgrep -f "^$touchstone .*-o $scratch/a/b" > /dev/null || break; sleep 0.05; done
[ "$status" -eq 137 ] && ! pgrep -f "^$touchstone .*-o $scratch/a/b" > /dev/null && [ -e a/b.partial ]
verdict $? 'a worker does not outlive its parent'
run "${tiny[@]}" -o a/b
[ "$status" -eq 0 ] && [ "$(cat stderr)" = 'touchstone: a/b: removed what a run that was killed had left there' ] &&
	[ "$(ls -A a)" = b ]
verdict $? 'the next run removes what was left, and says so'
rm -rf a

# Limits.
ending wait "${tiny[@]}" -o a/b --timeout 1
[ "$status" -eq 2 ] && [ "$(cat stderr)" = 'touchstone: stopped after 1 s, as --timeout asks; no result' ] &&
	rm -r now && leaves ''
verdict $? '--timeout'
run "${tiny[@]}" -o a/b --timeout 100
[ "$status" -eq 0 ] && [ -s a/b/mvr.png ]
verdict $? 'a run within its time'
rm -rf a

# What the worker starts: an encoder that waits for programs of its own, one of them in a session of its own.
mkdir bin
cat > bin/ffmpeg <<'SH'
#!/bin/bash
sleep 301 & setsid sleep 302 &
echo $$ $! $(pgrep -P $$ sleep) > "$STARTED.new" && mv "$STARTED.new" "$STARTED"
wait
SH
chmod +x bin/ffmpeg
# encoding COMMAND...: the command at that encoder, from $process and with $started; then how it ends is $status.
encoding() {
	rm -f started
	STARTED=$scratch/started PATH=$scratch/bin:$PATH "${heeding[@]}" "$touchstone" "${tiny[@]}" --frames 0..1 -o a/b \
		"$@" > stdout 2> stderr &
	process=$!
	for ((i = 0; i < 600; i++)); do [ -e started ] && break; sleep 0.05; done
	started=$(cat started)
}
# none_left: nothing of what was started still runs.
none_left() {
	for ((i = 0; i < 100; i++)); do
		# shellcheck disable=SC2086 # numbers
		ps -o pid= -p ${started// /,} > /dev/null || return 0
		sleep 0.05
	done
	return 1
}
encoding --timeout 5
wait $process
[ $? -eq 2 ] && grep -q 'stopped after 5 s, as --timeout asks; no result$' stderr &&
	[ "$(wc -w <<< "$started")" -ge 3 ] &&
	none_left && leaves 'bin started '
verdict $? '--timeout ends what the command has started'
for signal in INT TERM; do
	encoding
	{ kill -$signal $process; wait $process; } 2> /dev/null
	[ $? -eq $((128 + $(kill -l $signal))) ] && none_left && leaves 'bin started '
	verdict $? "$signal ends what the command has started"
done
rm -r bin started
(ulimit -t 1; run render indirect --method direct --no-images; [ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] &&
	grep -q '^touchstone: the run was killed at its limit of processor time (ulimit -t); no result$' stderr)
verdict $? 'ulimit -t is named'
case ${BUILD:-} in
*san) echo "ok $((tests += 1)) - limits of memory # SKIP a sanitizer takes address space of its own" ;;
*)
	run "${tiny[@]}" -o a/b --memory 60
	[ "$status" -eq 2 ] && tail -1 stderr | grep -q '^touchstone: ' && leaves ''
	verdict $? '--memory'
	run "${tiny[@]}" --no-images --trace -o a
	(ulimit -v 400000; run compare --forced a/trace-mvr a/trace-mvr --threads 64; [ "$status" -eq 0 ] &&
		grep -q '^touchstone: 64 threads wanted, [0-9]* are taken of what is there$' stderr)
	verdict $? 'fewer threads than asked are a line and the same verdict'
	rm -rf a
	;;
esac
refuses 'leave --no-worker out' "${tiny[@]}" --no-worker --timeout 1
refuses 'not a whole number' "${tiny[@]}" --timeout 0

# What appears.
ending 'fill out/mine' "${tiny[@]}" -o out
[ "$status" -eq 2 ] &&
	[ "$(cat stderr)" = 'touchstone: out: not empty; name another folder with -o, or replace it with --force' ] &&
	leaves 'out ' && [ "$(ls -A out)" = mine ]
verdict $? 'a folder that appeared stays'
rm -r out
ending 'fill out/report.json' "${tiny[@]}" -o out
[ "$status" -eq 2 ] && leaves 'out ' && [ "$(ls -A out)" = report.json ]
verdict $? 'a report.json that appeared stays'
rm -r out
run "${tiny[@]}" -o out
cp -r out before
ending 'fill out/mine' "${tiny[@]}" -o out --force --set seed=1
[ "$status" -eq 2 ] && [ -e out/mine ] && rm out/mine && diff -r out before > stdout && leaves 'before out '
verdict $? '--force keeps a file that appeared, and all else'

# Goldens: a case that ends its process loses its own verdict.
mkdir three
for i in 1 2 3; do
	echo "case-$i: mvr dining:triangles=10000:texels=16 --size 24x16 --reflectors 0 --set seed=$i"
done > three/cases.txt
run golden new --goldens three
accepts three case-{1,2,3}
# loses HOW TEXT OPTION...: the verdict of case-2, with that text, and no other.
loses() {
	{ TOUCHSTONE_END=$1 TOUCHSTONE_END_AT=$scratch/now/here TOUCHSTONE_END_OPEN=case-2 LD_PRELOAD=$scratch/end.so \
		timeout 100 "$touchstone" golden check --goldens three --junit j.xml "${@:3}" > stdout 2> stderr; } 2> said
	[ $? -eq 2 ] && [ "$(sed 's/ .*//' stdout | xargs)" = 'same lost same 2' ] && [ "$(wc -l < stderr)" -eq 1 ] &&
		grep -q "^lost  *case-2  case-2: $2" stdout && grep -q "^touchstone: golden: case-2: $2" stderr &&
		grep -q 'tests="3" failures="0" errors="1"' j.xml && grep -A1 'name="case-2"' j.xml |
		grep -q "<error message=\"case-2: $2"
	verdict $? "a case that ends by $1 loses its own verdict"
}
loses 'signal 11' 'the run ended by signal 11'
loses 'signal 9' 'the run was killed'
loses exit 'a library ended the run with exit code 1'
loses wait 'stopped after 2 s, as --timeout asks' --timeout 2
[[ ${BUILD:-} == *san ]] || loses 'signal 11' 'the run ended by signal 11' --memory 4000
{ TOUCHSTONE_END='signal 15' TOUCHSTONE_END_OPEN=case-2 LD_PRELOAD=$scratch/end.so "$touchstone" golden check \
	--goldens three > stdout 2> stderr; } 2> said
[ $? -eq 143 ] && [ "$(sed 's/ .*//' stdout)" = same ] && [ ! -s stderr ]
verdict $? 'a signal that was sent ends all cases'
rm -r three j.xml said now

# Two at a time.
TOUCHSTONE_END=wait TOUCHSTONE_END_AT=$scratch/now/here LD_PRELOAD=$scratch/end.so "$touchstone" "${tiny[@]}" -o two \
	> /dev/null 2>&1 &
process=$!
for ((i = 0; i < 600; i++)); do [ -e now/here ] && break; sleep 0.05; done
refuses 'two: process [0-9]* writes it now; wait for its end, or name another' "${tiny[@]}" -o two --force
[ -e two.partial ] && [ -e two.lock ]
verdict $? 'what another run writes is left alone'
{ kill $process; wait $process; } 2> /dev/null
rm -r now
leaves 'before out '
verdict $? 'until that run ends'

# Two equal runs.
for folder in first second; do
	run "${tiny[@]}" --truth=A --trace --margins --viewer --method epr,ivir -o $folder --threads 2
done
rm first/times.json second/times.json
diff -r first second > stdout && [ "$(find first -name '*.exr' | wc -l)" -gt 4 ] && [ -s first/report.json ]
verdict $? 'two runs write the same bytes but for times.json'
finish
