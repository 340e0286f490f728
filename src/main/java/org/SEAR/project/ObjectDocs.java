package org.SEAR.project;

import java.io.IOException;
import java.lang.reflect.Executable;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Beam;
import org.SEAR.POJOs.BeamCone;
import org.SEAR.POJOs.BoardWire;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.OpenInterfaceBody;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.VoltagePoint;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.project.xml.ObjectClasses;

/** Describes the classes of the object grammar from the same tables that validate: the page {@code docs/objects.md}, and lists for the terminal. */
public final class ObjectDocs {
    private static final String HEAD = "# Objects and their XML files\n\n"
        + "Written by `gradle objectDocs` from the classes that read and check the files; do not edit.\n\n"
        + "Each object is one file: an element named like the class, in it an element for each parameter, in any order. Elements that are not\n"
        + "required may be missing. Positions are metres, angles degrees. The world's x points north, y up, z east; a robot's z points forward,\n"
        + "x to the left, y up. See [projects.md](projects.md) for where the files lie.\n\n"
        + "A box, made by a script and as a file:\n\n```python\nfrom org.SEAR.POJOs import Box\nbox = Box(\"crate\", 0.5, 0.4, 0.3, 2)\n"
        + "box.move(1, 0.15, 0)\n"
        + "```\n\n```xml\n<Box>\n  <name>crate</name>\n"
        + "  <length>0.5</length>\n  <width>0.4</width>\n  <height>0.3</height>\n  <mass>2</mass>\n"
        + "  <x>1</x>\n  <y>0.15</y>\n</Box>\n```\n";

    private ObjectDocs() {
    }

    /**
     * Writes the page.
     *
     * @param args the file
     */
    public static void main(String[] args) throws IOException {
        Files.write(Paths.get(args[0]), page().getBytes(StandardCharsets.UTF_8));
    }

    private static void robots(StringBuilder out) {
        out.append("\n## Ready robots\n\niRobot's with the dimensions of the real ones, so that drivers made for those judge distances and turns "
            + "rightly; ordinary\nrobots otherwise:\n\n```python\nfrom org.SEAR.POJOs import Compass, Robots\n"
            + "rosie = Robots.create2(\"rosie\", \"/dev/my_Robot01\", \"/dev/SEAR_Robot_01\")    # the ports may be left out\n"
            + "rosie.move(1, 0, 2)\nrosie.rotate(0, 90, 0)\nrosie.addComponent(Compass(\"compass\"))\n```\n\n"
            + "| call | wheels apart | radius of the wheels | encoders |\n|---|---|---|---|\n");
        for (OpenInterfaceBody body : OpenInterfaceBody.values()) {
            out.append("| Robots.").append(body.model).append("(name) | ").append(Parameter.format(body.wheelBase)).append(" m | ")
                .append(Parameter.format(body.wheelRadius)).append(" m | ").append(body.hasEncoders() ? "508.8 counts a turn" : "none")
                .append(" |\n");
        }
        out.append("\nEach is 0.34 m across and 0.09 m high, weighs 3.6 kg and consists of `drive`, `body`, the wheels `left` and `right` and the "
            + "casters `front` and `back`.\nThe Roombas of the 500 series are as the Create, those of the 600 series as the Create 2. A robot that "
            + "answers as one of them\nand has other wheels is told at the start.\n\nAt their ports the first two talk at 57600 baud, which "
            + "MyRobotLab's `roomba.connect(port)` sets, and the Create 2 at 115200, as the\nreal one does: "
            + "`roomba.connect(\"/dev/SEAR_Robot_01\", 115200, 8, 1, 0)` talks to it, or, with `rosie.getPart(\"drive\").setBaud(57600)`\n"
            + "before the start, `roomba.connect(port)`.\n\nThree vehicles with motors, to build one's own from; they drive "
            + "by calls, keys and buttons, and have no port:\n\n| call | what it is | its wheels | its motors |\n|---|---|---|---|\n"
            + "| Robots.rover(name) | 2 kg, two driven wheels 0.2 m apart and a caster | `left`, `right`, `caster` | `leftMotor`, `rightMotor` |\n"
            + "| Robots.fourWheeled(name) | 4 kg, four driven wheels, turns by its two sides | `frontLeft`, `frontRight`, `rearLeft`, `rearRight` | "
            + "`leftMotor`, `rightMotor` |\n| Robots.car(name) | 5 kg, front wheels steered by up to 30 degrees, rear wheels driven | `frontLeft`, "
            + "`frontRight`, `rearLeft`, `rearRight` | `engine` |\n"
            + "| Robots.chassis(name) | 2 kg, a body to which you add wheels and motors | none | none |\n\nTheir other parts are `drive` and "
            + "`body`; [vehicles.md](vehicles.md) says what motors, casters and steered wheels do.\n"
            + "`rover.getPart(\"leftMotor\")` is one of the parts of a ready robot, and of every other, by"
            + " its name: `rover.getPart(\"body\").setColor(\"red\")`.\n"
            + "A name means one part of a robot: where the wheels are `left` and `right`, a sensor is called otherwise, `leftEye` or `rightPing`.\n");
    }

