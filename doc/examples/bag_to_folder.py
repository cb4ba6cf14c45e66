#!/usr/bin/env python3
"""Takes depth images and odometry out of a ROS 1 bag, for explore-rawlog import.

    bag_to_folder.py LOG.bag DEPTH_TOPIC FOLDER [ODOMETRY_TOPIC]

Makes FOLDER/depth.txt, FOLDER/depth/*.png (16 bit, millimetres), with a topic of nav_msgs/Odometry FOLDER/poses.tum, and
prints the command that makes the rawlog of them. Depth is 16UC1 or mono16 (millimetres) or 32FC1 (metres), its camera_info
beside it. Needs the Debian packages python3-rosbag, python3-sensor-msgs and python3-nav-msgs, and nothing else of ROS.
"""
import array
import math
import os
import struct
import sys
import zlib

import rosbag


def millimetres(image):
    """Big-endian 16-bit rows; 0 where nothing came back, or from too far."""
    floats = image.encoding == "32FC1"
    if not floats and image.encoding not in ("16UC1", "mono16"):
        sys.exit(f"{image.encoding}: depth of 16UC1, mono16 or 32FC1 is needed; republish compressed depth first")
    swaps = bool(image.is_bigendian) != (sys.byteorder == "big")
    for row in range(image.height):
        begin = row * image.step
        pixels = array.array("f" if floats else "H", image.data[begin:begin + image.width * (4 if floats else 2)])
        if swaps:
            pixels.byteswap()
        if floats:
            pixels = array.array("H", [round(1000 * z) if math.isfinite(z) and 0 < z < 65.5 else 0 for z in pixels])
        if sys.byteorder == "little":
            pixels.byteswap()
        yield pixels.tobytes()


def write_png(path, image):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", image.width, image.height, 16, 0, 0, 0, 0)
    rows = b"".join(b"\0" + row for row in millimetres(image))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 1)) +
                   chunk(b"IEND", b""))


def text_of(stamp):
    return f"{stamp.secs}.{stamp.nsecs:09d}"


def main(bag_path, depth_topic, folder, odometry_topic=None):
    info_topic = depth_topic.rsplit("/", 1)[0] + "/camera_info"
    os.makedirs(os.path.join(folder, "depth"))
    images, poses, info = [], [], None
    with rosbag.Bag(bag_path) as bag:
        for topic, message, _ in bag.read_messages([depth_topic, info_topic, odometry_topic]):
            time = text_of(message.header.stamp)
            if topic == depth_topic:
                name = f"depth/{time}.png"
                write_png(os.path.join(folder, name), message)
                images.append((message.header.stamp, f"{time} {name}\n"))
            elif topic == odometry_topic:
                p, q = message.pose.pose.position, message.pose.pose.orientation
                poses.append((message.header.stamp, f"{time} {p.x} {p.y} {p.z} {q.x} {q.y} {q.z} {q.w}\n"))
            else:
                info = message
    if not images or info is None:
        sys.exit(f"{bag_path}: holds no {depth_topic if info else info_topic}")
    if odometry_topic and not poses:
        sys.exit(f"{bag_path}: holds no {odometry_topic}")
    for name, lines in (("depth.txt", images), ("poses.tum", poses)):
        if lines:
            with open(os.path.join(folder, name), "w") as file:
                file.writelines(line for _, line in sorted(lines))  # by the time they were taken, not recorded
    if any(info.D):
        print("The lens distorts, which the import leaves out: rectify the images first.", file=sys.stderr)
    k = info.K
    print(f"explore-rawlog import --tum {folder} --depth-scale 0.001 --intrinsics {k[0]},{k[4]},{k[2]},{k[5]}" +
          (f" --poses {folder}/poses.tum" if poses else "") + " --pose X,Y,Z,YAW,PITCH,ROLL --out LOG.rawlog")


if len(sys.argv) not in (4, 5):
    sys.exit(__doc__)
main(*sys.argv[1:])
