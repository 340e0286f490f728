// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.record.RecordPictures;
import org.SEAR.sensors.CameraImage;
import org.SEAR.simulator.ProjectCheck;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.framework.Message;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.export.Exports;
import org.myrobotlab.service.sear.files.BundleTransfers;
import org.myrobotlab.service.sear.files.Edits;
import org.myrobotlab.service.sear.files.Projects;
import org.myrobotlab.service.sear.lockstep.Fence;
import org.myrobotlab.service.sear.lockstep.FencePass;
import org.myrobotlab.service.sear.netcam.CameraExports;
import org.myrobotlab.service.sear.panel.CameraPicture;
import org.myrobotlab.service.sear.panel.RecordMotion;
import org.myrobotlab.service.sear.panel.Preview;
import org.myrobotlab.service.sear.panel.TerrainMap;
import org.myrobotlab.service.sear.panel.WorldFeed;
import org.myrobotlab.service.sear.python3.Gateways;
import org.myrobotlab.service.sear.readings.Publisher;
import org.myrobotlab.service.sear.readings.ScriptActuators;
import org.myrobotlab.service.sear.readings.ScriptBodies;
import org.myrobotlab.service.sear.readings.ScriptCameras;
import org.myrobotlab.service.sear.readings.ScriptDriving;
import org.myrobotlab.service.sear.readings.ScriptReadings;
import org.myrobotlab.service.sear.records.RecordPictureCache;
import org.myrobotlab.service.sear.records.Plans;
import org.myrobotlab.service.sear.records.Plots;
import org.myrobotlab.service.sear.records.Recording;
import org.myrobotlab.service.sear.records.Records;
import org.myrobotlab.service.sear.run.RunSettings;
import org.myrobotlab.service.sear.run.SimulationControl;
import org.myrobotlab.service.sear.run.SimulationSession;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The parts of a SEAR service. They are separate so that the service class itself loads where a library is missing. */
final class SearParts {
    private static final Logger LOG = LoggerFactory.getLogger(SearParts.class);
    private static final String UART_CALLBACK = "onUartBytes";

    private final SimulationControl control;
    private final ScriptReadings readings;
    private final ScriptCameras cameras;
    private final ScriptDriving driving;
    private final ScriptActuators actuators;
    private final ScriptBodies bodies;
    private final Plans plans;
    private final Projects projects;
    private final Edits edits;
    private final Publisher publisher;
    private final Exports exports;
    private final CameraExports networkCameras;
    private final Gateways gateways = new Gateways();
    private final BundleTransfers transfers;
    private final Recording recording;
    private final Records records;
    private final RecordPictureCache kept = new RecordPictureCache();
    private final WorldFeed feed = new WorldFeed();
    private final Preview preview = new Preview();
    private final TerrainMap terrain = new TerrainMap();

    SearParts(Host host) {
        control = new SimulationControl(host, Projects::folder);
        readings = new ScriptReadings(control);
        cameras = new ScriptCameras(control);
        driving = new ScriptDriving(control);
        actuators = new ScriptActuators(control);
        bodies = new ScriptBodies(control);
        control.setActs(bodies);
        plans = new Plans(control);
        projects = new Projects(control, host);
        edits = new Edits();
        exports = new Exports(host, control);
        networkCameras = new CameraExports(host, cameras);
        transfers = new BundleTransfers(projects::write, projects::receive);
        recording = new Recording(control, host);
        records = new Records(host);
        control.scriptSession().open();
        Edits.mend(host::warn);
        publisher = new Publisher(host, control, readings, cameras);    // last: it starts a thread
        control.setStepListener(publisher::publishDue);
    }

    /**
     * Acknowledges a fence, which lock-step sends behind other messages and waits for.
     *
     * @return whether the message is a fence
     */
    public static boolean isFence(Message message) {
        boolean is = Fence.CALLBACK.equals(message.method) && message.data != null
            && message.data[0] instanceof FencePass;
        if (is) {
            FencePass.passed((FencePass) message.data[0]);
        }
        return is;
    }

    public SimulationControl control() {
        return control;
    }

    public ScriptReadings readings() {
        return readings;
    }

    public ScriptCameras cameras() {
        return cameras;
    }

    public ScriptDriving driving() {
        return driving;
    }

    public ScriptActuators actuators() {
        return actuators;
    }

    public Plans plans() {
        return plans;
    }

    public ScriptBodies bodies() {
        return bodies;
    }

    public Gateways gateways() {
        return gateways;
    }

    public Projects projects() {
        return projects;
    }

    public Edits edits() {
        return edits;
    }

    public Publisher publisher() {
        return publisher;
    }

    public Exports exports() {
        return exports;
    }

    public CameraExports networkCameras() {
        return networkCameras;
    }

    /** Returns the exports of ports and cameras: each name with the addresses that programs open. */
    public Map<String, List<String>> allExports() {
        Map<String, List<String>> all = new LinkedHashMap<>(exports.list());
        all.putAll(networkCameras.list());
        return all;
    }

    public BundleTransfers transfers() {
        return transfers;
    }

    public Recording recording() {
        return recording;
    }

    public Records records() {
        return records;
    }

    /** Returns the next state for panels, the whole world or its changes, see {@link WorldFeed}. */
    public Map<String, Object> nextState() throws InterruptedException {
        return control.look(feed::next, WorldFeed.nothing());
    }

    /** Returns the world's whole state, for a panel that opens later. */
    public Map<String, Object> wholeState() throws InterruptedException {
        return control.look(feed::whole, WorldFeed.nothing());
    }

