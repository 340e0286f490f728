package org.SEAR.cli.install;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Map;
import java.util.Objects;
import java.util.Properties;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;

/**
 * Puts the plug-in into a MyRobotLab and takes it out again. Everything is decided first, as a {@link InstallPlan}; nothing is written before that.
 * Any one thread.
 */
public final class Installer {
    /** Services by simple name, with the line that the service picker shows. */
    private static final Map<String, String> SERVICES = services();
    private static final String PANELS = "resource/";
    private static final String JARS = LibraryChoice.JARS;
    private static final String SERVICE_DATA = "libraries/serviceData.json";
    private static final String RECEIPT = "libraries/sear-install.json";
    /** What the services put below the resource root at run time, by name, as SHA-256. */
    private static final String COPIED = "resource/.sear-files.properties";
    /** A folder of our own, which a service may have made. */
    private static final Pattern OWN_FOLDER = Pattern.compile("resource/(?!WebGui$)\\w+|resource/WebGui/app/service/js/sear(/\\w+)?");
    private static final Pattern BARE = Pattern.compile("(?s)\\A(---\\s*)?!!org\\.myrobotlab\\.service\\.config\\.ServiceConfig\\b.*");
    private static final Pattern TYPE = Pattern.compile("(?m)^type:\\s*['\"]?(?:org\\.myrobotlab\\.service\\.)?(\\w+)['\"]?\\s*$");

    private final MrlFolder mrl;
    private final Receipt old;
    private final String recovered;

    /**
     * Looks at a MyRobotLab; what a call that was killed has begun there is undone or finished first.
     *
     * @param folder MyRobotLab's folder, or the one right above it
     */
    public Installer(Path folder) throws InstallException, IOException {
        mrl = MrlFolder.find(folder);
        if (InstallJournal.isPending(mrl.root())) {
            mrl.refuseIfRunning();
        }
        recovered = InstallJournal.recover(mrl.root());
        old = Receipt.read(mrl.receipt());
    }

    private static Map<String, String> services() {
        Map<String, String> services = new TreeMap<>();
        services.put("SEAR", "Robot simulator: worlds and robots from scripts, with the sensors and serial protocols of real hardware");
        services.put("LIDAR", "SICK LMS200 laser scanner, real or simulated");
        services.put("GPS", "GPS receiver that sends NMEA 0183, real or simulated");
        return Collections.unmodifiableMap(services);
    }

    /** MyRobotLab's folder. */
    public Path root() {
        return mrl.root();
    }

    /** What became of an earlier call that was killed; null if there was none. */
    public String recovered() {
        return recovered;
    }

    /** Version that is installed, or null. */
    public String installedVersion() {
        return old == null ? null : old.version;
    }

    /**
     * What installing the distribution would do.
     *
     * @param plugin the distribution's folder with sear.jar and its libraries
     * @param replaceEngine whether a jMonkeyEngine that is too old for the window makes room for the distribution's
     */
    public InstallPlan install(Path plugin, boolean replaceEngine) throws InstallException, IOException {
        InstallPayload payload = new InstallPayload(plugin);
        mrl.refuseIfRunning();
        if (old != null && Versions.compare(old.version, payload.version()) > 0) {
            throw new InstallException("SEAR " + old.version + " is installed in " + mrl.root() + ", which is newer than this " + payload.version()
                + ". To go back, remove it first: sear install --remove " + mrl.root());
        }
        Receipt receipt = new Receipt();
        receipt.version = payload.version();
        InstallPlan plan = new InstallPlan(mrl.root());
        for (Map.Entry<String, byte[]> file : filesToAdd(payload, new LibraryChoice(mrl, old, replaceEngine), plan, receipt).entrySet()) {
            plan.write(file.getKey(), file.getValue());
            receipt.added.put(file.getKey(), Receipt.hash(file.getValue()));
        }
        addPickerEntries(plan, receipt);
        repairConfigs(plan, receipt);
        if (old != null) {
            for (Map.Entry<String, String> file : old.added.entrySet()) {
                if (!receipt.added.containsKey(file.getKey())) {
                    deleteIfOurs(plan, file.getKey(), file.getValue());
                }
            }
            receipt.folders.addAll(old.folders);
        }
        receipt.folders.addAll(plan.newFolders());
        if (!plan.isEmpty() || old == null || !old.version.equals(receipt.version)) {
            plan.write(RECEIPT, receipt.bytes());
        }
        mrl.refuseIfNotWritable(plan);
        return plan;
    }

