// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Test;

/** Packages of the plug-in and their layers: each imports only from packages below it. */
public class RoomsTest {
    /** Every package, top to bottom. */
    private static final List<String> ROOMS = Arrays.asList(
        "org.myrobotlab.service", "org.myrobotlab.service.lidar", "org.myrobotlab.service.lidar.requests",
        "org.myrobotlab.service.gps", "org.myrobotlab.service.meta",
        "org.myrobotlab.service.config",
        "org.myrobotlab.service.sear.panel", "org.myrobotlab.service.sear.records",
        "org.myrobotlab.service.sear.netcam", "org.myrobotlab.service.sear.python3",
        "org.myrobotlab.service.sear.readings", "org.myrobotlab.service.sear.files",
        "org.myrobotlab.service.sear.export", "org.myrobotlab.service.sear.run", "org.myrobotlab.service.sear.lockstep",
        "org.myrobotlab.service.sear.tcp", "org.myrobotlab.service.sear", "org.myrobotlab.service.link",
        "org.myrobotlab.serial",
        "org.SEAR.view", "org.SEAR.view.hud", "org.SEAR.view.input", "org.SEAR.view.scene", "org.SEAR.view.terrain",
        "org.SEAR.view.process", "org.SEAR.view.link", "org.SEAR.view.platform",
        "org.SEAR.lessons", "org.SEAR.learning", "org.SEAR.plan", "org.SEAR.scene",
        "org.SEAR.record", "org.SEAR.simulator", "org.SEAR.simulator.orders", "org.SEAR.robot", "org.SEAR.robot.wheel",
        "org.SEAR.robot.servo", "org.SEAR.robot.surface",
        "org.SEAR.physics.start", "org.SEAR.physics", "org.SEAR.physics.joint", "org.SEAR.physics.solid",
        "org.SEAR.devices.oi", "org.SEAR.devices.lms", "org.SEAR.devices.cola", "org.SEAR.devices.scip",
        "org.SEAR.devices.rplidar",
        "org.SEAR.devices.gps", "org.SEAR.devices.imu", "org.SEAR.devices.arduino",
        "org.SEAR.devices.arduino.avr", "org.SEAR.devices",
        "org.SEAR.sensors", "org.SEAR.camera", "org.SEAR.camera.image", "org.SEAR.raycast", "org.SEAR.raycast.solid",
        "org.SEAR.raycast.tree", "org.SEAR.collision",
        "org.SEAR.project.urdf", "org.SEAR.project.bundle", "org.SEAR.project.edit", "org.SEAR.project.script",
        "org.SEAR.project",
        "org.SEAR.project.wiring", "org.SEAR.project.xml", "org.SEAR.project.models", "org.SEAR.project.models.format",
        "org.SEAR.project.problems",
        "org.SEAR.terrain", "org.SEAR.terrain.format", "org.SEAR.terrain.tiff", "org.SEAR.terrain.relief",
        "org.SEAR.plot", "org.SEAR.files",
        "org.SEAR.parallel", "org.SEAR.geometry", "org.SEAR.POJOs", "org.SEAR.grammar", "org.SEAR.protocol.scip",
        "org.SEAR.protocol.rplidar",
        "org.SEAR.protocol.lidar", "org.SEAR.protocol.lms", "org.SEAR.protocol.cola", "org.SEAR.protocol.nmea",
        "org.SEAR.protocol.ubx", "org.SEAR.protocol.firmata", "org.SEAR.protocol.mrlcomm", "org.SEAR.protocol.arduino",
        "org.SEAR.protocol");
    private static final List<String> CORE = ROOMS.subList(ROOMS.indexOf("org.SEAR.simulator"), ROOMS.size());
    private static final List<String> THREADS = Arrays.asList("EngineThread.java", "WorkerPool.java");
    /** Largest number of files that all use each other, directly or indirectly. */
    private static final int LARGEST_KNOT = 6;
    /** Objects of the grammar know their robot, their shapes and their storage. */
    private static final Map<String, Integer> LARGE_KNOTS = Collections.singletonMap("org.SEAR.POJOs", 10);
    private static final Pattern WORD = Pattern.compile("(?<![.\\w])[A-Z]\\w*");
    private static final Pattern NAME = Pattern.compile("\\b(?:org|com)\\.[A-Za-z0-9_.]+");
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", "."), "src");
    private static final Path SOURCES = ROOT.resolve("main/java");
    private static final Path MYROBOTLAB = ROOT.resolve("mrl/java");
    /** Source folders besides main and test. */
    private static final List<String> OTHERS = Arrays.asList("mrl", "cli", "assets", "jmh", "tools");

