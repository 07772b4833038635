#!/usr/bin/env bash
# Every source file is as clang-format writes it.   usage: format.sh SOURCE_DIR
set -euo pipefail
cd "$1"
command -v clang-format >/dev/null || { echo "clang-format is not installed: nothing checked"; exit 0; }
mapfile -t files < <(git ls-files '*.cpp' '*.hpp')
((${#files[@]} > 20)) || { echo "only ${#files[@]} files found"; exit 1; }
clang-format --dry-run --Werror "${files[@]}"
