#!/bin/sh
# run.sh BUILD SECONDS READER: throws mutated files at one reader and says how many.
set -eu
build=$1 seconds=$2 reader=$3
mkdir -p "$build/corpus/$reader"
if ! "$build/tests/fuzz/fuzz_$reader" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 \
    -dict="$build/words.dict" -print_final_stats=1 -artifact_prefix="$build/$reader-" \
    "$build/corpus/$reader" "tests/fuzz/corpus/$reader" > "$build/$reader.log" 2>&1; then
  tail -n 40 "$build/$reader.log"
  exit 1
fi
files=$(sed -n 's/^stat::number_of_executed_units: *//p' "$build/$reader.log")
echo "$reader: $files files in $seconds s, none got through"
