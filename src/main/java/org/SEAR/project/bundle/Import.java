// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.AxisJoint;
import org.SEAR.POJOs.Beam;
import org.SEAR.POJOs.ForceTorque;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SerialObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.project.BeamLibrary;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.xml.Xml;

/**
 * Copies objects of one project into the folder of another. Names and ports that exist there get a number, and so do
 * assets and beams that exist with different content. One use, one thread.
 */
final class Import {
    private static final List<String> ASSETS = Arrays.asList("path", "tile", "image", "sketch");
    private static final List<String> PORTS = Arrays.asList("uartPort", "userPort");

    private final Project source;
    private final Path target;
    private final Set<String> names = new HashSet<>();
    /** Names of the parts of the target's robots. */
    private final Set<String> parts = new HashSet<>();
    private final Set<String> ports = new HashSet<>();
    /** Messages about objects that the import leaves behind. */
    private final List<String> left = new ArrayList<>();
    /** Position of the last robot in the order of robots; 0 if there is none. */
    private int lastRobot;

    /** @param present the project in the target folder; null if the folder is empty */
    Import(Project source, Project present, Path target) {
        this.source = source;
        this.target = target;
        if (present != null) {
            present.getEnvironment().forEach(this::take);
            present.getJoints().forEach(this::take);
            for (SEARrobot robot : present.getRobots()) {
                lastRobot = Math.max(lastRobot, robot.getOrder() == null ? 1 : robot.getOrder());
                take(robot);
                robot.getComponents().forEach(this::takePart);
                robot.getWheels().forEach(wheel -> parts.add(key(wheel.getName())));
            }
        }
    }

    private void take(SearObject object) {
        names.add(key(object.getName()));
    }

    private static String key(String name) {
        return name.toLowerCase(Locale.ROOT);
    }

    private void takePart(SearObject object) {
        parts.add(key(object.getName()));
        if (object instanceof SerialObject) {
            ports.add(String.valueOf(((SerialObject) object).getUartPort()).toLowerCase(Locale.ROOT));
            ports.add(String.valueOf(((SerialObject) object).getUserPort()).toLowerCase(Locale.ROOT));
        }
    }

    /**
     * Copies the whole environment, with its joints; those of a robot stay behind, see {@link #left}.
     *
     * @return new names by old names
     */
    Map<String, String> environment() throws IOException {
        Map<String, String> renamed = new LinkedHashMap<>();
        for (SearObject object : source.getEnvironment()) {
            renamed.put(object.getName(), unique(object.getName(), name -> names.contains(name)
                || parts.contains(name)));
            names.add(key(renamed.get(object.getName())));
        }
        String prefix = copyAssets();
        for (SearObject object : source.getEnvironment()) {
            write(object, ProjectFolder.ENVIRONMENT, renamed.get(object.getName()), prefix);
        }
        copyJoints(renamed, prefix, name -> true);
        return renamed;
    }

    /** Returns messages about what was left behind. */
    List<String> left() {
        return left;
    }

    /**
     * Copies the joints whose objects are all copied.
     *
     * @param renamed new names of copied objects by old names; gets those of joints
     * @param reported whether a joint that has an object of this name and stays behind is worth a message
     */
    private void copyJoints(Map<String, String> renamed, String prefix, Predicate<String> reported)
        throws IOException {
        List<Joint> coming = new ArrayList<>();
        for (Joint joint : source.getJoints()) {
            if (comes(joint, renamed, reported)) {
                coming.add(joint);
                String name = unique(joint.getName(), other -> names.contains(other) || parts.contains(other));
                names.add(key(name));
                renamed.put(joint.getName(), name);
            }
        }
        for (Joint joint : coming) {
            String gear = joint instanceof AxisJoint ? ((AxisJoint) joint).getGear() : null;
            if (gear != null && !renamed.containsKey(gear)) {
                left.add(joint + " leaves its gear behind: the import does not copy " + gear + ", which it follows");
            }
            set(joint, "first", renamed::get);
            set(joint, "second", renamed::get);
            set(joint, "gear", renamed::get);
            write(joint, ProjectFolder.ENVIRONMENT, renamed.get(joint.getName()), prefix);
        }
    }

