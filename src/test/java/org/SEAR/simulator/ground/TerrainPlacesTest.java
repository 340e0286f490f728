// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ground;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import javax.imageio.ImageIO;
import net.sf.geographiclib.Geodesic;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Terrain;
import org.SEAR.Slow;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.sensors.GpsFix;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** A world on a real map: objects stand at their latitude and longitude, and sensors know their place on Earth. */
@Category(Slow.class)
public class TerrainPlacesTest {
    private static final double SUMMIT_LATITUDE = 36.485;
    private static final double SUMMIT_LONGITUDE = -84.2308333;
    private static final double SUMMIT = 1076;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static Terrain around(double latitude, double longitude) {
        Terrain terrain = new Terrain("jacksboro", "terrain/jacksboro.tif");
        terrain.setArea(latitude, longitude, 1000, 1000);
        return terrain;
    }

    private static SEARrobot rover(GPS gps) {
        SEARrobot rover = Worlds.cart("rover", 20, 0.1, 0.25, new double[] {0.2, -0.2}, 0, 0, 0, 0);
        rover.addComponent(gps);
        return rover;
    }

    @Test
    public void aReceiverOnTheSummitReadsItsPlaceAndHeight() throws Exception {
        around(SUMMIT_LATITUDE + 0.001, SUMMIT_LONGITUDE + 0.001);
        rover(new GPS("gps")).place(SUMMIT_LATITUDE, SUMMIT_LONGITUDE, 30);
        try (Simulation simulation = Worlds.start(project)) {
            assertEquals(List.of(), simulation.snapshot().warnings);
            simulation.step();
            GpsFix fix = (GpsFix) simulation.read("gps");
            double miss = Geodesic.WGS84.Inverse(SUMMIT_LATITUDE, SUMMIT_LONGITUDE, fix.getLatitude(),
                fix.getLongitude()).s12;
            assertTrue(miss + " m", miss < 2);
            assertEquals(SUMMIT, fix.getAltitude(), 1);
        }
    }

    @Test
    public void boxesStandAtAllProbesHeights() throws Exception {
        Terrain terrain = new Terrain("jacksboro", "terrain/jacksboro.tif");
        JsonNode probes = new ObjectMapper().readTree(Paths.get(System.getProperty("sear.root", "."),
            "src/test/resources/org/SEAR/terrain/probes.json").toFile()).get("probes");
        assertEquals(24, probes.size());
        for (int i = 0; i < probes.size(); i++) {
            double latitude = probes.get(i).get("latitude").asDouble();
            double longitude = probes.get(i).get("longitude").asDouble();
            assertEquals(probes.get(i).get("elevation_wgs84_grid").asDouble(),
                terrain.getHeight(latitude, longitude), 0.5);
            new Box("box" + i, 0.01, 0.01, 0.01).place(latitude, longitude);
        }
        Project read = Project.read(project.folder());
        try (Simulation simulation = Simulation.of(read, 1)) {
            assertEquals(List.of(), simulation.snapshot().warnings);
            for (int i = 0; i < probes.size(); i++) {
                Pose pose = simulation.getPose("box" + i);
                GeoOrigin.GeoPoint place = read.getOrigin().at(pose.x, pose.y - 0.005, pose.z);
                assertEquals(probes.get(i).get("latitude").asDouble(), place.latitude, 1e-8);
                assertEquals(probes.get(i).get("longitude").asDouble(), place.longitude, 1e-8);
                assertEquals(probes.get(i).get("elevation_wgs84_grid").asDouble(), place.altitude, 0.5);
                assertEquals(pose.y - 0.005, simulation.getGroundHeight(pose.x, pose.z), 0.01);
            }
        }
        double[] point = read.getOrigin().to(SUMMIT_LATITUDE, SUMMIT_LONGITUDE);
        assertEquals("before the start, too", SUMMIT, read.getOrigin().getAltitude()
            + Simulation.groundHeight(read, point[0], point[1]), 0.5);
    }

    @Test
    public void filledGapsAreReported() throws Exception {
        project.put("assets/holes.asc", "ncols 3\nnrows 3\nxllcenter -84.2\nyllcenter 36.4\ncellsize "
            + "0.001\nNODATA_value -1\n5 5 5\n5 5 -1\n5 5 5\n");
        new Terrain("holes", "holes.asc");
        try (Simulation simulation = Worlds.start(project)) {
            String told = simulation.snapshot().warnings.toString();
            assertTrue(told, told.contains("holes.asc: ")
                && told.contains("of the area has no data: SEAR interpolates it"));
        }
    }

