#!/usr/bin/env python3
"""A robot without a body: takes the explorer's commands, moves a pose by them, and tells it where it is.

robot_client.py COMMAND_PORT [LISTEN_PORT]   ends after 2 s of silence, and prints what it was told
"""
import json, math, socket, sys

commands = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
commands.bind(("127.0.0.1", int(sys.argv[1])))
explorer = ("127.0.0.1", int(sys.argv[2])) if len(sys.argv) > 2 else None
x = y = yaw = distance = 0.0
count, last_t, last = 0, None, {"stop": True}
timeout_s = 30.0  # the explorer may take its time to start
while True:
    commands.settimeout(timeout_s)
    try:
        last = json.loads(commands.recv(2048))
    except socket.timeout:  # a robot's own watchdog: stop the motors after 0.2 s of silence
        break
    count, timeout_s = count + 1, 2.0
    if last["t"] is None:  # the explorer waits for its first frame
        continue
    dt = 0.0 if last_t is None else last["t"] - last_t  # a real robot asks its clock
    last_t = last["t"]
    yaw += last["yaw_rate"] * dt  # here: set the motors to last["v"][0] and last["yaw_rate"]
    x, y = x + last["v"][0] * math.cos(yaw) * dt, y + last["v"][0] * math.sin(yaw) * dt
    distance += last["v"][0] * dt
    if explorer:
        pose = {"t": last_t, "x": x, "y": y, "z": 0, "yaw": yaw, "pitch": 0, "roll": 0}
        commands.sendto(json.dumps({"pose": pose}).encode(), explorer)
print(f"{count} commands, {distance:.2f} m, the last one {'stop' if last['stop'] else 'move'}")
