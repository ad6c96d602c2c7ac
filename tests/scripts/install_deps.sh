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

# wants GROUP: the packages that it would install on a machine without any.
wants() {
	TS_INSTALL=0 scripts/install-deps "--$1" 2>&1 > "$scratch/stdout" | sed -n 's/^install-deps: .* missing: //p' |
		tr ' ' '\n'
}
command dpkg-query 'exit 1'
good=0 before=/dev/null
for group in core build test package matrix; do
	wants $group > "$scratch/$group"
	n_before=$(wc -l < "$before")
	head -n "$n_before" "$scratch/$group" | cmp -s "$before" - && [ "$(wc -l < "$scratch/$group")" -gt "$n_before" ] ||
		good=1
	before=$scratch/$group
done
[ -z "$(sort "$scratch/matrix" | uniq -d)" ]
verdict $((good + $?)) 'each group is the one before and more, and names no package twice'
! grep -qE '^(clang|pocl|mesa|libcmocka)' "$scratch/build"
verdict $? 'who only builds gets no clang, no drivers and no tests'
for with in gcc-12:gcc-12 'clang-15:clang-15 libomp-15-dev'; do
	wants "${with%:*}" | grep -vxFf "$scratch/core" | paste -sd' ' | grep -qx "${with#*:}"
	verdict $? "the core with ${with%:*} needs that too"
done
refused=$(scripts/install-deps --none 2>&1)
[ $? -eq 2 ] && [ "$(wc -l <<< "$refused")" -eq 1 ] && grep -q 'unknown option --none: use --core, ' <<< "$refused"
verdict $? 'an unknown group is refused'

command dpkg-query '[ "${!#}" = gcc ] || echo installed'
deps env -u TS_INSTALL scripts/install-deps
[ "$status" -eq 0 ] && [ "$(cat "$scratch/stdout")" = 'install-deps: installing gcc' ] &&
	grep -q '^install .* gcc$' "$scratch/asked"
verdict $? 'what is missing is printed and installed'

# Fedora: there is rpm, and no dpkg-query. fedora GROUP: what is asked for there.
mkdir "$scratch/fedora"
for tool in bash env grep id; do ln -s "$(type -P $tool)" "$scratch/fedora"; done
mv "$scratch/bin/sudo" "$scratch/fedora"
command rpm '[ "${!#}" != gcc ]' && command dnf "echo \"\$*\" >> '$scratch/asked'"
mv "$scratch/bin/rpm" "$scratch/bin/dnf" "$scratch/fedora"
fedora() { deps env -u TS_INSTALL PATH="$scratch/fedora" scripts/install-deps "$@"; }
fedora
[ "$status" -eq 0 ] && [ "$(cat "$scratch/stdout")" = 'install-deps: installing gcc' ] &&
	grep -q '^install .* gcc$' "$scratch/asked"
verdict $? 'on Fedora what is missing comes by dnf'
sed -i 's/\[.*/exit 1/' "$scratch/fedora/rpm"
fedora --matrix
[ "$status" -eq 0 ] && grep -q ' gcc-c++ .* embree-devel .* clang .* pandoc ' "$scratch/asked" &&
	! grep -qE -- '-dev( |$)' "$scratch/asked"
verdict $? 'by the names that it has there'
rm "$scratch/fedora/dnf"
fedora
[ "$status" -eq 2 ] && grep -q '^install-deps: this is neither Debian nor Fedora' "$scratch/stderr"
verdict $? 'elsewhere what is missing is said'
mv "$scratch/fedora/sudo" "$scratch/bin"

# What the targets ask for; their own make stops at the target that has no rule.
for target in demo:build test:test fuzz:test mutants:test faults:test; do
	made=$(make -n "${target%:*}" T=none 2> "$scratch/stderr" | grep -o 'scripts/install-deps.*')
	[ "$made" = "scripts/install-deps --${target#*:}" ]
	verdict $? "make ${target%:*} wants what is needed to ${target#*:}"
done

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
