// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.lang.reflect.Executable;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.Beam;
import org.SEAR.POJOs.BeamCone;
import org.SEAR.POJOs.BoardWire;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.DriveErrors;
import org.SEAR.POJOs.Inertia;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.OpenInterfaceBody;
import org.SEAR.POJOs.PlacedObject;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.POJOs.SerialObject;
import org.SEAR.POJOs.SerialParameters;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.VoltagePoint;
import org.SEAR.POJOs.WallCorner;
import org.SEAR.files.AtomicFile;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.xml.ObjectClasses;

/**
 * Documentation of the classes of the object grammar, from the tables that also validate: the page
 * {@code docs/objects.md}, and lists for the terminal.
 */
public final class ObjectDocs {
    private static final String HEAD = "# Objects and their XML files\n\n"
        + "`gradle objectDocs` writes this page from the classes that read and check the files; do not edit it.\n\n"
        + "Each object is one file: an element named like the class contains an element for each parameter, in any "
        + "order. An element is\n"
        + "optional unless its default is \"required\". Positions are metres, angles degrees. The world's x points "
        + "north, y up,\n"
        + "z east; a robot's z points forward, x to the left, y up. [projects.md](projects.md) describes the "
        + "folders.\n\n"
        + "A box, by a script and as a file:\n\n```python\nfrom org.SEAR.POJOs import Box\nbox = Box(\"crate\", 0.5, "
        + "0.4, 0.3, 2)\nbox.move(1, 0.15, 0)\n```\n\n```xml\n<Box>\n  <name>crate</name>\n"
        + "  <length>0.5</length>\n  <width>0.4</width>\n  <height>0.3</height>\n  <mass>2</mass>\n"
        + "  <x>1</x>\n  <y>0.15</y>\n</Box>\n```\n";
    /** Words for the rules of text parameters in the column of legal values; other rules are printed there in full. */
    private static final Map<TextRule, String> RULES = Map.of(TextRule.ANY, "text", TextRule.NAME, "name",
        TextRule.COMPONENT, "component", TextRule.ASSET, "asset", TextRule.EXPORT, "export", TextRule.COLOR, "colour");
    private static final List<Shared> SHARED = List.of(new Shared("Every object", SearObject.class, Box.class),
        new Shared("Objects on the ground", PlacedObject.class, Box.class),
        new Shared("Shapes", Shape.class, Box.class), new Shared("Sensors", SensorObject.class, LIDAR.class),
            new Shared("Serial ports", SerialObject.class, LIDAR.class));

    /** Elements and calls of several classes, which the page describes once. */
    private static final class Shared {
        private final String title;
        private final Class<?> type;
        /** A class with these elements, whose defaults the page shows. */
        private final Class<?> sample;

        Shared(String title, Class<?> type, Class<?> sample) {
            this.title = title;
            this.type = type;
            this.sample = sample;
        }

        List<String> names() {
            return ParameterTable.of(type == SerialObject.class ? SerialParameters.class : type).names();
        }

        String link() {
            return "[" + title.toLowerCase(Locale.ROOT) + "](#" + title.toLowerCase(Locale.ROOT)
                .replace(' ', '-') + ")";
        }
    }

    private ObjectDocs() {
    }

    /**
     * Writes the page.
     *
     * @param args path of the page
     */
    public static void main(String[] args) throws IOException {
        AtomicFile.write(Paths.get(args[0]), page().getBytes(StandardCharsets.UTF_8));
    }

