#!/bin/bash
# The tarball of `make dist`: the same bytes each time, the files of the commit,
# which it knows where it is built without git.
. "$(dirname "$0")/../cli/tap.bash"
if [ ! -e .git ]; then
	echo '1..0 # SKIP not a git checkout'
	exit
fi

# dist NAME COMMAND...: a tarball made by the command.
dist() {
	local name=$1 made
	shift
	made=$("$@" make -s dist | tail -n 1) && cp "$made" "$scratch/$name"
}
(umask 077 && dist first env TZ=Asia/Tokyo) && dist second env LC_ALL=C XZ_OPT=-0 &&
	cmp "$scratch/first" "$scratch/second"
verdict $? 'the same bytes each time'

mkdir "$scratch/tree"
tar -xJf "$scratch/second" -C "$scratch/tree" && root=$(echo "$scratch"/tree/touchstone-*) && [ -d "$root" ] &&
	diff <(cd "$root" && find . ! -type d | sort) <(git ls-tree -r --name-only HEAD | sed 's|^|./|' | sort)
verdict $? 'the files of the commit'

object=build/none/obj/src/model/commit.c.o
commit=$(git rev-parse HEAD)
# knows COMMIT: what is built of the tarball says that.
knows() {
	(cd "$root" && GIT_DIR=/nowhere make -s BUILD=build/none "$object") &&
		[ "$(strings "$root/$object" | grep -oE '[0-9a-f]{40}.*')" = "$1" ]
}
knows "$commit"
verdict $? 'builds without git, and knows its commit'
touch "$root/src/model/core.h"
knows "$commit-dirty"
verdict $? 'knows that a file was changed'

! said=$(make -s -C "$root" dist 2>&1) && grep -q '^make dist: no git checkout here' <<< "$said"
verdict $? 'makes no tarball without git'

mkdir "$scratch/bin"
for tool in env gcc git grep make mkdir nproc pkg-config sed; do ln -s "$(command -v $tool)" "$scratch/bin"; done
said=$(env -u MAKEFLAGS -u MAKELEVEL PATH="$scratch/bin" make -s dist 2>&1)
[ $? -eq 2 ] && [ "$(grep -vc '^make: ' <<< "$said")" -eq 1 ] && grep -q '^make dist: no xz here' <<< "$said"
verdict $? 'names xz where it is missing'
finish
