// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.arduino.WireRole;

/** Rules for the wires of a board, with their messages. Any thread. */
public final class WireRules {
    private static final int FIRST_FREE = 2;
    private static final String KINDS = "a Bumper, Distance, Led, LineSensor, Motor or Servo";

    private WireRules() {
    }

    /**
     * Returns why a pin can't take a wire, in words; null if it can.
     *
     * @param others the present wires
     */
    static String reason(BoardModel board, List<BoardWire> others, String pin, WireRole role) {
        int number = board.pinOf(pin);
        if (number < 0) {
            return "no pin of " + article(board);
        }
        if (!board.can(number, role.getUse())) {
            return "not " + role.getUse().getWords() + " of " + article(board)
                + (number < FIRST_FREE ? ": 0 and 1 are its serial line" : "");
        }
        BoardWire there = wireAt(board, others, number);
        return there == null ? null : "wired to " + there.getPart() + " (" + there.getRole().getWord() + ") already";
    }

    /** Returns the free pins for a role, in words. */
    static String legal(BoardModel board, List<BoardWire> others, WireRole role) {
        return board.pinsFor(role.getUse(), pin -> wireAt(board, others, pin) == null) + " for " + role.getWord();
    }

    private static BoardWire wireAt(BoardModel board, List<BoardWire> wires, int pin) {
        return wires.stream().filter(wire -> wire.getRole() != null && board.pinOf(wire.getPin()) == pin).findFirst()
            .orElse(null);
    }

    /** Returns the wire of a component with the same role; null if there is none. */
    static BoardWire same(List<BoardWire> wires, String part, WireRole role) {
        return wires.stream().filter(wire -> part.equals(wire.getPart()) && wire.getRole() == role).findFirst()
            .orElse(null);
    }

    /**
     * Checks whether a component can have a wire.
     *
     * @param role null for the component's default role
     * @return the problem and the legal values; null if there is no problem
     */
    public static String problem(SearObject part, WireRole role) {
        if (!(part instanceof Wirable) || ((Wirable) part).getWireRoles().isEmpty()) {
            return part + " has no wires for the pins of an Arduino, legal: " + KINDS;
        }
        return role == null || ((Wirable) part).getWireRoles().contains(role) ? null : "role is \"" + role.getWord()
            + "\", legal for " + part + ": " + words(((Wirable) part).getWireRoles());
    }

    static String words(List<WireRole> roles) {
        return roles.stream().map(WireRole::getWord).collect(Collectors.joining(", "));
    }

    private static String article(BoardModel board) {
        return (board == BoardModel.UNO ? "an " : "a ") + board.getTitle();
    }
}
