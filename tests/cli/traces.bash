# What the scripts about traces share. Sourced after tap.bash.

# A frame of every kind of buffer, in a second.
frame=(render reflections "$(realpath scenes/room.gltf)" --size 96x54 --reflectors 3 --set reflectors.px=30 --set cube.max_px=64
	--set lookup.bounces=3 --no-images)

# digests_hold FOLDER: every file that its trace.json names has the digest it says, and there is no other.
digests_hold() {
	python3 - "$1" <<'PY'
import hashlib, json, os, sys
folder = sys.argv[1]
buffers = json.load(open(folder + "/trace.json"))["buffers"]
names = {b["file"]: b["sha256"] for b in buffers if b["file"]}
assert names, "no file"
assert set(os.listdir(folder)) == set(names) | {"trace.json"}, "other files"
for name, digest in names.items():
	assert hashlib.sha256(open(folder + "/" + name, "rb").read()).hexdigest() == digest, name
PY
}
