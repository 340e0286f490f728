package org.SEAR.view.link;

import java.util.List;
import org.SEAR.project.Project;
import org.SEAR.scene.BeamFan;
import org.SEAR.scene.SceneState;

/** What a window sees of a world and may ask of it. Every method answers at once; none waits for the simulation. Any thread. */
public interface WorldLink {
    /** The objects of the world. */
    Project project();

    /** The sensors with beams, as they are drawn. */
    List<BeamFan> beams();

    /** The newest state; null until there is one. */
    SceneState sceneState();

    boolean isPaused();

    /** Simulated seconds per real second lately. */
    double measuredSpeed();

    /** Simulated seconds per real second as asked for; infinite for as fast as possible. */
    double wantedSpeed();

    /** Whether a script drives the robot, so that keys must not. */
    boolean scriptDrives();

    void setPaused(boolean paused);

    /** @param factor > 0, infinite for as fast as possible */
    void setSpeed(double factor);

    /** Pauses, and advances by one step. */
    void singleStep();

    /**
     * Drives as the Roomba command does.
     *
     * @param robot its number in the project
     * @param speed m/s
     * @param radius metres, positive to the left, infinite: straight, 0: in place to the left
     */
    void drive(int robot, double speed, double radius);

    /** Everything back to the start, odometers too. */
    void reset();

    /** Whether states carry contact points from now on. */
    void wantContacts(boolean on);

    /**
     * Whose pictures are made from now on; at first nobody's.
     *
     * @param camera full name of a camera; null for none
     */
    void wantPicture(String camera);

    /** The newest picture of the camera that is wanted; null if there is none. */
    CameraFrame picture();

    /** The window goes: stops asking for readings. */
    void close();
}
