// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.myrobotlab.service.link.PanelFiles;

/**
 * Installs the plug-in in a MyRobotLab and removes it. Makes a complete {@link InstallPlan} before it writes anything.
 * Installs no library twice: MyRobotLab's own libraries stay, whatever their version, unless the user wants its
 * jMonkeyEngine replaced. Any one thread.
 */
final class Installer {
    /** Folder of panels, in the plug-in's jar and in MyRobotLab. */
    private static final String PANELS = "resource/";
    private static final String PLUGIN = "sear.jar";
    /** MyRobotLab's folder of jars. */
    private static final String JARS = "libraries/jar/";
    /** Folder of replaced jars; not on the class path. */
    private static final String REPLACED = "libraries/sear-replaced/";
    private static final String SERVICE_DATA = "libraries/serviceData.json";
    private static final String RECEIPT = "libraries/sear-install.json";
    /** Configuration file of one of SEAR's services that has lost its type. */
    private static final Pattern BARE =
        Pattern.compile("(?sm)\\A((?:---\\s*)?!!org\\.myrobotlab\\.service\\.config\\.)Service(Config\\b"
        + ".*?^type:\\s*['\"]?(?:org\\.myrobotlab\\.service\\.)?(" + String.join("|", ServiceData.SERVICES.keySet())
            + ")['\"]?\\s*$)");

    final MrlFolder mrl;
    /** Message about the rollback of a killed call; null if there was none. */
    final String recovered;
    /** The present installation; without a version if there is none. */
    final Receipt old;
    private final InstallPlan plan;
    /** The new installation. */
    private final Receipt receipt = new Receipt();
    /** Planned contents of files; null deletes a file. */
    private final Map<String, byte[]> files = new TreeMap<>();
    /** Check sums of files that an installation or the services have written, by path. */
    private final Map<String, Set<String>> ours = new TreeMap<>();

    /**
     * Reads a MyRobotLab, which must not be running, and rolls back the changes of a killed call.
     *
     * @param folder MyRobotLab's folder or its parent
     */
    Installer(Path folder) throws InstallException, IOException {
        mrl = new MrlFolder(folder);
        mrl.refuseIfRunning();
        plan = new InstallPlan(mrl.root);
        recovered = plan.recover();
        old = Receipt.read(mrl.root.resolve(RECEIPT), "Delete it and install again; nothing was changed.");
        old.added.forEach(this::know);
        old.changed.forEach(this::know);
        PanelFiles.record(mrl.root.resolve(PANELS)).forEach((name, hash) -> know(PANELS + name, (String) hash));
    }

    private void know(String path, String hash) {
        ours.computeIfAbsent(path, any -> new HashSet<>()).add(hash);
    }

    private boolean isOurs(String path, byte[] now) {
        return ours.getOrDefault(path, Set.of()).contains(PanelFiles.hash(now));
    }

    /**
     * Plans the installation of the distribution.
     *
     * @param plugin the distribution's folder with sear.jar and its libraries
     * @param replaceEngine whether to replace a jMonkeyEngine that is too old for the window
     */
    InstallPlan install(Path plugin, boolean replaceEngine) throws InstallException, IOException {
        Path jar = plugin.resolve(PLUGIN);
        if (!Files.isRegularFile(jar)) {
            throw new InstallException("The distribution is incomplete: " + jar
                + " is missing. Unpack sear's zip again, or run ./gradlew installDist.");
        }
        addPlugin(jar);
        if (old.version != null && JarName.compare(old.version, receipt.version) > 0) {
            throw new InstallException("SEAR " + old.version + " is installed in " + mrl.root
                + ", which is newer than this " + receipt.version
                + ". To go back, remove it first: sear install --remove " + mrl.root);
        }
        receipt.replaced.putAll(old.replaced);
        addLibraries(plugin, replaceEngine);
        addPickerEntries();
        repairConfigs();
        bring();
        if (!plan.isEmpty() || !receipt.version.equals(old.version)) {
            plan.write(RECEIPT, receipt.bytes());
        }
        plan.refuseIfNotWritable();
        return plan;
    }

    /** Adds the jar and the panels in MyRobotLab's resource folder. */
    private void addPlugin(Path plugin) throws IOException {
        files.put(JARS + PLUGIN, Files.readAllBytes(plugin));
        boolean unpacked = Files.isDirectory(mrl.root.resolve(PANELS));
        if (!unpacked) {
            plan.notes.add("later   panels: MyRobotLab unpacks its resource folder at its first start; the services "
                + "add their panels then");
        }
        try (JarFile jar = new JarFile(plugin.toFile())) {
            Manifest manifest = jar.getManifest();
            String version = manifest == null ? null : manifest.getMainAttributes().getValue("Implementation-Version");
            receipt.version = version == null ? "0" : version;
            for (ZipEntry entry : Collections.list(jar.entries())) {
                if (unpacked && entry.getName().startsWith(PANELS) && !entry.isDirectory()) {
                    try (InputStream in = jar.getInputStream(entry)) {
                        files.put(entry.getName(), in.readAllBytes());
                    }
                }
            }
        }
    }