    @Test
    public void aPackageImportsOnlyFromPackagesBelowIt() throws IOException {
        List<String> wrong = new ArrayList<>();
        for (Path file : sources()) {
            int from = ROOMS.indexOf(packageOf(file));
            assertTrue(packageOf(file) + " has no place in the list of packages", from >= 0);
            for (String name : namesIn(file)) {
                int to = ROOMS.indexOf(room(name));
                if (to >= 0 && to < from && !isMyRobotLabs(name)) {
                    wrong.add(file + " uses " + name);
                }
            }
        }
        assertEquals(Collections.emptyList(), wrong);
    }

    @Test
    public void theCoreKnowsNeitherMyRobotLabNorThreadsNorADisplay() throws IOException {
        Pattern forbidden = Pattern.compile("org\\.myrobotlab|java\\.awt\\.(Frame|Robot|event)|javax\\.swing|"
            + "com\\.jme3\\.(app|renderer|input|system)\\.|new Thread\\(");
        List<String> wrong = new ArrayList<>();
        for (Path file : sources()) {
            if (CORE.contains(packageOf(file)) && THREADS.stream().noneMatch(file::endsWith)) {
                lines(file).filter(line -> forbidden.matcher(line).find()
                    && !line.contains("com.jme3.system.JmeSystem"))
                    .forEach(line -> wrong.add(file + ": " + line.trim()));
            }
        }
        assertEquals(Collections.emptyList(), wrong);
    }

    @Test
    public void protocolsKnowNothingButTheJdk() throws IOException {
        for (Path file : sources()) {
            if (packageOf(file).startsWith("org.SEAR.protocol")) {
                assertTrue(file.toString(), namesIn(file).stream()
                    .allMatch(name -> name.startsWith("org.SEAR.protocol")));
            }
        }
    }

    @Test
    public void noPackageUsesTheNativeBullet() throws IOException {
        for (Path file : sources()) {
            assertTrue(file.toString(), namesIn(file).stream().noneMatch(name -> name.startsWith("com.jme3.bullet")));
        }
    }

    @Test
    public void servicesShowNoTypeOfTheGameEngine() throws IOException {
        for (Path file : sources()) {
            if (packageOf(file).startsWith("org.myrobotlab.service")) {
                assertTrue(file.toString(), namesIn(file).stream().noneMatch(name -> name.startsWith("com.jme3")));
            }
        }
    }

    @Test
    public void onlyPhysicsKnowsJbullet() throws IOException {
        for (Path file : sources()) {
            if (CORE.contains(packageOf(file)) && !packageOf(file).startsWith("org.SEAR.physics")) {
                assertTrue(file.toString(), namesIn(file).stream()
                    .noneMatch(name -> name.startsWith("com.bulletphysics")));
            }
        }
    }

    @Test
    public void noCycleOfFilesInsideAPackageIsLargerThanSix() throws IOException {
        List<String> wrong = new ArrayList<>();
        for (Map.Entry<String, Map<String, Set<String>>> room : uses().entrySet()) {
            int most = LARGE_KNOTS.getOrDefault(room.getKey(), LARGEST_KNOT);
            Map<String, Set<String>> reachable = new TreeMap<>();
            room.getValue().forEach((file, used) -> reachable.put(file, reachable(file, room.getValue())));
            for (String file : reachable.keySet()) {
                List<String> knot = reachable.get(file).stream().filter(other -> reachable.get(other).contains(file))
                    .collect(Collectors.toList());
                if (knot.size() > most) {
                    wrong.add(room.getKey() + ": " + knot);
                }
            }
        }
        assertEquals(Collections.emptyList(), wrong);
    }

