// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import com.sun.source.doctree.DocCommentTree;
import com.sun.source.doctree.DocTree;
import com.sun.source.doctree.ParamTree;
import com.sun.source.doctree.ReturnTree;
import com.sun.source.doctree.ThrowsTree;
import com.sun.source.doctree.UnknownBlockTagTree;
import com.sun.source.util.DocTrees;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePath;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.lang.model.element.Element;
import javax.lang.model.element.ElementKind;
import javax.lang.model.element.ExecutableElement;
import javax.lang.model.element.Modifier;
import javax.lang.model.element.TypeElement;
import javax.lang.model.element.VariableElement;
import javax.lang.model.type.TypeMirror;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * Reads the javadoc of a class's public methods with the compiler of the running JDK; other classes come from the class
 * path.
 */
final class JavadocReader {
    private static final Pattern SECTION = Pattern.compile("(?m)^ {4}// -{4} (.*?) -+$");
    private static final Map<String, String> PYTHON = Map.of("void", "", "double", "float", "long", "int", "boolean",
        "bool", "String", "str", "Object", "object");

    private final Path file;
    private final String source;
    private final List<ScriptCall> calls = new ArrayList<>();
    private String about;

    JavadocReader(Path file) throws IOException {
        this.file = file;
        source = Files.readString(file).replace("\r\n", "\n");
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter messages = new StringWriter();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
            JavacTask task = (JavacTask) compiler.getTask(messages, files, null,
                List.of("-proc:none", "-Xlint:none", "-cp", System.getProperty("java.class.path")), null,
                    files.getJavaFileObjects(file.toFile()));
            DocTrees trees = DocTrees.instance(task);
            for (Element element : task.analyze()) {
                read((TypeElement) element, trees);
            }
        }
        if (calls.isEmpty()) {
            throw new IOException(file + " could not be read: " + messages);
        }
    }

    /** Returns the first paragraph of the class's javadoc. */
    String about() {
        return about;
    }

    /** Returns all public methods in source order. */
    List<ScriptCall> calls() {
        return calls;
    }

    private void read(TypeElement type, DocTrees trees) {
        if (!type.getSimpleName().contentEquals(file.getFileName().toString().replace(".java", ""))) {
            return;
        }
        about = DocText.of(trees.getDocCommentTree(type).getFullBody()).split("\n\n")[0];
        for (Element element : type.getEnclosedElements()) {
            if (element.getKind() == ElementKind.METHOD && element.getModifiers().contains(Modifier.PUBLIC)) {
                calls.add(call((ExecutableElement) element, trees));
            }
        }
    }

    private ScriptCall call(ExecutableElement method, DocTrees trees) {
        ScriptCall call = new ScriptCall();
        call.name = method.getSimpleName().toString();
        call.answers = python(method.getReturnType());
        call.overrides = method.getAnnotation(Override.class) != null;
        for (VariableElement parameter : method.getParameters()) {
            call.parameters.put(parameter.getSimpleName().toString(), "");
            call.types.put(parameter.getSimpleName().toString(), python(parameter.asType()));
        }
        TreePath path = trees.getPath(method);
        call.section = section((int) trees.getSourcePositions()
            .getStartPosition(path.getCompilationUnit(), path.getLeaf()));
        DocCommentTree comment = trees.getDocCommentTree(method);
        if (comment != null) {
            call.text = DocText.of(comment.getFullBody());
            comment.getBlockTags().forEach(tag -> readTag(call, tag));
        }
        return call;
    }

    private static void readTag(ScriptCall call, DocTree tag) {
        if (tag instanceof ParamTree) {
            call.parameters.put(((ParamTree) tag).getName().toString(), DocText.of(((ParamTree) tag).getDescription()));
        } else if (tag instanceof ReturnTree) {
            call.returns = DocText.of(((ReturnTree) tag).getDescription());
        } else if (tag instanceof ThrowsTree) {
            ThrowsTree error = (ThrowsTree) tag;
            call.errors.merge(error.getExceptionName().getSignature(), DocText.of(error.getDescription()), (a, b) -> a
                + "; " + b);
        } else if (tag instanceof UnknownBlockTagTree && ((UnknownBlockTagTree) tag).getTagName().equals("example")) {
            call.example = DocText.raw((UnknownBlockTagTree) tag).replaceAll("\\s*\\n\\s*", " ");
        }
    }

    private String section(int position) {
        String title = "";
        Matcher titles = SECTION.matcher(source.substring(0, position));
        while (titles.find()) {
            title = titles.group(1);
        }
        return title;
    }

    private static String python(TypeMirror type) {
        String name = type.toString().replaceAll("\\b(\\w+\\.)+", "");
        if (name.endsWith("[]")) {
            return "array of " + python(name.substring(0, name.length() - 2));
        }
        return name.startsWith("List<") ? "list of " + python(name.substring("List<".length(), name.length() - 1))
            : python(name);
    }

    private static String python(String simple) {
        return simple.equals("float") || simple.equals("int") ? simple : PYTHON.getOrDefault(simple, simple);
    }
}
