// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

import java.util.List;
import java.util.Set;

/** Identity of one LMS2xx, which its telegrams contain. Immutable. */
public final class Identity {
    /** The device of SICK's telegram listing; drivers recognise its type. */
    public static final Identity LMS200_30106 = new Identity("LMS200;301063;V02.10 ", "00000000", 0);
    /** Outdoor device; drivers recognise the first ten characters of its type. */
    public static final Identity LMS221_30206 = new Identity("LMS221;302063;V02.10 ", "00000000", 0);
    /** Outdoor device; drivers recognise the first ten characters of its type. */
    public static final Identity LMS291_S05 = new Identity("LMS291;S05063;V02.10 ", "00000000", 0);
    private static final List<Identity> ALL = List.of(LMS200_30106, LMS221_30206, LMS291_S05);
    private static final Set<String> INDOOR = Set.of("LMS200", "LMS220");
    private static final int VERSION_SIZE = 7;

    private final String type;
    private final String serial;
    private final int address;

    /**
     * @param type 21 characters, the last 7 are the software version, for example {@code "LMS200;301063;V02.10 "}
     * @param serial 8 characters
     * @param address 0 to 127; with 0 the device answers broadcasts only
     */
    public Identity(String type, String serial, int address) {
        this.type = type;
        this.serial = serial;
        this.address = address;
    }

    /**
     * Finds the identity of a model.
     *
     * @throws IllegalArgumentException if the model is unknown
     */
    public static Identity of(String model) {
        return ALL.stream().filter(one -> one.getModel().equals(model)).findFirst()
            .orElseThrow(() -> new IllegalArgumentException("SEAR knows no LMS2xx model " + model));
    }

    /** Model name, for example {@code LMS291}. */
    public String getModel() {
        return type.substring(0, type.indexOf(';'));
    }

    /** Whether it is an indoor device, with millimetres as delivered; other devices have centimetres. */
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

    /** Address, 0 to 127. */
    public int getAddress() {
        return address;
    }
}
