package org.SEAR.cli.install;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;
import org.myrobotlab.service.link.PanelFiles;

/**
 * Puts the plug-in into a MyRobotLab and takes it out again. Everything is decided first, as a {@link InstallPlan}; nothing is written before that.
 * Any one thread.
 */
final class Installer {
    /** Where the services' panels are, in the plug-in's jar and in MyRobotLab's folder. */
    private static final String PANELS = "resource/";
    private static final String PLUGIN = "sear.jar";
    private static final String INSTALLED = LibraryChoice.JARS + PLUGIN;
    private static final String SERVICE_DATA = "libraries/serviceData.json";
    private static final String RECEIPT = "libraries/sear-install.json";
    /** A folder of our own, which a service may have made. */
    private static final Pattern OWN_FOLDER = Pattern.compile("resource/(?!WebGui$)\\w+|resource/WebGui/app/service/js/sear(/\\w+)?");
    private static final Pattern BARE = Pattern.compile("(?s)\\A(---\\s*)?!!org\\.myrobotlab\\.service\\.config\\.ServiceConfig\\b.*");
    private static final Pattern TYPE = Pattern.compile("(?m)^type:\\s*['\"]?(?:org\\.myrobotlab\\.service\\.)?(\\w+)['\"]?\\s*$");

    final MrlFolder mrl;
    /** What became of an earlier call that was killed; null if there was none. */
    final String recovered;
    /** What is installed, or null. */
    final Receipt old;
    private final InstallPlan plan;
    /** What will be installed. */
    private final Receipt receipt = new Receipt();

    /**
     * Looks at a MyRobotLab; what a call that was killed has begun there is undone or finished first.
     *
     * @param folder MyRobotLab's folder, or the one right above it
     */
    Installer(Path folder) throws InstallException, IOException {
        mrl = new MrlFolder(folder);
        plan = new InstallPlan(mrl.root);
        if (plan.isPending()) {
            mrl.refuseIfRunning();
        }
        recovered = plan.recover();
        old = Receipt.read(mrl.root.resolve(RECEIPT));
    }

