package org.myrobotlab.service;

import java.io.IOException;
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

/** All that a SEAR service is made of, in one place, so that the service class itself loads where a library is missing. */
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
        edits = new Edits(control);
        exports = new Exports(host, control);
        networkCameras = new CameraExports(host, cameras);
        transfers = new BundleTransfers(projects::save, projects::load);
        recording = new Recording(control, host);
        records = new Records(host);
        control.scriptSession().open();
        Edits.mend(host::warn);
        publisher = new Publisher(host, control, readings, cameras);    // last, for it has a thread
        control.setStepListener(publisher::publishDue);
    }

    /**
     * Takes a message that lock-step has sent behind others and waits for.
     *
     * @return whether it is one
     */
    public static boolean isFence(Message message) {
        boolean is = Fence.CALLBACK.equals(message.method) && message.data != null && message.data[0] instanceof FencePass;
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

    /** See {@link ScriptCameras}. */
    public ScriptCameras cameras() {
        return cameras;
    }

    public ScriptDriving driving() {
        return driving;
    }

    public ScriptActuators actuators() {
        return actuators;
    }

    /** See {@link Plans}. */
    public Plans plans() {
        return plans;
    }

    /** See {@link ScriptBodies}. */
    public ScriptBodies bodies() {
        return bodies;
    }

    /** See {@link Gateways}. */
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

    /** See {@link CameraExports}. */
    public CameraExports networkCameras() {
        return networkCameras;
    }

    /** The exports of ports and cameras: each name with what programs open. */
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

    /** What panels are told next of the world: the whole or what has changed, as {@link WorldFeed} says. */
    public Map<String, Object> nextState() throws InterruptedException {
        return control.look(feed::next, WorldFeed.nothing());
    }

    /** The whole state of the world, for a panel that comes later. */
    public Map<String, Object> wholeState() throws InterruptedException {
        return control.look(feed::whole, WorldFeed.nothing());
    }

    /** A camera's last picture, as {@link CameraPicture} has it; empty if no simulation with such a camera runs. */
    public Map<String, Object> cameraPicture(String name, int longest, int column, int row) throws InterruptedException {
        CameraImage image = cameras.look(name);
        if (image == null) {
            return Collections.emptyMap();
        }
        return CameraPicture.of(name, image, cameras.distance(name, image, column, row), new CameraPicture.Wish(longest, column, row));
    }

    /**
     * The world as it would start, for panels while nothing runs; nothing while a simulation does.
     *
     * @param known the stamp of the one they have
     */
    public Map<String, Object> preview(String known) {
        if (control.isRunning()) {
            return Collections.emptyMap();
        }
        return ProjectSwap.undisturbed(() -> preview.of(Projects.folder(), known));
    }

    /** Where everything was over time in a record, as {@link Records#frames} has it. */
    public Map<String, Object> recordFrames(String path) throws InterruptedException, IOException {
        return records.frames(path, wording());
    }

    /** How things turned, and what sensors saw in a record, as {@link RecordMotion#of} has it. */
    public Map<String, Object> recordMotion(String path) throws IOException {
        return RecordMotion.of(path, Records.open(path), control.getFolder());
    }

    /** A camera's picture in a record, as {@link CameraPicture} has it; empty if there is none. */
    public Map<String, Object> recordPicture(String path, String name, double time, int longest, int column, int row) throws IOException {
        RecordPictures pictures = kept.of(path);
        RecordPictures.Place place = pictures.at(name, time);
        return place == null ? Collections.emptyMap()
            : CameraPicture.of(path, name, time, place.time, pictures.read(place), new CameraPicture.Wish(longest, column, row));
    }

    /** Draws values of a record, see {@link Plots}; units are those of the running world's sensors, or else of the project's. */
    public void savePlot(String path, List<String> names, String picture) throws InterruptedException, IOException {
        Plots.saveRecord(path, names, picture, ofWorld(Plots::units));
    }

    /** How the sensors of the running world, or else of the project, tell their numbers; nothing where panels are told that there is no world. */
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

    /** The ground of the running world, or else of the project; empty if it has none. */
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

    /** What shapes of the running world, or else of the project, look like. */
    public List<Map<String, Object>> looks(List<String> wanted) {
        return control.isRunning() ? feed.looks(wanted) : preview.looks(wanted);
    }

    /** What is wrong with the project; empty if nothing. */
    public List<Problem> problems() {
        try {
            Project.read(Projects.folder());
            return Collections.emptyList();
        } catch (ProjectException e) {
            return e.getProblems();
        }
    }

    /** What keeps the project from starting, {@code problems}, and what its start would warn of, {@code warnings}. */
    public Map<String, Object> check() {
        return ProjectSwap.undisturbed(() -> {
            List<Problem> problems = Collections.emptyList();
            List<String> warnings = Collections.emptyList();
            try {
                warnings = ProjectCheck.warnings(Project.read(Projects.folder()));
            } catch (ProjectException e) {
                problems = e.getProblems();
            }
            return Map.of("problems", problems, "warnings", warnings);
        });
    }

    /**
     * Brings bytes from a device's Serial service to the device.
     *
     * @param parts null before the service has started: then they are lost
     * @return whether the message is one with such bytes
     */
    static boolean takesBytes(SearParts parts, Message message) {
        if (!UART_CALLBACK.equals(message.method)) {
            return false;
        }
        try {
            SimulationSession session = parts == null ? null : parts.control.anySession();
            if (session != null && message.data != null && message.data.length == 1 && message.data[0] instanceof byte[]) {
                session.toDevice(message.getSrcName(), (byte[]) message.data[0]);
            }
        } catch (RuntimeException e) {
            LOG.error("bytes from {} did not reach their device", message.sender, e);
        }
        return true;
    }

    /** Starts the project's world, with its exports. */
    public void start(boolean debugShapes) throws ProjectException, IOException {
        control.start(debugShapes);
        exports.begin();
        networkCameras.begin();
    }

    /** Ends the simulation and what hangs on it. */
    public void stop() {
        exports.pause();
        control.stop();
        recording.stopped();
        feed.forget();
    }

    /** Ends everything, for good. */
    public void close() {
        control.scriptSession().close();
        stop();
        publisher.close();    // whose thread, interrupted while it looks, has nothing to complain of by now
        exports.close();
        networkCameras.close();
        gateways.close();
    }
}
