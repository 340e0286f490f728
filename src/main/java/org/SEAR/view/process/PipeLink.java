// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.process;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.List;
import org.SEAR.project.Project;
import org.SEAR.scene.BeamFan;
import org.SEAR.scene.BeamFans;
import org.SEAR.simulator.Snapshot;
import org.SEAR.view.link.CameraFrame;
import org.SEAR.view.link.WorldLink;

/** Link to the world of another process: receives states and sends commands. Used in the window's process. */
public final class PipeLink implements WorldLink {
    private final Project project;
    private final DataOutputStream out;
    private final List<BeamFan> beams;
    private volatile StateMessage state;

    private interface Content {
        void write() throws IOException;
    }

    public PipeLink(Project project, DataOutputStream out) {
        this.project = project;
        this.out = out;
        beams = BeamFans.of(project);
    }

    /** Receives states until the stream ends. */
    public void receive(DataInputStream in) throws IOException {
        while (true) {
            state = StateMessage.read(in, state);
        }
    }

    private void send(int what, Content content) {
        synchronized (out) {
            try {
                out.writeByte(what);
                content.write();
                out.flush();
            } catch (IOException e) {
                throw new IllegalStateException("the simulation's process has ended", e);
            }
        }
    }

    public void say(int what, String words) {
        send(what, () -> out.writeUTF(words));
    }

    public void say(int what) {
        send(what, () -> { });
    }

    @Override
    public Project project() {
        return project;
    }

    @Override
    public List<BeamFan> beams() {
        return beams;
    }

    @Override
    public Snapshot snapshot() {
        return state == null ? null : state.snapshot;
    }

    @Override
    public boolean isPaused() {
        return state.paused;
    }

    @Override
    public double measuredSpeed() {
        return state.measuredSpeed;
    }

    @Override
    public double wantedSpeed() {
        return state.wantedSpeed;
    }

    @Override
    public boolean scriptDrives() {
        return state.scriptDrives;
    }

    @Override
    public void setPaused(boolean paused) {
        send(WindowProtocol.PAUSE, () -> out.writeBoolean(paused));
    }

    @Override
    public void setSpeed(double factor) {
        send(WindowProtocol.SPEED, () -> out.writeDouble(factor));
    }

    @Override
    public void singleStep() {
        say(WindowProtocol.STEP);
    }

    @Override
    public void drive(int robot, double speed, double radius) {
        send(WindowProtocol.DRIVE, () -> {
            out.writeInt(robot);
            out.writeDouble(speed);
            out.writeDouble(radius);
        });
    }

    @Override
    public void reset() {
        say(WindowProtocol.RESET);
    }

    @Override
    public void wantContacts(boolean on) {
        send(WindowProtocol.CONTACTS, () -> out.writeBoolean(on));
    }

    @Override
    public void wantPicture(String camera) {
        send(WindowProtocol.PICTURE, () -> out.writeUTF(camera == null ? "" : camera));
    }

    @Override
    public CameraFrame picture() {
        return state == null ? null : state.picture;
    }

    @Override
    public void close() {
        // the other process detects the end of this one
    }
}
