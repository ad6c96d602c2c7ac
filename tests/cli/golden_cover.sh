#!/bin/bash
# The goldens of reference/ together take every choice, stage and scene; what is stored is what its digests say.
. "$(dirname "$0")/tap.bash"

for what in params stages methods scenes; do
	"$touchstone" list $what --json > "$scratch/$what.json"
done
# cover WHAT: what of that kind no case takes, from the tables of the program and the stored files; nothing is right.
cover() {
	python3 - "$1" "$scratch" <<'PY'
import glob, json, os, re, subprocess, sys
what, scratch = sys.argv[1:]
table = {k: json.load(open(f"{scratch}/{k}.json"))[k] for k in ("params", "stages", "methods", "scenes")}
cases = {}
for path in glob.glob("reference/goldens/*/params.txt"):
	folder = os.path.dirname(path)
	case = dict(line.rstrip("\n").split("=", 1) for line in open(path))
	case["files"] = {re.sub(r"^\d\d-|\.npy$", "", line.split()[1]) for line in open(folder + "/SHA256SUMS")}
	cases[os.path.basename(folder)] = case
names = {m.group(1) for m in re.finditer(r"^([a-z0-9-]+):", open("reference/goldens/cases.txt").read(), re.M)}
methods = [(m["effect"], m["name"]) for m in table["methods"]]
of = lambda *methods: [case for case in cases.values() if (case["effect"], case["method"]) in methods]
# Who must take every choice of a parameter, if not whom takers_of says.
views = [("reflections", "ivir"), ("soft-shadows", "ivir"), ("omni-shadows", "ivir")]
soft, omni, indirect, particles = ([m for m in methods if m[0] == effect]
                                   for effect in ("soft-shadows", "omni-shadows", "indirect", "particles"))
hulls, lamps = [("indirect", "hulls")], [("area-light", m) for m in ("hulls", "direct")]
deferred, surfels = [("surfels", "deferred")], [m for m in methods if m[0] == "surfels"]
megaviews = [("indirect", m) for m in ("megaviews", "manylods", "bruteforce")]
takers = {"density.rate": views, "points.buffered": views, "points.snap": views, "scatter.at": views,
          "scatter.headroom": views[:1], "lamp.source": soft[:1], "lamp.radius": soft + lamps, "lamp.fov": soft,
          "lamp.views": soft, "lamp.views_a_pass": soft + omni, "depth_map.px": soft + omni, "lamp.cubes": omni,
          "depth_map.bias": soft + omni, "depth_map.bias_slope": soft + omni, "pcss.near": [("soft-shadows", "pcss")],
          **{p: [("omni-shadows", "epr")] for p in ("shadow_splat.rate", "shadow_splat.depth", "shadow_splat.resize")},
          "rsm.px": indirect, **{p: hulls for p in ("depth_grid.px", "segment.method", "segment.step", "corner.facing",
                                                    "hull.corners", "hull.surface", "hull.interpolation",
                                                    "hull.cosine", "hull.sharpness", "hull.integrals")},
          "gloss.lobe": lamps + [("indirect", m) for m in ("hulls", "direct")],
          **{p: megaviews for p in ("octree.levels", "vpl.paths", "vpl.bounces", "vpl.place", "view_map.px",
                                    "view_map.field", "view_map.apart", "view_map.multipixel", "view_map.fill",
                                    "view_map.fusion", "traverse.cull", "traverse.hierarchies", "traverse.queue_mb",
                                    "vpl_gather.level", "vpl_gather.cutoff", "vpl_gather.lights", "vpl_gather.near",
                                    "vpl_gather.bias", "vpl_gather.test", "vpl_gather.query",
                                    "vpl_gather.bias_plane", "vpl_gather.shadows", "bilateral.px")},
          "particle.count": particles, "particle.glow": particles,
          **{p: deferred for p in ("ewa.filter", "ewa.screen_radius", "ewa.sigma_k", "surfel_depth.epsilon",
                                   "surfel_setup.min_px", "surfel_setup.bounds", "deferred.shader", "surfels.radius",
                                   "surfels.sides",
                                    "surfel_blend.accumulation")},
          "ewa.sigma_h": [("surfels", "ewa")], "surfels.from_mesh": surfels,
          "eye.distance": deferred + [("reflections", "epr")],
          "points.conservative": views + [("reflections", "epr"), ("reflections", "vir")],
          "forward.viewer": [("reflections", "epr-forward")],
          **{p: [("reflections", "mvr")] for p in ("mvr.faces", "mvr.filter")}}
steps_of = {(m["effect"], m["name"]): [s for s in m["stages"].split() if not s.endswith("margin")]
            for m in table["methods"]}
def takers_of(param):
	"""Those above; else, of a family behind the first two, all methods that run one of its stages;
	else EPR's reflections."""
	families = re.findall(r"^#include FAMILY\((\w+)\)", open("src/families.def").read(), re.M)[2:]
	for folder in ("src/methods/" + family for family in families):
		if param not in takers and f'"{param}"' in open(folder + "/params.def").read():
			own = set(re.findall(r"^STAGE\((\w+)\)", open(folder + "/family.def").read(), re.M))
			return [m for m in methods if own & {step.replace(".", "_") for step in steps_of[m]}]
	return takers.get(param, [("reflections", "epr")])
missing = []
if what == "matrix":
	listed = subprocess.run(["scripts/matrix", "--list"], stdout=subprocess.PIPE, text=True, check=True).stdout
	taken = set()
	for line in listed.splitlines():
		effect, names = (re.search(f"--{word} (\\S+)", line) for word in ("effect", "method"))
		taken |= {(effect[1] if effect else "reflections", name) for name in names[1].split(",")}
	missing = [" by ".join(pair) for pair in sorted(taken ^ set(methods))]
elif what == "folders":
	missing = sorted(names ^ cases.keys())
elif what == "choices":
	for p in table["params"]:
		if p["name"] in ("truth.rays", "truth.area_samples", "truth.bounce_rays", "truth.grid_rays", "scene.ground",
		                 "surfels.neighbours"): # of truths and of files
			continue
		taken = {case[p["name"]] for case in of(*takers_of(p["name"])) if p["name"] in case}
		missing += [f"{p['name']}={c}" for c in p["range"].split("|") if "|" in p["range"] and c not in taken]
		missing += [p["name"]] if len(taken) < 2 else []
	missing += [f"lookup.bounces={n}" for n in "123"
	            if n not in {case["lookup.bounces"] for case in of(("reflections", "epr"))}]
	missing += [f"reflectors.count=0 by {m}" for e, m in methods
	            if "0" not in {case["reflectors.count"] for case in of((e, m))}]
elif what == "stages":
	several = {"image.sample_radiance"}  # of several samples a pixel alone
	writes = {s["name"]: [b for b in re.findall(r"[a-z0-9_.]+", s["writes"]) if b not in several]
	          for s in table["stages"]}
	for m in methods:
		steps, made = steps_of[m], set().union(*(case["files"] for case in of(m)))
		missing += [] if len(steps) > 5 else [m]
		missing += [f"{'/'.join(m)}: {s}" for s in steps if not writes[s] or not set(writes[s]) <= made]
elif what == "scenes":
	reflections = [m for m in methods if m[0] == "reflections" and m[1] in ("epr", "mvr")]
	groups = [[m] for m in reflections] + [views[:1], soft, omni, indirect, particles]
	of_surfels = [s["name"] for s in table["scenes"] if s["name"] == "checkerboard"]
	missing = [f"{s['name']} by {group[0]}" for group in groups + [deferred] for s in table["scenes"]
	           if s["name"] not in {case["scene"].split(":")[0] for case in of(*group)}
	           and (group == deferred or s["name"] not in of_surfels)]
print("".join(f"# missing: {text}\n" for text in missing), end="")
sys.exit(bool(missing))
PY
}