    /**
     * What installing the distribution would do.
     *
     * @param plugin the distribution's folder with sear.jar and its libraries
     * @param replaceEngine whether a jMonkeyEngine that is too old for the window makes room for the distribution's
     */
    InstallPlan install(Path plugin, boolean replaceEngine) throws InstallException, IOException {
        Path jar = jarIn(plugin);
        receipt.version = version(jar);
        mrl.refuseIfRunning();
        if (old != null && JarName.compare(old.version, receipt.version) > 0) {
            throw new InstallException("SEAR " + old.version + " is installed in " + mrl.root + ", which is newer than this " + receipt.version
                + ". To go back, remove it first: sear install --remove " + mrl.root);
        }
        Map<String, byte[]> files = libraries(plugin, replaceEngine);
        files.put(INSTALLED, Files.readAllBytes(jar));
        if (Files.isDirectory(mrl.root.resolve(PANELS))) {
            files.putAll(panelsToAdd(jar));
        } else {
            plan.notes.add("later   panels: MyRobotLab unpacks its resource folder at its first start; the services add their panels then");
        }
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            plan.write(file.getKey(), file.getValue());
            receipt.added.put(file.getKey(), PanelFiles.hash(file.getValue()));
        }
        addPickerEntries();
        repairConfigs();
        if (old != null) {
            old.added.keySet().removeAll(receipt.added.keySet());
            deleteIfOurs(old.added);
            receipt.folders.addAll(old.folders);
        }
        receipt.folders.addAll(plan.newFolders());
        if (!plan.isEmpty() || old == null || !old.version.equals(receipt.version)) {
            plan.write(RECEIPT, receipt.bytes());
        }
        plan.refuseIfNotWritable();
        return plan;
    }

    private static Path jarIn(Path plugin) throws InstallException {
        if (!Files.isRegularFile(plugin.resolve(PLUGIN))) {
            throw new InstallException("The distribution is incomplete: " + plugin.resolve(PLUGIN)
                + " is missing. Unpack sear's zip again, or run ./gradlew installDist.");
        }
        return plugin.resolve(PLUGIN);
    }

    private static String version(Path plugin) throws IOException {
        try (JarFile jar = new JarFile(plugin.toFile())) {
            Manifest manifest = jar.getManifest();
            String version = manifest == null ? null : manifest.getMainAttributes().getValue("Implementation-Version");
            return version == null ? "0" : version;
        }
    }

    private Map<String, byte[]> libraries(Path plugin, boolean replaceEngine) throws IOException, InstallException {
        if (old != null) {
            receipt.replaced.putAll(old.replaced);
        }
        List<Path> ours = MrlFolder.list(plugin, "*.jar");
        ours.remove(plugin.resolve(PLUGIN));
        List<JarName> there = MrlFolder.list(mrl.root.resolve(LibraryChoice.JARS), "*.jar").stream().map(JarName::new)
            .filter(jar -> old == null || !old.added.containsKey(LibraryChoice.JARS + jar.name)).collect(Collectors.toList());
        LibraryChoice choice = new LibraryChoice(plan, receipt);
        Map<String, byte[]> files = choice.choose(ours, there, mrl.ownEntries(), replaceEngine);
        if (choice.olderEngine() != null) {
            plan.remarks.add("The window needs jMonkeyEngine 3.6; " + choice.olderEngine() + " is there, so SEAR runs without a window. To have one, "
                + "call \"sear install --replace-jme " + mrl.root + "\"; --remove brings the old one back.");
        }
        return files;
    }

    private Map<String, byte[]> panelsToAdd(Path jar) throws IOException {
        Map<String, byte[]> panels = panels(jar);
        Map<String, String> copied = copiedByServices();
        for (Map.Entry<String, byte[]> panel : Map.copyOf(panels).entrySet()) {
            String path = panel.getKey();
            byte[] now = plan.now(path);
            String present = now == null ? null : PanelFiles.hash(now);
            if (now != null && !present.equals(PanelFiles.hash(panel.getValue())) && !present.equals(copied.get(path))
                    && (old == null || !present.equals(old.added.get(path)))) {
                plan.notes.add("keep    " + path + ": it was changed by hand");
                panels.remove(path);
            }
        }
        return panels;
    }

    /** The files that the services serve from MRL's resource root, by path. */
    private static Map<String, byte[]> panels(Path plugin) throws IOException {
        Map<String, byte[]> files = new TreeMap<>();
        try (ZipFile jar = new ZipFile(plugin.toFile())) {
            for (ZipEntry entry : Collections.list(jar.entries())) {
                if (entry.getName().startsWith(PANELS) && !entry.isDirectory()) {
                    try (InputStream in = jar.getInputStream(entry)) {
                        files.put(entry.getName(), in.readAllBytes());
                    }
                }
            }
        }
        return files;
    }

    /** What the services put below the resource root at run time, by path, as SHA-256. */
    private Map<String, String> copiedByServices() throws IOException {
        Map<String, String> files = new TreeMap<>();
        PanelFiles.record(mrl.root.resolve(PANELS)).forEach((name, hash) -> files.put(PANELS + name, (String) hash));
        return files;
    }

    private void addPickerEntries() throws IOException, InstallException {
        byte[] now = plan.now(SERVICE_DATA);
        if (now == null) {
            plan.notes.add("later   service picker: libraries/serviceData.json is not there yet; start MyRobotLab once, then install again");
            plan.remarks.add("Until MyRobotLab has been started once and this was called again, its service picker does not offer SEAR, LIDAR and "
                + "GPS: type the type by hand.");
            return;
        }
        // what MyRobotLab wrote anew since the last installation has our entries in it: these are not part of what was there before
        byte[] then = ServiceData.with(now);
        change(SERVICE_DATA, now, then == now ? now : ServiceData.without(now), then);
    }

    /** A yml that MRL wrote while the plug-in was missing has lost its type; MRL then answers null for the service until it is mended. */
    private void repairConfigs() throws IOException {
        for (Path yml : mrl.serviceConfigs()) {
            String path = mrl.root.relativize(yml).toString().replace('\\', '/');
            byte[] now = plan.now(path);
            String text = new String(now, StandardCharsets.UTF_8);
            Matcher type = TYPE.matcher(text);
            if (BARE.matcher(text).matches() && type.find() && ServiceData.services().contains(type.group(1))) {
                String mended = text.replaceFirst("config\\.ServiceConfig\\b", "config." + type.group(1) + "Config");
                change(path, now, now, mended.getBytes(StandardCharsets.UTF_8));
            } else {
                change(path, now, now, now);
            }
        }
    }

    /**
     * Changes a file that MRL owns; the receipt keeps what it was before the first installation.
     *
     * @param untouched how it is without us
     */
    private void change(String path, byte[] now, byte[] untouched, byte[] then) throws IOException {
        boolean oursSoFar = old != null && PanelFiles.hash(now).equals(old.changed.get(path));
        byte[] original = oursSoFar ? old.originals.get(path) : untouched;
        if (!Arrays.equals(original, then)) {
            plan.write(path, then);
            receipt.changed.put(path, PanelFiles.hash(then));
            receipt.originals.put(path, original);
        }
    }

    /**
     * What taking the plug-in out would do.
     *
     * @param plugin this distribution's plug-in folder, whose panels the services may have copied
     */
    InstallPlan remove(Path plugin) throws InstallException, IOException {
        if (old == null) {
            throw new InstallException("SEAR is not installed in " + mrl.root + ": there is no " + RECEIPT + ".");
        }
        mrl.refuseIfRunning();
        Map<String, String> ours = new TreeMap<>();
        panelsToRemove(plugin).forEach((path, bytes) -> ours.put(path, PanelFiles.hash(bytes)));
        ours.putAll(copiedByServices());
        ours.putAll(old.added);
        ours.remove(INSTALLED);
        plan.write(INSTALLED, null); // nobody else's, even if it is damaged
        plan.write(PANELS + PanelFiles.RECORD, null);
        deleteIfOurs(ours);
        old.changed.putIfAbsent(SERVICE_DATA, "");
        for (Map.Entry<String, String> file : old.changed.entrySet()) {
            restore(file.getKey(), file.getValue());
        }
        new LibraryChoice(plan, old).putBack();
        plan.write(RECEIPT, null);
        plan.deleteEmptied(old.folders);
        plan.deleteEmptied(ours.keySet().stream().map(Path::of).flatMap(path -> Stream.iterate(path, Objects::nonNull, Path::getParent))
            .map(folder -> folder.toString().replace('\\', '/')).filter(OWN_FOLDER.asMatchPredicate()).collect(Collectors.toSet()));
        plan.refuseIfNotWritable();
        return plan;
    }

    /** The installed jar's; of this distribution where that jar is gone or damaged. */
    private Map<String, byte[]> panelsToRemove(Path plugin) throws InstallException, IOException {
        try {
            return panels(mrl.root.resolve(INSTALLED));
        } catch (ZipException | NoSuchFileException e) {
            return panels(jarIn(plugin));
        }
    }

    private void restore(String path, String written) throws IOException, InstallException {
        byte[] now = plan.now(path);
        if (now != null && PanelFiles.hash(now).equals(written)) {
            plan.write(path, old.originals.get(path));
        } else if (now != null && path.equals(SERVICE_DATA)) {
            plan.write(path, ServiceData.without(now));
        } else if (now != null) {
            plan.notes.add("keep    " + path + ": it was changed since");
        }
    }

    private void deleteIfOurs(Map<String, String> hashes) throws IOException {
        for (Map.Entry<String, String> file : hashes.entrySet()) {
            byte[] now = plan.now(file.getKey());
            if (now != null && PanelFiles.hash(now).equals(file.getValue())) {
                plan.write(file.getKey(), null);
            } else if (now != null) {
                plan.notes.add("keep    " + file.getKey() + ": it was changed by hand");
            }
        }
    }
}
