package org.SEAR.protocol.rplidar;

/** Requests that an A1 knows; those from 80h on have a payload. Source: Slamtec's interface protocol, and {@code rplidar_cmd.h} of its kit. */
public enum RplidarCommand {
    /** Ends scanning; no answer. */
    STOP(0x25, null),
    /** Restarts the device; no answer but its banner. */
    RESET(0x40, null),
    /** Nodes of 5 bytes until another request comes. */
    SCAN(0x20, new Descriptor(Node.SIZE, true, 0x81)),
    /** The same, without waiting for the motor. */
    FORCE_SCAN(0x21, new Descriptor(Node.SIZE, true, 0x81)),
    /** Capsules of 84 bytes until another request comes. */
    EXPRESS_SCAN(0x82, new Descriptor(Capsule.SIZE, true, 0x82)),
    /** Model, firmware, hardware, serial number. */
    GET_INFO(0x50, new Descriptor(Info.SIZE, false, 0x04)),
    /** Whether it is well. */
    GET_HEALTH(0x52, new Descriptor(Health.SIZE, false, 0x06)),
    /** Microseconds of a sample, of SCAN and of EXPRESS_SCAN. */
    GET_SAMPLE_RATE(0x59, new Descriptor(4, false, 0x15));

    private final int code;
    private final Descriptor descriptor;

    RplidarCommand(int code, Descriptor descriptor) {
        this.code = code;
        this.descriptor = descriptor;
    }

    /** The command of a code; null if an A1 doesn't know it. */
    public static RplidarCommand of(int code) {
        for (RplidarCommand command : values()) {
            if (command.code == code) {
                return command;
            }
        }
        return null;
    }

    /** Its byte. */
    public int getCode() {
        return code;
    }

    /** What comes before its answer; null if it has none. */
    public Descriptor getDescriptor() {
        return descriptor;
    }

    /** Whether a payload belongs to it. */
    public boolean hasPayload() {
        return RplidarRequestPacket.hasPayload(code);
    }
}
