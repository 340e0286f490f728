// SPDX-License-Identifier: Apache-2.0
package org.SEAR.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.SEAR.POJOs.BeamCone;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.Project;
import org.SEAR.sensors.BeamPattern;

/** Creates the beams of a project's sensors for the window and the tab. Any thread. */
public final class BeamFans {
    private static final int DISTANCE_HIT = 0xff140d;
    private static final int LIDAR_HIT = 0xfff21a;
    private static final int LIDAR_BEAM = 0xff1f14;
    private static final float DISTANCE_RADIUS = 0.03f;
    private static final float LIDAR_RADIUS = 0.018f;
    private static final float BYTE = 255f;
    /** Maximum number of lines per sensor. More would be unreadable and slow without a graphics card. */
    private static final int MAX_LINES = 240;

    private BeamFans() {
    }

    /** Returns the fans in the order of the robots and their components. */
    public static List<BeamFan> of(Project project) {
        List<BeamFan> fans = new ArrayList<>();
        List<SEARrobot> robots = project.getRobots();
        for (int robot = 0; robot < robots.size(); robot++) {
            List<SearObject> parts = robots.get(robot).getComponents();
            for (int i = 0; i < parts.size(); i++) {
                if (parts.get(i) instanceof Distance) {
                    fans.add(cones((Distance) parts.get(i), robot, i));
                } else if (parts.get(i) instanceof LIDAR) {
                    fans.add(plane((LIDAR) parts.get(i), robot, i));
                }
            }
        }
        return fans;
    }

    private static BeamFan cones(Distance sensor, int robot, int part) {
        BeamPattern pattern = BeamPattern.of(sensor.getCones());
        int count = pattern.size();
        float[] directions = new float[3 * count];
        float[] ranges = new float[count];
        float[] colors = new float[3 * count];
        for (int i = 0; i < count; i++) {
            directions[3 * i] = (float) pattern.getX(i);
            directions[3 * i + 1] = (float) pattern.getY(i);
            directions[3 * i + 2] = (float) pattern.getZ(i);
            ranges[i] = (float) pattern.getRange(i);
            paint(colors, i, pattern.getColor(i));
        }
        return new BeamFan(sensor.getFullName(), robot, part, ObjectPose.of(sensor), directions, ranges, colors,
            lines(sensor.getCones(), count), DISTANCE_HIT, DISTANCE_RADIUS, sensor.getCones());
    }

    private static BeamFan plane(LIDAR lidar, int robot, int part) {
        int count = lidar.getBeams();
        float[] directions = new float[3 * count];
        float[] ranges = new float[count];
        float[] colors = new float[3 * count];
        for (int i = 0; i < count; i++) {
            double angle = Math.toRadians(i * lidar.getResolution() - lidar.getSpread() / 2);
            directions[3 * i] = (float) Math.sin(angle);
            directions[3 * i + 2] = (float) Math.cos(angle);
            ranges[i] = (float) lidar.getRange();
            paint(colors, i, LIDAR_BEAM);
        }
        return new BeamFan(lidar.getFullName(), robot, part, ObjectPose.of(lidar), directions, ranges, colors,
            everyNth(count, stride(count)), LIDAR_HIT, LIDAR_RADIUS, List.of());
    }

    private static void paint(float[] colors, int beam, int color) {
        colors[3 * beam] = (color >> 16 & 0xff) / BYTE;
        colors[3 * beam + 1] = (color >> 8 & 0xff) / BYTE;
        colors[3 * beam + 2] = (color & 0xff) / BYTE;
    }

    private static int stride(int count) {
        return (count + MAX_LINES - 1) / MAX_LINES;
    }

    private static int[] everyNth(int count, int stride) {
        return IntStream.range(0, count).filter(beam -> beam % stride == 0).toArray();
    }

    /**
     * Chooses every n-th line of each cone. The start shifts by one line from cone to cone so that cones fill each
     * other's gaps.
     */
    private static int[] lines(List<BeamCone> cones, int count) {
        int stride = stride(count);
        IntStream.Builder chosen = IntStream.builder();
        int first = 0;
        for (int cone = 0; cone < cones.size(); cone++) {
            int size = cones.get(cone).getLines();
            for (int i = 0; i < size; i += stride) {
                chosen.add(first + (i + cone) % size);
            }
            first += size;
        }
        return chosen.build().toArray();
    }
}
