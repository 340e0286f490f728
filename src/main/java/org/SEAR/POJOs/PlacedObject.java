package org.SEAR.POJOs;

import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;

/**
 * What may stand on the ground of the world: a thing of the environment, or a robot. {@link #place} and {@link #placeAt} say where; how high that is
 * comes out when the world is built, from the terrain, floor or model below it, so nobody has to know the ground's height.
 */
public abstract class PlacedObject extends SearObject {
    private static final String ON_GROUND = "onGround";
    private static final String LATITUDE = "placeLatitude";
    private static final String LONGITUDE = "placeLongitude";

    @Param(doc = "whether it stands on the ground at x and z, whatever y is: its lowest point touches the terrain, floor or model below it")
    private Boolean onGround;
    @Param(doc = "latitude of where it stands on the ground, north positive; with placeLongitude instead of x, y and z", unit = "deg",
        min = -90, max = 90)
    private Double placeLatitude;
    @Param(doc = "longitude of where it stands on the ground, east positive", unit = "deg", min = -180, max = 180)
    private Double placeLongitude;

    /** For reading from a file. */
    protected PlacedObject() {
    }

    /** @param name becomes the name of the file */
    protected PlacedObject(String name) {
        super(name);
    }

    /** Whether a parameter says where it stands on the ground. */
    static boolean isPlacing(String parameter) {
        return parameter.equals(ON_GROUND) || parameter.equals(LATITUDE) || parameter.equals(LONGITUDE);
    }

    /** Whether it stands on the ground: its own height doesn't count then. */
    public final boolean isOnGround() {
        return Boolean.TRUE.equals(onGround) || hasPlaceOnEarth();
    }

    /** Whether it stands at {@link #getPlaceLatitude} and {@link #getPlaceLongitude}, not at its x and z. */
    public final boolean hasPlaceOnEarth() {
        return placeLatitude != null && placeLongitude != null;
    }

    /** Degrees, north positive; null if it was not placed so. */
    public final Double getPlaceLatitude() {
        return placeLatitude;
    }

    /** Degrees, east positive; null if it was not placed so. */
    public final Double getPlaceLongitude() {
        return placeLongitude;
    }

    /**
     * Puts it on the ground at a place on the Earth, which a {@code Terrain} says where to find. It keeps its rotation.
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
     * Puts it on the ground at a point of the world. It keeps its rotation.
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
            throw new IllegalArgumentException(label() + " is a part of " + robot().label() + " and can't be placed on the ground: its move(x, y, z)"
                + " counts from the robot; place the robot");
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
        return isOnGround() ? " was placed on the ground, which a component can't be, legal: move(x, y, z), in the robot's frame" : null;
    }

    @Override
    protected void crossCheck(Faults faults) {
        if (placeLatitude == null != (placeLongitude == null)) {
            faults.add(placeLatitude == null ? LONGITUDE : LATITUDE, placeLatitude == null ? placeLongitude : placeLatitude,
                "both " + LATITUDE + " and " + LONGITUDE + ", or neither");
        }
    }
}
