#!/usr/bin/env python3
"""A robot without a body: takes the explorer's commands, moves a pose by them, and tells it where it is.

robot_client.py COMMAND_PORT [LISTEN_PORT]   ends after 2 s of silence, and prints what it was told
"""
import json, math, socket, sys, time

commands = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
commands.bind(("127.0.0.1", int(sys.argv[1])))
explorer = ("127.0.0.1", int(sys.argv[2])) if len(sys.argv) > 2 else None
x = y = yaw = distance = turned = 0.0
count, frame_t, last = 0, None, {"stop": True}
commands.settimeout(30.0)  # the explorer may take its time to start
while True:
    try:
        last = json.loads(commands.recv(2048))
    except socket.timeout:  # a robot's own watchdog: stop the motors after 0.2 s of silence
        break
    commands.settimeout(2.0)
    now, count = time.monotonic(), count + 1
    if last["t"] is None:  # the explorer waits for its first frame
        continue
    if frame_t is None:
        t = last["t"]
    if last["t"] != frame_t:
        frame_t, since = last["t"], now
    dt, t = max(0.0, frame_t + now - since - t), frame_t + now - since  # a real robot asks its clock
    v, yaw_rate = last["v"][0], last["yaw_rate"]  # here: set the motors
    yaw, turned, distance = yaw + yaw_rate * dt, turned + abs(yaw_rate) * dt, distance + v * dt
    x, y = x + v * math.cos(yaw) * dt, y + v * math.sin(yaw) * dt
    if explorer:
        pose = {"t": t, "x": x, "y": y, "z": 0, "yaw": yaw, "pitch": 0, "roll": 0}
        commands.sendto(json.dumps({"pose": pose}).encode(), explorer)
print(f"{count} commands, {distance:.2f} m, {turned:.2f} rad, the last one {'stop' if last['stop'] else 'move'}")
