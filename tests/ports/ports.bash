# What the scripts of this folder share beside ../cli/tap.bash. Sourced, not run.
export PYTHONDONTWRITEBYTECODE=1

# trace FOLDER SCENE OPTION...: a trace of EPR, in $scratch/FOLDER/trace-epr.
trace() {
	local folder=$1
	shift
	run render reflections "$@" --method epr --trace --no-images -o "$scratch/$folder"
	[ "$status" -eq 0 ]
}

# micro FOLDER SCENE OPTION...: the same of one of the triangles of scenes/; its values are in reference/PORTING.md.
micro() {
	local folder=$1 scene=$2
	shift 2
	trace "$folder" "scenes/$scene.gltf" --camera camera --reflectors 0 --size 64x64 --set cube.px=16 "$@"
}

# find_numpy: $python, a python3 that has numpy; without one, says that the test is skipped.
find_numpy() {
	for python in python3 /usr/bin/python3; do
		"$python" -c 'import numpy' 2> /dev/null && return 0
	done
	echo '1..0 # skip no python3 with numpy'
	return 1
}

# answered FOLDER: the words behind each "Answered" in its QUESTIONS.md stand in the document that is named there.
answered() {
	python3 - "$1/QUESTIONS.md" <<'PY'
import re, sys
text = open(sys.argv[1], encoding="utf-8").read()
answers = re.findall(r"\*Answered\* ([\w/]+\.md): ([^\n]+(?:\n   (?!\*)[^\n]+)*)", text)
assert len(answers) == len(re.findall(r"^\d+\. ", text, re.M)) > 5, len(answers)
for document, words in answers:
	held = " ".join(open("reference/" + document, encoding="utf-8").read().split())
	assert " ".join(words.split()) in held, f"{document}: {words}"
PY
	verdict $? "$1: each question has its answer"
}