    private static void robots(StringBuilder out) {
        out.append("\n## Ready robots\n\niRobot's models with their real dimensions, so that drivers compute correct "
            + "distances and turns. They "
            + "are ordinary\nrobots:\n\n```python\nfrom org.SEAR.POJOs import Compass, Robots\n"
            + "rosie = Robots.create2(\"rosie\", \"/dev/my_Robot01\", \"/dev/SEAR_Robot_01\")    # the ports "
            + "are optional\n"
            + "rosie.move(1, 0, 2)\nrosie.rotate(0, 90, 0)\nrosie.addComponent(Compass(\"compass\"))\n```\n\n"
            + "| call | track width | wheel radius | encoders |\n|---|---|---|---|\n");
        for (OpenInterfaceBody body : OpenInterfaceBody.values()) {
            out.append("| Robots.").append(body.model).append("(name) | ").append(Parameter.format(body.track))
                .append(" m | ")
                .append(Parameter.format(body.wheelRadius)).append(" m | ")
                .append(body.hasEncoders() ? "508.8 counts per turn" : "none")
                .append(" |\n");
        }
        out.append("\nEach is 0.34 m across and 0.09 m high, weighs 3.6 kg and consists of `drive`, `body`, the wheels "
            + "`left` and `right` and the "
            + "casters `front` and `back`.\nThe Roomba 500 series matches the Create, the 600 series the Create 2. At "
            + "the start SEAR warns about "
            + "a robot with the firmware of\none of them and other wheels.\n\nThe first two use 57600 baud, like "
            + "MyRobotLab's Roomba service. The Create 2 uses 115200, as the real one does: write\n"
            + "`Runtime.getService(\"serial\").connect(\"/dev/SEAR_Robot_01\", 115200, 8, 1, 0)` instead of "
            + "`roomba.connect`.\n"
            + "With `rosie.getPart(\"drive\").setBaud(57600)` before the start, 57600 also works.\n\nThree vehicles "
            + "with motors and a chassis "
            + "are a base for your own. You drive them by calls, keys and buttons; they have no "
            + "port:\n\n| call | robot | wheels | motors |\n|---|---|---|---|\n"
            + "| Robots.rover(name) | 2 kg, two driven wheels 0.2 m apart and a caster | `left`, `right`, `caster` | "
            + "`leftMotor`, `rightMotor` |\n"
            + "| Robots.fourWheeled(name) | 4 kg, four driven wheels, skid-steered | `frontLeft`, `frontRight`, "
            + "`rearLeft`, `rearRight` | "
            + "`leftMotor`, `rightMotor` |\n| Robots.car(name) | 5 kg, front wheels steered by up to 30 degrees, rear "
            + "wheels driven | `frontLeft`, `frontRight`, `rearLeft`, `rearRight` | `engine` |\n"
            + "| Robots.chassis(name) | 2 kg, a body for your own wheels and motors | none | none |\n\nTheir other "
            + "parts are `drive` and `body`; [vehicles.md](vehicles.md) explains motors, casters and steered wheels.\n"
            + "`getPart` returns a part of any robot by its name: `rover.getPart(\"body\").setColor(\"red\")`. Part "
            + "names are unique: next to\nwheels `left` and `right` call a sensor `leftEye` or `rightPing`.\n");
    }

    /** Returns the page, in Markdown. */
    static String page() {
        StringBuilder out = new StringBuilder(HEAD);
        out.append("\nElements and calls that several classes share come first.\n");
        SHARED.forEach(shared -> shared(out, shared));
        for (Class<? extends SearObject> type : ObjectClasses.find().all()) {
            section(out, type);
        }
        robots(out);
        out.append("\n## Named beams\n\n| beam | other names | range | minimum | description "
            + "|\n|---|---|---|---|---|\n");
        for (Beam beam : BeamLibrary.comeWithSear()) {
            double farthest = beam.getCones().stream().mapToDouble(BeamCone::getRange).max().orElse(0);
            out.append("| ").append(beam.getName()).append(" | ").append(String.join(", ", beam.getAliases()))
                .append(" | ")
                .append(Parameter.format(farthest)).append(" m | ").append(Parameter.format(beam.getMinRange()))
                .append(" m | ").append(beam.getDescription()).append(" |\n");
        }
        for (Class<?> type : List.of(Beam.class, BeamCone.class, VoltagePoint.class, Noise.class, DriveErrors.class,
            Inertia.class, BoardWire.class, WallCorner.class)) {
            section(out, type);
        }
        out.append("\n## Texts\n\n| text | legal |\n|---|---|\n");
        new TreeMap<>(RULES).forEach((rule, word) -> out.append("| ").append(word).append(" | ")
            .append(cell(rule == TextRule.COMPONENT ? rule.legal().replace(TextRule.NAME.legal(), "a name as above")
                : rule.legal())).append(" |\n"));
        return out.toString();
    }

    private static void shared(StringBuilder out, Shared shared) {
        out.append("\n## ").append(shared.title).append("\n\n").append(shared.type == Shape.class
            ? "Also have the elements and calls of " + SHARED.get(1).link() + ".\n\n" : "");
        block(out, sharedCalls(shared));
        List<String> known = SHARED.stream().takeWhile(one -> one != shared).flatMap(one -> one.names().stream())
            .collect(Collectors.toList());
        ParameterTable table = ParameterTable.of(shared.sample);
        table(out, table, shared.names().stream().filter(name -> !known.contains(name) && !name.equals("baud"))
            .map(table::get));
    }

    private static List<String> sharedCalls(Shared shared) {
        List<String> known = SHARED.stream().takeWhile(one -> one != shared)
            .flatMap(one -> changes(one.type).stream()).collect(Collectors.toList());
        return changes(shared.type).stream().filter(call -> !known.contains(call)).collect(Collectors.toList());
    }

    private static void section(StringBuilder out, Class<?> type) {
        List<Shared> groups = SHARED.stream().filter(shared -> shared.type != SearObject.class
            && shared.type.isAssignableFrom(type)).collect(Collectors.toList());
        if (groups.stream().anyMatch(shared -> shared.type == Shape.class)) {
            groups.removeIf(shared -> shared.type == PlacedObject.class);
        }
        out.append("\n## ").append(type.getSimpleName()).append("\n\n").append(sentence(type)).append(groups.isEmpty()
            ? "" : " Also has the elements and calls of "
            + groups.stream().map(Shared::link).collect(Collectors.joining(", ")) + ".").append("\n\n");
        block(out, calls(type));
        ParameterTable table = ParameterTable.of(type);
        table(out, table, table.getParameters().stream()
            .filter(parameter -> SHARED.stream().noneMatch(shared -> isIn(shared, table, parameter))));
    }

