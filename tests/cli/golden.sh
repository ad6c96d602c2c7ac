#!/bin/bash
# Goldens: proposed, blessed for a reason, and checked; a changed byte is named by buffer and element; hostile folders.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/stamp.bash"
export OMP_WAIT_POLICY=passive # other tests run beside this one
ref=$scratch/reference
mkdir "$ref"
small='--size 24x16 --reflectors 1 --set reflectors.px=12 --set cube.max_px=16 --small'
cat > "$ref/cases.txt" <<CASES
# The smallest that there are.
few: epr atrium:triangles=10000:texels=32 $small # kept
none: mvr dining:triangles=10000:texels=32 --size 24x16 --reflectors 0
CASES

# as COMMIT: the command as if it was built from that commit.
as() {
	stamp "$1" "$scratch"
	touchstone=$scratch/touchstone
}

# golden ARGUMENT...: on the small folder.
golden() { run golden "$@" --goldens "$ref"; }
# fails PATTERN ARGUMENT...: exit code 2 and one line on stderr that matches; stdout may hold verdicts.
fails() {
	local pattern=$1
	shift
	golden "$@"
	[ "$status" -eq 2 ] && [ "$(wc -l < "$scratch/stderr")" -eq 1 ] && grep -qe "$pattern" "$scratch/stderr"
	verdict $? "refused ($pattern): golden ${*//$'\n'/ }"
}
# says STATUS PATTERN NAME: what the last run ended with and printed.
says() {
	[ "$status" -eq "$1" ] && grep -qE -- "$2" "$scratch/stdout"
	verdict $? "$3"
}
# all_of FOLDER: the digests of all its files.
all_of() { (cd "$1" && find . -type f -exec sha256sum {} + | sort -k 2); }
# poke FILE OFFSET: adds one to a byte, counted from the end if the offset is negative.
poke() {
	python3 - "$@" <<'PY'
import sys
data = bytearray(open(sys.argv[1], "rb").read())
data[int(sys.argv[2])] = (data[int(sys.argv[2])] + 1) % 256
open(sys.argv[1], "wb").write(data)
PY
}

as clean-1
fails 'few: there is no such folder' check
says 2 '^0 passed, 2 failed, 0 skipped$' 'a missing golden fails, and is counted'
grep -q '^missing  *few' "$scratch/stdout"
verdict $? 'a missing golden is called so'
fails 'nothing new' bless few --reason first

golden new
[ "$status" -eq 0 ] && [ "$(cd "$ref" && echo *)" = 'cases.txt few.new none.new' ] &&
	[ "$(cd "$ref/few.new" && echo *)" = 'SHA256SUMS params.txt preview.png small' ] &&
	[ "$(cd "$ref/none.new" && echo *)" = 'SHA256SUMS params.txt preview.png' ]
verdict $? 'new writes nothing but .new'
fails 'few: there is no such folder' check
golden new few
[ "$status" -eq 0 ] && [ "$(cd "$ref" && echo *)" = 'cases.txt few.new none.new' ]
verdict $? 'a proposal replaces another'
touch "$ref/few.new/notes"
fails 'few.new: holds notes, which is no part of a golden' new few
rm "$ref/few.new/notes"

fails 'golden check: --reason is for bless' check few --reason first
fails 'golden new: --reason is for bless' new few --reason first
fails 'no reason' bless few
fails 'no reason' bless few --reason '  '
fails 'control characters' bless few --reason $'one\ntwo'
fails 'at most 400 bytes' bless few --reason "$(printf '%401s' x)"
fails 'which case' bless --reason first
fails 'no backend "metal"' bless few --reason first --backend metal
as a-dirty
fails 'not committed (a-dirty)' bless few --reason first
as unknown
fails 'does not know its commit' bless few --reason first
as clean-1
[ ! -e "$ref/few" ]
verdict $? 'what was refused changed nothing'
for case in few none; do
	golden bless $case --reason "first of $case"
	says 0 "^blessed  *$case$" "blessed: $case"
done
[ "$(cat "$ref/few/CHANGES" "$ref/none/CHANGES")" = $'first of few\nfirst of none' ]
verdict $? 'the reasons are kept'
[ "$(cd "$ref" && echo *)" = 'cases.txt few none' ] &&
	[ "$(cd "$ref/few" && echo *)" = 'CHANGES SHA256SUMS params.txt preview.png small' ]
