// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Included;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.ScriptText;
import org.SEAR.grammar.TextRule;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.arduino.ProgramFile;
import org.SEAR.protocol.arduino.WireRole;

/** An Arduino on a pair of serial ports, with the robot's sensors and motors wired to its pins. */
@Described("an Arduino on a pair of serial ports, with the robot's sensors and motors wired to its pins")
public class Arduino extends SearObject implements SerialObject {
    private static final String MRL_COMM = "MrlComm";
    private static final String FIRMATA = "StandardFirmata";
    private static final int MRL_COMM_BAUD = 115200;
    private static final int FIRMATA_BAUD = 57600;
    private static final int MAX_WIRES = 70;

    @Param(doc = "kind of board", values = {"uno", "mega"})
    private String board = "uno";
    @Param(doc = "program on the board: MyRobotLab's own, or Firmata 2.5 with encoders and echoes",
        values = {MRL_COMM, FIRMATA})
    private String firmware = MRL_COMM;
    @Param(doc = "compiled sketch below assets, .hex or .elf, which an uno runs instead of the firmware",
        text = TextRule.ASSET)
    private String sketch;
    @Included
    private final SerialParameters serial = new SerialParameters(this, MRL_COMM_BAUD);
    @Param(doc = "a wire from a pin to a component", element = "wire", maxEntries = MAX_WIRES)
    private List<BoardWire> wires = new ArrayList<>();

    /** For reading from a file. */
    protected Arduino() {
    }

    /** An Uno. */
    public Arduino(String name) {
        this(name, "uno");
    }

    /** @param board uno or mega */
    public Arduino(String name, String board) {
        super(name);
        this.board = lower(board);
        created(Arduino.class);
    }

    private static String lower(String text) {
        return text == null ? null : text.toLowerCase(Locale.ROOT);
    }

    @Override
    boolean isRobotPart() {
        return true;
    }

    /** Checks the wires one by one, so that of two wires at one pin the second is the faulty one. */
    @Override
    protected void crossCheck(Faults faults) {
        String problem = sketchProblem(sketch);
        if (problem != null) {
            faults.add("sketch", sketch, problem);
        }
        List<BoardWire> good = new ArrayList<>();
        for (int i = 0; i < wires.size(); i++) {
            BoardWire wire = wires.get(i);
            if (wire.getRole() == null || wire.getPart() == null) {
                continue;
            }
            String reason = WireRules.reason(getModel(), good, wire.getPin(), wire.getRole());
            BoardWire same = WireRules.same(good, wire.getPart(), wire.getRole());
            if (reason != null) {
                faults.add("wire#" + i, wire.getPin() + ", " + reason,
                    WireRules.legal(getModel(), good, wire.getRole()));
            } else if (same != null) {
                faults.add("wire#" + i, wire.getPin(), "one wire for " + wire.getRole().getWord() + " of "
                    + wire.getPart() + ", which is at pin " + same.getPin());
            } else {
                good.add(wire);
            }
        }
    }

    /** Returns the kind of board. */
    public BoardModel getModel() {
        return BoardModel.of(board);
    }

    public String getBoard() {
        return board;
    }

    public String getFirmware() {
        return firmware;
    }

    /** Returns the path of the compiled sketch below assets; null if the board runs its firmware. */
    public String getSketch() {
        return sketch;
    }

    public boolean isFirmata() {
        return FIRMATA.equals(firmware);
    }

    /** Returns the wires in the order of their addition; a view. */
    public List<BoardWire> getWires() {
        return Collections.unmodifiableList(wires);
    }

    /**
     * Wires a component to a pin, in the default role of its kind.
     *
     * @param pin for example "A0" or "7"
     */
    public void wire(String pin, SearObject part) {
        wire(pin, part, null);
    }

    /** Wires a component to a digital pin, in the default role of its kind. */
    public void wire(int pin, SearObject part) {
        wire(Integer.toString(pin), part, null);
    }

    /** Wires a component to a digital pin. */
    public void wire(int pin, SearObject part, String role) {
        wire(Integer.toString(pin), part, role);
    }

    /** Wires a component by its name to a digital pin. */
    public void wire(int pin, String part) {
        wire(Integer.toString(pin), part, null);
    }

    /** Wires a component by its name to a pin. */
    public void wire(String pin, String part) {
        wire(pin, part, null);
    }

    /** Wires a component by its name to a digital pin. */
    public void wire(int pin, String part, String role) {
        wire(Integer.toString(pin), part, role);
    }

    /**
     * Wires a component by its name to a pin.
     *
     * @param part a component of the Arduino's robot; before the Arduino is on a robot, of the only robot with such a
     *     component
     * @throws IllegalArgumentException with the names of the parts, and as the call with the component itself
     */
    public void wire(String pin, String part, String role) {
        String name = ScriptText.of(part);
        wire(pin, name == null ? (SearObject) null : find(name), role);
    }

