#!/bin/bash
# The transcripts of reference/PORTING.md are what is printed. With --write they are made again.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/ports.bash"
root=$PWD
find_numpy || exit 0
mkdir "$scratch/bin" "$scratch/work"
ln -s "$touchstone" "$scratch/bin/touchstone"
printf '#!/bin/sh\nexec %s "$@"\n' "$(command -v "$python")" > "$scratch/bin/python3"
chmod +x "$scratch/bin/python3"
for folder in scenes tests include; do ln -s "$root/$folder" "$scratch/work/$folder"; done
cd "$scratch/work" && PATH=$scratch/bin:$PATH LC_ALL=C.UTF-8 /usr/bin/python3 "$root/tests/ports/transcript.py" "$@" \
	"$root/reference/PORTING.md"
