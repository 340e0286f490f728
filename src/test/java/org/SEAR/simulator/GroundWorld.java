// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.Pose;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.physics.Body;
import org.SEAR.physics.PhysicsWorld;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.start.StartPoses;
import org.SEAR.physics.solid.MassProperties;
import org.SEAR.physics.solid.Solid;
import org.SEAR.physics.solid.Solids;
import org.SEAR.project.ObjectPose;
import org.SEAR.project.Project;
import org.SEAR.robot.RobotBuilder;
import org.SEAR.robot.RobotModel;
import org.SEAR.robot.RobotTruth;
import org.SEAR.robot.VirtualWalls;
import org.SEAR.robot.surface.SurfaceColors;
import org.SEAR.sensors.Earth;

/** A world on ground that no object of the grammar describes. */
public final class GroundWorld {
    public final PhysicsWorld physics = new PhysicsWorld();
    final RaycastScenes scenes = new RaycastScenes(false);
    public final List<String> warnings = new ArrayList<>();
    public final List<Body> bodies = new ArrayList<>();
    public RobotModel robot;
    private long steps;

    public GroundWorld(Solid ground, Project project, Shape... things) throws Exception {
        Body body = new Body("ground", MassProperties.FIXED, Collections.singletonList(ground),
            new Pose[] {Pose.IDENTITY}, Pose.IDENTITY);
        physics.add(body);
        body.addTo(scenes, Collections.singletonList(true), -1, 1);
        scenes.addGround(body);
        for (Shape thing : things) {
            Solid solid = Solids.of(thing, project, new ArrayList<>());
            Body one = new Body(thing.getName(), solid.perKilogram().withMass(thing.getMass()),
                Collections.singletonList(solid), new Pose[] {solid.offset}, ObjectPose.of(thing));
            physics.add(one);
            one.addTo(scenes, Collections.singletonList(true), -1, 1);
            bodies.add(one);
        }
        for (SEARrobot object : project.getRobots()) {
            RobotBuilder builder = RobotBuilder.of(object, project, warnings);
            physics.add(builder.body);
            builder.addTo(scenes, 0);
            robot = new RobotModel(builder, 0, scenes,
                new RobotTruth(builder, scenes, new SurfaceColors(project.getAssets(), warnings::add), 0,
                    Earth.of(project, object), 0, WorkerPool.ALONE),
                new VirtualWalls(scenes), warnings::add);
        }
        StartPoses.moveOut(physics.getBodies(), scenes.grounds(), warnings);
        physics.restart();
        body.mirror(scenes);
        bodies.forEach(one -> one.mirror(scenes));
        if (robot != null) {
            robot.restart(physics, 1);
            robot.mirror();
        }
        scenes.commit();
    }

    public void run(double seconds) {
        for (long end = steps + Math.round(seconds / Simulation.STEP); steps < end; steps++) {
            if (robot != null) {
                robot.prepare();
            }
            physics.step();
            bodies.forEach(body -> body.mirror(scenes));
            if (robot != null) {
                robot.follow(physics.isAwake(robot.getBody()));
                robot.truth().update(steps, true);
            }
            scenes.commit();
        }
    }
}
