// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.util.Locale;
import java.util.Map;
import org.SEAR.protocol.nmea.Nmea;

/** Differences between receivers, as data. Source: recordings of real receivers. */
public enum GpsModel {
    /** San Jose Navigation FV-M8, FV-M11. */
    MT3301(SentenceStyle.MT3301, 200, "MTK3301_1.0") {
        @Override
        String getGreeting() {
            return MEDIATEK;
        }
    },
    /** GlobalTop and others. */
    MT3329(SentenceStyle.MT3329, 100, "AXN_1.30") {
        @Override
        String getGreeting() {
            return MEDIATEK;
        }
    },
    /** u-blox NEO-M8N. */
    NEOM8N(SentenceStyle.UBLOX, 100, "EXT CORE 3.01 (107900)") {
        @Override
        String getGreeting() {
            StringBuilder text = new StringBuilder();
            for (String line : UBLOX) {
                text.append(Nmea.sentence("GNTXT,01,01,02," + line));
            }
            return text.toString();
        }
    };

    private static final String MEDIATEK = Nmea.sentence("PMTK010,001")
        + "$POLYN,TIME,RESTART_OCCURRED\r\n$POLYN,EPH,0,00000000\r\n$POLYN,ALM,0,00000000\r\n";
    private static final String[] UBLOX = {"u-blox AG - www.u-blox.com", "HW UBX-M8030 00080000",
        "EXT CORE 3.01 (107900)", "ROM BASE 3.01 (107888)",
        "FWVER=SPG 3.01", "PROTVER=18.00", "MOD=NEO-M8N-0", "FIS=0xC22536 (100111)", "GPS;GLO;GAL;BDS",
            "SBAS;IMES;QZSS", "ANTSTATUS=OK"};
    private static final Map<String, GpsModel> ALIASES = Map.of("FVM8", MT3301, "FVM11", MT3301, "UBLOX", NEOM8N);

    private final SentenceStyle style;
    private final int shortestPeriod;
    private final String release;

    GpsModel(SentenceStyle style, int shortestPeriod, String release) {
        this.style = style;
        this.shortestPeriod = shortestPeriod;
        this.release = release;
    }

    /**
     * Finds a model by name, in any spelling. FV-M8 and FV-M11 are MT3301, u-blox is NEO-M8N.
     *
     * @throws IllegalArgumentException that lists the valid models
     */
    public static GpsModel of(String name) {
        String plain = name.replaceAll("[^A-Za-z0-9]", "").toUpperCase(Locale.ROOT);
        for (GpsModel model : values()) {
            if (model.name().equals(plain) || model == ALIASES.get(plain)) {
                return model;
            }
        }
        throw new IllegalArgumentException("GPS model is \"" + name + "\", legal: MT3301 (also FV-M8, FV-M11), MT3329, "
            + "NEO-M8N (also u-blox)");
    }

    SentenceStyle getStyle() {
        return style;
    }

    /** Shortest fix interval, milliseconds. */
    public int getShortestPeriod() {
        return shortestPeriod;
    }

    /** Firmware version as reported to a query. */
    String getRelease() {
        return release;
    }

    /** Sentences sent at power-on. */
    abstract String getGreeting();
}
