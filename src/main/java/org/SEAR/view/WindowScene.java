// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import com.jme3.font.BitmapFont;
import com.jme3.math.Quaternion;
import com.jme3.math.Vector3f;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.function.Consumer;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.scene.Movement;
import org.SEAR.scene.ReadingTexts;
import org.SEAR.simulator.Snapshot;
import org.SEAR.view.hud.Hud;
import org.SEAR.view.hud.StatusText;
import org.SEAR.view.input.Controls;
import org.SEAR.view.input.Key;
import org.SEAR.view.input.KeyDrive;
import org.SEAR.view.input.KeyLayout;
import org.SEAR.view.link.WorldLink;
import org.SEAR.view.scene.CameraRig;
import org.SEAR.view.scene.DebugShapes;
import org.SEAR.view.scene.Labels;
import org.SEAR.view.scene.Lighting;
import org.SEAR.view.scene.Materials;
import org.SEAR.view.scene.SceneBuilder;
import org.SEAR.view.scene.WorldView;
import org.SEAR.view.terrain.FarView;
import org.SEAR.view.terrain.TerrainView;

/** Content of the window and the commands of its keys. Window thread only. */
final class WindowScene {
    private static final double[] SPEEDS = {0.1, 0.25, 0.5, 1, 2, 4, 8, 16, 32, Double.POSITIVE_INFINITY};
    /** Height above a robot's origin that the follow camera looks at, metres. */
    private static final float LOOK_UP = 0.1f;

    private final WorldLink link;
    private final ReadingTexts texts;
    private final Movement movement = new Movement();
    private final Lighting lighting;
    private final WorldView world;
    private final DebugShapes shapes;
    private final CameraRig camera;
    private final Controls controls;
    private final Labels labels;
    private final Hud hud;
    private final Screenshots screenshots;
    private final FrameRateMonitor frameRate = new FrameRateMonitor();
    private final KeyDrive drive = new KeyDrive();
    private final Hud.State state = new Hud.State();
    private final WindowApplication window;
    private final Vector3f target = new Vector3f();
    private final Vector3f heading = new Vector3f(Vector3f.UNIT_X);
    private int robot;
    /** Number of the camera whose picture is shown; -1 for none. */
    private int picture = -1;
    /** Terrain and far view; null without a terrain. */
    private final TerrainView terrain;
    private final FarView far;

    WindowScene(WindowApplication window, WorldLink link, WindowOptions options, ExecutorService background) {
        this.window = window;
        this.link = link;
        texts = new ReadingTexts(link.project());
        BitmapFont font = window.getAssetManager().loadFont("Interface/Fonts/Default.fnt");
        Materials materials = new Materials(window.getAssetManager(), !window.isSoftware(), options.getWarnings());
        SceneBuilder builder = new SceneBuilder(new ModelLoader(link.project().getAssets()), materials,
            options.getWarnings());
        lighting = new Lighting(window.getAssetManager(), window.getRootNode(), window.getViewPort());
        world = new WorldView(link.project(), builder, link.beams(), materials);
        window.getRootNode().attachChild(world.root());
        terrain = GroundViews.of(link.project(), window, options.getWarnings());
        shapes = new DebugShapes(link.project(), world, materials);
        setShapes(options.isDebugShapes());
        camera = new CameraRig(window.getCamera());
        far = terrain == null ? null : new FarView(window.getRenderManager(), window.getViewPort(),
            window.getRootNode(), lighting.sky());
        if (terrain != null) {
            window.getRootNode().attachChild(terrain.node());
            camera.setGround(terrain.field(), link.project().getRobots().isEmpty());
        }
        controls = new Controls(new KeyLayout(window.getContext().getKeyInput()), camera, this::pressed);
        window.getInputManager().addRawInputListener(controls);
        labels = new Labels(font, materials, window.getGuiNode());
        hud = new Hud(font, materials, window.getGuiNode());
        Consumer<String> report = message -> window.enqueue(() -> hud.say(message));
        screenshots = new Screenshots(options.getScreenshotFolder(), background, report);
        window.getGuiViewPort().addProcessor(screenshots);
        state.beamSensors = world.beamSensors();
        state.hasCameras = !world.cameras().isEmpty();
    }

