#!/usr/bin/env python3
"""Makes the truth of a recording of your own from doors that were measured once, for explore-eval.

    label_doors.py DOORS.json RUN LOG.truth.json

RUN is a folder that explore-mrpt left of that recording: its frames.jsonl tells times and poses. DOORS.json tells where the
doors are in the map, and camera and mount as explore-rawlog info prints them (doc/labelling.md has an example). In each frame a
door is "visible" where both jambs, half of their height and half of the opening are in the image and within 5 m; else it is
"ignored". What stands in front of it is not known here: name such frames in the door's "ignore", [[first, last], ...].
"""
import json
import math
import sys

ROBOT = {"kind": "ground", "radius": 0.22, "height": 0.6, "max_speed": 0.5, "max_acceleration": 0.5, "max_yaw_rate": 1.0,
         "min_altitude": 0.5, "max_altitude": 2.0}
RANGE = 5.0


def rotation(pose):
    """Rows of the matrix of yaw about z, then pitch about y, then roll about x."""
    (cy, sy), (cp, sp), (cr, sr) = ((math.cos(pose[a]), math.sin(pose[a])) for a in ("yaw", "pitch", "roll"))
    return ((cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
            (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
            (-sp, cp * sr, cp * cr))


def into(pose, point):
    """A point of the frame in which the pose is told, as the pose's own frame has it."""
    difference = (point[0] - pose["x"], point[1] - pose["y"], point[2] - pose["z"])
    return [sum(row[i] * d for row, d in zip(rotation(pose), difference)) for i in range(3)]


def in_image(camera, point):
    if point[0] < 0.05:
        return False
    u = camera["cx"] - camera["fx"] * point[1] / point[0]
    v = camera["cy"] - camera["fy"] * point[2] / point[0]
    return 0 <= u <= camera["width"] - 1 and 0 <= v <= camera["height"] - 1


def share(flags):
    return sum(flags) / len(flags)


def truth_of_door(door, head, frame):
    """None behind the camera."""
    def seen(along, z):  # metres to the left of the opening's middle, metres above the floor
        place = (x - along * normal[1], y + along * normal[0], floor + z)
        return into(head["robot_from_camera"], into(frame["pose"], place))

    x, y, floor = (door["at"] + [0.0])[:3]
    normal = (math.cos(door["yaw"]), math.sin(door["yaw"]))
    if normal[0] * (frame["pose"]["x"] - x) + normal[1] * (frame["pose"]["y"] - y) < 0:
        normal = (-normal[0], -normal[1])
    half, height, verdict = door["width"] / 2, door.get("height"), door.get("verdict", "open")
    top = min(2.0, height or 2.0)
    rows = [(i + 0.5) / 20 for i in range(20)]
    inside = lambda along, z: in_image(head["camera"], seen(along, z))
    if seen(0.0, 1.0)[0] < 0.05:
        return None
    # Seen by the camera, which looks against the normal, the left jamb is the one to the normal's right.
    jambs = [share([inside(side * half, top * r) for r in rows]) for side in (-1, 1)]
    opening = share([inside((2 * c - 1) * half, top * r) for r in rows for c in rows])
    near = all(math.hypot(*seen(side * half, 1.0)[:2]) <= RANGE for side in (-1, 1))
    ignored = any(first <= frame["frame"] <= last for first, last in door.get("ignore", []))
    clear = door.get("clear_width", 0.0 if verdict in ("closed", "blocked") else door["width"])
    fits = clear >= 2 * head["robot"]["radius"] + 0.10 and (height is None or height >= head["robot"]["height"] + 0.05)
    return {"id": door["id"], "center": [x, y, floor + (height or 2.0) / 2], "normal": [*normal, 0.0], "width": door["width"],
            "height": height, "clear_width": clear, "verdict": verdict,
            "passable": fits and verdict in ("open", "ajar", "passage"),
            "visibility": "visible" if near and not ignored and min(opening, *jambs) >= 0.5 else "ignored",
            "visible_share": opening, "jamb_share": jambs, "lintel_in_view": height is not None and inside(0.0, height)}


def main(doors_path, run, truth_path):
    with open(doors_path) as file:
        head = json.load(file)
    doors = head.pop("doors")
    head = {"schema": 1, "world": "", "family": "", "configuration": "", "negative": False, "robot": ROBOT, "noise": "real",
            "seed": 0, "command": "doc/examples/label_doors.py", **head, "frames": []}
    with open(run + "/frames.jsonl") as file:
        for frame in map(json.loads, file):
            seen = [truth for truth in (truth_of_door(door, head, frame) for door in doors) if truth]
            pose = {name: frame["pose"][name] for name in ("x", "y", "z", "yaw", "pitch", "roll")}
            head["frames"].append({"index": frame["frame"], "t": frame["t"], "scene": 0, "map_from_robot": pose, "doors": seen,
                                   "corridor": {"state": "not_scored", "direction": [1, 0, 0], "width": 0}, "obstacles": [],
                                   "free_paths": None})
    with open(truth_path, "w") as file:
        json.dump(head, file)
    visible = sum(door["visibility"] == "visible" for frame in head["frames"] for door in frame["doors"])
    print(f"{len(head['frames'])} frames, {len(doors)} doors, visible {visible} times")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
