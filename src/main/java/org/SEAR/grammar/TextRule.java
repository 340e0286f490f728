package org.SEAR.grammar;

import java.nio.charset.StandardCharsets;
import java.text.Normalizer;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import org.SEAR.protocol.lidar.LidarModel;

/** What a text parameter may look like; each rule says in words what is legal. Immutable, any thread. */
public enum TextRule {
    /** Any text in one line. */
    ANY("one line of at most 200 characters") {
        @Override
        boolean allows(String text) {
            return true;
        }
    },
    /** The name of an object, which is the name of its file on every system. */
    NAME("a name of 1 to 100 characters that can be a file name on every system: none of / \\ : * ? \" < > |, no dot or blank at either end,"
        + " not a device name such as CON") {
        @Override
        boolean allows(String text) {
            String stem = text.split("\\.", 2)[0].trim().toUpperCase(Locale.ROOT);
            return text.length() <= 100
                && text.getBytes(StandardCharsets.UTF_8).length <= MAX_BYTES
                && !text.isEmpty() && !FORBIDDEN.matcher(text).find() && !EDGES.matcher(text).find()
                && !DEVICES.contains(stem);
        }
    },
    /** The file of a robot's component: its name, or the robot's and its own with a slash between. */
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
    /** Where a port is exported to. */
    EXPORT(ExportTarget.LEGAL) {
        @Override
        boolean allows(String text) {
            return ExportTarget.isLegal(text);
        }
    },
    /** A colour. */
    COLOR("a colour: #rrggbb, or " + String.join(", ", ColorNames.all())) {
        @Override
        boolean allows(String text) {
            return ColorNames.hex(text) != null;
        }
    },
    /** A GPS receiver, in whatever spelling: fv_m8 is an FV-M8. */
    GPS_MODEL("MT3301 (also FV-M8, FV-M11), MT3329 or NEO-M8N (also u-blox)") {
        @Override
        boolean allows(String text) {
            return RECEIVERS.contains(plain(text));
        }
    },
    /** A laser scanner, in whatever spelling: urg04lx is a URG-04LX. */
    LIDAR_MODEL(LidarModel.names()) {
        @Override
        boolean allows(String text) {
            return LidarModel.isKnown(text);
        }
    };

    private static final Pattern FORBIDDEN = Pattern.compile("[/\\\\:*?\"<>|\\p{Cntrl}\\x{fffe}\\x{ffff}]");
    private static final Pattern EDGES = Pattern.compile("^[.\\s\\p{Z}]|[.\\s\\p{Z}]$");
    private static final Pattern LINE_BREAKS = Pattern.compile("[\\p{Cntrl}\\x{fffe}\\x{ffff}]");
    private static final Set<String> DEVICES = Set.of("CON", "PRN", "AUX", "NUL", "COM1", "COM2", "COM3", "COM4", "COM5", "COM6", "COM7", "COM8",
        "COM9", "LPT1", "LPT2", "LPT3", "LPT4", "LPT5", "LPT6", "LPT7", "LPT8", "LPT9");
    private static final Set<String> RECEIVERS = Set.of("MT3301", "MT3329", "FVM8", "FVM11", "NEOM8N", "UBLOX");
    private static final Set<String> UBLOX = Set.of("NEOM8N", "UBLOX");
    private static final int MAX_LENGTH = 200;
    /** With {@code robot/} and {@code .xml} a path of a bundle. */
    private static final int MAX_COMPONENT = 190;
    /** File systems end at 255 bytes, and a temporary file's name is a little longer. */
    private static final int MAX_BYTES = 200;

    private final String legal;

    TextRule(String legal) {
        this.legal = legal;
    }

    /** Whether a GPS receiver is one of u-blox. */
    public static boolean isUblox(String receiver) {
        return UBLOX.contains(plain(receiver));
    }

    /** Two names or paths for which this is the same are one on some system: capitals do not count there, nor how an accent is spelt. */
    public static String onAnySystem(String name) {
        return Normalizer.normalize(name, Normalizer.Form.NFC).toUpperCase(Locale.ROOT).toLowerCase(Locale.ROOT);
    }

    private static String plain(String text) {
        return text.replaceAll("[^A-Za-z0-9]", "").toUpperCase(Locale.ROOT);
    }

    abstract boolean allows(String text);

    /**
     * Whether a text is legal.
     *
     * @param text not null
     */
    public boolean isLegal(String text) {
        return text.length() <= MAX_LENGTH && !LINE_BREAKS.matcher(text).find() && wellFormed(text) && allows(text);
    }

    /** What is legal, in words. */
    public String legal() {
        return legal;
    }

    /** Half of a surrogate pair can be written to no file. */
    private static boolean wellFormed(String text) {
        return text.codePoints().noneMatch(c -> c >= Character.MIN_SURROGATE && c <= Character.MAX_SURROGATE);
    }
}
