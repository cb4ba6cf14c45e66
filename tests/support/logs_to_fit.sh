#!/usr/bin/env bash
# logs_to_fit.sh BUILD OUT: the logs that the openings' trees were fitted to (doc/method.md), in folders of OUT. Takes hours
# of one core; what is there already is not made again.
set -euo pipefail
programs=$1 out=$2
rawlog=$programs/apps/explore-rawlog/explore-rawlog support=$programs/tests/support

scenes()
{
	local name=$1 count=$2 seed=$3 noise=$4
	[ -e "$out/$name" ] || "$rawlog" synth --family all --count "$count" --seed "$seed" --noise "$noise" --out "$out/$name"
}

# A camera 0.3–1.2 m up, pitched by −8…8 degrees: one mount a building.
building()
{
	local set=$1 kind=$2 seed=$3 count=$4 noise=$5
	local folder=$out/$set world=$out/worlds/$kind-$seed mount height pitch
	[ ! -e "$folder/$kind-$seed-mav.truth.json" ] || return 0
	mkdir -p "$folder" "$world"
	"$support/make_building" --kind "$kind" --seed "$seed" --out "$world"
	mount="import random; r = random.Random('$kind$seed'); print('%.2f %.1f' % (r.uniform(.3, 1.2), r.uniform(-8, 8)))"
	read -r height pitch < <(python3 -c "$mount")
	"$support/sample_poses" --world "$world/building.sdf" --robot ground --camera "$height" --count "$count" \
		--seed "$seed" --out "$world/ground.tum"
	"$support/sample_poses" --world "$world/building.sdf" --robot mav --count "$count" --seed $((seed + 1)) --out "$world/mav.tum"
	"$rawlog" record --world "$world/building.sdf" --poses "$world/ground.tum" --robot ground --pose "0.1,0,$height,0,$pitch,0" \
		--noise "$noise" --no-color --seed "$seed" --out "$folder/$kind-$seed-ground.rawlog"
	"$rawlog" record --world "$world/building.sdf" --poses "$world/mav.tum" --robot mav \
		--noise "$noise" --no-color --seed "$seed" --out "$folder/$kind-$seed-mav.rawlog"
}

# buildings SET FIRST_SEED COUNT NOISE_OF_EVERY KIND...: every NOISE_OF_EVERY-th with speckle noise.
buildings()
{
	local set=$1 seed=$2 count=$3 every=$4 kind
	shift 4
	for kind in "$@"; do
		building "$set" "$kind" "$seed" "$count" "$([ $((seed % every)) = 0 ] && echo speckle || echo kinect)"
		seed=$((seed + 1))
	done
}

mkdir -p "$out"
scenes kinect-11 50 11 kinect
scenes kinect-21 40 21 kinect
scenes kinect-31 50 31 kinect
scenes speckle-12 30 12 speckle
scenes speckle-22 15 22 speckle
scenes speckle-32 40 32 speckle
kinds=(house office school hotel warehouse house)
buildings buildings-1 101 60 1000 house house office school hotel warehouse
buildings buildings-1 107 60 1 office house
buildings buildings-2 201 60 4 "${kinds[@]}" office school hotel house office school hotel warehouse house office
buildings buildings-3 301 40 4 "${kinds[@]}" "${kinds[@]}" "${kinds[@]}" "${kinds[@]}"
kinds[5]=office
buildings buildings-4 401 60 2 "${kinds[@]}" "${kinds[@]}" "${kinds[@]}"