    /**
     * Returns a camera's last picture in the form of {@link CameraPicture}; empty if no simulation with this camera
     * runs.
     */
    public Map<String, Object> cameraPicture(String name, int longest, int column, int row)
        throws InterruptedException {
        CameraImage image = cameras.look(name);
        if (image == null) {
            return Collections.emptyMap();
        }
        return CameraPicture.of(name, image, cameras.distance(name, image, column, row),
            new CameraPicture.Wish(longest, column, row));
    }

    /**
     * Returns the world as it would start, for panels; empty while a simulation runs.
     *
     * @param known stamp of the panels' preview
     */
    public Map<String, Object> preview(String known) {
        if (control.isRunning()) {
            return Collections.emptyMap();
        }
        return ProjectSwap.undisturbed(() -> preview.of(Projects.folder(), known));
    }

    /** Returns the poses of a record over time, see {@link Records#frames}. */
    public Map<String, Object> recordFrames(String path) throws InterruptedException, IOException {
        return records.frames(path, wording());
    }

    /** Returns rotations and sensor readings of a record, see {@link RecordMotion#of}. */
    public Map<String, Object> recordMotion(String path) throws IOException {
        return RecordMotion.of(path, Records.open(path), control.getFolder());
    }

    /** Returns a camera's picture from a record in the form of {@link CameraPicture}; empty if there is none. */
    public Map<String, Object> recordPicture(String path, String name, double time, int longest, int column, int row)
        throws IOException {
        RecordPictures pictures = kept.of(path);
        RecordPictures.Place place = pictures.at(name, time);
        return place == null ? Collections.emptyMap()
            : CameraPicture.of(path, name, time, place.time, pictures.read(place),
                new CameraPicture.Wish(longest, column, row));
    }

    /**
     * Plots values of a record, see {@link Plots}. Units are those of the running world's sensors, otherwise of the
     * project's.
     */
    public Path savePlot(String path, List<String> names, String picture) throws InterruptedException, IOException {
        return Plots.saveRecord(path, names, picture, ofWorld(Plots::units));
    }

    /**
     * Returns how the sensors of the running world, otherwise of the project, format their numbers; empty if the
     * project is invalid.
     */
    private Map<String, Function<double[], String>> wording() throws InterruptedException {
        return ofWorld(Records::wording);
    }

    private <T> Map<String, T> ofWorld(Function<Simulation, Map<String, T>> question) throws InterruptedException {
        Map<String, T> running = control.look((world, session) -> question.apply(world), null);
        if (running != null) {
            return running;
        }
        ProjectSwap.hold();
        try (Simulation start = Simulation.load(Projects.folder(), RunSettings.fromSystem().seed)) {
            return question.apply(start);
        } catch (ProjectException e) {
            return Collections.emptyMap();
        } finally {
            ProjectSwap.letGo();
        }
    }

    /** Returns the ground of the running world, otherwise of the project; empty without a ground. */
    public Map<String, Object> terrain() throws InterruptedException, IOException, ProjectException {
        SimulationSession session = control.sessionOrNull();
        if (session != null) {
            return terrain.of(session.getSimulation().getProject());
        }
        ProjectSwap.hold();
        try {
            return terrain.of(Project.read(Projects.folder()));
        } finally {
            ProjectSwap.letGo();
        }
    }

    /** Returns the appearance of shapes of the running world, otherwise of the project. */
    public List<Map<String, Object>> looks(List<String> wanted) {
        return control.isRunning() ? feed.looks(wanted) : preview.looks(wanted);
    }

    /** Returns the warnings of a start of the project. */
    private static List<String> warnings() throws ProjectException {
        return ProjectSwap.undisturbed(() -> ProjectCheck.warnings(Project.read(Projects.folder())));
    }

    /** Returns what prevents a start of the project; empty if nothing does. */
    public List<Problem> problems() {
        try {
            warnings();
            return Collections.emptyList();
        } catch (ProjectException e) {
            return e.getProblems();
        }
    }

    /** Returns the {@code problems} that prevent a start and the {@code warnings} of a start. */
    public Map<String, Object> check() {
        try {
            return Map.of("problems", Collections.emptyList(), "warnings", warnings());
        } catch (ProjectException e) {
            return Map.of("problems", e.getProblems(), "warnings", Collections.emptyList());
        }
    }

    /**
     * Passes bytes from a device's Serial service to the device.
     *
     * @param parts null before the service has started; the bytes are then lost
     * @return whether the message carries such bytes
     */
    static boolean takesBytes(SearParts parts, Message message) {
        if (!UART_CALLBACK.equals(message.method)) {
            return false;
        }
        try {
            SimulationSession session = parts == null ? null : parts.control.anySession();
            if (session != null && message.data != null && message.data.length == 1
                && message.data[0] instanceof byte[]) {
                session.toDevice(message.getSrcName(), (byte[]) message.data[0]);
            }
        } catch (RuntimeException e) {
            LOG.error("bytes from {} did not reach their device", message.sender, e);
        }
        return true;
    }

    /** Starts the project's world and its exports. */
    public void start(boolean debugShapes) throws ProjectException, IOException {
        control.start(debugShapes);
        exports.begin();
        networkCameras.begin();
    }

    /** Stops the simulation and what depends on it. */
    public void stop() {
        exports.pause();
        control.stop();
        recording.stopped();
        feed.forget();
    }

    /** Closes everything. */
    public void close() {
        control.scriptSession().close();
        stop();
        publisher.close();    // after stop(), so that its interrupted thread has nothing to report
        exports.close();
        networkCameras.close();
        gateways.close();
    }
}
