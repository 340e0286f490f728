// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.math.Quaternion;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.scene.BeamFan;
import org.SEAR.scene.Movement;
import org.SEAR.scene.ViewCone;
import org.SEAR.sensors.Reading;
import org.SEAR.simulator.Snapshot;

/** Scene of a project: objects, robots and beams at poses interpolated between steps. Window thread only. */
public final class WorldView {
    private static final float LABEL_HEIGHT = 0.12f;
    private final Node root = new Node("world");
    private final List<Node> environment = new ArrayList<>();
    private final List<Node> robots = new ArrayList<>();
    private final List<List<Node>> wheels = new ArrayList<>();
    /** Component nodes of each robot with servos or joints; empty for others. */
    private final List<List<Node>> parts = new ArrayList<>();
    private final List<List<Bulb>> lights = new ArrayList<>();
    private final List<BeamView> beams = new ArrayList<>();
    private final List<ConeView> cones = new ArrayList<>();
    private final Vector3f place = new Vector3f();
    private final Quaternion turn = new Quaternion();
    private boolean beamsShown = true;
    private final List<BeamView> hidden = new ArrayList<>();

    public WorldView(Project project, SceneBuilder builder, List<BeamFan> fans, Materials materials) {
        for (SearObject object : project.getEnvironment()) {
            environment.add(attach(root, builder.object(object)));
        }
        for (SEARrobot robot : project.getRobots()) {
            Node node = attach(root, builder.robot(robot));
            robots.add(node);
            parts.add(parts(robot, node));
            lights.add(lights(robot, node));
            List<Node> turning = new ArrayList<>();
            for (Wheel wheel : robot.getWheels()) {
                turning.add(attach(node, builder.object(wheel)));
            }
            wheels.add(turning);
        }
        for (BeamFan fan : fans) {
            BeamView view = new BeamView(fan, materials);
            robots.get(fan.robot).attachChild(view.node());
            beams.add(view);
        }
        for (ViewCone cone : ViewCone.of(project)) {
            ConeView view = new ConeView(cone, materials);
            robots.get(cone.robot).attachChild(view.node());
            cones.add(view);
        }
    }

    private static Node attach(Node parent, Node child) {
        parent.attachChild(child);
        return child;
    }

    /** Returns the component nodes. The builder attaches them in order. */
    private static List<Node> parts(SEARrobot robot, Node node) {
        List<Node> all = new ArrayList<>();
        if (robot.getComponents().stream().anyMatch(part -> part instanceof Servo || part instanceof Joint)) {
            node.getChildren().forEach(child -> all.add((Node) child));
        }
        return all;
    }

    private static List<Bulb> lights(SEARrobot robot, Node node) {
        List<Bulb> all = new ArrayList<>();
        for (int i = 0; i < robot.getComponents().size(); i++) {
            if (robot.getComponents().get(i) instanceof Led) {
                all.add(new Bulb((Led) robot.getComponents().get(i), (Geometry) ((Node) node.getChild(i)).getChild(0)));
            }
        }
        return all;
    }

    /** Light with its displayed colour. */
    private static final class Bulb {
        private final Led led;
        private final Geometry seen;
        private double brightness;

        Bulb(Led led, Geometry seen) {
            this.led = led;
            this.seen = seen;
        }

        void shine(double now) {
            if (now != brightness) {
                brightness = now;
                seen.getMaterial().setColor("Color", Materials.glow(led, now));
            }
        }
    }

    public Node root() {
        return root;
    }

    public Node robot(int index) {
        return robots.get(index);
    }

    public Node wheel(int robot, int wheel) {
        return wheels.get(robot).get(wheel);
    }

    public List<Node> robots() {
        return robots;
    }

    public List<Node> environment() {
        return environment;
    }

    public List<BeamView> beams() {
        return beams;
    }

    /** Returns the cones of the cameras. */
    public List<ConeView> cones() {
        return cones;
    }

