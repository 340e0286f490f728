// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.nmea.Pmtk;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;

/** Receiver models that the GPS service supports. Immutable, any thread. */
public enum ReceiverModel {
    FV_M8("FV-M8", 5, Language.PMTK),
    MT3301("MT3301", 5, Language.PMTK),
    MT3329("MT3329", 10, Language.PMTK),
    NEO_M8N("NEO-M8N", 10, Language.UBX),
    /** Any other receiver; gets no commands. */
    NMEA("NMEA", 0, Language.NONE);

    /** Slowest rate that all models accept, Hz. */
    private static final double SLOWEST = 0.1;
    private static final double MILLIS = 1000;
    private static final int PORT_SIZE = 20;
    private static final int EIGHT_BITS_NO_PARITY = 0x08D0;
    private static final int IN_PROTOCOLS = 7;
    private static final int OUT_PROTOCOLS = 3;
    private static final String UBLOX = "UBLOX";

    /** Command languages of the receivers. */
    private enum Language { PMTK, UBX, NONE }

    private final String label;
    private final double fastest;
    private final Language language;

    ReceiverModel(String label, double fastest, Language language) {
        this.label = label;
        this.fastest = fastest;
        this.language = language;
    }

    /**
     * Returns a model by name. Ignores case and punctuation; "u-blox" means NEO-M8N.
     *
     * @throws IllegalArgumentException with the legal names
     */
    public static ReceiverModel of(String name) {
        String plain = name == null ? "" : plain(name);
        for (ReceiverModel model : values()) {
            if (plain(model.label).equals(plain) || model == NEO_M8N && UBLOX.equals(plain)) {
                return model;
            }
        }
        throw new IllegalArgumentException("GPS model is \"" + name + "\", legal: " + names());
    }

    private static String plain(String name) {
        return name.replaceAll("[^A-Za-z0-9]", "").toUpperCase(Locale.ROOT);
    }

    public static List<String> names() {
        List<String> names = new ArrayList<>();
        for (ReceiverModel model : values()) {
            names.add(model.label);
        }
        return names;
    }

    public String getLabel() {
        return label;
    }

    public boolean takesCommands() {
        return language != Language.NONE;
    }

    /** Returns the factory baud rate. */
    public int deliveredBaud() {
        return language == Language.UBX ? 9600 : 38400;
    }

    /**
     * Returns the baud rate if it is legal.
     *
     * @throws IllegalArgumentException with the legal rates
     */
    public int checkedBaud(int baud) {
        List<Integer> bauds = language == Language.UBX ? UbxFrame.BAUDS : Pmtk.BAUDS;
        if (!bauds.contains(baud)) {
            throw new IllegalArgumentException("GPS baud rate is " + baud + ", legal: " + bauds);
        }
        return baud;
    }

    /** Returns the command that changes the baud rate; empty for NMEA. */
    public byte[] baudCommand(int baud) {
        switch (language) {
            case PMTK:
                return sentence(Pmtk.SET_BAUD.body(baud));
            case UBX:
                return new UbxFrame(UbxMessage.CFG_PRT, UbxFrame.room(PORT_SIZE).putShort((short) 1).putShort((short) 0)
                    .putInt(EIGHT_BITS_NO_PARITY)
                    .putInt(baud).putShort((short) IN_PROTOCOLS).putShort((short) OUT_PROTOCOLS).array()).toBytes();
            default:
                return new byte[0];
        }
    }

    /**
     * Returns the command that sets the rate of fixes.
     *
     * @throws IllegalArgumentException with the legal range
     */
    public byte[] rateCommand(double hertz) {
        if (language == Language.NONE) {
            throw new IllegalArgumentException("GPS rate is " + hertz + " Hz, but model NMEA takes no commands: "
                + "setModel first, legal: " + names());
        }
        if (!(hertz >= SLOWEST && hertz <= fastest)) {
            throw new IllegalArgumentException("GPS rate is " + hertz + " Hz, legal for " + label + ": " + SLOWEST
                + " to " + fastest);
        }
        int millis = (int) Math.round(MILLIS / hertz);
        return language == Language.PMTK ? sentence(Pmtk.SET_PERIOD.body(millis)) : new UbxFrame(UbxMessage.CFG_RATE,
            UbxFrame.room(6).putShort((short) millis).putShort((short) 1).putShort((short) 1).array()).toBytes();
    }

    /** Returns the query for the firmware version; empty for NMEA. */
    public byte[] firmwareQuestion() {
        switch (language) {
            case PMTK:
                return sentence(Pmtk.QUERY_RELEASE.body());
            case UBX:
                return new UbxFrame(UbxMessage.MON_VER).toBytes();
            default:
                return new byte[0];
        }
    }

    /**
     * Returns the model for the release of MediaTek firmware: {@code MTK3301_1.0} means MT3301, {@code AXN_1.30} means
     * MT3329. Returns null for others.
     */
    public static ReceiverModel ofRelease(String release) {
        return release.contains("3301") ? MT3301 : release.startsWith("AXN") ? MT3329 : null;
    }

    private static byte[] sentence(String body) {
        return Nmea.sentence(body).getBytes(StandardCharsets.US_ASCII);
    }
}
