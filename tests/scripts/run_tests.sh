#!/bin/bash
# The runner of tests: which tests a name means, what it leaves out, and that it fails a test that takes too much
# processor time, hangs, crashes or reports nothing. Prints TAP.
. "$(dirname "$0")/../cli/tap.bash"
runner=$(realpath scripts/run-tests)
cd "$scratch" || exit
unset TS_REQUIRE
mkdir -p scripts tests/{a,b}
ln -s "$runner" scripts/run-tests
ln -s "${runner%/*}"/{usage,settings}.py scripts
mkdir -p build/{record,cuda,python}
touch build/{touchstone{,-core},record/touchstone,cuda/libcuda.so.1,python/touchstone}
echo '# none' > tests/apart.txt
printf '# tiers\nlate: what is late\n\tb/late.sh\n' > tests/tiers.txt

# make_test NAME COMMAND
make_test() {
	printf '#!/bin/bash\n%s\n' "$2" > "tests/$1" && chmod +x "tests/$1"
}
make_test a/quick.sh 'echo "ok 1 - quick"'
make_test a/quick_too.sh 'echo "ok 1 - quick"'
make_test b/late.sh 'for ((i = 0; i < 300000; i++)); do :; done; echo "ok 1 - late"'

# runs STATUS PATTERN NAME WORD...: the runner, with a bound of 0.1 s of processor time and a limit of 5 s.
runs() {
	local expected=$1 pattern=$2 name=$3
	shift 3
	BUILD=build /usr/bin/python3 - "${all_s:-10}" "$@" > stdout 2> stderr <<'PY'
import importlib.machinery, importlib.util, sys
sys.path.insert(0, "scripts")
loader = importlib.machinery.SourceFileLoader("run_tests", "scripts/run-tests")
runner = importlib.util.module_from_spec(importlib.util.spec_from_loader("run_tests", loader))
loader.exec_module(runner)
runner.MOST_S, runner.ALL_S = 0.1, float(sys.argv.pop(1))
runner.run.__defaults__ = (5,)
sys.exit(runner.main())
PY
	[ $? -eq "$expected" ] && cat stdout stderr | grep -q -- "$pattern"
	verdict $? "$name"
}
runs 0 '^2 passed, 0 failed, 0 skipped' 'all but the tiers'
runs 0 'make test-late`: 1 tests: b/late.sh' 'what is left out is named, with what runs it'
grep -q 'slowest' stdout && grep -q ' a/quick.sh$' build/times.txt
verdict $? 'the slowest are named, and times are kept'
runs 0 '^1 passed' 'a tier' --tier late
printf 'late: what is late\n\tb/late.sh\n\ta/quick.sh\n' > tests/tiers.txt
runs 0 '^2 passed' 'two tests of a tier' --tier late
[ "$(grep -o 'b/late.sh\|a/quick.sh' stdout | head -n 2 | tr '\n' ' ')" = 'b/late.sh a/quick.sh ' ]
verdict $? 'they run in the order of their list'
printf '# tiers\nlate: what is late\n\tb/late.sh\n' > tests/tiers.txt
runs 0 '^1 passed' 'a whole name is that test alone' a/quick
runs 0 '^1 passed' 'and so is its file' tests/a/quick.sh
runs 0 '^2 passed' 'a part of a name' quic
runs 0 '^1 passed' 'a whole name of a tier' b/late
runs 0 '^0 passed' 'a part of a name of a tier is left out' lat
runs 2 'no test has "nil" in its name' 'a name of none' nil
runs 2 'one of late would be right' 'a tier of none' --tier early
[ ! -s stdout ] && [ "$(wc -l < stderr)" -eq 1 ]
verdict $? 'in one line'
echo 'late: what is late' > tests/tiers.txt
runs 1 'FAILED  b/late.sh took' 'a test of no tier that takes long fails'
grep -q 'took .* s of a machine.s processor time, of 0.1: shorten it, or list it in tests/tiers.txt' stdout
verdict $? 'and it is said why'
make_test b/late.sh '[ -e later ] || for ((i = 0; i < 300000; i++)); do :; done; touch later; echo "ok 1 - late"'
runs 0 '^3 passed' 'one that takes long beside others, and not alone, passes'
all_s=0.001 runs 1 'FAILED  all tests took' 'all tests that take long together fail'
make_test b/late.sh 'kill -SEGV $$'
runs 1 'killed by SIGSEGV' 'a crash'
make_test b/late.sh 'sleep 100'
runs 1 'no end after 5 s' 'a test that does not end'
make_test b/late.sh ':'
runs 1 'reported no test' 'a test that reports nothing'
make_test b/late.sh 'echo "ok 1 - no"; exit 3'
runs 1 'exit status 3' 'a test that ends with another status'
chmod -x tests/b/late.sh
runs 1 'exit status 126' 'a test that may not be executed'
make_test b/late.sh 'echo "ok 1 - no # SKIP nothing here"'
runs 0 '^2 passed, 0 failed, 1 skipped' 'a skip'
export TS_REQUIRE=all
printf '# none\n' > tests/skips.txt
runs 1 'skips 1, and tests/skips.txt has 0' 'a skip that is not listed, where everything is required'
printf '# one\nb/late.sh 1: nothing is there\n' > tests/skips.txt
runs 0 '^2 passed, 0 failed, 1 skipped' 'one that is'
unset TS_REQUIRE
rm build/record/touchstone
runs 2 'build/record/touchstone is not built: `make tests` builds it' 'what is not built is named, with what builds it'
finish
