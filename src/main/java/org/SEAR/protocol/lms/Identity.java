package org.SEAR.protocol.lms;

/** What is printed on one LMS200: data that its telegrams repeat. Immutable. */
public final class Identity {
    /** The device of SICK's telegram listing; drivers know its type. */
    public static final Identity LMS200_30106 = new Identity("LMS200;301063;V02.10 ", "00000000", 0);
    private static final int VERSION_SIZE = 7;

    private final String type;
    private final String serial;
    private final int address;

    /**
     * @param type 21 characters, the last 7 are the version of the software, for example {@code "LMS200;301063;V02.10 "}
     * @param serial 8 characters
     * @param address 0 to 127; with 0 the device answers broadcasts only
     */
    public Identity(String type, String serial, int address) {
        this.type = type;
        this.serial = serial;
        this.address = address;
    }

    /** Type, part number and version. */
    public String getType() {
        return type;
    }

    /** Version of the system software, 7 characters. */
    public String getVersion() {
        return type.substring(type.length() - VERSION_SIZE);
    }

    /** Serial number, 8 characters. */
    public String getSerial() {
        return serial;
    }

    /** Own address, 0 to 127. */
    public int getAddress() {
        return address;
    }
}
