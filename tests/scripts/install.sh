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

make -s install DESTDIR="$scratch/made" "${places[@]}" > "$scratch/stdout"
verdict $? 'installs'
find "$scratch/made" ! -type d -printf '/%P\n' |
	grep -vE "^($at/(bin/touchstone$|lib/machine/|include/touchstone/|share/)|/opt/docs/)" > "$scratch/astray"
[ ! -s "$scratch/astray" ]
verdict $? 'into the folders that were named'

mv "$scratch/made" "$scratch/moved"
make -s installcheck DESTDIR="$scratch/moved" "${places[@]}" | sed 's/^/# /'
verdict "${PIPESTATUS[0]}" 'all of it works where it is moved to'

echo kept > "$scratch/moved/opt/docs/other"
make -s uninstall DESTDIR="$scratch/moved" "${places[@]}" > "$scratch/stdout" &&
	[ "$(find "$scratch/moved" ! -type d)" = "$scratch/moved/opt/docs/other" ]
verdict $? 'uninstall leaves what is of others'
finish
