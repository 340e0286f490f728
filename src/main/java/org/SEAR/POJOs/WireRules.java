package org.SEAR.POJOs;

import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.protocol.arduino.BoardModel;
import org.SEAR.protocol.arduino.WireRole;

/** Which wires a board takes, and in words which it would. Any thread. */
public final class WireRules {
    private static final int FIRST_FREE = 2;
    private static final String KINDS = "a Bumper, Distance, Led, LineSensor, Motor or Servo";

    private WireRules() {
    }

    /**
     * Why a pin can't take a wire, in words; null if it can.
     *
     * @param others wires that are there already
     */
    static String reason(BoardModel board, List<BoardWire> others, String pin, WireRole role) {
        int number = board.pinOf(pin);
        if (number < 0) {
            return "no pin of " + article(board);
        }
        if (!board.can(number, role.getUse())) {
            return "not " + role.getUse().getWords() + " of " + article(board) + (number < FIRST_FREE ? ": 0 and 1 are its serial line" : "");
        }
        BoardWire there = wireAt(board, others, number);
        return there == null ? null : "wired to " + there.getPart() + " (" + there.getRole().getWord() + ") already";
    }

    /** The pins that can still take a wire. */
    static String legal(BoardModel board, List<BoardWire> others, WireRole role) {
        return board.pinsFor(role.getUse(), pin -> wireAt(board, others, pin) == null) + " for " + role.getWord();
    }

    private static BoardWire wireAt(BoardModel board, List<BoardWire> wires, int pin) {
        return wires.stream().filter(wire -> wire.getRole() != null && board.pinOf(wire.getPin()) == pin).findFirst().orElse(null);
    }

    /** The wire of a component that is for the same already; null if there is none. */
    static BoardWire same(List<BoardWire> wires, String part, WireRole role) {
        return wires.stream().filter(wire -> part.equals(wire.getPart()) && wire.getRole() == role).findFirst().orElse(null);
    }

    /**
     * Why a component can't have a wire.
     *
     * @param role null for the one that is meant where nothing is said
     * @return what is wrong and what is legal; null if nothing is wrong
     */
    public static String problem(SearObject part, WireRole role) {
        if (!(part instanceof Wirable) || ((Wirable) part).getWireRoles().isEmpty()) {
            return part + " has no wires for the pins of an Arduino, legal: " + KINDS;
        }
        return role == null || ((Wirable) part).getWireRoles().contains(role) ? null : "role is \"" + role.getWord() + "\", legal for " + part + ": "
            + words(((Wirable) part).getWireRoles());
    }

    static String words(List<WireRole> roles) {
        return roles.stream().map(WireRole::getWord).collect(Collectors.joining(", "));
    }

    private static String article(BoardModel board) {
        return (board == BoardModel.UNO ? "an " : "a ") + board.getTitle();
    }
}
