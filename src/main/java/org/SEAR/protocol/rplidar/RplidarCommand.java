// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.rplidar;

/**
 * Requests that an A1 supports; those from 80h on have a payload. Source: Slamtec's interface protocol, and
 * {@code rplidar_cmd.h} of its kit.
 */
public enum RplidarCommand {
    /** Ends a scan; no answer. */
    STOP(0x25, null),
    /** Restarts the device; its only answer is its banner. */
    RESET(0x40, null),
    /** Nodes of 5 bytes until another request. */
    SCAN(0x20, new Descriptor(Node.SIZE, true, 0x81)),
    /** Nodes as for {@link #SCAN}, without waiting for the motor. */
    FORCE_SCAN(0x21, new Descriptor(Node.SIZE, true, 0x81)),
    /** Capsules of 84 bytes until another request. */
    EXPRESS_SCAN(0x82, new Descriptor(Capsule.SIZE, true, 0x82)),
    /** Model, firmware, hardware, serial number. */
    GET_INFO(0x50, new Descriptor(Info.SIZE, false, 0x04)),
    /** State and error code. */
    GET_HEALTH(0x52, new Descriptor(Health.SIZE, false, 0x06)),
    /** Duration of a sample, us, in SCAN and in EXPRESS_SCAN. */
    GET_SAMPLE_RATE(0x59, new Descriptor(4, false, 0x15));

    private final int code;
    private final Descriptor descriptor;

    RplidarCommand(int code, Descriptor descriptor) {
        this.code = code;
        this.descriptor = descriptor;
    }

    /** Finds a command by code; null if an A1 does not support it. */
    public static RplidarCommand of(int code) {
        for (RplidarCommand command : values()) {
            if (command.code == code) {
                return command;
            }
        }
        return null;
    }

    /** Byte of the request. */
    public int getCode() {
        return code;
    }

    /** Descriptor of its answer; null if it has none. */
    public Descriptor getDescriptor() {
        return descriptor;
    }

    /** Whether the request has a payload. */
    public boolean hasPayload() {
        return RplidarRequestPacket.hasPayload(code);
    }
}
