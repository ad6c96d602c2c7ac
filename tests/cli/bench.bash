# What the scripts of tables share: for Python, the report of a folder with its times or as printed; and a file of a
# folder, timed or not. Sourced, not run.
cat > "$scratch/results.py" <<'PY'
import json, os
def results(path):
	files = [f"{path}/{name}.json" for name in ("report", "times")] if os.path.isdir(path) else [path]
	return {key: value for name in files if os.path.exists(name) for key, value in json.load(open(name)).items()}
def found(folder, name):
	return next(path for path in (f"{folder}/{name}", f"{folder}/times-{name}") if os.path.exists(path))
PY
export PYTHONPATH=$scratch
