// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.BeamCone;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Sphere;
import org.SEAR.POJOs.Wheel;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/**
 * Setters and constructors reject illegal values: the message names object, value and legal range, and no file changes.
 */
public class DoorTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private final List<String> wrong = new ArrayList<>();
    private Box box;
    private SEARrobot robot;
    private LIDAR lidar;

    @Before
    public void haveObjects() {
        box = new Box("box", 1, 2, 3, 4);
        robot = new SEARrobot("robot");
        lidar = new LIDAR("lidar");
        robot.addComponent(lidar);
    }

    private void refused(Runnable action, String... parts) {
        try {
            Map<String, String> before = project.files();
            try {
                action.run();
                wrong.add("not refused: " + String.join(" ", parts));
            } catch (IllegalArgumentException e) {
                for (String part : parts) {
                    if (!e.getMessage().contains(part)) {
                        wrong.add("\"" + part + "\" is not in: " + e.getMessage());
                    }
                }
            }
            if (!before.equals(project.files())) {
                wrong.add("files changed: " + String.join(" ", parts));
            }
        } catch (IOException e) {
            fail(e.toString());
        }
    }

    @Test
    public void constructors() {
        refused(() -> new Box("b", 0, 1, 1, 1), "Box \"b\": length is 0, legal: a number from 0.0001 to 100000 m");
        refused(() -> new Box("b", 1, -1, Double.NaN, -2), "width is -1", "height is NaN",
            "mass is -2, legal: 0, or a number from 0.000001 to 1000000 kg");
        refused(() -> new Cylinder("c", Double.POSITIVE_INFINITY, 1, 1), "radius is Infinity");
        refused(() -> new Sphere("s", -1, 1), "radius is -1");
        refused(() -> new Cone("a/b", 1, 1, 1), "name is \"a/b\"", "can be a file name");
        refused(() -> new Cone(null, 1, 1, 1), "name is missing");
        refused(() -> new Floor("NUL", 1, 1), "name is \"NUL\"", "device name");
        refused(() -> new Floor(" f", 1, 1), "name is \" f\"", "blank at either end");
        refused(() -> new Floor("\ud800", 1, 1), "name is");
        refused(() -> new Box("BOX", 1, 1, 1, 0), "name is \"BOX\"", "more than capitals");
        refused(() -> new Model("m", null), "path is missing");
        refused(() -> new Model("m", "../x.obj"), "path is \"../x.obj\", legal: a file below assets");
        refused(() -> new Cylinder("c", 1, 1, 1, "C:\\x.png"), "image is \"C:\\x.png\"");
        refused(() -> new Wheel("w", 0.1, 0.1, 3), "Wheel \"w\": type is 3, legal: 0, 1, 2");
        refused(() -> new Dynamics("d", 0), "mass is 0, legal: a number from 0.001");
        refused(() -> new GPS("g", 91, 0, -181), "latitude is 91", "longitude is -181, legal: a number from "
            + "-180 to 180 deg");
        refused(() -> new Accelerometer("a", 0), "bandwidth is 0", "Hz");
        refused(() -> new LIDAR("l", 8, 90, 100), "resolution is 100, legal: at most the spread, 90 deg");
        refused(() -> new LIDAR("l", 8, 360, 0.0001), "resolution is 0.0001");
        refused(() -> new Distance("d", "PONG"), "Distance \"d\": beam is \"PONG\", legal: ", "PING)))");
        refused(() -> new Distance("d", List.of()), "cone is missing");
        refused(() -> new Distance("d", List.of(List.of(1))), "cone is [1]", "half-angle");
        refused(() -> new Distance("d", List.of(List.of(1, 2, "rot"))), "color is \"rot\", legal: a colour: #rrggbb, "
            + "or black, silver");
        refused(() -> new BeamCone(10, 1, "#000000", 361), "lines is 361, legal: a whole number from 1 to 360");
        refused(() -> new Noise(-1), "white is -1");
        assertEquals(List.of(), wrong);
    }

    @Test
    public void changes() {
        Compass compass = new Compass("c");
        refused(() -> box.move(0, Double.NaN, 0), "Box \"box\": y is NaN");
        refused(() -> box.rotate(0, 0, 1e9), "rz is 1000000000, legal: a number from -36000 to 36000 deg");
        refused(() -> box.scale(0), "scaleX is 0");
        refused(() -> box.setMass(-1), "mass is -1");
        refused(() -> box.setImage(""), "image is \"\"");
        refused(() -> box.setColor("reddish"), "Box \"box\": color is \"reddish\", legal: a colour: #rrggbb, or "
            + "black, silver,", ", orange, brown");
        refused(() -> box.setColor("#12345"), "Box \"box\": color is \"#12345\"");
        Floor floor = new Floor("f", 1, 1);
        refused(() -> floor.setImageSize(0), "Floor \"f\": imageSize is 0, legal: a number from 0.01 to 100000 m");
        refused(() -> box.setColor(""), "Box \"box\": color is \"\"");
        refused(() -> lidar.setRange(0), "LIDAR \"lidar\": range is 0");
        refused(() -> lidar.setBaud(1), "baud is 1, legal: a whole number from 300 to 100000000 baud");
        refused(() -> lidar.setPorts("a", "a"), "ports are \"a\" and \"a\", legal: two different names");
        refused(() -> lidar.setPorts(null, "a"), "legal: two different names");
        refused(() -> lidar.LMS(2), "lms is 2, legal: 0, 1");
        refused(() -> lidar.setModel("LMS400"), "LIDAR \"lidar\": model is \"LMS400\", legal: LMS200, LMS221, LMS291, "
            + "LMS111, TiM561, URG-04LX,", " UTM-30LX, RPLIDAR-A1");
        LIDAR wide = new LIDAR("wide", 10, 270, 0.3);
        refused(() -> wide.setPorts("a", "b"), "none has spread 270 with resolution 0.3 deg, legal: 100 with 1, 0.5 or "
            + "0.25; 180 with 1 or 0.5;", "without setPorts every fan", "; setModel has it with RPLIDAR-A1");
        wide.LMS(0);
        wide.setPorts("a", "b");
        refused(() -> wide.LMS(1), "LIDAR \"wide\": at a port there is an LMS200");
        refused(() -> compass.setNorth(0, 1, 0), "north is (0, 1, 0)");
        assertEquals(List.of(), wrong);
    }

    @Test
    public void parts() {
        SEARrobot other = new SEARrobot("other");
        Wheel wheel = new Wheel("wheel", 0.1, 0.1);
        Model terrain = new Model("hill", "models/Tree/Tree.mesh.xml");
        terrain.setTerrain(true);
        Floor floor = new Floor("floor", 1, 1);
        Box twin = new Box("LIDAR", 1, 1, 1, 1);
        robot.addComponent(new Dynamics("first", 1));
        Dynamics second = new Dynamics("second", 1);
        refused(() -> robot.addComponent(lidar), "LIDAR \"lidar\" is already a part of SEARrobot \"robot\"");
        refused(() -> other.addComponent(lidar), "is already a part of SEARrobot \"robot\"");
        refused(() -> robot.addComponent(wheel), "is a wheel, legal: robot.addWheel(wheel)");
        refused(() -> robot.addComponent(other), "can't be a component");
        refused(() -> robot.addComponent(null), "a component is null");
        refused(() -> robot.addComponent(terrain), "is the terrain");
        refused(() -> robot.addComponent(floor), "can't be a component");
        refused(() -> robot.addComponent(twin), "has the name of another part");
        refused(() -> robot.addComponent(second), "second Dynamics");
        robot.addWheel(wheel);
        refused(() -> robot.addWheel(wheel), "is already a part");
        refused(() -> robot.addWheel(null), "a wheel is null");
        assertEquals(List.of(), wrong);
    }

    @Test
    public void readObjectsAreImmutable() throws Exception {
        Box read = (Box) Project.read(project.folder()).getEnvironment().get(0);
        try {
            read.move(1, 2, 3);
            fail("was moved");
        } catch (IllegalStateException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("was read from a project and can't be changed"));
        }
        assertEquals(0, read.getX(), 0);
    }

    @Test
    public void aFileThatCantBeWrittenIsAClearError() throws Exception {
        Files.write(project.getRoot().toPath().resolve("blocked"), new byte[0]);
        System.setProperty("sear.project", project.getRoot().toPath().resolve("blocked").toString());
        try {
            new Box("b", 1, 1, 1, 1);
            fail("was written");
        } catch (UncheckedIOException e) {
            assertTrue(e.getMessage(), e.getMessage().startsWith("Box \"b\" could not be written"));
        }
    }
}
