// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;

/**
 * An object that can be placed on the ground: an object of the environment, or a robot. {@link #place} and
 * {@link #placeAt} set where; SEAR finds the height from the terrain, floor or model below when it builds the world.
 */
public abstract class PlacedObject extends SearObject {
    private static final String ON_GROUND = "onGround";
    private static final String LATITUDE = "placeLatitude";
    private static final String LONGITUDE = "placeLongitude";

    @Param(doc = "whether its lowest point touches the terrain, floor or model below x and z; y is ignored")
    private Boolean onGround;
    @Param(doc = "latitude of its place on the ground, north positive; replaces x, y and z, needs placeLongitude",
        unit = "deg", min = -90, max = 90)
    private Double placeLatitude;
    @Param(doc = "longitude of its place on the ground, east positive", unit = "deg", min = -180, max = 180)
    private Double placeLongitude;

    /** For reading from a file. */
    protected PlacedObject() {
    }

    /** @param name becomes the name of the file */
    protected PlacedObject(String name) {
        super(name);
    }

    /** Returns whether a parameter places the object on the ground. */
    static boolean isPlacing(String parameter) {
        return parameter.equals(ON_GROUND) || parameter.equals(LATITUDE) || parameter.equals(LONGITUDE);
    }

    /** Returns whether the object is placed on the ground, which overrides its own y. */
    public final boolean isOnGround() {
        return Boolean.TRUE.equals(onGround) || hasPlaceOnEarth();
    }

    /** Returns whether {@link #getPlaceLatitude} and {@link #getPlaceLongitude} define its position, not x and z. */
    public final boolean hasPlaceOnEarth() {
        return placeLatitude != null && placeLongitude != null;
    }

    public final Double getPlaceLatitude() {
        return placeLatitude;
    }

    public final Double getPlaceLongitude() {
        return placeLongitude;
    }

    /**
     * Places the object on the ground at a geographic position, which a {@code Terrain} maps to the world. The rotation
     * stays.
     *
     * @param latitude degrees, north positive
     * @param longitude degrees, east positive
     */
    public void place(double latitude, double longitude) {
        double checkedLatitude = checked(LATITUDE, latitude);
        double checkedLongitude = checked(LONGITUDE, longitude);
        checkNoPart();
        setPosition(0, 0, 0);
        onGround = null;
        placeLatitude = checkedLatitude;
        placeLongitude = checkedLongitude;
        changed();
    }

    /**
     * Places the object on the ground at a point of the world. The rotation stays.
     *
     * @param newX metres north of the world's origin
     * @param newZ metres east of it
     */
    public void placeAt(double newX, double newZ) {
        checked("x", newX);
        checked("z", newZ);
        checked(ON_GROUND, true);
        checkNoPart();
        setPosition(newX, 0, newZ);
        onGround = true;
        placeLatitude = null;
        placeLongitude = null;
        changed();
    }

    private void checkNoPart() {
        if (robot() != null) {
            throw new IllegalArgumentException(label() + " is a part of " + robot().label()
                + " and can't be placed on the ground: its move(x, y, z) is relative to the robot; place the robot");
        }
    }

    @Override
    public void move(double newX, double newY, double newZ) {
        Boolean wasOnGround = onGround;
        Double wasLatitude = placeLatitude;
        Double wasLongitude = placeLongitude;
        onGround = null;
        placeLatitude = null;
        placeLongitude = null;
        boolean done = false;
        try {
            super.move(newX, newY, newZ);
            done = true;
        } finally {
            if (!done) {
                onGround = wasOnGround;
                placeLatitude = wasLatitude;
                placeLongitude = wasLongitude;
            }
        }
    }

    @Override
    void valuesSet() {
        if (isOnGround()) {
            String fixed = whyFixed(ON_GROUND);
            if (fixed != null) {
                throw new IllegalArgumentException(label() + ": " + ON_GROUND + " can't be set: " + fixed);
            }
            checkNoPart();
        }
    }

    @Override
    String whyNoComponent() {
        return isOnGround() ? " was placed on the ground, which a component can't be, legal: move(x, y, z), in the "
            + "robot's frame" : null;
    }

    @Override
    protected void crossCheck(Faults faults) {
        if (placeLatitude == null != (placeLongitude == null)) {
            faults.add(placeLatitude == null ? LONGITUDE : LATITUDE, placeLatitude == null ? placeLongitude
                : placeLatitude, "both " + LATITUDE + " and " + LONGITUDE + ", or neither");
        }
    }
}
