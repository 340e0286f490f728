// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ground;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Terrain;
import org.SEAR.Slow;
import org.SEAR.geometry.HeightTiles;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.sensors.LidarScan;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.SEAR.terrain.Ground;
import org.SEAR.terrain.WideMap;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Robots can drive on all of 10812 x 10812 samples, three by three degrees at 1 arc second, in bounded memory. */
@Category(Slow.class)
public class WideTerrainTest {
    private static final int SIDE = 10812;
    /** More samples per side than fit in memory, 16 million in all. */
    private static final int LARGE = 4050;
    private static final int MEGABYTE = 1 << 20;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Terrain terrain(WideMap map) throws Exception {
        Path file = project.folder().resolve("assets/terrain/wide.tif");
        Files.createDirectories(file.getParent());
        map.write(file);
        return new Terrain("wide", "terrain/wide.tif");
    }

    private static long used() {
        System.gc();
        return (Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory()) / MEGABYTE;
    }

    private static SEARrobot rover(String name) {
        SEARrobot rover = Worlds.cart(name, 20, 0.1, 0.25, new double[] {0.2, -0.2}, 0, 0, 0, 0);
        rover.addComponent(new LIDAR(name + "Lidar", 80, 180, 0.5));
        return rover;
    }

    private static void drive(Simulation simulation) {
        simulation.step();
        simulation.post(world -> world.getRobots().forEach(robot -> robot.drive(0.5, Double.POSITIVE_INFINITY)));
        Worlds.run(simulation, 1);
    }

    private static Pose placed(Ground ground, int... place) {
        double[] at = ground.origin.to(WideMap.latitude(place[0]), WideMap.longitude(place[1]));
        return Pose.ofDegrees(at[0], 0, at[1], 0, 0, 0);
    }

    @Test
    public void robotsDriveInAllCornersOfIt() throws Exception {
        long before = used();
        WideMap map = new WideMap(SIDE);
        terrain(map);
        int[][] places = {{300, 300}, {300, 10500}, {10400, 400}, {10400, 10400}, {5400, 5410}};
        for (int i = 0; i < places.length; i++) {
            rover("rover" + i).place(WideMap.latitude(places[i][0]), WideMap.longitude(places[i][1]), 45);
        }
        Ground ground;
        Pose[] poses = new Pose[places.length];
        try (Simulation simulation = Worlds.start(project)) {
            ground = Project.read(project.folder()).getGround();
            HeightTiles tiles = (HeightTiles) ground.heights;
            assertTrue(tiles.rows + " x " + tiles.columns, tiles.rows > 10000 && tiles.columns > 10000);
            for (int[] place : places) {
                double height = ground.height(WideMap.latitude(place[0]), WideMap.longitude(place[1]));
                assertEquals(map.height(place[0], place[1]), height, 1e-6);
            }
            drive(simulation);
            for (int i = 0; i < places.length; i++) {
                Pose start = placed(ground, places[i]);
                Pose pose = Worlds.body(simulation, "rover" + i).getPose();
                assertEquals("rover" + i + " stands on the ground", tiles.height(pose.x, pose.z), pose.y, 0.35);
                double way = Math.hypot(pose.x - start.x, pose.z - start.z);
                assertTrue("rover" + i + " has gone " + way + " m", way > 0.3);
                assertEquals(361, ((LidarScan) simulation.read("rover" + i + "Lidar")).size());
            }
            assertTrue(tiles.held() <= HeightTiles.room());
            for (int i = 0; i < tiles.size(); i += 2) {
                tiles.tile(i).getPyramid();
            }
            assertEquals(HeightTiles.room(), tiles.held());
            long more = used() - before;
            assertTrue(more + " MB more than before", more < 400);
            Worlds.run(simulation, 1);
            for (int i = 0; i < places.length; i++) {
                poses[i] = Worlds.body(simulation, "rover" + i).getPose();
            }
        }
        try (Simulation again = Worlds.start(project)) {
            drive(again);
            Worlds.run(again, 1);
            for (int i = 0; i < places.length; i++) {
                Pose pose = Worlds.body(again, "rover" + i).getPose();
                assertEquals("the same bytes whichever tiles were held", poses[i].toString(), pose.toString());
            }
        }
        assertEquals(List.of(), ground.warnings);
    }

    @Test
    public void aProjectThatHoldsOneIsSharedAndOpened() throws Exception {
        WideMap map = new WideMap(LARGE);
        terrain(map);
        Ground ground = Project.read(project.folder()).getGround();
        assertTrue(ground.heights instanceof HeightTiles);
        Path bundle = project.getRoot().toPath().resolve("wide.sear");
        Bundle.save(project.folder(), bundle);
        Project other = Bundle.load(bundle, project.getRoot().toPath().resolve("other").resolve("SEARproject"));
        assertEquals(ground.heights.rows, other.getGround().heights.rows);
        assertEquals(ground.heights.height(40000.3, -50000.7), other.getGround().heights.height(40000.3, -50000.7), 0);
    }
}
