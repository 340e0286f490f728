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

/** Which package of the plug-in uses which, read from its class files. */
final class PackageGraph {
    private final SortedMap<String, SortedSet<String>> uses = new TreeMap<>();

    /** @param uses each package and those that it uses */
    PackageGraph(Map<String, ? extends Collection<String>> uses) {
        uses.forEach((name, others) -> {
            this.uses.computeIfAbsent(name, any -> new TreeSet<>()).addAll(others);
            others.forEach(other -> this.uses.computeIfAbsent(other, any -> new TreeSet<>()));
        });
    }

    /** Writes the picture to the path that is the argument. */
    public static void main(String[] arguments) throws IOException, URISyntaxException {
        Files.write(Path.of(arguments[0]), new PackagePicture(ofPlugin()).svg().getBytes(StandardCharsets.UTF_8));
    }

    /** The plug-in as it was compiled. */
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
            namesIn(file).stream().filter(classes::contains).map(PackageGraph::packageOf).filter(other -> !other.equals(from)).forEach(to::add);
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

    /** The packages that lie on a circle. */
    SortedSet<String> circles() {
        return uses.keySet().stream().filter(name -> below(name).contains(name)).collect(Collectors.toCollection(TreeSet::new));
    }

    /** Everything that a package needs, directly or not. */
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

    /** What a package uses and would not reach by way of another that it uses. */
    SortedSet<String> direct(String name) {
        return uses.get(name).stream().filter(target -> uses.get(name).stream().noneMatch(other -> below(other).contains(target)))
            .collect(Collectors.toCollection(TreeSet::new));
    }

    /** How many packages lie on the longest way down. */
    int height(String name) {
        return uses.get(name).stream().mapToInt(this::height).max().orElse(-1) + 1;
    }
}
