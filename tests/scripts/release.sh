#!/bin/bash
# `make release` of the tarball alone, in a clone of the last commit: what the folder holds, and what is refused. The
# other parts take minutes. Prints TAP.
. "$(dirname "$0")/../cli/tap.bash"
if [ ! -e .git ]; then
	echo '1..0 # SKIP not a git checkout'
	exit
fi
git clone -q . "$scratch/clone" && cd "$scratch/clone" || exit

# releases PART...: with $status, $scratch/stdout and $scratch/stderr.
releases() {
	make -s release T="$*" > "$scratch/stdout" 2> "$scratch/stderr"
	status=$?
}
# refused PATTERN: by one line, and nothing is left.
refused() {
	[ "$status" -eq 2 ] && [ "$(grep -c '^release: ' "$scratch/stderr")" -eq 1 ] &&
		grep -q "^release: $1" "$scratch/stderr" &&
		[ -z "$(ls -d build/dist* 2> /dev/null)" ]
	verdict $? "refused: $1"
}

releases tarball nil
refused 'no part nil; usage: '
touch new
releases tarball
refused 'there are changes that are not committed'
rm new
sed -i 's/^## [0-9].*/## Unreleased/' CHANGELOG.md
git -c user.name=one -c user.email=one commit -qam unreleased
releases tarball
refused 'CHANGELOG.md has no section'
git reset -q --hard HEAD~1
mkdir "$scratch/bin" && printf '#!/bin/sh\necho 1000\n' > "$scratch/bin/id" && chmod +x "$scratch/bin/id"
PATH=$scratch/bin:$PATH releases tarball packages
grep -q 'skipped: a chroot needs root' "$scratch/stdout" &&
	refused 'packages: could not be made, .*T="tarball" leaves it out'

releases tarball
[ "$status" -eq 0 ] &&
	[ "$(cd build && find dist* | sort)" = "$(printf '%s\n' dist dist/SHA256SUMS "dist/$(basename build/*.tar.xz)")" ]
verdict $? 'the folder holds the tarball and its digest'
(cd build/dist && sha256sum --quiet -c SHA256SUMS) && [ "$(wc -l < build/dist/SHA256SUMS)" -eq 1 ]
verdict $? 'the digests are right'
! grep -vE "^ *[0-9]+  build/dist/" "$scratch/stdout" &&
	[ "$(stat -c '%s  %n' build/dist/* | sort)" = "$(sed 's/^ *//' "$scratch/stdout" | sort)" ]
verdict $? 'each file is printed with its size'
cp -r build/dist "$scratch/first"
releases tarball
diff -r "$scratch/first" build/dist
verdict $? 'the same bytes each time'
finish
