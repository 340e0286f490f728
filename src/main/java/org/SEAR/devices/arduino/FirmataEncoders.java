// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

import java.util.Arrays;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.SEAR.protocol.arduino.PinUse;
import org.SEAR.protocol.firmata.EncoderMessage;
import org.SEAR.protocol.firmata.FirmataMessage;

/** The encoder feature: counts of up to five encoders with two pins each. Pins without an encoder give no counts. */
final class FirmataEncoders {
    private static final int PINS = 2;

    private final Pins pins;
    private final PinWire.Encoder[] encoders = new PinWire.Encoder[EncoderMessage.ENCODERS];
    private final long[] zeros = new long[EncoderMessage.ENCODERS];
    private boolean automatic;

    FirmataEncoders(Pins pins) {
        this.pins = pins;
    }

    void clear() {
        Arrays.fill(encoders, null);
        automatic = false;
    }

    /** Whether a motor's encoder is wired to a pin. */
    boolean isTrack(int pin) {
        return IntStream.range(0, pins.board().getPins())
            .anyMatch(other -> other != pin && pins.encoder(pin, other) != null);
    }

    void execute(FirmataMessage message, Consumer<FirmataMessage> answer) {
        int number = message.get(1);
        boolean known = number < encoders.length;
        switch (message.size() == 0 ? -1 : message.get(0)) {
            case EncoderMessage.ATTACH:
                if (known && message.size() > 1 + PINS) {
                    attach(number, message.get(PINS), message.get(PINS + 1));
                }
                break;
            case EncoderMessage.REPORT:
                if (known && encoders[number] != null) {
                    report(new int[] {number}, answer);
                }
                break;
            case EncoderMessage.REPORT_ALL:
                reportAll(answer);
                break;
            case EncoderMessage.RESET:
                if (known && encoders[number] != null) {
                    zeros[number] = encoders[number].counts();
                }
                break;
            case EncoderMessage.AUTOMATIC:
                automatic = number != 0;
                break;
            case EncoderMessage.DETACH:
                if (known) {
                    encoders[number] = null;
                }
                break;
            default:
                break;
        }
    }

    private void attach(int number, int first, int second) {
        if (!pins.board().can(first, PinUse.DIGITAL) || !pins.board().can(second, PinUse.DIGITAL)) {
            return;
        }
        pins.setMode(first, Pins.Mode.PULLUP);
        pins.setMode(second, Pins.Mode.PULLUP);
        PinWire.Encoder found = pins.encoder(first, second);
        encoders[number] = found == null ? () -> 0 : found;
        zeros[number] = encoders[number].counts();
    }

    /** Reports all encoders at a sample, if automatic reports are on. */
    void reportAutomatic(Consumer<FirmataMessage> answer) {
        if (automatic) {
            reportAll(answer);
        }
    }

    private void reportAll(Consumer<FirmataMessage> answer) {
        report(IntStream.range(0, encoders.length).filter(i -> encoders[i] != null).toArray(), answer);
    }

    private void report(int[] numbers, Consumer<FirmataMessage> answer) {
        if (numbers.length > 0) {
            answer.accept(EncoderMessage.positions(
                numbers, IntStream.of(numbers).mapToLong(i -> encoders[i].counts() - zeros[i]).toArray()));
        }
    }
}
