#!/bin/bash
# What scripts/install-deps says and does where packages are missing; nothing is installed, for apt-get is one of ours.
. "$(dirname "$0")/../cli/tap.bash"
mkdir "$scratch/bin"
PATH=$scratch/bin:$PATH
command() { printf '#!/bin/bash\n%s\n' "$2" > "$scratch/bin/$1" && chmod +x "$scratch/bin/$1"; }
command dpkg-query '[ "${!#}" = gcc ] || echo installed'
command apt-get "echo \"\$*\" >> '$scratch/asked'"
command sudo '"$@"'

# deps COMMAND...: its output, and what apt-get was asked for.
deps() {
	: > "$scratch/asked"
	"$@" > "$scratch/stdout" 2> "$scratch/stderr"
	status=$?
}

deps env -u TS_INSTALL scripts/install-deps
[ "$status" -eq 0 ] && [ "$(cat "$scratch/stdout")" = 'install-deps: installing gcc' ] &&
	grep -q '^install .* gcc$' "$scratch/asked"
verdict $? 'what is missing is printed and installed'

for target in demo test check; do
	install=0
	[ $target = check ] && install=1
	deps env TS_INSTALL=$install make $target T=none
	[ "$status" -ne 0 ] && [ ! -s "$scratch/asked" ] &&
		[ "$(grep -c '^install-deps: .*missing: gcc$' "$scratch/stderr")" -eq 1 ]
	verdict $? "make $target installs nothing and says what is missing"
done

command dpkg-query 'echo installed'
deps env TS_INSTALL=0 scripts/install-deps
[ "$status" -eq 0 ] && [ ! -s "$scratch/asked" ] && [ ! -s "$scratch/stdout" ]
verdict $? 'nothing is said where nothing is missing'
finish
