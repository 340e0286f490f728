// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.grammar.Described;

/**
 * Generates names and type hints of the Python 3 package {@code sear}: each call of SEAR, LIDAR and GPS in
 * docs/scripting.md, and each class of {@code org.SEAR.POJOs}. {@code gradle pythonNames} writes the names into the
 * sources, the build the hints into the distribution.
 */
public final class PythonStubs {
    private static final String HINTS = ".pyi";
    private static final String POJOS = "org.SEAR.POJOs.";
    /** Python keywords, which cannot name parameters. */
    private static final List<String> KEYWORDS = List.of("from", "in", "is", "with", "as", "lambda", "global", "del",
        "pass", "not", "and", "or");

    private final Path root;

    /** @param root of the sources */
    PythonStubs(Path root) {
        this.root = root;
    }

    /**
     * Writes a file.
     * @param args the file: hints if it ends with .pyi, otherwise names
     */
    public static void main(String[] args) throws IOException {
        PythonStubs stubs = new PythonStubs(Path.of("."));
        Files.writeString(Path.of(args[0]), args[0].endsWith(HINTS) ? stubs.hints() : stubs.names());
    }

    /** Returns the classes of the object grammar that a script can import, ordered by name. */
    private List<Class<?>> objects() throws IOException {
        try (Stream<Path> files = Files.list(root.resolve("src/main/java/org/SEAR/POJOs"))) {
            return files.map(file -> file.getFileName().toString())
                .filter(name -> name.endsWith(".java") && !name.startsWith("package-"))
                .map(name -> type(name.replace(".java", ""))).filter(type -> Modifier.isPublic(type.getModifiers())
                    && !type.isAnnotation())
                .sorted(Comparator.comparing(Class::getSimpleName)).collect(Collectors.toList());
        }
    }

