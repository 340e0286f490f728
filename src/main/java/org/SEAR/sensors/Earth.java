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
    private final MagneticModel model;

    /** @param origin null if nobody said where the world lies */
    public Earth(GeoOrigin origin, MagneticModel model) {
        this.origin = origin;
        this.model = model;
    }

    /**
     * The Earth of a robot: the origin is its own first GPS's, or else that of the first GPS of any robot; the magnetic field is that of
     * {@code assets/WMM.COF}, or else the World Magnetic Model 2025.
     *
     * @throws ProjectException if {@code assets/WMM.COF} is there but can't be used
     */
    public static Earth of(Project project, SEARrobot robot) throws ProjectException {
        List<SEARrobot> robots = new ArrayList<>(project.getRobots());
        robots.add(0, robot);
        GeoOrigin origin = null;
        for (SEARrobot each : robots) {
            for (SearObject part : each.getComponents()) {
                if (origin == null && part instanceof GPS) {
                    GPS gps = (GPS) part;
                    origin = new GeoOrigin(gps.getLatitude(), gps.getAltitude(), gps.getLongitude());
                }
            }
        }
        return new Earth(origin, model(project.asset(MODEL_FILE)));
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

    /** Where the world's origin lies; null if no robot has a GPS that says so. */
    public GeoOrigin getOrigin() {
        return origin;
    }

    /** The magnetic field. */
    public MagneticModel getMagneticModel() {
        return model;
    }
}
