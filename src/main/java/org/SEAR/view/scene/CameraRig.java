// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import com.jme3.collision.CollisionResults;
import com.jme3.math.FastMath;
import com.jme3.math.Ray;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;
import com.jme3.scene.Spatial;
import java.util.List;
import org.SEAR.geometry.HeightGrid;

/**
 * Position of the camera: by default it follows the robot from behind; as flycam the user moves it. Angles in radians.
 * Yaw is counter-clockwise from above, 0 looks along +z; pitch is downwards. Window thread only.
 */
public final class CameraRig {
    private static final float FIELD_OF_VIEW = 50;
    private static final float NEAR = 0.05f;
    /** Far plane, metres. {@link org.SEAR.view.terrain.FarView} draws terrain beyond it. */
    private static final float FAR = 400;
    private static final float NEAREST = 0.4f;
    private static final float FARTHEST = 80;
    private static final float STEEPEST = 1.5f;
    /** Rotation per pixel of mouse movement, radians. */
    private static final float MOUSE = 0.005f;
    /** Speed of the flycam, m/s. */
    private static final float FLY_SPEED = 2;
    private static final float FAST = 4;
    /** Time constant with which the follow camera turns after the robot, seconds. */
    private static final float LAG = 0.5f;
    private static final float ZOOM = 1.15f;

    /** Minimum distance of the camera from a wall or the ground, metres. */
    private static final float WALL = 0.12f;
    /** Seconds in which the flycam over a terrain flies as far as it is high. */
    private static final float HEIGHT_TIME = 3;
    /** Distance for an overview of a terrain, as a share of its longer side. */
    private static final float OVERVIEW = 0.7f;

    private final Camera camera;
    private final CollisionResults hits = new CollisionResults();
    private boolean flying;
    private boolean fast;
    private final Vector3f flight = new Vector3f();
    private final Vector3f place = new Vector3f();
    private float yaw;
    private float pitch;
    private float robotYaw = Float.NaN;
    private float orbitYaw;
    private float orbitPitch = 0.45f;
    private float distance = 2.6f;
    /** Null without a terrain. */
    private GroundSight ground;
    private float farthest = FARTHEST;

    public CameraRig(Camera camera) {
        this.camera = camera;
        reshape();
    }

    /**
     * Sets a terrain, above which the camera stays. The maximum distance from the robot becomes the terrain's size.
     * @param whole whether the camera starts with an overview
     */
    public void setGround(HeightGrid field, boolean whole) {
        ground = new GroundSight(field, WALL);
        farthest = Math.max(FARTHEST, ground.extent());
        distance = whole ? OVERVIEW * ground.extent() : distance;
    }

    /** Adapts to the window's size. */
    public void reshape() {
        camera.setFrustumPerspective(FIELD_OF_VIEW, (float) camera.getWidth() / camera.getHeight(), NEAR, FAR);
    }

    public boolean isFlying() {
        return flying;
    }

    /** Toggles between following the robot and flying from the present position. */
    public void toggle() {
        flying = !flying;
        place.set(camera.getLocation());
    }

    /**
     * Moves the flycam.
     * @param newYaw radians, likewise newPitch
     */
    public void fly(Vector3f newPlace, float newYaw, float newPitch) {
        flying = true;
        place.set(newPlace);
        yaw = newYaw;
        pitch = newPitch;
    }

    /**
     * Moves the follow camera.
     * @param newDistance metres
     * @param newYaw radians relative to the robot's back, likewise newPitch
     */
    public void orbit(float newDistance, float newYaw, float newPitch) {
        flying = false;
        distance = newDistance;
        orbitYaw = newYaw;
        orbitPitch = newPitch;
        robotYaw = Float.NaN;
    }

    /** Adds to the flight direction: right, up and forward, each -1, 0 or 1. */
    public void steer(float right, float up, float forward) {
        flight.addLocal(right, up, forward);
    }

    public void setFast(boolean on) {
        fast = on;
    }

    /** Turns the camera by a mouse drag, pixels to the right and up. */
    public void drag(float right, float up) {
        if (flying) {
            yaw -= right * MOUSE;
            pitch = FastMath.clamp(pitch - up * MOUSE, -STEEPEST, STEEPEST);
        } else {
            orbitYaw -= right * MOUSE;
            orbitPitch = FastMath.clamp(orbitPitch - up * MOUSE, -0.2f, STEEPEST);
        }
    }

    /** Zooms by notches of the mouse wheel, + to move closer. */
    public void zoom(float notches) {
        if (flying) {
            place.addLocal(direction().multLocal(notches * Math.max(Math.min(distance, FARTHEST), height()) / FAST));
        } else {
            distance = FastMath.clamp(distance * FastMath.pow(ZOOM, -notches), NEAREST, farthest);
        }
    }

    /**
     * Moves the camera for a frame.
     * @param target point that the follow camera looks at
     * @param heading direction that the follow camera looks along
     * @param obstacles objects that may not hide the target
     */
    public void update(float frameTime, Vector3f target, Vector3f heading, List<? extends Spatial> obstacles) {
        if (flying) {
            Vector3f ahead = direction();
            Vector3f right = ahead.cross(Vector3f.UNIT_Y).normalizeLocal();
            float way = frameTime * Math.max(FLY_SPEED, height() / HEIGHT_TIME) * (fast ? FAST : 1);
            place.addLocal(right.multLocal(flight.x * way)).addLocal(0, flight.y * way, 0)
                .addLocal(ahead.mult(flight.z * way));
        } else {
            turnAfter(heading, frameTime);
            yaw = robotYaw + orbitYaw;
            pitch = orbitPitch;
            Vector3f back = direction().negateLocal();
            place.set(target).addLocal(back.mult(sight(target, back, obstacles)));
        }
        if (ground != null) {
            ground.lift(place);
        }
        camera.setLocation(place);
        camera.lookAtDirection(direction(), Vector3f.UNIT_Y);
    }

    /** Returns the height above the terrain, metres; 0 without one. */
    private float height() {
        return ground == null ? 0 : ground.above(place);
    }

    /** Returns the maximum distance behind the target without an obstacle between, metres. */
    private float sight(Vector3f target, Vector3f back, List<? extends Spatial> obstacles) {
        Ray ray = new Ray(target, back);
        ray.setLimit(distance);
        float free = ground == null ? distance : Math.max(NEAREST, ground.free(target, back, distance));
        for (Spatial obstacle : obstacles) {
            hits.clear();
            if (obstacle.collideWith(ray, hits) > 0 && hits.getClosestCollision().getDistance() < free) {
                free = Math.max(NEAREST, hits.getClosestCollision().getDistance() - WALL);
            }
        }
        return free;
    }

    private void turnAfter(Vector3f heading, float frameTime) {
        boolean level = heading != null && heading.x * heading.x + heading.z * heading.z > FastMath.ZERO_TOLERANCE;
        float wanted = level ? FastMath.atan2(heading.x, heading.z) : 0;
        if (Float.isNaN(robotYaw)) {
            robotYaw = wanted;
        } else if (level) {
            float error = FastMath.normalize(wanted - robotYaw, -FastMath.PI, FastMath.PI);
            robotYaw = FastMath.normalize(robotYaw + error * Math.min(1, frameTime / LAG), -FastMath.PI, FastMath.PI);
        }
    }

    private Vector3f direction() {
        float level = FastMath.cos(pitch);
        return new Vector3f(FastMath.sin(yaw) * level, -FastMath.sin(pitch), FastMath.cos(yaw) * level);
    }
}