    private SearObject find(String part) {
        Map<String, SEARrobot> robots = new LinkedHashMap<>();
        for (SEARrobot robot : robot() != null ? List.of(robot()) : ScriptSessions.ALL.made(SEARrobot.class)) {
            if (robot.isInProject()) {
                robots.put(robot.getName(), robot);    // replaces an earlier robot of the same name
            }
        }
        List<SearObject> found = new ArrayList<>();
        List<String> names = new ArrayList<>();
        for (SEARrobot robot : robots.values()) {
            for (SearObject one : robot.getComponents()) {
                if (one.getName().equals(part)) {
                    found.add(one);
                }
                if (one instanceof Wirable) {
                    names.add(one.getName());
                }
            }
        }
        if (found.isEmpty()) {
            throw new IllegalArgumentException(label() + ": part is " + ParameterTable.quote(part)
                + ", legal: a component of the robot"
                + (names.isEmpty() ? "; no robot has one to wire yet, call addComponent(...) first" : ", "
                    + String.join(", ", names)));
        }
        if (found.size() > 1) {
            throw new IllegalArgumentException(label() + ": " + ParameterTable.quote(part)
                + " is on several robots, legal: a part of "
                + label() + "'s own robot; call robot.addComponent(...) first");
        }
        return found.get(0);
    }

    /**
     * Wires a component to a pin.
     *
     * @param pin for example "A0" or "7"
     * @param part a component of the same robot
     * @param role of the wire; null for the default role of the component's kind
     * @throws IllegalArgumentException with the legal values, if the pin is unsuitable or taken, or the component has
     *     no such wire
     */
    public void wire(String pin, SearObject part, String role) {
        checkChangeable();
        if (part == null) {
            throw new IllegalArgumentException(label() + ": the part for pin " + pin + " is missing (None), legal: a "
                + "component of the robot");
        }
        WireRole wanted = role == null ? null : WireRole.of(role);
        String problem = WireRules.problem(part, wanted);
        if (problem != null) {
            throw new IllegalArgumentException(label() + ": " + problem);
        }
        List<WireRole> roles = ((Wirable) part).getWireRoles();
        if (role != null && wanted == null) {
            throw new IllegalArgumentException(label() + ": role is " + ParameterTable.quote(role) + ", legal for "
                + part + ": " + WireRules.words(roles));
        }
        add(pin, part, wanted == null ? roles.get(0) : wanted);
    }

    private void add(String pin, SearObject part, WireRole role) {
        String reason = WireRules.reason(getModel(), wires, pin, role);
        if (reason != null) {
            throw new IllegalArgumentException(label() + ": pin " + pin + " is " + reason + ", legal: "
                + WireRules.legal(getModel(), wires, role));
        }
        BoardWire same = WireRules.same(wires, part.getName(), role);
        if (same != null) {
            throw new IllegalArgumentException(label() + ": " + part + " has its " + role.getWord() + " at pin "
                + same.getPin()
                + " already, legal: one pin for it; unwire(\"" + same.getPin() + "\") removes that wire");
        }
        wires.add(new BoardWire(getModel().nameOf(getModel().pinOf(pin)), part.getName(), role));
        changed();
    }

    /**
     * Removes the wire at a pin.
     *
     * @throws IllegalArgumentException with the wired pins, if nothing is wired to it
     */
    public void unwire(String pin) {
        checkChangeable();
        int number = getModel().pinOf(pin);
        if (!wires.removeIf(wire -> getModel().pinOf(wire.getPin()) == number)) {
            List<String> pins = new ArrayList<>();
            wires.forEach(wire -> pins.add(wire.getPin()));
            throw new IllegalArgumentException(label() + ": nothing is wired to pin " + pin + ", legal: "
                + (pins.isEmpty() ? "none, nothing is wired" : String.join(", ", pins)));
        }
        changed();
    }

    /** Removes the wire at a digital pin. */
    public void unwire(int pin) {
        unwire(Integer.toString(pin));
    }

    /** @param newFirmware MrlComm (default 115200 baud) or StandardFirmata (57600) */
    public void setFirmware(String newFirmware) {
        int old = deliveredBaud();
        firmware = checked("firmware", newFirmware);
        if (getBaud() == old && old != deliveredBaud()) {
            setBaud(deliveredBaud());
        }
        changed();
    }

    /**
     * Lets an Uno run a compiled sketch on a simulated microcontroller, instead of the firmware. {@code Serial.begin}
     * in the sketch sets the baud rate.
     *
     * @param path Intel HEX (.hex) or ELF (.elf) file below assets; null for the firmware
     */
    public void setSketch(String path) {
        if (path == null) {
            checkChangeable();
        } else {
            String wanted = checked("sketch", path);
            String problem = sketchProblem(wanted);
            if (problem != null) {
                throw new IllegalArgumentException(label() + ": sketch is " + ParameterTable.quote(wanted)
                    + ", legal: " + problem);
            }
        }
        sketch = path;
        changed();
    }

    /** Returns the legal values if the board can't run a file by its name, otherwise null. */
    private String sketchProblem(String path) {
        if (path == null || getModel() == null) {
            return null;
        }
        if (getModel().getFlash() == 0) {
            return "none for a " + board + "; SEAR simulates the microcontroller of an uno";
        }
        return ProgramFile.isNamed(path) ? null : "a compiled sketch, .hex or .elf" + (lower(path).endsWith(".ino")
            ? ": compile it first, in the Arduino IDE by Sketch, Export Compiled Binary" : "");
    }

    private int deliveredBaud() {
        return isFirmata() ? FIRMATA_BAUD : MRL_COMM_BAUD;
    }

    @Override
    public SerialParameters getSerial() {
        return serial;
    }
}