verdict $? 'nothing stays proposed'
fails 'nothing new' bless few --reason again
golden new few
cp -r "$ref/few.new" "$scratch/kept"
golden bless few --reason second
[ "$(cat "$ref/few/CHANGES")" = $'first of few\nsecond' ]
verdict $? 'another reason stands behind the first'
cp -r "$scratch/kept" "$ref/few.new" # as if it was killed before it removed that
golden bless few --reason second
[ "$status" -eq 0 ] && [ "$(cat "$ref/few/CHANGES")" = $'first of few\nsecond' ] && [ ! -e "$ref/few.new" ]
verdict $? 'what was blessed already is not blessed twice'
cp -r "$scratch/kept" "$ref/few.new"
touch "$ref/few/mine"
fails 'few: holds mine, which is no part of a golden' bless few --reason third
rm -r "$ref/few/mine" "$ref/few.new"

all_of "$ref" > "$scratch/before"
golden check
says 0 '^2 passed, 0 failed, 0 skipped$' 'what was blessed is the same'
golden check few --threads 3 --no-fast-paths
says 0 '^1 passed, 0 failed, 0 skipped$' 'one case, by the kernels alone'
touchstone=$(realpath "${BUILD:-build/release}/touchstone-core")
golden check
says 0 '^2 passed, 0 failed, 0 skipped$' 'the static core says so too'
touchstone=$(realpath "${BUILD:-build/release}/touchstone")
all_of "$ref" | cmp -s - "$scratch/before"
verdict $? 'check writes nothing'
(cd "$ref/few/small" && sha256sum -c --ignore-missing --status ../SHA256SUMS)
verdict $? 'sha256sum finds the small files right'
run digest atrium:triangles=10000:texels=32 --method epr --size 24x16 --reflectors 1 --set reflectors.px=12 \
	--set cube.max_px=16
grep -v '^#' "$scratch/stdout" | cmp -s - "$ref/few/SHA256SUMS"
verdict $? 'SHA256SUMS is what digest prints'
# What EPR reads, without what scenes of files do and what its other choices would.
"$touchstone" list params --effect reflections --method epr --json | sed -n 's/.*"name": "\(.*\)".*/\1/p' |
	sort > "$scratch/listed"
sed 's/=.*//' "$ref/few/params.txt" | grep -vx 'effect\|method\|scene' | sort > "$scratch/held"
grep -qx 'scene=atrium:triangles=10000:texels=32' "$ref/few/params.txt" &&
	grep -qx 'cube.max_px=16' "$ref/few/params.txt" &&
	[ "$(comm -13 "$scratch/listed" "$scratch/held")" = '' ] &&
	[ "$(comm -23 "$scratch/listed" "$scratch/held" | tr '\n' ' ')" = 'scene.ground surfels.neighbours ' ]
verdict $? 'params.txt holds the scene and every parameter that is read'

# with COMMANDS: changes a copy of the folder; the next golden commands work on it.
with() {
	rm -rf "$scratch/copy"
	cp -r "$scratch/reference" "$scratch/copy"
	ref=$scratch/copy
	(cd "$ref" && eval "$1")
}

with 'poke few/small/04-eye.depth_triangle.npy $((128 + 8 * 27))'
golden check few
says 1 \
	'^different  few  *04-eye.depth_triangle.npy: element \[1, 3\]: golden [0-9]+ \(0x[0-9a-f]+\) here [0-9]+ .*small/ does not' \
	'a changed byte is found with its element'
(cd "$ref/few/small" && ! sha256sum -c --ignore-missing --status ../SHA256SUMS)
verdict $? 'sha256sum finds it too'
with 'poke few/small/05-mirror_pixel.record.npy -96; poke few/small/20-image.srgb.npy -1'
golden check few
says 1 \
	'05-mirror_pixel.record.npy: element \[[0-9]+\], field position\[0\]: golden -?0x[0-9a-fp.+-]+ \([0-9a-f]{8}\) here ' \
	'the first in the pipeline is named, with its field'
with "sed -i '/12-splat/s/^./x/; /12-splat/s/^x\(.\)/\1\1/' few/SHA256SUMS"
golden check few
says 1 '12-splat.depth_index.npy: (SHA-256|small)' 'a changed digest is found'
with "sed -i '/eye.depth/d' none/SHA256SUMS"
golden check
says 1 '^different  none  *04-eye.depth_triangle.npy: not in SHA256SUMS$' 'a buffer without a digest is found'
with "sed -i 's/^lookup.bounces=1/lookup.bounces=2/' few/params.txt"
golden check few
says 1 'params.txt: lookup.bounces=2, but cases.txt makes it 1' 'other parameters are found'
with "sed -i '/^bounces/d' few/params.txt"
golden check few
says 0 '^same ' 'a parameter that the golden does not know has its default'
with 'rm few/small/20-image.srgb.npy'
fails 'small/20-image.srgb.npy: there is no such file' check few

