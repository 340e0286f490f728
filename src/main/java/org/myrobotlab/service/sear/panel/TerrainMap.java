// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.io.IOException;
import java.util.Collections;
import java.util.Map;
import java.util.zip.CRC32;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Terrain;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.terrain.Ground;
import org.SEAR.terrain.TerrainColors;

/**
 * The ground of a project for panels, see {@link TerrainJson}. A world reports the stamp of its ground; a panel without
 * this ground requests it once. Caches the last one. Any thread.
 */
public final class TerrainMap {
    /** Approximate number of elevations in a stamp: enough to distinguish maps, cheap for each new world. */
    private static final int LOOKED_AT = 65_536;

    private Map<String, Object> last = Collections.emptyMap();

    /**
     * Returns a stamp of the ground, equal for equal elevations, location and colours; null for a project without
     * terrain.
     */
    static String stamp(Project project) throws ProjectException {
        Ground ground = project.getGround();
        if (ground == null) {
            return null;
        }
        Terrain terrain = terrain(project);
        CRC32 sum = new CRC32();
        float[] heights = ground.field.heights;
        for (int i = 0; i < heights.length; i += 1 + heights.length / LOOKED_AT) {
            int bits = Float.floatToIntBits(heights[i]);
            sum.update(bits);
            sum.update(bits >> 8);
            sum.update(bits >> 16);
            sum.update(bits >> 24);
        }
        String place = ground.origin == null ? "" : ground.origin.getLatitude() + " " + ground.origin.getLongitude();
        return String.format("%x-%x", sum.getValue(),
            (ground.field.rows + " " + ground.field.columns + " " + ground.field.lowX + " "
            + ground.field.lowZ + " " + place + " " + ground.altitude + " " + terrain.getImage() + " "
                + terrain.hasColor() + terrain.getColor())
            .hashCode());
    }

    private static Terrain terrain(Project project) {
        for (SearObject object : project.getEnvironment()) {
            if (object instanceof Terrain) {
                return (Terrain) object;
            }
        }
        throw new IllegalArgumentException("the project has no terrain");
    }

    /**
     * Returns the ground of a project.
     *
     * @return empty for a project without terrain
     * @throws ProjectException if the map can't be read
     * @throws IOException with the name of the map's picture, the problem and legal values
     */
    public synchronized Map<String, Object> of(Project project) throws ProjectException, IOException {
        String stamp = stamp(project);
        if (stamp == null) {
            return Collections.emptyMap();
        }
        if (!stamp.equals(last.get("stamp"))) {
            Ground ground = project.getGround();
            last = new TerrainJson(stamp, ground.field, ground.origin, ground.altitude, ground.spacing,
                TerrainColors.of(terrain(project), project.getAssets(), ground)).map();
        }
        return last;
    }
}
