// SPDX-License-Identifier: Apache-2.0
package org.SEAR.scene;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.BrownLens;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.Project;

/**
 * Field of view of a camera as drawn: the edge of its picture at some distance, and lines from the camera to its
 * corners. Any thread.
 */
public final class ViewCone {
    /** Colour of the lines, 0xrrggbb. */
    public static final int COLOR = 0x2e9bd6;
    /** Number of corners of a picture. */
    public static final int CORNERS = 4;
    /** Points per side; lens distortion may bend a side. */
    public static final int SIDE = 8;
    /** Distance at which the edge is drawn, metres, limited by the camera's far plane. */
    private static final double REACH = 1.5;

    public final Camera camera;
    public final String sensor;
    /** Number of the robot that carries the camera. */
    public final int robot;
    /** Number of the camera among the robot's components. */
    public final int part;
    /** Pose of the camera in the robot's body frame, unless a servo turns it. */
    public final Pose mount;
    /** x, y, z of the edge's points, from the upper left corner on, {@link #SIDE} per side; camera frame, metres. */
    public final float[] edge;

    private ViewCone(Camera camera, int robot, int part) {
        this.camera = camera;
        sensor = camera.getFullName();
        this.robot = robot;
        this.part = part;
        mount = ObjectPose.of(camera);
        edge = edge(camera);
    }

    /** Returns the cones in the order of the robots and their components. */
    public static List<ViewCone> of(Project project) {
        List<ViewCone> cones = new ArrayList<>();
        List<SEARrobot> robots = project.getRobots();
        for (int robot = 0; robot < robots.size(); robot++) {
            List<SearObject> parts = robots.get(robot).getComponents();
            for (int i = 0; i < parts.size(); i++) {
                if (parts.get(i) instanceof Camera) {
                    cones.add(new ViewCone((Camera) parts.get(i), robot, i));
                }
            }
        }
        return cones;
    }

    /** Returns the edge of a camera's picture, see {@link #edge}. */
    private static float[] edge(Camera camera) {
        double reach = Math.min(REACH, camera.getFar());
        double right = camera.getWidth() - 1.0;
        double bottom = camera.getHeight() - 1.0;
        double[][] corners = {{-0.5, -0.5}, {right + 0.5, -0.5}, {right + 0.5, bottom + 0.5}, {-0.5, bottom + 0.5}};
        float[] edge = new float[3 * CORNERS * SIDE];
        BrownLens lens = camera.getLens();
        double[] point = new double[2];
        for (int side = 0; side < CORNERS; side++) {
            double[] from = corners[side];
            double[] to = corners[(side + 1) % CORNERS];
            for (int i = 0; i < SIDE; i++) {
                double share = (double) i / SIDE;
                double column = from[0] + share * (to[0] - from[0]);
                double row = from[1] + share * (to[1] - from[1]);
                // a strong distortion may not extend half a pixel outside: use the pixel's centre
                if (!lens.point(column, row, point)) {
                    lens.point(Math.max(0, Math.min(right, column)), Math.max(0, Math.min(bottom, row)), point);
                }
                int at = 3 * (side * SIDE + i);
                edge[at] = (float) (-point[0] * reach);
                edge[at + 1] = (float) (-point[1] * reach);
                edge[at + 2] = (float) reach;
            }
        }
        return edge;
    }
}
