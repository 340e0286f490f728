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

/** What a robot's sensors know of the Earth: where the world lies on it, and its magnetic field. Immutable, any thread. */
public final class Earth {
    /** A file of this name in the project's assets replaces the coefficients that come with SEAR. */
    public static final String MODEL_FILE = "WMM.COF";

    private final GeoOrigin origin;
    private final boolean ofTerrain;
    private final MagneticModel model;

    /** @param origin as a GPS has it; null if nobody said where the world lies */
    public Earth(GeoOrigin origin, MagneticModel model) {
        this(origin, false, model);
    }

    /** @param ofTerrain whether the origin is what the terrain's map says */
    public Earth(GeoOrigin origin, boolean ofTerrain, MagneticModel model) {
        this.origin = origin;
        this.ofTerrain = ofTerrain;
        this.model = model;
    }

    /**
     * The Earth of a robot: the origin is that of the terrain, or else that of its own first GPS which says one, or else of the first such GPS of
     * any robot; the magnetic field is that of {@code assets/WMM.COF}, or else the World Magnetic Model 2025.
     *
     * @throws ProjectException if {@code assets/WMM.COF} is there but can't be used, or a GPS without coordinates has no terrain to take them from
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
            throw new ProjectException(Collections.singletonList(new Problem("robot/" + gps.getFileName() + ".xml", 0, "", gps
                + " has no latitude, altitude and longitude", "all three of them, or a Terrain whose map says where on Earth the world lies")));
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
            throw new ProjectException(Collections.singletonList(new Problem("assets/" + MODEL_FILE, e.getLine(), "", e.getMessage(), e.getLegal())));
        }
    }

    /** Whether the origin is what the terrain's map says; else a GPS says it. */
    public boolean isOfTerrain() {
        return ofTerrain;
    }

    /** Where the world's origin lies; null if neither terrain nor GPS says so. */
    public GeoOrigin getOrigin() {
        return origin;
    }

    /** The magnetic field. */
    public MagneticModel getMagneticModel() {
        return model;
    }
}
