// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.project.Project;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;

/** The Earth as a robot's sensors know it: the world's origin on it, and its magnetic field. Immutable; any thread. */
public final class Earth {
    /** A file of this name in the project's assets replaces SEAR's coefficients. */
    public static final String MODEL_FILE = "WMM.COF";

    private final GeoOrigin origin;
    private final boolean ofTerrain;
    private final MagneticModel model;

    /** @param origin as in a GPS; null if unknown */
    public Earth(GeoOrigin origin, MagneticModel model) {
        this(origin, false, model);
    }

    /** @param ofTerrain whether the origin comes from the terrain's map */
    public Earth(GeoOrigin origin, boolean ofTerrain, MagneticModel model) {
        this.origin = origin;
        this.ofTerrain = ofTerrain;
        this.model = model;
    }

    /**
     * Returns the Earth of a robot. The origin comes from the terrain, otherwise from the robot's first GPS with an
     * origin, otherwise from any robot's first such GPS. The magnetic field comes from {@code assets/WMM.COF},
     * otherwise from the World Magnetic Model 2025.
     *
     * @throws ProjectException if {@code assets/WMM.COF} is unusable, or a GPS without coordinates has no terrain to
     *     take them from
     */
    public static Earth of(Project project, SEARrobot robot) throws ProjectException {
        MagneticModel model = model(project.asset(MODEL_FILE));
        GeoOrigin ground = project.getOrigin();
        if (ground != null) {
            return new Earth(ground, true, model);
        }
        List<SEARrobot> robots = new ArrayList<>(project.getRobots());
        robots.add(0, robot);
        GeoOrigin origin = null;
        for (SEARrobot each : robots) {
            for (SearObject part : each.getComponents()) {
                if (part instanceof GPS) {
                    GeoOrigin own = origin((GPS) part);
                    origin = origin == null ? own : origin;
                }
            }
        }
        return new Earth(origin, model);
    }

    private static GeoOrigin origin(GPS gps) throws ProjectException {
        if (!gps.hasReference()) {
            throw new ProjectException(Collections.singletonList(
                new Problem("robot/" + gps.getFileName() + ".xml", 0, "", gps
                + " has no latitude, altitude and longitude", "all three of them, or a Terrain whose map says where on "
                    + "Earth the world lies")));
        }
        return new GeoOrigin(gps.getLatitude(), gps.getAltitude(), gps.getLongitude());
    }

    private static MagneticModel model(Path file) throws ProjectException {
        if (!Files.exists(file)) {
            return MagneticModel.standard();
        }
        try {
            return MagneticModel.read(file);
        } catch (MagneticModel.FormatException e) {
            throw new ProjectException(Collections.singletonList(
                new Problem("assets/" + MODEL_FILE, e.getLine(), "", e.getMessage(), e.getLegal())));
        }
    }

    /** Returns whether the origin comes from the terrain's map; otherwise it comes from a GPS. */
    public boolean isOfTerrain() {
        return ofTerrain;
    }

    /** Returns the world's origin; null if neither terrain nor GPS defines it. */
    public GeoOrigin getOrigin() {
        return origin;
    }

    /** Returns the magnetic field model. */
    public MagneticModel getMagneticModel() {
        return model;
    }
}
