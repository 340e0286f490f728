// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.link;

import java.util.List;
import org.SEAR.project.Project;
import org.SEAR.scene.BeamFan;
import org.SEAR.simulator.Snapshot;

/** Access of a window to a world. No method waits for the simulation. Any thread. */
public interface WorldLink {
    Project project();

    /** Returns the beams of all sensors. */
    List<BeamFan> beams();

    /** Returns the newest state; null before the first one. */
    Snapshot snapshot();

    boolean isPaused();

    /** Returns the recent speed, simulated seconds per real second. */
    double measuredSpeed();

    /** Returns the requested speed, simulated seconds per real second; infinite for maximum. */
    double wantedSpeed();

    /** Returns whether a script drives the robot, which disables the keys. */
    boolean scriptDrives();

    void setPaused(boolean paused);

    /** @param factor simulated seconds per real second, above 0; infinite for maximum */
    void setSpeed(double factor);

    /** Pauses and advances by one step. */
    void singleStep();

    /**
     * Drives like the Roomba's Drive command.
     * @param robot its number in the project
     * @param speed m/s
     * @param radius metres, positive to the left; infinite: straight; 0: in place to the left
     */
    void drive(int robot, double speed, double radius);

    /** Resets the world to its start, including odometers. */
    void reset();

    /** Includes or omits contact points in further states. */
    void wantContacts(boolean on);

    /**
     * Selects the camera that takes pictures; initially none.
     * @param camera full name of a camera, or null
     */
    void wantPicture(String camera);

    /** Returns the newest picture of the selected camera, or null. */
    CameraFrame picture();

    /** Stops requesting readings, as the window closes. */
    void close();
}
