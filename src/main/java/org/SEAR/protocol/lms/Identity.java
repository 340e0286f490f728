package org.SEAR.protocol.lms;

import java.util.List;
import java.util.Set;

/** What is printed on one LMS2xx: data that its telegrams repeat. Immutable. */
public final class Identity {
    /** The device of SICK's telegram listing; drivers know its type. */
    public static final Identity LMS200_30106 = new Identity("LMS200;301063;V02.10 ", "00000000", 0);
    /** Outdoors; drivers know it by the first ten characters of its type. */
    public static final Identity LMS221_30206 = new Identity("LMS221;302063;V02.10 ", "00000000", 0);
    /** Outdoors; drivers know it by the first ten characters of its type. */
    public static final Identity LMS291_S05 = new Identity("LMS291;S05063;V02.10 ", "00000000", 0);
    private static final List<Identity> ALL = List.of(LMS200_30106, LMS221_30206, LMS291_S05);
    private static final Set<String> INDOOR = Set.of("LMS200", "LMS220");
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

    /**
     * The device of a model.
     *
     * @throws IllegalArgumentException if there is none of that name
     */
    public static Identity of(String model) {
        return ALL.stream().filter(one -> one.getModel().equals(model)).findFirst().orElseThrow(() -> new IllegalArgumentException(
            "no type is known of an LMS2xx that is an " + model));
    }

    /** {@code LMS291}. */
    public String getModel() {
        return type.substring(0, type.indexOf(';'));
    }

    /** Whether it measures indoors, in millimetres as delivered; the others in centimetres. */
    public boolean isIndoor() {
        return INDOOR.contains(getModel());
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
