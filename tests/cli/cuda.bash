# What the scripts on CUDA share. Sourced after tap.bash, from the root of the repository. The driver that needs no GPU
# (tests/backends/cuda) stands before the machine's own, if there is one;
# kernels once translated are kept from run to run.
without_driver=${LD_LIBRARY_PATH:-}
export LD_LIBRARY_PATH=${touchstone%/*}/cuda${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
. tests/cli/device.bash