    @Test
    public void eachPackageStatesItsPurpose() throws IOException {
        Map<String, Long> said = foldersOfAllSources().stream().collect(Collectors.groupingBy(RoomsTest::nameOf,
            Collectors.filtering(folder -> Files.exists(folder.resolve("package-info.java")), Collectors.counting())));
        said.forEach((name, count) -> assertEquals("package-info.java of " + name, Long.valueOf(1), count));
    }

    private static Set<Path> foldersOfAllSources() throws IOException {
        Set<Path> all = new TreeSet<>();
        sources().forEach(file -> all.add(file.getParent()));
        for (String other : OTHERS) {
            sources(ROOT.resolve(other).resolve("java")).forEach(file -> all.add(file.getParent()));
        }
        return all;
    }

    private static String nameOf(Path folder) {
        Path inside = ROOT.relativize(folder);
        return inside.subpath(2, inside.getNameCount()).toString().replace(java.io.File.separatorChar, '.');
    }

    /** Returns, by package and file, the files of the same package that it uses. */
    private static Map<String, Map<String, Set<String>>> uses() throws IOException {
        Map<String, Map<String, Set<String>>> rooms = new TreeMap<>();
        for (Path file : sources()) {
            rooms.computeIfAbsent(packageOf(file), name -> new TreeMap<>())
                .put(file.getFileName().toString().replace(".java", ""), new TreeSet<>());
        }
        for (Path file : sources()) {
            Map<String, Set<String>> room = rooms.get(packageOf(file));
            String mine = file.getFileName().toString().replace(".java", "");
            lines(file).forEach(line -> {
                Matcher words = WORD.matcher(line.replaceAll("\"(\\\\.|[^\"\\\\])*\"|//.*|/\\*.*", ""));
                while (words.find()) {
                    if (room.containsKey(words.group()) && !words.group().equals(mine)) {
                        room.get(mine).add(words.group());
                    }
                }
            });
        }
        return rooms;
    }

    private static Set<String> reachable(String from, Map<String, Set<String>> uses) {
        Set<String> found = new TreeSet<>();
        Deque<String> open = new ArrayDeque<>(uses.get(from));
        while (!open.isEmpty()) {
            String file = open.remove();
            if (found.add(file)) {
                open.addAll(uses.get(file));
            }
        }
        return found;
    }

    /** Returns the listed package that contains a class or member, or an empty text. */
    private static String room(String name) {
        return ROOMS.stream().filter(room -> name.equals(room) || name.startsWith(room + "."))
            .max(Comparator.comparingInt(String::length)).orElse("");
    }

    /** Returns whether a class is MyRobotLab's own; MyRobotLab shares two package names with the plug-in. */
    private static boolean isMyRobotLabs(String name) {
        return Files.exists(MYROBOTLAB.resolve(name.replace('.', '/') + ".java"));
    }

    private static String packageOf(Path file) {
        return nameOf(file.getParent());
    }

    private static List<String> namesIn(Path file) throws IOException {
        List<String> names = new ArrayList<>();
        lines(file).forEach(line -> {
            Matcher matcher = NAME.matcher(line);
            while (matcher.find()) {
                names.add(matcher.group());
            }
        });
        return names;
    }

    /** Returns the lines of code, without package declarations and comments. */
    private static Stream<String> lines(Path file) throws IOException {
        return Files.readAllLines(file, StandardCharsets.UTF_8).stream()
            .filter(line -> !line.startsWith("package ") && !line.trim().matches("(\\*|/\\*|//).*"));
    }

    private static List<Path> sources() throws IOException {
        return sources(SOURCES);
    }

    private static List<Path> sources(Path root) throws IOException {
        try (Stream<Path> files = Files.walk(root)) {
            return files.filter(file -> file.toString().endsWith(".java")).sorted().collect(Collectors.toList());
        }
    }
}
