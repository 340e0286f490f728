// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.SEAR.POJOs.Beam;
import org.SEAR.grammar.Parameter;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ParsedObject;
import org.SEAR.project.xml.Xml;

/**
 * The named beams of a project: the files of its {@code beams/} folder, which take precedence, and the beams that come
 * with SEAR.
 */
public final class BeamLibrary {
    private static final String INDEX = "beams/index.txt";
    private static final Map<String, Beam> BUILT_IN = builtIn();
    private static final Map<String, Class<?>> ROOT = Collections.singletonMap("Beam", Beam.class);

    private final Path folder;

    /** @param project the SEARproject folder */
    public BeamLibrary(Path project) {
        folder = project.resolve(ProjectFolder.BEAMS);
    }

    private static Map<String, Beam> builtIn() {
        Map<String, Beam> beams = new LinkedHashMap<>();
        ProblemList problems = new ProblemList();
        for (String name : new String(resource(INDEX), StandardCharsets.UTF_8).trim().split("\n")) {
            String file = "beams/" + name + ProjectFolder.XML;
            ParsedObject parsed = Xml.parse(resource(file), file,
                Collections.singletonMap("Beam", Beam.class), problems);
            check(parsed, problems);
            if (!problems.isEmpty()) {
                throw new IllegalStateException("the beams that come with SEAR are broken: " + problems);
            }
            beams.put(name, (Beam) parsed.object);
        }
        return Collections.unmodifiableMap(beams);
    }

    private static byte[] resource(String name) {
        try (InputStream in = BeamLibrary.class.getResourceAsStream(name)) {
            if (in == null) {
                throw new IllegalStateException("sear.jar lacks org/SEAR/project/" + name);
            }
            return in.readAllBytes();
        } catch (IOException e) {
            throw new IllegalStateException("org/SEAR/project/" + name + " can't be read", e);
        }
    }

    private static void check(ParsedObject parsed, ProblemList problems) {
        if (parsed == null || parsed.isBroken()) {
            return;
        }
        Beam beam = (Beam) parsed.object;
        if (beam.getCones().isEmpty()) {
            problems.add(parsed.file, parsed.line(""), "", "<cone> is missing", "at least one cone");
        }
        for (int i = 1; i < beam.getVoltages().size(); i++) {
            double before = beam.getVoltages().get(i - 1).getDistance();
            double distance = beam.getVoltages().get(i).getDistance();
            if (distance <= before) {
                problems.add(parsed.file, parsed.line("voltage#" + i), "voltage.distance", Parameter.format(distance),
                    "more than the one before, " + Parameter.format(before) + " m");
            }
        }
    }

    /**
     * Returns a beam by its name, or by another name of the same product. An exact match takes precedence over a
     * case-insensitive one.
     *
     * @throws IllegalArgumentException with the names of the beams, or with the problem of the project's file
     */
    public Beam get(String name) {
        ProblemList problems = new ProblemList();
        List<Beam> all = new ArrayList<>(own(problems).values());
        all.addAll(BUILT_IN.values());
        Beam found = find(all, name::equals);
        found = found == null ? find(all, name::equalsIgnoreCase) : found;
        if (found != null) {
            return found;
        }
        throw new IllegalArgumentException("beam is \"" + name + "\", legal: " + String.join(", ", names())
            + (problems.isEmpty() ? "" : "; " + problems));
    }

    private static Beam find(List<Beam> beams, Predicate<String> isIt) {
        return beams.stream().filter(beam -> isIt.test(beam.getName()) || beam.getAliases().stream().anyMatch(isIt))
            .findFirst().orElse(null);
    }

    /** Returns the names of all beams, in order, including the other names of the same products. */
    public List<String> names() {
        TreeSet<String> names = new TreeSet<>(own(new ProblemList()).keySet());
        for (Beam beam : BUILT_IN.values()) {
            names.add(beam.getName());
            names.addAll(beam.getAliases());
        }
        return new ArrayList<>(names);
    }

    /** Returns the beams that come with SEAR, in the order of the documentation. */
    public static List<Beam> comeWithSear() {
        return new ArrayList<>(BUILT_IN.values());
    }

    /** Returns the project's own beams by name; invalid files are reported and left out. */
    Map<String, Beam> own(ProblemList problems) {
        Map<String, Beam> beams = new TreeMap<>();
        for (Path file : files(problems)) {
            String name = ProjectFolder.BEAMS + "/" + file.getFileName();
            int before = problems.size();
            ParsedObject parsed = Xml.read(file, name, ROOT, problems);
            check(parsed, problems);
            if (problems.size() == before) {
                Beam beam = (Beam) parsed.object;
                if (!(beam.getName() + ProjectFolder.XML).equals(file.getFileName().toString())) {
                    problems.add(name, parsed.line("name"), "name", beam.getName(),
                        "the name of the file without .xml");
                } else {
                    beams.put(beam.getName(), beam);
                }
            }
        }
        return beams;
    }

    private List<Path> files(ProblemList problems) {
        List<Path> files = new ArrayList<>();
        if (Files.isDirectory(folder)) {
            try (Stream<Path> all = Files.list(folder)) {
                all.filter(f -> f.getFileName().toString().endsWith(ProjectFolder.XML)).sorted().forEach(files::add);
            } catch (IOException e) {
                problems.add(ProjectFolder.BEAMS, 0, "", "it can't be read (" + e + ")", "a readable folder");
            }
        }
        return files;
    }
}