    private void addLibraries(Path plugin, boolean replaceEngine) throws IOException, InstallException {
        Set<String> inside = mrl.ownEntries();
        List<JarName> there = MrlFolder.list(mrl.root.resolve(JARS), "*.jar").stream().map(JarName::new)
            .filter(jar -> !old.added.containsKey(JARS + jar.name)).collect(Collectors.toList());
        String olderEngine = null;
        List<Path> libraries = MrlFolder.list(plugin, "*.jar");
        libraries.remove(plugin.resolve(PLUGIN));
        for (Path library : libraries) {
            JarName wanted = new JarName(library);
            JarName found = null;
            for (JarName jar : there) {
                if (!jar.artifact.equals(wanted.artifact)) {
                    continue;
                }
                if (replaceEngine && jar.isTooOldForTheWindow()) {
                    setAside(jar.name);
                } else if (found == null || JarName.compare(jar.version, found.version) > 0) {
                    found = jar;
                }
            }
            if (found != null) {
                plan.notes.add("keep    " + found.name
                    + (found.version.equals(wanted.version) ? ": MyRobotLab has this library"
                    : " instead of " + wanted.version + ": " + found.verdict(wanted)));
                olderEngine = found.isTooOldForTheWindow()
                    && (olderEngine == null || found.artifact.equals("jme3-core")) ? found.name : olderEngine;
            } else if (isInside(library, inside)) {
                plan.notes.add("keep    " + wanted.name + ": myrobotlab.jar contains this library");
            } else {
                files.put(JARS + wanted.name, Files.readAllBytes(library));
            }
        }
        if (olderEngine != null) {
            plan.remarks.add("The window needs jMonkeyEngine 3.6, but MyRobotLab has " + olderEngine
                + ", so SEAR runs without a window."
                + " To get one, run \"sear install --replace-jme " + mrl.root + "\"; --remove restores the old one.");
        }
    }

    private static boolean isInside(Path library, Set<String> entries) throws IOException {
        try (ZipFile jar = new ZipFile(library.toFile())) {
            return jar.stream().map(ZipEntry::getName)
                .filter(name -> name.endsWith(".class") && !name.contains("-info"))
                .findFirst().map(entries::contains).orElse(false);
        }
    }

    private void setAside(String jar) throws IOException {
        byte[] bytes = plan.now(JARS + jar);
        plan.write(REPLACED + jar, bytes);
        plan.write(JARS + jar, null);
        receipt.replaced.put(jar, PanelFiles.hash(bytes));
    }

    private void addPickerEntries() throws IOException, InstallException {
        byte[] now = plan.now(SERVICE_DATA);
        if (now == null) {
            plan.notes.add("later   service picker: libraries/serviceData.json does not exist yet; start MyRobotLab "
                + "once, then install again");
            plan.remarks.add("The service picker does not list SEAR, LIDAR and GPS yet. Start MyRobotLab once and "
                + "install again, or type the service type by hand.");
            return;
        }
        // MyRobotLab may have rewritten the file with SEAR's entries, which must not count as its original content
        byte[] then = ServiceData.with(now);
        change(SERVICE_DATA, now, then == now ? now : ServiceData.without(now), then);
    }

    /**
     * Restores the type in files that MyRobotLab wrote without the plug-in; it can't create these services otherwise.
     */
    private void repairConfigs() throws IOException {
        for (Path folder : MrlFolder.list(mrl.root.resolve("data/config"), "*")) {
            for (Path yml : MrlFolder.list(folder, "*.yml")) {
                String path = mrl.root.relativize(yml).toString().replace('\\', '/');
                byte[] now = plan.now(path);
                Matcher bare = BARE.matcher(new String(now, StandardCharsets.UTF_8));
                change(path, now, now, bare.find() ? bare.replaceFirst("$1$3$2")
                    .getBytes(StandardCharsets.UTF_8) : now);
            }
        }
    }

    /**
     * Plans a change of one of MyRobotLab's files. The receipt keeps the content before the first installation.
     *
     * @param untouched the content without SEAR
     */
    private void change(String path, byte[] now, byte[] untouched, byte[] then) {
        byte[] original = isOurs(path, now) ? old.originals.get(path) : untouched;
        if (!Arrays.equals(original, then)) {
            files.put(path, then);
            receipt.originals.put(path, original);
        }
    }

    /**
     * Plans all files, and restores SEAR's former ones. Keeps panels, and files to be restored, that were changed by
     * hand.
     */
    private void bring() throws IOException {
        Set<String> paths = new TreeSet<>(files.keySet());
        paths.addAll(ours.keySet());
        for (String path : paths) {
            byte[] now = plan.now(path);
            byte[] then = files.getOrDefault(path, now == null ? null : old.originals.get(path));
            boolean mayStay = path.startsWith(PANELS) || !files.containsKey(path);
            if (mayStay && now != null && !Arrays.equals(now, then) && !isOurs(path, now)) {
                plan.notes.add("keep    " + path + ": it was changed by hand");
                continue;
            }
            plan.write(path, then);
            if (then != null) {
                (receipt.originals.containsKey(path) ? receipt.changed : receipt.added)
                    .put(path, PanelFiles.hash(then));
            }
        }
    }

    /** Plans the removal of the plug-in. */
    InstallPlan remove() throws InstallException, IOException {
        if (old.version == null) {
            throw new InstallException("SEAR is not installed in " + mrl.root + ": there is no " + RECEIPT + ".");
        }
        files.put(JARS + PLUGIN, null); // certainly SEAR's, even if damaged
        plan.write(PANELS + PanelFiles.RECORD, null);
        byte[] data = plan.now(SERVICE_DATA);
        if (data != null && !isOurs(SERVICE_DATA, data)) {
            files.put(SERVICE_DATA, ServiceData.without(data));
        }
        bring();
        for (String jar : old.replaced.keySet()) {
            putBack(jar);
        }
        plan.write(RECEIPT, null);
        plan.refuseIfNotWritable();
        return plan;
    }

    private void putBack(String jar) throws IOException {
        byte[] kept = plan.now(REPLACED + jar);
        if (kept == null) {
            plan.notes.add("lost    " + JARS + jar + ": it is missing in " + REPLACED
                + "; MyRobotLab can install it again");
        } else if (plan.now(JARS + jar) == null) {
            plan.write(JARS + jar, kept);
        }
        plan.write(REPLACED + jar, null);
    }
}