    private boolean comes(Joint joint, Map<String, String> renamed, Predicate<String> reported) {
        List<String> missing = new ArrayList<>();
        for (String end : Arrays.asList(joint.getFirst(), joint.getSecond())) {
            if (end != null && !renamed.containsKey(end)) {
                missing.add(end);
            }
        }
        if (!missing.isEmpty()) {
            if (reported.test(joint.getFirst()) || reported.test(joint.getSecond())) {
                left.add(joint + " stays behind: the import does not copy " + String.join(" and ", missing)
                    + ", which it joins");
            }
        }
        return missing.isEmpty();
    }

    /**
     * Copies a robot with all its parts and its joints to the world, as the last of the target's robots. Its parts may
     * have the same names as other robots' parts.
     *
     * @return new names by old names; the robot's comes first
     */
    Map<String, String> robot(SEARrobot robot) throws IOException {
        List<SearObject> components = withoutLonely(robot);
        Set<String> own = new HashSet<>();
        components.forEach(part -> own.add(key(part.getName())));
        robot.getWheels().forEach(wheel -> own.add(key(wheel.getName())));
        Map<String, String> renamed = new LinkedHashMap<>();
        String robotName = unique(robot.getName(), name -> names.contains(name) || parts.contains(name)
            || own.contains(name));
        renamed.put(robot.getName(), robotName);
        names.add(key(robotName));
        Map<String, String> files = new LinkedHashMap<>();
        for (SearObject part : components) {
            String name = part.getName();
            if (names.contains(key(name))) {
                name = unique(name, other -> names.contains(other) || own.contains(other));
                own.add(key(name));
            }
            renamed.put(part.getName(), name);
            files.put(part.getFileName(), isPlaceTaken(name, robotName) ? robotName + "/" + name : name);
        }
        ParameterTable.of(SEARrobot.class).find("order")
            .set(robot, lastRobot == 0 ? null : Integer.valueOf(lastRobot + 1));
        ParameterTable.of(SEARrobot.class).find("component").set(robot, new ArrayList<>(files.values()));
        String prefix = copyAssets();
        copyJoints(renamed, prefix, robot.getName()::equals);
        Iterator<String> file = files.values().iterator();
        for (SearObject part : components) {
            ParameterTable.of(part.getClass()).getParameters().stream().filter(one -> !one.getNamed().isEmpty())
                .forEach(one -> set(part, one.getName(), name -> renamed.getOrDefault(name, name)));
            writePart(part, renamed.get(part.getName()), file.next(), prefix);
        }
        write(robot, ProjectFolder.ROBOT, robotName, prefix);
        return renamed;
    }

    /** Returns the parts of a robot without sensors at joints that stay behind. */
    private List<SearObject> withoutLonely(SEARrobot robot) {
        List<SearObject> all = new ArrayList<>(robot.getComponents());
        for (Joint joint : source.getJoints()) {
            boolean comes = joint.getFirst() == null && joint.getSecond().equals(robot.getName());
            all.removeIf(part -> !comes && part instanceof ForceTorque
                && joint.getName().equals(((ForceTorque) part).getJoint())
                && left.add(part + " stays behind: the import does not copy " + joint.getName()
                    + ", which it measures"));
        }
        return all;
    }

    /** Returns whether another part or the robot itself uses the file in {@code robot/}. */
    private boolean isPlaceTaken(String name, String robot) {
        return parts.contains(key(name)) || name.equalsIgnoreCase(robot)
            || Files.exists(target.resolve(ProjectFolder.ROBOT).resolve(name + ProjectFolder.XML));
    }

    /** Returns the name, with the first free number if it is taken: {@code rover}, {@code rover_2}. */
    private static String unique(String name, Predicate<String> taken) {
        String free = name;
        for (int number = 2; taken.test(key(free)); number++) {
            free = name + "_" + number;
        }
        return free;
    }

    private String freePort(String port) {
        String free = unique(port, ports::contains);
        ports.add(key(free));
        return free;
    }

