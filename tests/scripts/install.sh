#!/bin/bash
# What a packager does: installs below DESTDIR with a libdir of several parts, moves all of it, and checks it there.
. "$(dirname "$0")/../cli/tap.bash"
case ${BUILD:-} in
*asan | *ubsan | *tsan)
	echo "1..0 # SKIP a program of the shared library would have to begin with the sanitizer's library"
	exit ;;
esac
grep -q -e -Werror "${BUILD:-build/release}/flags" && export WERROR=1
at=/opt/touchstone
places=(prefix=$at libdir=$at/lib/machine docdir=/opt/docs)

(umask 077 && make -s install DESTDIR="$scratch/made" "${places[@]}" > "$scratch/stdout") &&
	[ -z "$(find "$scratch/made/opt" ! -type d ! -perm -444)" ]
verdict $? 'installs, for all to read'
find "$scratch/made" ! -type d -printf '/%P\n' |
	grep -vE \
	"^($at/(bin/touchstone$|lib/machine/|lib/python3/dist-packages/touchstone/|include/touchstone/|share/)|/opt/docs/)" \
	> "$scratch/astray"
[ ! -s "$scratch/astray" ]
verdict $? 'into the folders that were named'
diff -r tests/api/example "$scratch/made$at/share/touchstone/examples"
verdict $? 'with the examples'
[ -e "$scratch/made$at/include/touchstone/candidate.h" ] &&
	[ "$(head -qn 1 "$scratch/made$at/include/touchstone"/* | sort -u)" = '/* SPDX-License-Identifier: Apache-2.0 */' ]
verdict $? 'with headers that say their licence, alone'
! command -v clang > "$scratch/stdout" ||
	[ "$(grep -c '^\.visible \.entry' "$scratch/made$at/share/touchstone/kernels.ptx")" -eq \
	"$(scripts/assembled src/backends/kernels.def | grep -c '^KERNEL(')" ]
verdict $? 'with all kernels as PTX, where there is clang'
[ ! -e .git ] || grep -q "^\.TH TOUCHSTONE [1] \"$(date -u -d "@$(git log -1 --format=%ct)" +%F)\" " \
	"$scratch/made$at/share/man/man1/touchstone.1"
verdict $? "with a manual of the commit's date"

# As debian/rules installs it, which leaves out these two.
patterns=$(sed 's|\.|\\.|g; s|\*|[^/]*|g' debian/*.install)
set -f
find "$scratch/made" ! -type d -printf '/%P\n' | grep -vE '^/opt/docs/(CHANGELOG.md|LICENSE)$' |
	sed "s|^$at/|usr/|; s|^/opt/docs/|usr/share/doc/touchstone/|" | while read -r file; do
	n=0
	for pattern in $patterns; do [[ $file =~ ^$pattern(/|$) ]] && n=$((n + 1)); done
	[ $n -eq 1 ] || echo "# $file is in $n packages"
done > "$scratch/astray"
set +f
cat "$scratch/astray"
[ ! -s "$scratch/astray" ]
verdict $? 'each file is in one package of debian/'

mv "$scratch/made" "$scratch/moved"
make -s installcheck DESTDIR="$scratch/moved" "${places[@]}" | sed 's/^/# /'
verdict "${PIPESTATUS[0]}" 'all of it works where it is moved to'

echo kept | tee "$scratch/moved/opt/docs/"{other,reference/other} \
	"$scratch/moved$at/share/man/man1/touchstone-other.1" > "$scratch/stdout"
make -s uninstall DESTDIR="$scratch/moved" "${places[@]}" > "$scratch/stdout" &&
	[ "$(find "$scratch/moved" ! -type d -exec cat {} + | sort | uniq -c)" = '      3 kept' ]
verdict $? 'uninstall leaves what is of others'
for word in docdir= libdir='a b' DESTDIR='a b'; do
	! make -s uninstall "$word" 2> "$scratch/stderr" && grep -q 'without blanks would be right' "$scratch/stderr"
	verdict $? "uninstall of $word is refused"
done
finish
