#!/bin/bash
# What the recipes left open when they were tried has its answer in them.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/../ports/ports.bash"

answered tests/recipes
finish
