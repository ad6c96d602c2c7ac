#!/bin/bash
# The JUnit XML of comparisons: of every end that is an error, of names of any bytes, and of traces.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/images.bash"
ending=$(realpath tests/cli/preload/end.c) goldens=$(realpath reference/goldens)
cd "$scratch" || exit 2
writes_two
run "${frame[@]:0:${#frame[@]}-1}" --method epr --trace-only scene,eye,image -o r
verdict "$status" 'pictures and a trace'

# JUnit of comparisons that could not be made.
# breaks TEXT NAME ARGUMENT...: exit code 2, and the file has one error, whose message holds the text.
breaks() {
	local text=$1 name=$2
	shift 2
	rm -f j.xml
	run compare "$@" --junit j.xml
	[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && grep -qF -- "$text" j.xml
	verdict $? "an error in JUnit: $name"
	suits 1 0 1 0 "which suits the schema: $name"
}
breaks 'none.png: No such file' 'no candidate' a.png none.png
breaks 'the reference has 10 x 4' 'another size' a.png r/epr.png
breaks 'holds linear radiance' 'another kind' r/epr.png r/epr.exr
breaks '--forced: means something for traces only' 'an option that means nothing' a.png b.png --forced
breaks 'none/trace.json' 'no trace' r/trace-epr none
breaks 'does not say which buffer' 'no buffer' r/trace-epr/*image.srgb.npy j.npy
breaks '&lt;&amp;&gt;&quot;?\xe9' 'a name of any bytes' a.png $'<&>"\e\xe9'
breaks 'ï¿½?.png' 'a name that is UTF-8 and no XML' a.png $'ï¿½\xef\xbf\xbe.png'
cp a.png $'<&>"\e\xe9.png'
run compare b.png $'<&>"\e\xe9.png' --junit j.xml
[ "$status" -eq 1 ] && grep -qF 'name="&lt;&amp;&gt;&quot;?\xe9.png"' j.xml
verdict $? 'a case with such a name'
suits 1 1 0 0 'suits the schema too'
if ${CC:-gcc} -shared -fPIC -o end.so "$ending" -ldl 2> stderr; then
	{ ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0:handle_segv=0" \
		TSAN_OPTIONS="${TSAN_OPTIONS:-}:handle_segv=0" TOUCHSTONE_END='signal 11' TOUCHSTONE_END_AT=now \
		LD_PRELOAD=$scratch/end.so "$touchstone" compare a.png a.png -o end --junit j.xml; } 2> stderr
	[ $? -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && grep -q '<error message="the run ended by signal 11' j.xml
	verdict $? 'an error in JUnit: a run that a signal ended'
	suits 1 0 1 0 'which suits the schema'
fi
rm j.xml
run compare a.png b.png --junit j.xml --rmse x
[ "$status" -eq 2 ] && grep -qF -- '--rmse: &quot;x&quot; is not a number' j.xml
verdict $? 'an error in JUnit: a value that is none'
suits 1 0 1 0 'which suits the schema'
refuses '/dev/full: cannot be written' compare a.png b.png --junit /dev/full
rm j.xml
run golden check small-none --goldens "$goldens" --junit j.xml
[ "$status" -eq 2 ] && grep -q '<testcase .*classname="touchstone.golden"' j.xml && grep -qF small-none j.xml
verdict $? 'an error in JUnit: golden check of a case that is none'
suits 1 0 1 0 'which suits the schema'

# And of what was skipped: each case, in every form; shards without a device are merged with the others.
without_device() { OCL_ICD_VENDORS=/nonexistent run golden check 'small-e*' small-mvr --goldens "$goldens" \
	--backend opencl "$@"; }
without_device --junit j.xml --tap
[ "$status" -eq 77 ] && [ "$(grep -c '^ok .* - small-.* # SKIP skipped: .*no OpenCL device' stdout)" -eq 2 ] &&
	tail -n 1 stdout | grep -qx '1..2' &&
	[ "$(grep -c '<skipped message=".*no OpenCL device' j.xml)" -eq 2 ] &&
	grep -qx 'touchstone: backend opencl: no OpenCL device; .*' stderr
verdict $? 'JUnit and TAP of a device that is not there'
suits 2 0 0 2 'which suits the schema'
without_device --json
python3 -c "
import json
report = json.load(open('stdout'))
assert report['verdict'] == 'skipped' and report['skipped'] == 2 and report['passed'] == report['failed'] == 0"
verdict $? 'JSON of a device that is not there'
without_device --shard 1/2 -o skipped-1
[ "$status" -eq 77 ]
verdict $? 'a shard of a device that is not there'
run golden check 'small-e*' small-mvr --goldens "$goldens" --backend opencl --shard 2/2 -o skipped-2
if [ "$status" -eq 77 ]; then
	echo "ok $((tests += 1)) - it is merged with the others # SKIP no OpenCL device here"
else
	run merge skipped-2 skipped-1 --junit j.xml
	[ "$status" -eq 77 ] && grep -qx 'touchstone: merge: shard 1 in skipped-1 had no device' stderr &&
		grep -q '^1 passed, 0 failed, 1 skipped$\|^same' stdout
	verdict $? 'it is merged with the others'
	suits 2 0 0 1 'which suits the schema'
fi

# JUnit of traces.
run compare r/trace-epr r/trace-epr --junit j.xml --ignore image.srgb,image.radiance
[ "$status" -eq 0 ] && grep -q 'classname="touchstone.epr"' j.xml
verdict $? 'JUnit of a trace'
xmllint --noout --schema "$junit_schema" j.xml 2> lint
verdict $? 'suits the schema'
python3 - <<'PY'
import xml.dom.minidom
suite = xml.dom.minidom.parse("j.xml").documentElement
times = [float(c.getAttribute("time")) for c in suite.getElementsByTagName("testcase")]
assert 0 < sum(times) <= float(suite.getAttribute("time")) and times[-1] == 0, times  # the last is ignored
PY
verdict $? 'whose cases take no longer together than the suite'

finish
