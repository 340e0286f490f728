// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.io.IOException;
import java.net.JarURLConnection;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLConnection;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collections;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.JarEntry;
import java.util.stream.Stream;

/**
 * The classes of a package in jars and folders of the class path; Jython needs them for {@code from PACKAGE import *}.
 * Any thread.
 */
final class PackageClasses {
    private static final String CLASS = ".class";

    private PackageClasses() {
    }

    /**
     * Returns the simple names of the top-level classes, sorted; empty if there is no such package.
     *
     * @throws IOException if the class path can't be read
     */
    static Set<String> of(String name, ClassLoader loader) throws IOException {
        String folder = name.replace('.', '/');
        Set<String> found = new TreeSet<>();
        for (URL place : Collections.list(loader.getResources(folder))) {
            URLConnection connection = place.openConnection();
            if (connection instanceof JarURLConnection) {
                ((JarURLConnection) connection).getJarFile().stream().map(JarEntry::getName)
                    .filter(one -> one.startsWith(folder + "/"))
                    .forEach(one -> add(found, one.substring(folder.length() + 1)));
            } else {
                addFolder(found, place);
            }
        }
        return found;
    }

    private static void addFolder(Set<String> found, URL place) throws IOException {
        try (Stream<Path> files = Files.list(Paths.get(new URI(place.toString())))) {
            files.forEach(one -> add(found, one.getFileName().toString()));
        } catch (URISyntaxException e) {
            throw new IOException(place + " can't be read", e);
        }
    }

    private static void add(Set<String> found, String file) {
        boolean isClass = file.endsWith(CLASS) && file.indexOf('/') < 0 && file.indexOf('$') < 0;
        if (isClass && !file.startsWith("package-info")) {
            found.add(file.substring(0, file.length() - CLASS.length()));
        }
    }
}
