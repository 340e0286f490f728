// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.util.function.Function;
import org.SEAR.devices.FakeContext;
import org.SEAR.protocol.arduino.BoardModel;

/** Boards on a line, with probes that tests connect to their pins. */
final class Boards {
    final FakeContext line = new FakeContext();
    final Pins pins;
    final ArduinoBoard board;

    private Boards(BoardModel model, int baud, Function<Firmware.Host, Firmware> firmware) {
        pins = new Pins(model, "test", line);
        board = line.attach(new ArduinoBoard(model.getTitle(), baud, pins, line, firmware));
    }

    static Boards firmata(BoardModel model) {
        return new Boards(model, 57600, FirmataFirmware::new);
    }

    static Boards mrlComm(BoardModel model) {
        return new Boards(model, 115200, MrlCommFirmware::new);
    }

    /** Connects a probe to a pin, which applies a voltage and records what the board writes. */
    Probe probe(int pin) {
        Probe probe = new Probe();
        pins.connect(pin, probe);
        return probe;
    }

    /** Returns the reply to a command. */
    String answer(String hex) {
        line.take();
        line.host(hex);
        return line.takeHex();
    }

    /** Probe on a pin. */
    static class Probe implements PinWire {
        double volts = Double.NaN;
        double level = Double.NaN;
        int micros;
        double echo = Double.NaN;
        long counts;
        PinWire second;

        @Override
        public double volts() {
            return volts;
        }

        @Override
        public void drive(double newLevel) {
            level = newLevel;
        }

        @Override
        public void pulse(int newMicros) {
            micros = newMicros;
        }

        @Override
        public double echo(PinWire listened) {
            return listened == this || listened == second ? echo : Double.NaN;
        }

        @Override
        public Encoder encoder(PinWire other) {
            return other == second && second != null ? () -> counts : null;
        }

        @Override
        public String describe() {
            return "probe";
        }
    }
}
