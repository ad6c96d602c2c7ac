#!/bin/bash
# The stages in the orders of reference/PORTING.md read and write the buffers that stand beside them.
. "$(dirname "$0")/../cli/tap.bash"
run list stages --json
/usr/bin/python3 tests/ports/orders.py "$scratch/stdout"