    public List<String> cameras() {
        return cones.stream().map(view -> view.cone().sensor).collect(Collectors.toList());
    }

    /** Moves all nodes to their present poses. */
    public void update(Movement movement) {
        Snapshot shown = movement.shown();
        for (int i = 0; i < Math.min(environment.size(), shown.environment.size()); i++) {
            move(environment.get(i), movement.environment(i));
        }
        for (int i = 0; i < Math.min(robots.size(), shown.robots.size()); i++) {
            move(robots.get(i), movement.robot(i));
            for (int j = 0; j < Math.min(wheels.get(i).size(), shown.robots.get(i).wheels.size()); j++) {
                move(wheels.get(i).get(j), movement.wheel(i, j));
            }
            for (int j = 0; j < Math.min(lights.get(i).size(), shown.robots.get(i).lights.size()); j++) {
                lights.get(i).get(j).shine(shown.robots.get(i).lights.get(j));
            }
            for (int j = 0; j < parts.get(i).size(); j++) {
                move(parts.get(i).get(j), movement.part(i, j));
            }
        }
        for (BeamView beam : beams) {
            move(beam.node(), movement.part(beam.fan().robot, beam.fan().part));
            if (beam.isVisible()) {
                Reading reading = shown.readings.get(beam.fan().sensor);
                beam.update(reading == null ? null : reading.beams());
            }
        }
        for (ConeView view : cones) {
            move(view.node(), movement.part(view.cone().robot, view.cone().part));
        }
    }

    /**
     * Moves a node. Nodes at rest stay untouched, which saves jMonkeyEngine from recomputing their bounds.
     * @param pose null to leave the node in place
     */
    private void move(Node node, Pose pose) {
        if (pose == null) {
            return;
        }
        place.set((float) pose.x, (float) pose.y, (float) pose.z);
        turn.set((float) pose.qx, (float) pose.qy, (float) pose.qz, (float) pose.qw);
        if (!node.getLocalTranslation().equals(place)) {
            node.setLocalTranslation(place);
        }
        if (!node.getLocalRotation().equals(turn)) {
            node.setLocalRotation(turn);
        }
    }

    /** @param readings as text, by sensor name */
    public void label(Labels labels, Map<String, String> readings, Camera camera) {
        labels.begin();
        for (BeamView beam : beams) {
            String value = readings.get(beam.fan().sensor);
            Vector3f point = beam.node().localToWorld(new Vector3f(0, LABEL_HEIGHT, 0), null);
            labels.put(beam.fan().sensor, beam.isVisible() && value != null ? beam.fan().sensor + "  " + value : null,
                point, camera);
        }
    }

    public boolean areBeamsShown() {
        return beamsShown;
    }

    /** Shows or hides the beams of all sensors. Individually hidden beams stay hidden. */
    public void toggleBeams() {
        beamsShown = !beamsShown;
        show();
    }

    /**
     * Shows or hides one sensor's beams.
     * @return message for the user
     */
    public String toggleBeam(int number) {
        if (number < 0 || number >= beams.size()) {
            return "there is no beam sensor " + (number + 1) + "; there are " + beams.size();
        }
        BeamView beam = beams.get(number);
        if (!hidden.remove(beam)) {
            hidden.add(beam);
        }
        show();
        return beam.fan().sensor + (hidden.contains(beam) ? ": beams hidden" : ": beams shown");
    }

    private void show() {
        for (BeamView beam : beams) {
            beam.setVisible(beamsShown && !hidden.contains(beam));
        }
        cones.forEach(cone -> cone.setVisible(beamsShown));
    }

    public List<String> beamSensors() {
        return beams.stream().map(beam -> beam.fan().sensor).collect(Collectors.toList());
    }

    public List<String> hiddenSensors() {
        return beams.stream().filter(beam -> !beam.isVisible()).map(beam -> beam.fan().sensor)
            .collect(Collectors.toList());
    }
}
