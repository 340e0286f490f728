// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.io.IOException;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Hints for names that a script can't import or has not imported. Any thread. */
final class WrongNames {
    private static final String SERVICES = "org.myrobotlab.service";
    private static final String OBJECTS = "org.SEAR.POJOs";
    private static final String IMPORT = "from " + OBJECTS + " import ";
    private static final Pattern NO_MODULE = Pattern.compile("No module named (\\w+)");
    private static final Pattern NOTHING_IN_IT = Pattern.compile("cannot import name (\\w+)");
    /** Popular packages for CPython. */
    private static final Set<String> NOT_IN_JYTHON = Set.of("numpy", "scipy", "pandas", "matplotlib", "cv2", "serial", "pylab", "tkinter",
        "requests");
    private static final Set<String> MODULES = Set.of("math", "time", "random", "os", "json", "threading", "datetime", "csv", "re");
    private static final Set<String> OF_MATH = Set.of("sqrt", "sin", "cos", "tan", "atan", "atan2", "asin", "acos", "pi", "radians", "degrees",
        "hypot", "floor", "ceil", "exp", "log", "fabs");
    private static final Set<String> NOTHING = Set.of("null", "nil", "undefined", "NULL", "none");
    /** Common words for objects of SEAR. */
    private static final Map<String, String> OTHER_WORDS = otherWords();

    private WrongNames() {
    }

    private static Map<String, String> otherWords() {
        Map<String, String> words = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
        for (String sensor : new String[] {"Sonar", "Ultrasonic", "UltrasonicSensor", "Infrared", "Ping", "DistanceSensor", "RangeSensor", "Radar"}) {
            words.put(sensor, "Distance");
        }
        for (String box : new String[] {"Wall", "Cube", "Block", "Crate", "Obstacle"}) {
            words.put(box, "Box");
        }
        words.put("Ball", "Sphere");
        words.put("Ground", "Floor");
        words.put("Plane", "Floor");
        words.put("Robot", "SEARrobot");
        words.put("Rover", "Robots");
        words.put("Create", "Robots");
        words.put("Gyro", "Gyroscope");
        words.put("Accel", "Accelerometer");
        words.put("Light", "Led");
        words.put("Scanner", "LIDAR");
        words.put("Laser", "LIDAR");
        words.put("Sensor", "Distance");
        return words;
    }

    /**
     * Returns a hint for a failed import.
     *
     * @param line the script's line; may be empty
     * @return lines to append to the error; empty without a hint
     */
    static String imported(String message, String line) {
        Matcher module = NO_MODULE.matcher(message);
        Matcher name = NOTHING_IN_IT.matcher(message);
        if (name.find()) {
            String other = line.contains(SERVICES) ? ServiceTypes.hint(name.group(1)) : "";
            return other.isEmpty() ? objectsOf(name.group(1)) : "\n" + other;
        }
        if (!module.find()) {
            return "";
        }
        String wanted = module.group(1);
        if (NOT_IN_JYTHON.contains(wanted)) {
            return "\nscripts are Python 2.7 (Jython), which can't use packages with C code: there is no " + wanted
                + ". sear.savePlot(...) draws plots, and Python 3 programs can call SEAR (docs/python3.md)";
        }
        if (line.contains("org.")) {
            return "\ndid you mean " + IMPORT + "*?";
        }
        String service = known(SERVICES, wanted);
        String object = known(OBJECTS, wanted);
        if (service != null && !line.matches(".*from .*import [A-Z].*")) {
            return "\n" + service + " is a service of MyRobotLab, not a module: write " + start(service) + " instead of the import";
        }
        return service != null || object != null ? "\nimport objects like this: " + IMPORT + "*" : objectsOf(wanted);
    }

    private static String objectsOf(String wanted) {
        String meant = meant(wanted);
        return meant == null ? "" : "\nSEAR has no " + wanted + "; did you mean " + IMPORT + meant + "?";
    }

    /**
     * Returns a hint for a name that the script has not imported.
     *
     * @return a line to append to the error; empty without a hint
     */
    static String used(String wanted) {
        String service = exactly(SERVICES, wanted);
        if (exactly(OBJECTS, wanted) != null) {
            return "\nimport it first: " + IMPORT + wanted + (service == null ? "" : "; or, for the service, " + start(wanted));
        }
        if (service != null) {
            return "\nstart a service like this: " + start(wanted);
        }
        String meant = OTHER_WORDS.get(wanted);
        return meant == null || !Character.isUpperCase(wanted.charAt(0)) ? "" : "\nSEAR has no " + wanted + "; did you mean " + IMPORT + meant + "?";
    }

    /** Returns a hint line for a name of a Python module, or another language's None; else empty. */
    static String ofPython(String wanted) {
        if (MODULES.contains(wanted)) {
            return "\nit is a Python module: write import " + wanted + " in an earlier line";
        }
        return OF_MATH.contains(wanted) ? "\nit is in a Python module: from math import " + wanted
            : NOTHING.contains(wanted) ? "\ndid you mean None?" : "";
    }

    /**
     * Returns a hint for a service's class called like a constructor.
     *
     * @return a line to append to the error; empty for any other class
     */
    static String made(String message) {
        Matcher made = Pattern.compile("^org\\.myrobotlab\\.service\\.(\\w+)\\(\\): ").matcher(message);
        if (!made.find()) {
            return "";
        }
        String name = made.group(1);
        return exactly(OBJECTS, name) == null ? "\nstart a service like this: " + start(name)
            : "\n" + name + " is the service's class here, because a service of that type was started. After that line write "
                + IMPORT + name + " to use the object";
    }

    private static String start(String service) {
        String name = service.toLowerCase(Locale.ROOT);
        return name + " = Runtime.start(\"" + name + "\", \"" + service + "\")";
    }

    /** Returns the object for a name in other letter case, or a common word for it; null if there is none. */
    private static String meant(String wanted) {
        String known = known(OBJECTS, wanted);
        return known != null ? known : OTHER_WORDS.get(wanted);
    }

    private static String exactly(String where, String wanted) {
        String known = known(where, wanted);
        return wanted.equals(known) ? known : null;
    }

    private static String known(String where, String wanted) {
        try {
            return PackageClasses.of(where, WrongNames.class.getClassLoader()).stream().filter(wanted::equalsIgnoreCase).findFirst().orElse(null);
        } catch (IOException e) {
            return null;
        }
    }
}
