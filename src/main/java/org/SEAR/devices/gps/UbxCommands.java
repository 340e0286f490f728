// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.nio.ByteBuffer;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;

/**
 * Commands of u-blox receivers. Settings are acknowledged and polls answered. Unknown settings and illegal values get
 * ACK-NAK; other unknown messages get no answer.
 */
final class UbxCommands {
    private static final int USED_MODE_BITS = 0x3CC0;
    private static final int MASKS_SIZE = 12;
    private static final int RESET_SIZE = 4;
    private static final int MAX_CYCLES = 127;
    private static final int OUT_MASK = UbxSettings.UBX | UbxSettings.NMEA;
    private static final int IN_MASK = OUT_MASK | UbxSettings.RTCM;
    /** Number of UART 2, which this receiver lacks. */
    private static final int NO_PORT = 2;
    private static final int LAST_PORT = 4;

    private final NeoM8n device;

    UbxCommands(NeoM8n device) {
        this.device = device;
    }

    void execute(UbxFrame frame, double time) {
        if (frame.getMessage() == UbxMessage.CFG_RST) {
            reset(frame, time);
        } else if (frame.getGroup() == UbxMessage.CFG) {
            boolean done = frame.getMessage() != null && (poll(frame, time) || set(frame, time));
            device.answer(new UbxFrame(done ? UbxMessage.ACK_ACK : UbxMessage.ACK_NAK, (byte) frame.getGroup(),
                (byte) frame.getId()), time);
            if (done && frame.getMessage() == UbxMessage.CFG_PRT || frame.getMessage() == UbxMessage.CFG_CFG) {
                device.followBaud(time);
            }
        } else if (frame.getLength() == 0 && frame.getMessage() != null) {
            device.answerPoll(frame.getMessage(), time);
        }
    }

    /**
     * Answers a poll of a setting.
     *
     * @return whether it is a poll with an answer
     */
    private boolean poll(UbxFrame frame, double time) {
        byte[] answer = settingAskedFor(frame);
        if (answer != null) {
            device.answer(new UbxFrame(frame.getMessage(), answer), time);
        }
        return answer != null;
    }

    private byte[] settingAskedFor(UbxFrame frame) {
        UbxSettings settings = device.getSettings();
        ByteBuffer payload = frame.read();
        switch (frame.getMessage()) {
            case CFG_PRT:
                int port = frame.getLength() == 1 ? payload.get(0) : UbxSettings.UART;
                return frame.getLength() <= 1 && isPort(port) ? settings.ports[port] : null;
            case CFG_MSG:
                byte[] rates = frame.getLength() == 2 ? settings.rates.get(message(payload)) : null;
                return rates == null ? null : UbxFrame.room(2 + UbxSettings.PORTS).put(frame.getPayload())
                    .put(rates).array();
            case CFG_RATE:
                return frame.getLength() == 0 ? settings.rate : null;
            default:
                return frame.getLength() == 0 ? settings.kept.get(frame.getMessage()) : null;
        }
    }

    private static boolean isPort(int port) {
        return port >= 0 && port <= LAST_PORT && port != NO_PORT;
    }

    private static UbxMessage message(ByteBuffer payload) {
        return UbxMessage.of(payload.get(0) & 0xFF, payload.get(1) & 0xFF);
    }

    private boolean set(UbxFrame frame, double time) {
        switch (frame.getMessage()) {
            case CFG_PRT:
                return frame.getLength() == UbxSettings.PORT_SIZE && setPort(frame);
            case CFG_MSG:
                return setRates(frame);
            case CFG_RATE:
                return frame.getLength() == UbxSettings.RATE_SIZE && setPeriod(frame, time);
            case CFG_CFG:
                return configure(frame, time);
            default:
                return device.getSettings().kept.set(frame.getMessage(), frame.getPayload());
        }
    }

    private boolean setPort(UbxFrame frame) {
        ByteBuffer payload = UbxFrame.room(UbxSettings.PORT_SIZE).put(frame.getPayload());
        int port = payload.get(0);
        boolean legal = isPort(port) && (port != UbxSettings.UART
            || UbxFrame.BAUDS.contains(payload.getInt(UbxSettings.BAUD_AT))
            && (payload.getInt(UbxSettings.MODE_AT) & USED_MODE_BITS) == (UbxSettings.MODE & USED_MODE_BITS));
        if (legal) {
            payload.putShort(UbxSettings.IN_AT, (short) (payload.getShort(UbxSettings.IN_AT) & IN_MASK));
            payload.putShort(UbxSettings.OUT_AT, (short) (payload.getShort(UbxSettings.OUT_AT) & OUT_MASK));
            device.getSettings().ports[port] = payload.array();
        }
        return legal;
    }

    private boolean setRates(UbxFrame frame) {
        ByteBuffer payload = frame.read();
        byte[] rates = frame.getLength() >= 2 ? device.getSettings().rates.get(message(payload)) : null;
        if (rates == null) {
            return false;
        }
        if (frame.getLength() == 3) {
            rates[UbxSettings.UART] = payload.get(2);
        } else if (frame.getLength() == 2 + UbxSettings.PORTS) {
            System.arraycopy(frame.getPayload(), 2, rates, 0, UbxSettings.PORTS);
        } else {
            return false;
        }
        return true;
    }

    private boolean setPeriod(UbxFrame frame, double time) {
        ByteBuffer payload = frame.read();
        int millis = payload.getShort() & 0xFFFF;
        int cycles = payload.getShort() & 0xFFFF;
        int reference = payload.getShort();
        boolean legal = millis >= device.getModel().getShortestPeriod() && cycles >= 1 && cycles <= MAX_CYCLES
            && (reference == 0 || reference == 1);
        if (legal) {
            System.arraycopy(frame.getPayload(), 0, device.getSettings().rate, 0, UbxSettings.RATE_SIZE);
            device.setPeriod(device.getSettings().period(), time);
        }
        return legal;
    }

    /** Clears saved settings, saves the present ones, and loads saved ones, each with a mask (CFG-CFG). */
    private boolean configure(UbxFrame frame, double time) {
        boolean legal = frame.getLength() == MASKS_SIZE || frame.getLength() == MASKS_SIZE + 1;
        if (legal) {
            ByteBuffer payload = frame.read();
            device.getSaved().copy(device.getDelivered(), payload.getInt());
            device.getSaved().copy(device.getSettings(), payload.getInt());
            device.getSettings().copy(device.getSaved(), payload.getInt());
            if (device.getSettings().period() != device.getPeriod()) {
                device.setPeriod(device.getSettings().period(), time);
            }
        }
        return legal;
    }

    /** Runs CFG-RST: a mask of the data to clear, 0 for a hot start, and the reset mode. */
    private void reset(UbxFrame frame, double time) {
        if (frame.getLength() == RESET_SIZE) {
            ByteBuffer payload = frame.read();
            device.restart(payload.getShort() != 0, payload.get(), time);
        }
    }
}