with 'rm none/SHA256SUMS'
fails 'none/SHA256SUMS: there is no such file' check
says 2 '^1 passed, 1 failed, 0 skipped$' 'the others are checked all the same'
with 'echo nonsense >> none/SHA256SUMS'
fails 'is not a digest' check none
with "sed -i 's,  0,  ../../0,' none/SHA256SUMS"
fails 'writes no file' check none
with 'cat none/SHA256SUMS none/SHA256SUMS > x; mv x none/SHA256SUMS'
fails 'stands there twice' check none
with 'truncate -s 1M none/SHA256SUMS'
fails 'at most 65536 are read' check none
with 'touch few/small/evil.npy'
fails 'evil.npy" is not a file that SHA256SUMS names' check few
with 'truncate -s -1 few/small/20-image.srgb.npy'
fails 'its shape needs' check few
with 'echo surprise=1 >> none/params.txt'
fails 'no parameter "surprise"' check none
with 'mv none/SHA256SUMS x; ln -s ../x none/SHA256SUMS'
fails 'a link; the file itself would be right' check none
with 'mv none ..; ln -s ../none none'
fails 'cannot open the folder' check none
rm -rf "$scratch/none"

# The picture and the reasons.
# paint FILE WIDTH [X Y]: a PNG of the pixels of few's picture, so wide, all rows by another filter; that pixel one off.
paint() {
	python3 - "$ref/few/small/20-image.srgb.npy" "$@" <<'PY'
import struct, sys, zlib
width, pixels = int(sys.argv[3]), bytearray(open(sys.argv[1], "rb").read()[128:])
if len(sys.argv) > 4:
	pixels[3 * (int(sys.argv[5]) * width + int(sys.argv[4])) + 1] ^= 1
rows = [pixels[i:i + 3 * width] for i in range(0, len(pixels), 3 * width)]
above, packed = bytes(3 * width), b""
for y, row in enumerate(rows):
	packed += bytes([y % 5])
	for i, value in enumerate(row):
		a, b, c = (row[i - 3], above[i], above[i - 3]) if i >= 3 else (0, above[i], 0)
		nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
		packed += bytes([(value - (0, a, b, (a + b) // 2, nearest)[y % 5]) % 256])
	above = row
chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
open(sys.argv[2], "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR",
                                                           struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0)) +
                              chunk(b"IDAT", zlib.compress(packed, 1)) + chunk(b"IEND", b""))
PY
}
as clean-1
with 'paint few/preview.png 24'
golden check few
says 0 '^same ' 'another file of the same pixels is the same preview'
with 'paint few/preview.png 24 7 3'
golden check few
says 1 '^different  few  preview.png: pixel \[3, 7\]: golden [0-9]+ [0-9]+ [0-9]+ here [0-9]+ [0-9]+ [0-9]+$' \
	'a changed pixel of the preview is found'
with 'paint few/preview.png 12'
golden check few
says 1 '^different  few  preview.png: golden 12 by 32 pixels here 24 by 16$' 'a preview of another size is found'
with 'cp none/preview.png few/preview.png'
golden check few
says 1 '^different  few  preview.png: pixel' "another case's preview is found"
with 'rm few/preview.png'
fails 'few/preview.png: there is no such file' check few
with 'truncate -s -20 few/preview.png'
fails 'few/preview.png: damaged: ' check few
with 'poke few/preview.png 45'
fails 'few/preview.png: damaged: ' check few
with ': > few/preview.png'
fails 'few/preview.png: neither PNG nor JPEG' check few
with 'poke few/preview.png 16'
fails 'few/preview.png: its header says 16777240 by 16; at most 1048576 texels are justified' check few
with 'truncate -s 9M few/preview.png'
fails 'few/preview.png: 9437184 bytes; at most 8388608 are read' check few
with 'rm few/CHANGES'
fails 'few/CHANGES: there is no such file' check few
with ': > few/CHANGES'
fails 'few/CHANGES: not lines of text' check few
with 'printf unended >> few/CHANGES'
fails 'few/CHANGES: not lines of text' check few
with 'printf "a\0b\n" >> few/CHANGES'
fails 'few/CHANGES: not lines of text' check few
with 'echo >> few/CHANGES'
fails 'few/CHANGES: line 3: no reason' check few
with 'printf "\033[2J\n" >> few/CHANGES'
fails 'few/CHANGES: line 3: a reason is one line, without control' check few
with 'printf "%401s\n" x >> few/CHANGES'
fails 'few/CHANGES: line 3: a reason has at most 400 bytes' check few
with 'rm few/CHANGES; mkdir few/CHANGES'
fails 'few/CHANGES: not a regular file' check few

# line PATTERN TEXT: a cases.txt of that line is refused.
line() {
	with true
	printf '%b\n' "# first\n$2" > "$ref/cases.txt"
	golden check
	[ "$status" -eq 2 ] && [ ! -s "$scratch/stdout" ] && [ "$(wc -l < "$scratch/stderr")" -eq 1 ] &&
		grep -qe "cases.txt:[0-9]*: .*$1" "$scratch/stderr"
	verdict $? "refused line ($1): ${2:0:60}"
}
line 'is not a name' '../few: epr atrium'
line 'is not a name' '/etc: epr atrium'
line 'is not a name' '.: epr atrium'
line 'is not a name' ': epr atrium'
line 'is not a name' '-few: epr atrium'
line 'is not a name' 'Few: epr atrium'
line 'is not a name' 'a\033[2Jb: epr atrium'
line 'is not a name' "$(printf '%041d' 0): epr atrium"
line 'second case of the name' 'few: epr atrium --size 16x16\nfew: mvr atrium'
line 'no ":"' 'epr atrium'
line 'too few arguments' 'few: epr'
line 'one argument too many' 'few: epr atrium gallery'
line 'no method "rays" of reflections' 'few: rays atrium'
line 'no method "epr" of soft-shadows' 'few: soft-shadows/epr atrium'
line 'no effect "shadows"; the nearest is' 'few: shadows/mvr atrium'
line 'neither a built-in scene nor the path' 'few: epr /scenes/room.gltf'
line 'beyond 199 bytes' "few: epr atrium:$(printf '%0300d' 0)"
line 'no such parameter; the nearest is lookup.bounces' 'few: epr atrium --set bouncs=2'
line 'not a whole number' 'few: epr atrium --set lookup.bounces=4'
line 'at most 1048576 pixels' 'few: epr atrium --size 2000x2000'
line 'at most .* frame 1000' 'few: epr atrium --size 16x16 --frame 1001'
line 'no option --output' 'few: epr atrium --output x'
line 'no option -o' 'few: epr atrium -o x'
line 'help is no part' 'few: epr atrium --help'
line 'more than 99 words' "few: epr$(printf ' atrium%.0s' {1..100})"
line 'no case' ''
with "printf 'few: epr\\0 atrium\\n' > cases.txt"
fails 'a byte that is no text' check
with 'truncate -s 1M cases.txt'
fails 'at most 65536 are read' check
with 'rm cases.txt; mkfifo cases.txt'
fails 'not a regular file' check
with "sed -i '\$s/triangles=10000/triangles=9/' cases.txt"
golden check none
says 1 'params.txt: scene=dining:triangles=10000:texels=32, but cases.txt makes it dining:triangles=9:texels=32' \
	'another scene is found'
fails 'out of range' new none

# What bless looks at: that this build computes what was proposed.
as clean-1
with true
golden new few
rm -r "$scratch/kept" && cp -r "$ref/few.new" "$scratch/kept"
# proposes: the same again.
proposes() { rm -r "$ref/few.new" && cp -r "$scratch/kept" "$ref/few.new"; }
paint "$ref/few.new/preview.png" 24 0 0
fails 'computes something else: preview.png: pixel \[0, 0\]' bless few --reason painted
proposes
poke "$ref/few.new/small/01-eye.view.npy" -1
fails 'computes something else: 01-eye.view.npy: element' bless few --reason damaged
proposes
sed -i 's/^lookup.bounces=1/lookup.bounces=2/' "$ref/few.new/params.txt"
fails 'lookup.bounces=2, but cases.txt makes it 1' bless few --reason other
proposes
rm "$ref/few.new/preview.png"
fails 'no preview.png in' bless few --reason unseen
as clean-1
with "sed -i 's/--reflectors 0/--reflectors 0 --set image.exposure=1024 --set light.ambient=1000000/' cases.txt"
golden new none
fails 'the image is of one colour' bless none --reason white

ref=$scratch/reference
refuses 'the nearest is check' golden chekc --goldens "$ref"
refuses 'no case "fewer" in .*; the nearest is few' golden check fewer --goldens "$ref"
refuses 'no case "../few"' golden check ../few --goldens "$ref"
refuses 'too few arguments' golden
refuses 'cannot open the folder' golden check --goldens "$scratch/absent"

finish
