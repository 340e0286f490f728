// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.TextRule;
import org.SEAR.protocol.arduino.WireRole;

/**
 * A distance sensor with nested cones of rays; the nearest hit of all rays counts. The cones come from a named beam or
 * from the user.
 */
@Described("a distance sensor: nested cones of rays; the nearest hit counts")
public class Distance extends SensorObject implements Wirable {
    private static final String DEFAULT_BEAM = "ultrasonic";
    private static final int MAX_CONES = 100;
    private static final List<WireRole> VOLTS = List.of(WireRole.VOLTS);
    private static final List<WireRole> ECHO = List.of(WireRole.PING, WireRole.TRIGGER, WireRole.ECHO);

    @Param(doc = "name of a beam that comes with SEAR or lies in the project's beams folder; excludes cones",
        text = TextRule.NAME, initial = DEFAULT_BEAM)
    private String beam;
    @Param(doc = "a cone of its own", element = "cone", maxEntries = MAX_CONES)
    private List<BeamCone> cones = new ArrayList<>();
    @Param(doc = "rays of each cone; 0 keeps each cone's own number", max = BeamCone.MAX_LINES)
    private int lines;
    @Param(doc = "whether its beams hit parts of its own robot")
    private boolean seesOwnRobot;
    private Beam shape;

    /** For reading from a file. */
    protected Distance() {
    }

    /**
     * Uses the beam that the sensor's name contains, as "Sharp GP2Y0A21" or "left PING", otherwise a plain ultrasonic
     * beam. A message names the beam, unless the name is exactly a beam's.
     */
    public Distance(String name) {
        this(name, ofName(name));
    }

    /**
     * @param beam for example PING))), LV-EZ1, GP2Y0A21, ultrasonic, SONAR, RADAR, infrared, laser; or a text with such
     * a name
     */
    public Distance(String name, String beam) {
        this(name, beam, 0, 0, 0, 0, 0, 0);
    }

    /** At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees. */
    public Distance(String name, String beam, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        this.beam = chosen(beam);
        pose(x, y, z, rx, ry, rz);
        this.shape = named(this.beam);
        created(Distance.class);
    }

    /**
     * A single cone of 36 rays.
     *
     * @param halfAngle degrees
     * @param range metres
     */
    public Distance(String name, double halfAngle, double range) {
        this(name, Collections.singletonList(new BeamCone(halfAngle, range)));
    }

    /**
     * @param cones each a {@link BeamCone}, or a list of half-angle, range, colour, lines, yaw, pitch (the first two
     * are needed)
     */
    public Distance(String name, List<?> cones) {
        this(name, cones, 0, 0, 0, 0, 0, 0);
    }

    /** With all parameters. */
    public Distance(String name, List<?> cones, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        this.cones = listed(cones);
        pose(x, y, z, rx, ry, rz);
        created(Distance.class);
    }

    private static String ofName(String name) {
        List<String> names = ObjectStores.get().beamNames();
        String found = names.contains(name) ? name : name == null ? null : BeamNames.in(name, names);
        String beam = found == null ? DEFAULT_BEAM : found;
        if (!beam.equals(name) && !ObjectStores.isRedirected()) {
            Notices.say("Distance \"" + name + "\" gets the beam " + beam
                + (found == null ? ", as its name contains no beam's" : " of its name")
                + ": Distance(name, beam) chooses another");
        }
        return beam;
    }

    /** Returns a beam's name as given, or the beam's name that a longer text contains, with a message. */
    private String chosen(String wanted) {
        List<String> names = ObjectStores.get().beamNames();
        String found = wanted == null || names.stream().anyMatch(wanted::equalsIgnoreCase) ? wanted
            : BeamNames.in(wanted, names);
        if (found == null || found.equals(wanted)) {
            return wanted;
        }
        Notices.say(label() + ": beam \"" + wanted + "\" is taken as " + found);
        return found;
    }

    private Beam named(String wanted) {
        try {
            return ObjectStores.get().beam(wanted);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(label() + ": " + e.getMessage(), e);
        }
    }

    private List<BeamCone> listed(List<?> entries) {
        if (entries == null || entries.isEmpty()) {
            throw new IllegalArgumentException(label() + ": cone is missing, legal: 1 to " + MAX_CONES + " cones");
        }
        try {
            return entries.stream().map(BeamCone::of).collect(Collectors.toList());
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(label() + ": " + e.getMessage(), e);
        }
    }

    @Override
    void valuesSet() {
        super.valuesSet();
        beam = chosen(beam);
        shape = beam == null ? null : named(beam);
    }

    /** Sets the beam data of a sensor that was read from a file. */
    void link(Beam named) {
        shape = named;
    }

    /** Returns the wires: the voltage of a beam with a voltage curve, otherwise the echo. */
    @Override
    public List<WireRole> getWireRoles() {
        return shape == null || shape.getVoltages().isEmpty() ? ECHO : VOLTS;
    }

    @Override
    protected void crossCheck(Faults faults) {
        if (beam == null && cones.isEmpty()) {
            faults.add("beam", "", "the name of a beam, or cones");
        }
        if (beam != null && !cones.isEmpty()) {
            faults.add("beam", beam, "either a beam or cones, not both");
        }
    }

    /** Returns the cones of the named beam, or the sensor's own; at least one. */
    public List<BeamCone> getCones() {
        List<BeamCone> effective = shape == null ? cones : shape.getCones();
        if (lines > 0) {
            return effective.stream().map(c -> c.withLines(lines)).collect(Collectors.toUnmodifiableList());
        }
        return Collections.unmodifiableList(effective);
    }

    public String getBeam() {
        return beam;
    }

    /** Returns the data of the named beam (nearest distance, voltages); null if the sensor has cones of its own. */
    public Beam getShape() {
        return shape;
    }

    public int getLines() {
        return lines;
    }

    public boolean isSeesOwnRobot() {
        return seesOwnRobot;
    }

    /** @param count rays of each cone, 1 to 360; 0 keeps each cone's own number */
    public void setLines(int count) {
        lines = checked("lines", count);
        changed();
    }

    public void setSeesOwnRobot(boolean on) {
        seesOwnRobot = checked("seesOwnRobot", on);
        changed();
    }

    /** @param newBeam name of a beam, or a text with such a name; replaces the present beam or cones */
    public void setBeam(String newBeam) {
        String legal = chosen(checked("beam", newBeam));
        shape = named(legal);
        beam = legal;
        cones = new ArrayList<>();
        changed();
    }

    /** @param newCones as in the constructor; replaces the present beam or cones */
    public void setCones(List<?> newCones) {
        checkChangeable();
        cones = listed(newCones);
        beam = null;
        shape = null;
        changed();
    }
}
