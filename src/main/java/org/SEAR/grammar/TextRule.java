// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.nio.charset.StandardCharsets;
import java.text.Normalizer;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import org.SEAR.protocol.lidar.LidarModel;

/** Syntax of a text parameter, with a description in words. Immutable, any thread. */
public enum TextRule {
    /** Any single line. */
    ANY("one line of at most 200 characters") {
        @Override
        boolean allows(String text) {
            return true;
        }
    },
    /** A line of a drawing by characters, whose first characters may be blanks. */
    DRAWING("one line of at most 200 characters, drawn from its first one") {
        @Override
        boolean allows(String text) {
            return true;
        }
    },
    /** The name of an object, usable as a file name on every system. */
    NAME("a name of 1 to 100 characters that can be a file name on every system: none of / \\ : * ? \" < > |, no dot "
        + "or blank at either end, not a device name such as CON") {
        @Override
        boolean allows(String text) {
            String stem = text.split("\\.", 2)[0].trim().toUpperCase(Locale.ROOT);
            return text.length() <= 100
                && text.getBytes(StandardCharsets.UTF_8).length <= MAX_BYTES
                && !text.isEmpty() && !FORBIDDEN.matcher(text).find() && !EDGES.matcher(text).find()
                && !DEVICES.contains(stem);
        }
    },
    /** The file of a robot's component: {@code name} or {@code robot/name}. */
    COMPONENT(NAME.legal + "; or robot/name, at most 190 characters, for a file in the robot's own folder") {
        @Override
        boolean allows(String text) {
            int slash = text.indexOf('/');
            return NAME.allows(text.substring(slash + 1))
                && (slash < 0 || NAME.allows(text.substring(0, slash)) && text.length() <= MAX_COMPONENT);
        }
    },
    /** A file below assets, with forward slashes. */
    ASSET("a file below assets: forward slashes, no '..', neither drive nor leading slash, at most 200 characters") {
        @Override
        boolean allows(String text) {
            String path = text.startsWith("./") ? text.substring(2) : text;
            if (path.isEmpty() || path.endsWith("/")) {
                return false;
            }
            for (String part : path.split("/")) {
                if (!NAME.allows(part)) {
                    return false;
                }
            }
            return true;
        }
    },
    /** A port export, see {@link ExportTarget}. */
    EXPORT(ExportTarget.LEGAL) {
        @Override
        boolean allows(String text) {
            return ExportTarget.isLegal(text);
        }
    },
    COLOR("a colour: #rrggbb, or " + String.join(", ", ColorNames.all())) {
        @Override
        boolean allows(String text) {
            return ColorNames.hex(text) != null;
        }
    },
    /** A GPS receiver; case and punctuation are ignored: fv_m8 is an FV-M8. */
    GPS_MODEL("MT3301 (also FV-M8, FV-M11), MT3329 or NEO-M8N (also u-blox)") {
        @Override
        boolean allows(String text) {
            return RECEIVERS.contains(plain(text));
        }
    },
    /** A laser scanner; case and punctuation are ignored: urg04lx is a URG-04LX. */
    LIDAR_MODEL(LidarModel.names()) {
        @Override
        boolean allows(String text) {
            return LidarModel.isKnown(text);
        }
    };

    private static final Pattern FORBIDDEN = Pattern.compile("[/\\\\:*?\"<>|\\p{Cntrl}\\x{fffe}\\x{ffff}]");
    private static final Pattern EDGES = Pattern.compile("^[.\\s\\p{Z}]|[.\\s\\p{Z}]$");
    private static final Pattern LINE_BREAKS = Pattern.compile("[\\p{Cntrl}\\x{fffe}\\x{ffff}]");
    private static final Set<String> DEVICES = Set.of("CON", "PRN", "AUX", "NUL", "COM1", "COM2", "COM3", "COM4",
        "COM5", "COM6", "COM7", "COM8", "COM9", "LPT1", "LPT2", "LPT3", "LPT4", "LPT5", "LPT6", "LPT7", "LPT8", "LPT9");
    private static final Set<String> RECEIVERS = Set.of("MT3301", "MT3329", "FVM8", "FVM11", "NEOM8N", "UBLOX");
    private static final Set<String> UBLOX = Set.of("NEOM8N", "UBLOX");
    private static final int MAX_LENGTH = 200;
    /** With {@code robot/} and {@code .xml} this is a path of a bundle. */
    private static final int MAX_COMPONENT = 190;
    /** File systems allow 255 bytes; a temporary file's name is slightly longer than the file's. */
    private static final int MAX_BYTES = 200;

    private final String legal;

    TextRule(String legal) {
        this.legal = legal;
    }

    /** Returns whether a GPS receiver is one by u-blox. */
    public static boolean isUblox(String receiver) {
        return UBLOX.contains(plain(receiver));
    }

    /**
     * Returns a key that is equal for names or paths that some system takes for the same file: case and Unicode
     * composition are ignored.
     */
    public static String onAnySystem(String name) {
        return Normalizer.normalize(name, Normalizer.Form.NFC).toUpperCase(Locale.ROOT).toLowerCase(Locale.ROOT);
    }

    private static String plain(String text) {
        return text.replaceAll("[^A-Za-z0-9]", "").toUpperCase(Locale.ROOT);
    }

    abstract boolean allows(String text);

    /**
     * Returns whether a text is legal.
     *
     * @param text not null
     */
    public boolean isLegal(String text) {
        return text.length() <= MAX_LENGTH && !LINE_BREAKS.matcher(text).find() && wellFormed(text) && allows(text);
    }

    /** Returns the syntax in words. */
    public String legal() {
        return legal;
    }

    /** Returns whether the text has no unpaired surrogate, which no file can store. */
    private static boolean wellFormed(String text) {
        return text.codePoints().noneMatch(c -> c >= Character.MIN_SURROGATE && c <= Character.MAX_SURROGATE);
    }
}
