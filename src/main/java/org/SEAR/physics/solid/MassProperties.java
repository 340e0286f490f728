// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.util.List;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.InertiaTensor;
import org.SEAR.geometry.Pose;

/** Mass, centre of mass and inertia tensor of a rigid body in some frame. Immutable, any thread. */
public final class MassProperties {
    /** Mass properties of a body that never moves. */
    public static final MassProperties FIXED = new MassProperties(0, new double[3], InertiaTensor.ZERO);

    /** Mass, kg. */
    public final double mass;
    /** Tensor about the centre of mass, kg m^2. */
    public final InertiaTensor inertia;
    private final double x;
    private final double y;
    private final double z;

    /**
     * @param mass kg
     * @param centre of mass, {x, y, z}, metres
     * @param inertia about the centre of mass, kg m^2
     */
    public MassProperties(double mass, double[] centre, InertiaTensor inertia) {
        this.mass = mass;
        this.inertia = inertia;
        x = centre[0];
        y = centre[1];
        z = centre[2];
    }

    /** Returns one kilogram of a convex solid of uniform density. */
    static MassProperties of(ConvexShape shape) {
        return new MassProperties(1, shape.centre(), shape.inertia());
    }

    /** Centre of mass: {x, y, z}, metres. */
    public double[] centre() {
        return new double[] {x, y, z};
    }

    /** Returns the same distribution with another mass, kg. */
    public MassProperties withMass(double newMass) {
        return new MassProperties(newMass, centre(), inertia.times(newMass / mass));
    }

    /** Returns the same distribution with its centre elsewhere: {x, y, z}, metres. */
    public MassProperties withCentre(double[] centre) {
        return new MassProperties(mass, centre, inertia);
    }

    /** Returns the properties in the parent frame; {@code frame} is the pose of the present one in it. */
    public MassProperties inParent(Pose frame) {
        return new MassProperties(mass, frame.transform(x, y, z), inertia.inParent(frame));
    }

    /** Returns the properties of a body made from parts, all in its frame; their masses must not all be 0. */
    public static MassProperties sum(List<MassProperties> parts) {
        double mass = 0;
        double[] centre = new double[3];
        for (MassProperties part : parts) {
            mass += part.mass;
            centre[0] += part.mass * part.x;
            centre[1] += part.mass * part.y;
            centre[2] += part.mass * part.z;
        }
        for (int i = 0; i < centre.length; i++) {
            centre[i] /= mass;
        }
        InertiaTensor inertia = InertiaTensor.ZERO;
        for (MassProperties part : parts) {
            inertia = inertia.plus(part.inertia.displaced(part.mass, part.x - centre[0], part.y - centre[1],
                part.z - centre[2]));
        }
        return new MassProperties(mass, centre, inertia);
    }
}