    private static Class<?> type(String name) {
        try {
            return Class.forName(POJOS + name);
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Returns the module of names. */
    String names() throws IOException {
        return "# SPDX-License-Identifier: Apache-2.0\n\"\"\"The classes of the object grammar. Written by `gradle "
            + "pythonNames`; do not edit.\"\"\"\n\nOBJECTS = (\n"
            + objects().stream().map(type -> "    \"" + type.getSimpleName() + "\",\n")
            .collect(Collectors.joining()) + ")\n";
    }

    /** Returns the module of type hints. */
    String hints() throws IOException {
        StringBuilder out = new StringBuilder(
            Files.readString(root.resolve("src/tools/resources/org/SEAR/documents/python-hints-head.pyi"))
            .replace("\r\n", "\n"));
        ScriptDocs docs = new ScriptDocs(root);
        for (String service : ScriptDocs.SERVICES) {
            Map<String, List<ScriptCall>> calls = new LinkedHashMap<>();
            docs.calls(service).forEach(call -> calls.computeIfAbsent(call.name, any -> new ArrayList<>()).add(call));
            out.append("\n\nclass _").append(service).append("(JavaObject):\n    \"\"\"")
                .append(line(docs.about(service))).append("\"\"\"\n");
            calls.values().forEach(same -> same.forEach(call -> {
                String parameters = call.types.entrySet().stream()
                    .map(one -> ", " + safe(one.getKey()) + ": " + hint(one.getValue(), true))
                    .collect(Collectors.joining());
                method(out, same.size() > 1, false, call.name, parameters, hint(call.answers, false),
                    line(call.text.split("\n\n")[0]));
            }));
        }
        for (Class<?> type : objects()) {
            describe(out, type);
        }
        out.append("\n\n__all__ += [\n");
        objects().forEach(type -> out.append("    \"").append(type.getSimpleName()).append("\",\n"));
        return out.append("]\n").toString();
    }

    private static void describe(StringBuilder out, Class<?> type) {
        Class<?> above = type.getSuperclass();
        boolean known = above != null && above.getName().startsWith(POJOS) && Modifier.isPublic(above.getModifiers());
        Described said = type.getAnnotation(Described.class);
        out.append("\n\nclass ").append(type.getSimpleName()).append('(')
            .append(known ? above.getSimpleName() : "JavaObject")
            .append("):\n    \"\"\"").append(said == null ? type.getSimpleName() : line(said.value()))
            .append("\"\"\"\n");
        if (type.isEnum()) {
            Arrays.stream(type.getEnumConstants()).forEach(one -> out.append("    ").append(((Enum<?>) one).name())
                .append(": ").append(type.getSimpleName()).append('\n'));
        }
        Constructor<?>[] makers = Modifier.isAbstract(type.getModifiers()) ? new Constructor<?>[0]
            : type.getConstructors();
        Arrays.sort(makers, Comparator.comparing(PythonStubs::parameters));
        for (Constructor<?> maker : makers) {
            method(out, makers.length > 1, false, "__init__", parameters(maker), "None", "");
        }
        Map<String, List<Method>> methods = new TreeMap<>();
        Set<String> own = Arrays.stream(type.getDeclaredMethods()).map(Method::getName).collect(Collectors.toSet());
        // A declared method hides inherited overloads of the same name from a type checker.
        Arrays.stream(type.getMethods())
            .filter(one -> known ? own.contains(one.getName()) : one.getDeclaringClass() != Object.class)
            .filter(one -> !one.isSynthetic() && one.getDeclaringClass() != Enum.class)
            .forEach(one -> methods.computeIfAbsent(one.getName(), any -> new ArrayList<>()).add(one));
        methods.values().forEach(same -> {
            same.sort(Comparator.comparing(PythonStubs::parameters));
            same.forEach(one -> method(out, same.size() > 1, Modifier.isStatic(one.getModifiers()), one.getName(),
                parameters(one), hint(one.getReturnType(), false), ""));
        });
    }

    private static String parameters(Executable call) {
        return Arrays.stream(call.getParameters())
            .map(one -> ", " + safe(one.getName()) + ": " + hint(one.getType(), true)).collect(Collectors.joining());
    }

    private static void method(StringBuilder out, boolean overloaded, boolean isStatic, String name, String parameters,
        String answer, String text) {
        out.append(overloaded ? "    @overload\n" : "").append(isStatic ? "    @staticmethod\n" : "").append("    def ")
            .append(name).append('(')
            .append(isStatic ? parameters.replaceFirst("^, ", "") : "self" + parameters).append(") -> ").append(answer)
            .append(':').append(text.isEmpty() ? " ...\n" : "\n        \"\"\"" + text + "\"\"\"\n");
    }

    private static String safe(String name) {
        return KEYWORDS.contains(name) ? name + "_" : name;
    }

    private static String line(String text) {
        return text.replace('\n', ' ').replace("\\", "\\\\").replace("\"\"\"", "'''").trim();
    }

    private static String hint(Class<?> type, boolean given) {
        if (type == void.class) {
            return "None";
        }
        if (type.isArray()) {
            return given ? "Sequence[Any]" : type == byte[].class ? "bytes" : type.getComponentType().isPrimitive()
                ? "np.ndarray" : "List[Any]";
        }
        if (type.getName().startsWith(POJOS) && Modifier.isPublic(type.getModifiers())
            && type.getDeclaringClass() == null) {
            return "\"" + type.getSimpleName() + "\"";
        }
        if (List.class.isAssignableFrom(type)) {
            return given ? "Sequence[Any]" : "List[Any]";
        }
        return hint(type.isPrimitive() ? type == double.class || type == float.class ? "float" : type == boolean.class
            ? "bool" : "int" : type == String.class ? "str" : type.getSimpleName(), given);
    }

    private static String hint(String words, boolean given) {
        if (words.isEmpty()) {
            return "None";
        } else if (List.of("float", "int", "bool", "str").contains(words)) {
            return words;
        } else if (words.startsWith("array of ")) {
            return words.endsWith("byte") ? "bytes" : "np.ndarray";
        } else if (words.startsWith("list of ")) {
            String of = hint(words.substring("list of ".length()), given);
            return (given ? "Sequence[" : "List[") + of + "]";
        }
        return words.startsWith("Map<") ? "Dict[str, Any]" : "Any";
    }
}