    private Map<String, byte[]> filesToAdd(InstallPayload payload, LibraryChoice libraries, InstallPlan plan, Receipt receipt)
            throws IOException, InstallException {
        Map<String, byte[]> files = new TreeMap<>();
        files.put(JARS + InstallPayload.PLUGIN, Files.readAllBytes(payload.plugin()));
        libraries.choose(payload, plan, files, receipt);
        if (libraries.olderEngine() != null) {
            plan.remark("The window needs jMonkeyEngine 3.6; " + libraries.olderEngine() + " is there, so SEAR runs without a window. To have one, "
                + "call \"sear install --replace-jme " + mrl.root() + "\"; --remove brings the old one back.");
        }
        if (Files.isDirectory(mrl.resources())) {
            Map<String, String> copied = copiedByServices();
            for (Map.Entry<String, byte[]> panel : panels(payload.plugin()).entrySet()) {
                Path file = mrl.root().resolve(panel.getKey());
                String present = Files.exists(file) ? Receipt.hash(Files.readAllBytes(file)) : null;
                if (present != null && !present.equals(Receipt.hash(panel.getValue())) && !present.equals(copied.get(panel.getKey()))
                        && (old == null || !present.equals(old.added.get(panel.getKey())))) {
                    plan.note("keep    " + panel.getKey() + ": it was changed by hand");
                } else {
                    files.put(panel.getKey(), panel.getValue());
                }
            }
        } else {
            plan.note("later   panels: MyRobotLab unpacks its resource folder at its first start; the services add their panels then");
        }
        return files;
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

    private Map<String, String> copiedByServices() throws IOException {
        Map<String, String> files = new TreeMap<>();
        Path record = mrl.root().resolve(COPIED);
        if (Files.exists(record)) {
            Properties names = new Properties();
            try (InputStream in = Files.newInputStream(record)) {
                names.load(in);
            }
            names.forEach((name, hash) -> files.put(PANELS + name, (String) hash));
        }
        return files;
    }

    private void addPickerEntries(InstallPlan plan, Receipt receipt) throws IOException, InstallException {
        if (!Files.exists(mrl.serviceData())) {
            plan.note("later   service picker: libraries/serviceData.json is not there yet; start MyRobotLab once, then install again");
            plan.remark("Until MyRobotLab has been started once and this was called again, its service picker does not offer SEAR, LIDAR and GPS: "
                + "type the type by hand.");
            return;
        }
        byte[] now = Files.readAllBytes(mrl.serviceData());
        ServiceDataFile data = new ServiceDataFile(new String(now, StandardCharsets.UTF_8));
        boolean changed = false;
        for (Map.Entry<String, String> service : SERVICES.entrySet()) {
            changed |= data.add(service.getKey(), service.getValue(), "SEAR".equals(service.getKey()) ? "simulator" : "sensors");
        }
        if (!changed) {
            change(plan, receipt, SERVICE_DATA, now, now, now);
            return;
        }
        // what MyRobotLab wrote anew since the last installation has our entries in it: these are not part of what was there before
        change(plan, receipt, SERVICE_DATA, now, withoutOurs(now), data.text().getBytes(StandardCharsets.UTF_8));
    }

    /** Service data without entries of ours: the same bytes where there are none. */
    private static byte[] withoutOurs(byte[] text) throws InstallException {
        ServiceDataFile data = new ServiceDataFile(new String(text, StandardCharsets.UTF_8));
        boolean there = false;
        for (String service : SERVICES.keySet()) {
            there |= data.remove(service);
        }
        return there ? data.text().getBytes(StandardCharsets.UTF_8) : text;
    }

    /** A yml that MRL wrote while the plug-in was missing has lost its type; MRL then answers null for the service until it is mended. */
    private void repairConfigs(InstallPlan plan, Receipt receipt) throws IOException {
        for (Path yml : mrl.serviceConfigs()) {
            byte[] now = Files.readAllBytes(yml);
            String text = new String(now, StandardCharsets.UTF_8);
            Matcher type = TYPE.matcher(text);
            String path = mrl.root().relativize(yml).toString().replace('\\', '/');
            if (BARE.matcher(text).matches() && type.find() && SERVICES.containsKey(type.group(1))) {
                byte[] mended = text.replaceFirst("config\\.ServiceConfig\\b", "config." + type.group(1) + "Config").getBytes(StandardCharsets.UTF_8);
                change(plan, receipt, path, now, now, mended);
            } else if (old != null && old.changed.containsKey(path)) {
                change(plan, receipt, path, now, now, now);
            }
        }
    }

    /**
     * Changes a file that MRL owns; the receipt keeps what it was before the first installation.
     *
     * @param untouched how it is without us
     */
    private void change(InstallPlan plan, Receipt receipt, String path, byte[] now, byte[] untouched, byte[] then) throws IOException {
        boolean oursSoFar = old != null && Receipt.hash(now).equals(old.changed.get(path));
        byte[] original = oursSoFar ? old.original(path) : untouched;
        if (java.util.Arrays.equals(original, then)) {
            return;
        }
        plan.write(path, then);
        receipt.changed.put(path, Receipt.hash(then));
        receipt.keepOriginal(path, original);
    }

    /**
     * What taking the plug-in out would do.
     *
     * @param plugin this distribution's plug-in folder, whose panels the services may have copied
     */
    public InstallPlan remove(Path plugin) throws InstallException, IOException {
        if (old == null) {
            throw new InstallException("SEAR is not installed in " + mrl.root() + ": there is no " + RECEIPT + ".");
        }
        mrl.refuseIfRunning();
        InstallPlan plan = new InstallPlan(mrl.root());
        Map<String, String> ours = new TreeMap<>();
        for (Map.Entry<String, byte[]> panel : panelsToRemove(plugin).entrySet()) {
            ours.put(panel.getKey(), Receipt.hash(panel.getValue()));
        }
        ours.putAll(copiedByServices());
        ours.putAll(old.added);
        ours.remove(JARS + InstallPayload.PLUGIN);
        plan.delete(JARS + InstallPayload.PLUGIN); // nobody else's, even if it is damaged
        plan.delete(COPIED);
        for (Map.Entry<String, String> file : ours.entrySet()) {
            deleteIfOurs(plan, file.getKey(), file.getValue());
        }
        for (Map.Entry<String, String> file : old.changed.entrySet()) {
            restore(plan, file.getKey(), file.getValue());
        }
        if (!old.changed.containsKey(SERVICE_DATA)) {
            restore(plan, SERVICE_DATA, "");
        }
        LibraryChoice.putBack(mrl, old, plan);
        plan.delete(RECEIPT);
        plan.deleteEmptied(old.folders);
        plan.deleteEmptied(ours.keySet().stream().map(Path::of).flatMap(path -> Stream.iterate(path, Objects::nonNull, Path::getParent))
            .map(folder -> folder.toString().replace('\\', '/')).filter(OWN_FOLDER.asMatchPredicate()).collect(Collectors.toSet()));
        mrl.refuseIfNotWritable(plan);
        return plan;
    }

    /** The installed jar's; of this distribution where that jar is gone or damaged. */
    private Map<String, byte[]> panelsToRemove(Path plugin) throws InstallException, IOException {
        Path installed = mrl.jars().resolve(InstallPayload.PLUGIN);
        if (Files.exists(installed)) {
            try {
                return panels(installed);
            } catch (ZipException e) {
                return panels(new InstallPayload(plugin).plugin());
            }
        }
        return panels(new InstallPayload(plugin).plugin());
    }

    private void restore(InstallPlan plan, String path, String written) throws IOException, InstallException {
        Path file = mrl.root().resolve(path);
        if (!Files.exists(file)) {
            return;
        }
        byte[] now = Files.readAllBytes(file);
        if (Receipt.hash(now).equals(written)) {
            plan.write(path, old.original(path));
        } else if (path.equals(SERVICE_DATA)) {
            plan.write(path, withoutOurs(now));
        } else {
            plan.note("keep    " + path + ": it was changed since");
        }
    }

    private void deleteIfOurs(InstallPlan plan, String path, String hash) throws IOException {
        Path file = mrl.root().resolve(path);
        if (Files.exists(file)) {
            if (Receipt.hash(Files.readAllBytes(file)).equals(hash)) {
                plan.delete(path);
            } else {
                plan.note("keep    " + path + ": it was changed by hand");
            }
        }
    }
}