    /** Draws the newest state, if there is one. */
    void update(float frameTime) {
        Snapshot snapshot = link.snapshot();
        if (snapshot == null) {
            return;
        }
        state.paused = link.isPaused();
        state.measuredSpeed = link.measuredSpeed();
        state.wantedSpeed = link.wantedSpeed();
        state.scriptDrives = link.scriptDrives();
        state.flying = camera.isFlying();
        state.robot = robot;
        state.picture = picture < 0 ? null : link.picture();
        state.readings = texts.of(snapshot.readings);
        state.hidden = world.hiddenSensors();
        movement.advance(snapshot, state.paused ? 0 : state.measuredSpeed, frameTime);
        world.update(movement);
        shapes.update(movement.newest());
        look(frameTime);
        lighting.follow(window.getCamera());
        if (terrain != null) {
            far.update(frameTime);
            terrain.update(window.getCamera());
        }
        if (frameRate.count(frameTime)) {
            lighting.hurryShadows();
        }
        world.label(labels, state.readings, window.getCamera());
        hud.update(frameTime, window.getCamera().getWidth(), window.getCamera().getHeight(), movement.newest(), state);
    }

    private void look(float frameTime) {
        if (!world.robots().isEmpty()) {
            target.set(world.robot(robot).getLocalTranslation()).addLocal(0, LOOK_UP, 0);
            Quaternion turn = world.robot(robot).getLocalRotation();
            turn.mult(Vector3f.UNIT_Z, heading);
        }
        camera.update(frameTime, target, heading, world.environment());
    }

    /** Returns whether a state has been drawn. */
    boolean hasPicture() {
        return movement.newest() != null;
    }

    void reshape() {
        camera.reshape();
    }

    void releaseKeys() {
        controls.release();
    }

    private void pressed(Key key, int number) {
        if (drive.press(key)) {
            drive(key);
            return;
        }
        switch (key) {
            case FLYCAM:
                camera.toggle();
                break;
            case PAUSE:
                link.setPaused(!link.isPaused());
                break;
            case STEP:
                link.singleStep();
                break;
            case FASTER:
                speed(1);
                break;
            case SLOWER:
                speed(-1);
                break;
            case NEXT_ROBOT:
                nextRobot();
                break;
            case SENSOR:
                hud.say(world.toggleBeam(number));
                break;
            default:
                look(key);
                break;
        }
    }

    private void look(Key key) {
        switch (key) {
            case HELP:
                hud.toggleHelp();
                labels.setCovered(hud.isHelpShown());
                break;
            case BEAMS:
                world.toggleBeams();
                hud.say(world.areBeamsShown() ? "beams shown" : "beams hidden");
                break;
            case SHAPES:
                setShapes(!shapes.isVisible());
                hud.say(shapes.isVisible() ? "physics shapes shown" : "physics shapes hidden");
                break;
            case FOLD:
                hud.toggleFolded();
                break;
            case LABELS:
                labels.toggle();
                break;
            case CAMERA:
                nextCamera();
                break;
            case SCREENSHOT:
                screenshots.take();
                break;
            default:
                break;
        }
    }

    private void setShapes(boolean on) {
        shapes.setVisible(on);
        link.wantContacts(on);
    }

    private void drive(Key key) {
        if (key == Key.RESET) {
            link.reset();
            hud.say("simulation reset");
        } else if (link.scriptDrives()) {
            hud.say("a script drives the robot: the keys H K U J ; are off");
        } else if (world.robots().isEmpty()) {
            hud.say("there is no robot to drive");
        } else {
            link.drive(robot, drive.speed(), drive.radius());
            hud.say(drive.words());
        }
    }

    private void speed(int up) {
        int at = 0;
        while (at < SPEEDS.length - 1 && SPEEDS[at] < link.wantedSpeed()) {
            at++;
        }
        double wanted = SPEEDS[Math.max(0, Math.min(SPEEDS.length - 1, at + up))];
        link.setSpeed(wanted);
        hud.say("speed " + StatusText.factor(wanted));
    }

    private void nextRobot() {
        if (!world.robots().isEmpty()) {
            robot = (robot + 1) % world.robots().size();
            hud.say("following " + world.robot(robot).getName());
        }
    }

    private void nextCamera() {
        List<String> cameras = world.cameras();
        picture = picture + 1 < cameras.size() ? picture + 1 : -1;
        state.camera = picture < 0 ? null : cameras.get(picture);
        link.wantPicture(state.camera);
        hud.say(cameras.isEmpty() ? "there is no camera" : picture < 0 ? "camera picture hidden" : "picture of "
            + state.camera);
    }

    /** Saves the next frame to this file. */
    void picture(Path file) {
        screenshots.take(file);
    }

    WorldView world() {
        return world;
    }

    CameraRig camera() {
        return camera;
    }

    Hud hud() {
        return hud;
    }

    Labels labels() {
        return labels;
    }

    DebugShapes shapes() {
        return shapes;
    }

    /** Returns the terrain, or null. */
    TerrainView terrain() {
        return terrain;
    }

    Lighting lighting() {
        return lighting;
    }
}