    private void writePart(SearObject part, String name, String file, String prefix) throws IOException {
        int slash = file.indexOf('/');
        write(part, slash < 0 ? ProjectFolder.ROBOT : ProjectFolder.ROBOT + "/" + file.substring(0, slash),
            name, prefix);
    }

    private void write(SearObject object, String folder, String newName, String prefix) throws IOException {
        set(object, "name", name -> newName);
        copyBeam(object);
        ASSETS.forEach(element -> set(object, element, path -> isOwnAsset(path) ? prefix
            + path.replaceFirst("^(\\./)+", "") : path));
        PORTS.forEach(element -> set(object, element, this::freePort));
        if (object instanceof SEARrobot) {
            for (Wheel wheel : ((SEARrobot) object).getWheels()) {
                set(wheel, "image", path -> isOwnAsset(path) ? prefix + path : path);
            }
        }
        Path file = Files.createDirectories(target.resolve(folder)).resolve(object.getName() + ProjectFolder.XML);
        Files.writeString(file, Xml.write(object));
    }

    private static void set(SearObject object, String element, UnaryOperator<String> change) {
        Parameter parameter = ParameterTable.of(object.getClass()).find(element);
        if (parameter == null) {
            return;
        }
        List<Object> values = new ArrayList<>();
        parameter.values(object).forEach(value -> values.add(change.apply((String) value)));
        if (!values.isEmpty()) {
            parameter.set(object, parameter.isList() ? values : values.get(0));
        }
    }

    private boolean isOwnAsset(String path) {
        return Files.isRegularFile(source.getAssets().getFolder().resolve(path));
    }

    /**
     * Copies all assets: to the same paths if no different file exists there, otherwise to a new folder.
     *
     * @return prefix of the new paths
     */
    private String copyAssets() throws IOException {
        Path from = source.getAssets().getFolder();
        Path to = target.resolve(ProjectFolder.ASSETS);
        if (!Files.isDirectory(from)) {
            return "";
        }
        List<Path> files;
        try (Stream<Path> all = Files.walk(from)) {
            files = all.filter(Files::isRegularFile).map(from::relativize).collect(Collectors.toList());
        }
        String prefix = "";
        for (int number = 1; !fit(files, from, to.resolve(prefix)); number++) {
            prefix = "imported" + number + "/";
        }
        for (Path file : files) {
            Path copy = to.resolve(prefix).resolve(file);
            Files.createDirectories(copy.getParent());
            Files.copy(from.resolve(file), copy, StandardCopyOption.REPLACE_EXISTING);
        }
        return prefix;
    }

    private static boolean fit(List<Path> files, Path from, Path to) throws IOException {
        for (Path file : files) {
            if (Files.exists(to.resolve(file)) && !isSame(from.resolve(file), to.resolve(file))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isSame(Path a, Path b) throws IOException {
        return Files.isRegularFile(b) && Files.size(a) == Files.size(b)
            && Arrays.equals(Files.readAllBytes(a), Files.readAllBytes(b));
    }

    /**
     * Copies the source's own beam of a sensor; if the target has another beam of that name, the copy gets a number.
     */
    private void copyBeam(SearObject object) throws IOException {
        Parameter parameter = ParameterTable.of(object.getClass()).find("beam");
        if (parameter == null || parameter.get(object) == null) {
            return;
        }
        String name = (String) parameter.get(object);
        Path from = source.getFolder().resolve(ProjectFolder.BEAMS).resolve(name + ProjectFolder.XML);
        if (!Files.isRegularFile(from)) {
            return;
        }
        Path beams = Files.createDirectories(target.resolve(ProjectFolder.BEAMS));
        String free = name;
        Beam beam = new BeamLibrary(source.getFolder()).get(name);
        String text = Xml.write(beam);
        for (int number = 2; !isFree(beams.resolve(free + ProjectFolder.XML), free, text); number++) {
            free = name + "_" + number;
            ParameterTable.of(Beam.class).find("name").set(beam, free);
            text = Xml.write(beam);
        }
        Files.writeString(beams.resolve(free + ProjectFolder.XML), text);
        parameter.set(object, free);
    }

    private boolean isFree(Path file, String name, String text) {
        return !Files.exists(file) || Xml.write(new BeamLibrary(target).get(name)).equals(text);
    }
}