    /** The page, in Markdown. */
    static String page() {
        StringBuilder out = new StringBuilder(HEAD);
        out.append("\n## Elements that every object has\n\n");
        table(out, ParameterTable.of(SearObject.class), List.of());
        for (Class<? extends SearObject> type : ObjectClasses.find().all()) {
            section(out, type, ParameterTable.of(SearObject.class).names());
        }
        robots(out);
        out.append("\n## Named beams\n\n| beam | other names | farthest | nearest | what it is |\n|---|---|---|---|---|\n");
        for (Beam beam : BeamLibrary.comeWithSear()) {
            double farthest = beam.getCones().stream().mapToDouble(BeamCone::getRange).max().orElse(0);
            out.append("| ").append(beam.getName()).append(" | ").append(String.join(", ", beam.getAliases())).append(" | ")
                .append(Parameter.format(farthest)).append(" m | ").append(Parameter.format(beam.getMinRange())).append(" m | ")
                .append(beam.getDescription()).append(" |\n");
        }
        for (Class<?> type : List.of(Beam.class, BeamCone.class, VoltagePoint.class, Noise.class, BoardWire.class)) {
            section(out, type, List.of());
        }
        return out.toString();
    }

    private static void section(StringBuilder out, Class<?> type, List<String> known) {
        out.append("\n## ").append(type.getSimpleName()).append("\n\n").append(sentence(type)).append("\n\n");
        List<String> calls = calls(type);
        if (!calls.isEmpty()) {
            out.append("```text\n").append(String.join("\n", calls)).append("\n```\n\n");
        }
        table(out, ParameterTable.of(type), known);
    }

    private static String sentence(Class<?> type) {
        String text = description(type);
        return text.isEmpty() ? "" : Character.toUpperCase(text.charAt(0)) + text.substring(1) + ".";
    }

    private static void table(StringBuilder out, ParameterTable table, List<String> known) {
        List<Parameter> own = table.getParameters().stream().filter(p -> !known.contains(p.getName())).collect(Collectors.toList());
        if (own.isEmpty()) {
            return;
        }
        out.append("| element | meaning | unit | default | legal |\n|---|---|---|---|---|\n");
        for (Parameter parameter : own) {
            out.append("| ").append(parameter.getName()).append(" | ").append(parameter.getDoc()).append(" | ").append(parameter.getUnit())
                .append(" | ").append(defaultText(table, parameter)).append(" | ").append(legal(parameter).replace("|", "\\|")).append(" |\n");
        }
    }

    private static String defaultText(ParameterTable table, Parameter parameter) {
        return parameter.isRequired() ? "required" : table.defaultOf(parameter);
    }

    private static String legal(Parameter parameter) {
        String one = parameter.getKind() == Parameter.Kind.GROUP ? "a [" + parameter.getType().getSimpleName() + "](#"
            + parameter.getType().getSimpleName().toLowerCase(Locale.ROOT) + ")" : parameter.legal();
        return parameter.isList() ? one + "; up to " + parameter.getMaxEntries() + " of them" : one;
    }

    private static List<String> calls(Class<?> type) {
        List<Executable> makers = new ArrayList<>(Arrays.asList(type.getConstructors()));
        makers.removeIf(c -> c.getParameterCount() == 0 && SearObject.class.isAssignableFrom(type));
        List<String> lines = new ArrayList<>();
        makers.stream().map(c -> call(type.getSimpleName(), c)).sorted(ObjectDocs::shorterFirst).forEach(lines::add);
        TreeSet<String> changes = new TreeSet<>();
        for (Method method : type.getMethods()) {
            boolean changing = !Modifier.isStatic(method.getModifiers())
                && !method.getName().matches("(get|is|has).*|to[A-Z].*|wait|notify.*|equals|hashCode");
            if (changing && method.getDeclaringClass() != Object.class && !isOfEvery(method)) {
                changes.add("." + call(method.getName(), method));
            }
        }
        lines.addAll(changes);
        return lines;
    }

    /** Whether every object has it, as move and rotate. */
    private static boolean isOfEvery(Method method) {
        return Arrays.stream(SearObject.class.getMethods()).anyMatch(one -> one.getName().equals(method.getName()));
    }

    private static int shorterFirst(String a, String b) {
        return a.length() != b.length() ? Integer.compare(a.length(), b.length()) : a.compareTo(b);
    }

    private static String call(String name, Executable maker) {
        return name + Arrays.stream(maker.getParameters()).map(p -> p.getName().replaceAll("^new([A-Z])", "$1"))
            .map(p -> p.length() > 1 && Character.isUpperCase(p.charAt(1)) ? p : Character.toLowerCase(p.charAt(0)) + p.substring(1))
            .collect(Collectors.joining(", ", "(", ")"));
    }

    /** What a class is, in one sentence without a full stop; empty if it doesn't say. */
    public static String description(Class<?> type) {
        Described described = type.getAnnotation(Described.class);
        return described == null ? "" : described.value();
    }

    /** A class and its parameters for the terminal: a line each, with unit, legal range and default. */
    public static String listing(Class<? extends SearObject> type) {
        StringBuilder out = new StringBuilder(type.getSimpleName()).append(": ").append(description(type)).append('\n');
        ParameterTable table = ParameterTable.of(type);
        for (Parameter parameter : table.getParameters()) {
            String meaning = parameter.getDoc() + "; " + parameter.legal();
            String standard = table.defaultOf(parameter);
            out.append(String.format("  %-18s %s%s%n", parameter.getName(), meaning,
                parameter.isRequired() ? "; required" : standard.isEmpty() ? "" : "; default " + standard));
        }
        return out.toString();
    }
}
