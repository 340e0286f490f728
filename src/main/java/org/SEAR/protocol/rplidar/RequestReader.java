// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.rplidar;

import java.util.Arrays;
import java.util.function.Consumer;

/** Finds requests in a host's output. Skips requests with a wrong checksum. One thread at a time. */
public final class RequestReader {
    private final Consumer<RplidarRequestPacket> requests;
    private final byte[] payload = new byte[256];
    private State state = State.IDLE;
    private int code;
    private int length;
    private int count;
    private int sum;

    private enum State { IDLE, CODE, LENGTH, PAYLOAD, SUM }

    public RequestReader(Consumer<RplidarRequestPacket> requests) {
        this.requests = requests;
    }

    /** @param value 0 to 255 */
    public void accept(int value) {
        switch (state) {
            case CODE:
                readCode(value);
                break;
            case LENGTH:
                length = value;
                count = 0;
                state = value == 0 ? State.SUM : State.PAYLOAD;
                break;
            case PAYLOAD:
                payload[count++] = (byte) value;
                state = count < length ? State.PAYLOAD : State.SUM;
                break;
            case SUM:
                state = State.IDLE;
                if (value == sum) {
                    requests.accept(new RplidarRequestPacket(code, Arrays.copyOf(payload, length)));
                }
                break;
            default:
                state = value == RplidarRequestPacket.START ? State.CODE : State.IDLE;
                sum = 0;
                break;
        }
        sum ^= value;
    }

    private void readCode(int value) {
        code = value;
        if (RplidarRequestPacket.hasPayload(value)) {
            state = value == RplidarRequestPacket.START ? State.CODE : State.LENGTH;
        } else {
            state = State.IDLE;
            requests.accept(new RplidarRequestPacket(value));
        }
    }

    /** Discards an incomplete request. */
    public void clear() {
        state = State.IDLE;
    }
}
