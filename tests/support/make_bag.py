#!/usr/bin/env python3
"""Makes a ROS 1 bag as a robot with a depth camera leaves it: make_bag.py OUT.bag 16UC1|32FC1

The robot drives 0.3 m/s along the middle of a corridor of 2 m, from x = 0 on toward a wall at x = 6 m, for 2 s. Its camera
is 0.1 m ahead of its centre and 0.5 m above the floor; 10 images and 20 odometry messages a second.
"""
import array
import sys

import genpy
import rosbag
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import CameraInfo, Image
from tf2_msgs.msg import TFMessage

WIDTH, HEIGHT, FOCAL, CX, CY = 80, 60, 73.5, 39.5, 29.5
START = 1500000000


def depth_at(x, u, v):
    """Along the optical axis, in metres; the camera's x is forward, y left, z up."""
    y, z = (CX - u) / FOCAL, (CY - v) / FOCAL
    depths = [6.0 - (x + 0.1)]
    if y:
        depths.append(1.0 / abs(y))
    if z < 0:
        depths.append(-0.5 / z)
    return min(depths)


def image_at(x, encoding, header):
    depths = [depth_at(x, u, v) for v in range(HEIGHT) for u in range(WIDTH)]
    depths[0] = 0.0 if encoding == "16UC1" else float("nan")  # nothing came back
    if encoding == "16UC1":
        pixels = array.array("H", [round(1000 * depth) for depth in depths])
    else:
        pixels = array.array("f", depths)
    if sys.byteorder == "big":
        pixels.byteswap()
    return Image(header=header, height=HEIGHT, width=WIDTH, encoding=encoding, is_bigendian=0,
                 step=WIDTH * pixels.itemsize, data=pixels.tobytes())


def transform(stamp, parent, child, translation, rotation):
    message = TransformStamped()
    message.header.stamp, message.header.frame_id, message.child_frame_id = stamp, parent, child
    t, q = message.transform.translation, message.transform.rotation
    t.x, t.y, t.z = translation
    q.x, q.y, q.z, q.w = rotation
    return TFMessage(transforms=[message])


def main(path, encoding):
    with rosbag.Bag(path, "w") as bag:
        start = genpy.Time(START)
        # From the camera's optical axes (z forward, x right, y down) to the robot's.
        mount = transform(start, "base_link", "camera_optical", (0.1, 0, 0.5), (-0.5, 0.5, -0.5, 0.5))
        bag.write("/tf_static", mount, start)
        for tick in range(40):
            stamp = genpy.Time(START + tick // 20, 50000000 * (tick % 20))
            x = 0.3 * 0.05 * tick
            odometry = Odometry()
            odometry.header.stamp, odometry.header.frame_id = stamp, "odom"
            odometry.pose.pose.position.x, odometry.pose.pose.orientation.w = x, 1.0
            bag.write("/odom", odometry, stamp)
            bag.write("/tf", transform(stamp, "odom", "base_link", (x, 0, 0), (0, 0, 0, 1)), stamp)
            if tick % 2:
                continue
            image = image_at(x, encoding, odometry.header)
            image.header.frame_id = "camera_optical"
            info = CameraInfo(header=image.header, width=WIDTH, height=HEIGHT, distortion_model="plumb_bob",
                              D=[0.0] * 5, K=[FOCAL, 0, CX, 0, FOCAL, CY, 0, 0, 1])
            bag.write("/camera/depth/camera_info", info, stamp)
            bag.write("/camera/depth/image_raw", image, stamp)


main(*sys.argv[1:])
