#!/bin/sh
# Kills an exploration of the corridor world at ten random moments, goes on each time, and compares what it leaves with a
# run that was never killed.
#   kill_and_resume.sh EXPLORE_MRPT [SEED [MAX_FRAMES]]
set -eu
program=$1 seed=${2:-1} frames=${3:-1200}
folder=$(mktemp -d)
begin="--ini corridor.ini --world corridor.sdf --seed $seed --max-frames $frames --quiet"

# shellcheck disable=SC2086
"$program" $begin --out "$folder/whole"
seconds=$(awk -F, 'NR > 1 { ms += $NF } END { print ms / 1000 }' "$folder/whole/timing.csv")
moments=$(awk -v seed="$seed" -v s="$seconds" 'BEGIN { srand(seed); for (i = 0; i < 10; i++) print 0.3 + rand() * s / 8 }')

next="$begin --out $folder/killed"
kills=0
for moment in $moments
do
	# shellcheck disable=SC2086
	"$program" $next &
	process=$!
	sleep "$moment"
	kill -9 "$process" 2> /dev/null || break
	wait "$process" 2> /dev/null || true
	kills=$((kills + 1))
	[ -e "$folder/killed/state/checkpoint" ] || continue
	next="--resume $folder/killed --quiet"
	lines=$(wc -l < "$folder/killed/frames.jsonl")
	age=$(stat -c %Y "$folder/killed/state/checkpoint")
	echo "killed after $moment s of this part, $lines frames written; state $(($(date +%s) - age)) s old"
done
# shellcheck disable=SC2086
"$program" $next

for file in frames.jsonl trajectory.tum truth.tum map.ot map.bt map.pgm map.yaml scene.3Dscene
do
	cmp "$folder/whole/$file" "$folder/killed/$file"
done
for run in whole killed
do
	python3 -c 'import json, sys
summary = json.load(open(sys.argv[1]))
del summary["timing_ms"], summary["peak_rss_mb"], summary["processor"]
json.dump(summary, open(sys.argv[2], "w"), indent=1)' "$folder/$run/summary.json" "$folder/$run.json"
done
for run in whole killed
do
	# Without what the clock says: all before the element "run".
	sed -n '/id="run">/,$p' "$folder/$run/report.html" > "$folder/$run.html"
done
cmp "$folder/whole.html" "$folder/killed.html"
cmp "$folder/whole.json" "$folder/killed.json"
echo "$kills kills: everything is the same"
rm -r "$folder"