for what in folders choices stages scenes; do
	cover $what
	verdict $? "the cases take all $what"
done
cover matrix
verdict $? "the cases of scripts/matrix take every method of every effect"
for folder in reference/goldens/*/; do
	[ -f "$folder/preview.png" ] && [ -f "$folder/SHA256SUMS" ] && { [ ! -d "$folder/small" ] ||
		(cd "$folder/small" && sha256sum -c --ignore-missing --status ../SHA256SUMS); }
	verdict $? "$folder holds what its digests say"
	grep -q . "$folder/CHANGES"
	verdict $? "$folder was blessed for a reason"
done
# The core, which reads no PNG, cannot tell: the digest of the picture is that of the preview's pixels behind a header.
python3 - <<'PY'
import base64, glob, hashlib, re, sys
sys.path.insert(0, "tests/cli")
from report import pixels_of
others = []
for path in glob.glob("reference/goldens/*/preview.png"):
	width, height, n, pixels = pixels_of(base64.b64encode(open(path, "rb").read()))
	head = f"{{'descr': '|u1', 'fortran_order': False, 'shape': ({height}, {width}, {n}), }}"
	file = b"\x93NUMPY\x01\x00\x76\x00" + head.ljust(117).encode() + b"\n" + pixels
	sums = open(path.replace("preview.png", "SHA256SUMS")).read()
	if not re.search(f"^{hashlib.sha256(file).hexdigest()}  \\d\\d-image.srgb.npy$", sums, re.M):
		others.append(path)
print("".join(f"# another picture: {path}\n" for path in others), end="")
sys.exit(bool(others))
PY
verdict $? 'each preview is the picture that its digests name'
[ "$(du -sk reference | cut -f 1)" -lt 20480 ]
verdict $? 'reference/ is smaller than 20 MB'

finish
