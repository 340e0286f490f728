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
 * The ground of a project for panels, as {@link TerrainJson} has it. A world tells the stamp of its ground; a panel that has no ground of that stamp
 * asks for it, once. The last one is kept for further panels. Any thread.
 */
public final class TerrainMap {
    /** Heights that a stamp looks at, more or less: enough to tell maps apart, few enough for each new world. */
    private static final int LOOKED_AT = 65_536;

    private Map<String, Object> last = Collections.emptyMap();

    /** What a panel knows a ground by: the same for the same heights, place and colours; null for a project without a terrain. */
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
        return String.format("%x-%x", sum.getValue(), (ground.field.rows + " " + ground.field.columns + " " + ground.field.lowX + " "
            + ground.field.lowZ + " " + place + " " + ground.altitude + " " + terrain.getImage() + " " + terrain.hasColor() + terrain.getColor())
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
     * The ground of a project.
     *
     * @return empty for a project without a terrain
     * @throws ProjectException if its map can't be read
     * @throws IOException that names the picture over it, what is wrong with it and what is legal
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