    private static boolean isIn(Shared shared, ParameterTable table, Parameter parameter) {
        ParameterTable sample = ParameterTable.of(shared.sample);
        String name = parameter.getName();
        return !name.equals("baud") && shared.names().contains(name) && row(table, parameter)
            .equals(row(sample, sample.get(name)));
    }

    private static String sentence(Class<?> type) {
        String text = description(type);
        return text.isEmpty() ? "" : Character.toUpperCase(text.charAt(0)) + text.substring(1) + ".";
    }

    private static void block(StringBuilder out, List<String> calls) {
        if (!calls.isEmpty()) {
            out.append("```text\n").append(String.join("\n", calls)).append("\n```\n\n");
        }
    }

    private static void table(StringBuilder out, ParameterTable table, Stream<Parameter> parameters) {
        String rows = parameters.map(parameter -> row(table, parameter)).collect(Collectors.joining());
        if (!rows.isEmpty()) {
            out.append("| element | meaning | unit | default | legal |\n|---|---|---|---|---|\n").append(rows);
        }
    }

    private static String row(ParameterTable table, Parameter parameter) {
        return "| " + parameter.getName() + " | " + parameter.getDoc() + " | " + parameter.getUnit() + " | "
            + (parameter.isRequired() ? "required" : table.defaultOf(parameter)) + " | "
            + cell(legal(parameter)) + " |\n";
    }

    private static String cell(String text) {
        return text.replace("|", "\\|");
    }

    private static String legal(Parameter parameter) {
        String one = legalOfOne(parameter);
        return parameter.isList() ? one + ", up to " + parameter.getMaxEntries() : one;
    }

    private static String legalOfOne(Parameter parameter) {
        if (parameter.getKind() == Parameter.Kind.GROUP) {
            String name = parameter.getType().getSimpleName();
            return "[" + name + "](#" + name.toLowerCase(Locale.ROOT) + ")";
        }
        if (!parameter.getValues().isEmpty()) {
            return String.join(", ", parameter.getValues());
        }
        String range = Parameter.format(parameter.getMin()) + " to " + Parameter.format(parameter.getMax());
        switch (parameter.getKind()) {
            case NUMBER:
                return (parameter.isOrZero() ? "0, or " : "") + range;
            case WHOLE:
                return "whole, " + range;
            case TEXT:
                String word = RULES.get(parameter.getTextRule());
                return word == null ? parameter.legal() : "[" + word + "](#texts)";
            default:
                return parameter.legal();
        }
    }

    private static List<String> calls(Class<?> type) {
        List<Executable> makers = new ArrayList<>(Arrays.asList(type.getConstructors()));
        makers.removeIf(c -> c.getParameterCount() == 0 && SearObject.class.isAssignableFrom(type));
        List<String> lines = new ArrayList<>();
        makers.stream().map(c -> call(type.getSimpleName(), c)).sorted(ObjectDocs::shorterFirst).forEach(lines::add);
        TreeSet<String> changes = changes(type);
        SHARED.stream().filter(shared -> shared.type.isAssignableFrom(type))
            .forEach(shared -> changes.removeAll(changes(shared.type)));
        lines.addAll(changes);
        return lines;
    }

    private static TreeSet<String> changes(Class<?> type) {
        TreeSet<String> changes = new TreeSet<>();
        for (Method method : type.getMethods()) {
            boolean changing = !Modifier.isStatic(method.getModifiers())
                && !method.getName().matches("(get|is|has).*|to[A-Z].*|wait|notify.*|equals|hashCode");
            if (changing && method.getDeclaringClass() != Object.class) {
                changes.add("." + call(method.getName(), method));
            }
        }
        return changes;
    }

    private static int shorterFirst(String a, String b) {
        return a.length() != b.length() ? Integer.compare(a.length(), b.length()) : a.compareTo(b);
    }

    private static String call(String name, Executable maker) {
        return name + Arrays.stream(maker.getParameters()).map(p -> p.getName().replaceAll("^new([A-Z])", "$1"))
            .map(p -> p.length() > 1 && Character.isUpperCase(p.charAt(1)) ? p : Character.toLowerCase(p.charAt(0))
                + p.substring(1))
            .collect(Collectors.joining(", ", "(", ")"));
    }

    /** Returns the description of a class, one sentence without a full stop; empty if it has none. */
    public static String description(Class<?> type) {
        Described described = type.getAnnotation(Described.class);
        return described == null ? "" : described.value();
    }

    /** Returns a class and its parameters for the terminal, a line each, with unit, legal range and default. */
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
