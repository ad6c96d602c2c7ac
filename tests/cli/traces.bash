# What the scripts about traces share. Sourced after tap.bash.

# A frame of every kind of buffer, in a second.
frame=(render reflections "$(realpath scenes/room.gltf)" --size 96x54 --reflectors 3 --set reflectors.px=30
	--set cube.max_px=64
	--set lookup.bounces=3 --no-images)

# digests_hold FOLDER: every file that its trace.json names has the digest it says, and there is no other in the folder.
digests_hold() {
	python3 - "$1" <<'PY'
import hashlib, json, os, sys
folder = sys.argv[1]
buffers = json.load(open(folder + "/trace.json"))["buffers"]
names = {b["file"]: b["sha256"] for b in buffers if b["file"]}
assert names, "no file"
own = {name for name in names if not name.startswith("../scene/")}
assert set(os.listdir(folder)) == own | {"trace.json"}, "other files"
for name, digest in names.items():
	assert hashlib.sha256(open(folder + "/" + name, "rb").read()).hexdigest() == digest, name
PY
}

# change FILE ELEMENT_BYTES ELEMENT OFFSET HEX: overwrites bytes of an element of a .npy file.
change() {
	python3 - "$@" <<'PY'
import sys
name, size, element, offset = sys.argv[1], *map(int, sys.argv[2:5])
data = bytearray(open(name, "rb").read())
at = 10 + data[8] + 256 * data[9] + size * element + offset
new = bytes.fromhex(sys.argv[5])
data[at:at + len(new)] = new
open(name, "wb").write(data)
PY
}
