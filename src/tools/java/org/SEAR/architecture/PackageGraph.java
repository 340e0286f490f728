// SPDX-License-Identifier: Apache-2.0
package org.SEAR.architecture;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.myrobotlab.service.SEAR;

/** Dependencies between the packages of the plug-in, read from class files. */
final class PackageGraph {
    private final SortedMap<String, SortedSet<String>> uses = new TreeMap<>();

    /** @param uses each package with the packages that it uses */
    PackageGraph(Map<String, ? extends Collection<String>> uses) {
        uses.forEach((name, others) -> {
            this.uses.computeIfAbsent(name, any -> new TreeSet<>()).addAll(others);
            others.forEach(other -> this.uses.computeIfAbsent(other, any -> new TreeSet<>()));
        });
    }

    /** Writes the picture to the path given as argument. */
    public static void main(String[] arguments) throws IOException, URISyntaxException {
        Files.write(Path.of(arguments[0]), new PackagePicture(ofPlugin()).svg().getBytes(StandardCharsets.UTF_8));
    }

    static PackageGraph ofPlugin() throws IOException, URISyntaxException {
        return read(Path.of(SEAR.class.getProtectionDomain().getCodeSource().getLocation().toURI()));
    }

    private static PackageGraph read(Path folder) throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.walk(folder)) {
            files = all.filter(file -> file.toString().endsWith(".class")).collect(Collectors.toList());
        }
        Set<String> classes = files.stream().map(file -> name(folder, file)).collect(Collectors.toSet());
        SortedMap<String, SortedSet<String>> found = new TreeMap<>();
        for (Path file : files) {
            String from = packageOf(name(folder, file));
            SortedSet<String> to = found.computeIfAbsent(from, any -> new TreeSet<>());
            namesIn(file).stream().filter(classes::contains).map(PackageGraph::packageOf)
                .filter(other -> !other.equals(from)).forEach(to::add);
        }
        return new PackageGraph(found);
    }

    private static Set<String> namesIn(Path file) {
        try {
            return ClassNames.in(Files.readAllBytes(file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String name(Path folder, Path file) {
        return folder.relativize(file).toString().replace('\\', '/').replace(".class", "");
    }

    private static String packageOf(String name) {
        return name.substring(0, name.lastIndexOf('/')).replace('/', '.');
    }

    SortedMap<String, SortedSet<String>> uses() {
        return uses;
    }

    /** Returns the packages that are part of a cycle. */
    SortedSet<String> circles() {
        return uses.keySet().stream().filter(name -> below(name).contains(name))
            .collect(Collectors.toCollection(TreeSet::new));
    }

    /** Returns all packages that a package needs, directly or indirectly. */
    SortedSet<String> below(String name) {
        SortedSet<String> seen = new TreeSet<>();
        collect(name, seen);
        return seen;
    }

    private void collect(String name, Set<String> seen) {
        for (String next : uses.get(name)) {
            if (seen.add(next)) {
                collect(next, seen);
            }
        }
    }

    /** Returns the packages that a package uses and does not also reach through another package. */
    SortedSet<String> direct(String name) {
        return uses.get(name).stream()
            .filter(target -> uses.get(name).stream().noneMatch(other -> below(other).contains(target)))
            .collect(Collectors.toCollection(TreeSet::new));
    }

    /** Returns the number of packages on the longest path down. */
    int height(String name) {
        return uses.get(name).stream().mapToInt(this::height).max().orElse(-1) + 1;
    }
}