    @Test
    public void aReceiverWithOtherCoordinatesIsReported() throws Exception {
        around(SUMMIT_LATITUDE, SUMMIT_LONGITUDE);
        rover(new GPS("gps", 33.61, 182.5, -80.865)).placeAt(0, 0);
        try (Simulation simulation = Worlds.start(project)) {
            String told = simulation.snapshot().warnings.toString();
            assertTrue(told, told.contains("gps gps puts the world's origin at latitude 33.6100000, longitude "
                + "-80.8650000, altitude 182.5 m, but"
                + " the terrain puts it at latitude 36.4850000, longitude -84.2308333, altitude 107"));
            simulation.step();
            assertEquals(33.61, ((GpsFix) simulation.read("gps")).getLatitude(), 1e-5);
        }
    }

    @Test
    public void compassesKnowTheTerrainsPlace() throws Exception {
        around(SUMMIT_LATITUDE, SUMMIT_LONGITUDE);
        SEARrobot rover = Worlds.cart("rover", 20, 0.1, 0.25, new double[] {0.2, -0.2}, 0, 0, 0, 0);
        rover.addComponent(new Compass("compass", true));
        rover.placeAt(0, 0, 0);
        try (Simulation simulation = Worlds.start(project)) {
            assertEquals(List.of(), simulation.snapshot().warnings);
            simulation.step();
            double declination = -(Double) simulation.read("compass").value();
            assertEquals("in Tennessee magnetic north lies five and a half degrees west", -5.5, declination, 0.6);
        }
    }

    @Test
    public void beyondTheAreaThereIsNothing() throws Exception {
        Terrain terrain = around(SUMMIT_LATITUDE, SUMMIT_LONGITUDE);
        String told = assertThrows(IllegalArgumentException.class, () -> terrain.getHeight(36.5, SUMMIT_LONGITUDE))
            .getMessage();
        assertTrue(told, told.startsWith("Terrain \"jacksboro\" has no ground at latitude 36.5, longitude -84.2308333, "
            + "legal: latitude 36.480"));
        new Box("box", 1, 1, 1).place(36.5, SUMMIT_LONGITUDE);
        String problem = assertThrows(ProjectException.class, () -> Worlds.start(project)).getMessage();
        assertTrue(problem, problem.contains("environment/box.xml: placeLatitude, placeLongitude is \"36.5, "
            + "-84.2308333 (1665 m north and 0 m east of the origin)\", legal: a place with ground"));
    }

    @Test
    public void aPictureHasNoPlaceOnEarth() throws Exception {
        BufferedImage grey = new BufferedImage(20, 20, BufferedImage.TYPE_BYTE_GRAY);
        Path file = Files.createDirectories(project.folder().resolve("assets")).resolve("hills.png");
        ImageIO.write(grey, "png", file.toFile());
        Terrain terrain = new Terrain("hills", "hills.png");
        terrain.setSize(100, 100, 0, 5);
        assertThrows(IllegalArgumentException.class, () -> terrain.getHeight(36.5, SUMMIT_LONGITUDE));
        new Box("box", 1, 1, 1).placeAt(3, 4);
        try (Simulation simulation = Worlds.start(project)) {
            assertEquals(3, simulation.getPose("box").x, 0);
        }
        new Box("box", 1, 1, 1).place(36.5, SUMMIT_LONGITUDE);
        assertThrows(ProjectException.class, () -> Worlds.start(project));
        rover(new GPS("gps"));
        String problem = assertThrows(ProjectException.class, () -> Worlds.start(project)).getMessage();
        assertTrue(problem, problem.contains("GPS \"gps\" has no latitude, altitude and longitude"));
    }

    @Test
    public void aFileThatIsNotAMapIsReported() throws Exception {
        project.put("assets/letter.tif", "Dear reader");
        Terrain terrain = new Terrain("letter", "letter.tif");
        assertFalse(terrain.hasArea());
        String problem = assertThrows(ProjectException.class, () -> Worlds.start(project)).getMessage();
        assertTrue(problem, problem.contains("environment/letter.xml:15: path is \"letter.tif\", legal: an elevation "
            + "map that can be used ("));
    }
}
